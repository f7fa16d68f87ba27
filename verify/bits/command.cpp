#include "verify/bits/command.hpp"

#include <fmt/format.h>

#include <fstream>
#include <goishi/error.hpp>
#include <iterator>

#include "verify/bits/kinds.hpp"

namespace goishi::verify::bits {

CLI::App* define_bits(CLI::App& app, Options& options) {
  CLI::App* const command = app.add_subcommand(
      "bits", "one hash of the results of each kind of work: the same for every compiler, processor and optimisation");
  command->add_option("--check", options.check, "compare with this file, verify/bits/hashes.txt")->type_name("FILE");
  command->add_option("--write", options.write, "write them to this file")->type_name("FILE");
  return command;
}

bool run_bits_command(const Options& options) {
  std::string lines;
  for (const Kind& kind : kinds()) {
    const std::string one = line(kind);
    fmt::print("{}    how far off: {}\n", one, fmt::join(kind.claims, ", "));
    lines += one;
  }
  if (!options.write.empty()) {
    std::ofstream file(options.write);
    file << lines;
    require(static_cast<bool>(file.flush()), "--write", options.write, "cannot be written");
  }
  if (options.check.empty()) {
    return true;
  }
  std::ifstream file(options.check);
  require(static_cast<bool>(file), "--check", options.check, "cannot be read");
  const std::string expected{std::istreambuf_iterator<char>(file), {}};
  if (expected != lines) {
    fmt::print("{} has others:\n{}", options.check, expected);
  }
  return expected == lines;
}

}  // namespace goishi::verify::bits
