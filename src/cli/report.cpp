#include "report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>

namespace goishi::cli {

void report(std::string_view message) {
  std::string line = "goishi: ";
  for (const char c : message) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) {
      fmt::format_to(std::back_inserter(line), "\\x{:02x}", code);
    } else {
      line += c;
    }
  }
  line += '\n';
  std::fputs(line.c_str(), stderr);
}

void report_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    report("note: " + note);
  }
}

}  // namespace goishi::cli
