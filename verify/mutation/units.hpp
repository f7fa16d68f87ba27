#pragma once
/// \file
/// What a program of claims or tests is asked by `verify/mutants`: `--list`, or units to judge, each as SECONDS:NAME with the
/// processor's time that it may take. Exit status 0 if all hold, 1 if one does not; ended by SIGPROF where one takes longer.

#include <sys/time.h>
#include <unistd.h>

#include <cstdlib>
#include <goishi/mutation.hpp>
#include <string>
#include <vector>

namespace goishi::mutant {

struct Unit {
  double seconds;
  std::string name;
};

[[nodiscard]] inline std::vector<Unit> units_of(int argc, const char* const* argv) {
  std::vector<Unit> units;
  for (int i = 1; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
      units.push_back({std::atof(text.c_str()), text.substr(colon + 1)});
    }
  }
  return units;
}

/// From here on the program does this unit's work. Its name is written at once, since it may be the last that is written.
inline void begin(const Unit& unit) {
  const std::string line = "\nunit " + unit.name + "\n";
  if (write(STDOUT_FILENO, line.data(), line.size()) < 0) {
    std::_Exit(2);
  }
  run.stage = 2;
  end_after(unit.seconds);
}

}  // namespace goishi::mutant
