#include "verify/certify/command.hpp"

#include <fmt/format.h>

#include <fstream>
#include <goishi/error.hpp>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "verify/certify/certify.hpp"

namespace goishi::verify::certify {

namespace {

std::string read(const std::string& file) {
  if (file == "-") {
    return {std::istreambuf_iterator<char>(std::cin), {}};
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    throw InvalidArgument("file", file, "must be a file that can be read");
  }
  return text;
}

template <class Judge>
bool judge_file(const std::string& file, Judge&& judge) {
  const std::string text = read(file);
  const std::string name = file == "-" ? "standard input" : file;
  Outcome outcome;
  try {
    outcome = judge(text);
  } catch (const std::runtime_error& error) {
    outcome.faults.emplace_back(error.what());
  } catch (const InvalidArgument& error) {  // no stone of the catalogue
    outcome.faults.emplace_back(error.what());
  }
  for (const std::string& fault : outcome.faults) {
    fmt::print("FAILS  {}: {}\n", name, fault);
  }
  fmt::print("{}: {} numbers certified, {} faults\n", name, outcome.certified, outcome.faults.size());
  return outcome.faults.empty() && 0 < outcome.certified;
}

}  // namespace

CLI::App* define_certify(CLI::App& app, Options& options) {
  CLI::App* certify = app.add_subcommand("certify",
                                         "Certifies printed numbers: each is the correctly rounded decimal of an "
                                         "enclosure, by Arb's rigorous integration of the stone's profile.");
  certify
      ->add_option("files", options.tables,
                   "what goishi table printed, with the catalogue's densities, in any format; -: standard input")
      ->type_name("FILE");
  certify
      ->add_option(
          "--document", options.documents,
          "a README of the source tree, by its path: the exact results in its sentences; of the README at the top, "
          "also the table below its marker")
      ->type_name("FILE")
      ->allow_extra_args(false);
  certify->add_flag("--whole", options.whole,
                    "a table must have white and black stones, sharp and with b = 1 mm; else each color and bevel that "
                    "occurs must have all sizes");
  certify->add_option("--standard", options.standard, "whose dimensions the tables' stones have: talk or nihon-kiin")
      ->capture_default_str()
      ->type_name("WHOSE");
  certify->footer(
      "Exit status: 0 every number is certified, 1 one is not, or no table is found, 2 bad usage.\n"
      "Example: goishi table --format csv | goishi-verify certify --whole -");
  return certify;
}

bool run_certify_command(const Options& options) {
  const std::optional<Standard> standard = standard_named(options.standard);
  if (!standard) {
    throw InvalidArgument("standard", options.standard, "must be talk or nihon-kiin");
  }
  if (options.tables.empty() && options.documents.empty()) {
    throw InvalidArgument("file", "(none)", "must be given");
  }
  bool all = true;
  for (const std::string& file : options.tables) {
    all = judge_file(file, [&](std::string_view text) { return certify_table(text, options.whole, *standard); }) && all;
  }
  for (const std::string& file : options.documents) {
    all = judge_file(file, [&](std::string_view text) { return certify_document(text, file); }) && all;
  }
  return all;
}

}  // namespace goishi::verify::certify
