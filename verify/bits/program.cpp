/// The hashes as this program's compiler and processor make them, a line for each kind of work: with nothing but the library, so
/// that any compiler makes it.

#include <cstdio>

#include "verify/bits/kinds.hpp"

int main() {
  for (const auto& kind : goishi::verify::bits::kinds()) {
    std::fputs(goishi::verify::bits::line(kind).c_str(), stdout);
    std::fflush(stdout);
  }
  return 0;
}
