#include "verify/reference/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <goishi/error.hpp>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "verify/reference/answers.hpp"
#include "verify/reference/file.hpp"
#include "verify/reference/sections.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify::reference {

namespace {

std::string content_of(const std::string& file, const char* argument) {
  if (file == "-") {
    return {std::istreambuf_iterator<char>(std::cin), {}};
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  require(static_cast<bool>(stream), argument, file, "must be a file that can be read");
  return text;
}

std::filesystem::path path_of(const std::string& folder, const Section& section) {
  return std::filesystem::path(folder) / (section.name + ".json");
}

/// The file's text; nothing, and says so, where an enclosure is not proved.
std::optional<std::string> proved_text(const Section& section) {
  try {
    return file_text(section);
  } catch (const std::runtime_error& error) {
    fmt::print("FAILS  {}.json, {}\n", section.name, error.what());
    return std::nullopt;
  }
}

/// All or none.
bool write_files(const std::string& folder) {
  require(std::filesystem::is_directory(folder), "write", folder, "must be a folder that exists");
  const std::vector<Section> sections = all_sections();
  std::vector<std::string> texts;
  for (const Section& section : sections) {
    if (const std::optional<std::string> text = proved_text(section)) {
      texts.push_back(*text);
    }
  }
  if (texts.size() != sections.size()) {
    return false;
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::filesystem::path path = path_of(folder, sections[i]);
    write_file(path, texts[i]);
    fmt::print("{}: {} cases\n", path.string(), sections[i].problems.size());
  }
  return true;
}

void write_answers(const std::string& file) {
  std::string text = "id,quantity,value\n";
  for (const Section& section : all_sections()) {
    text += own_answers(section);
  }
  if (file == "-") {
    fmt::print("{}", text);
  } else {
    write_file(file, text);
  }
}

/// The first line in which two texts differ.
std::string first_difference(std::string_view now, std::string_view before) {
  std::size_t line = 1, start = 0;
  for (std::size_t i = 0; i < now.size() && i < before.size() && now[i] == before[i]; ++i) {
    if (now[i] == '\n') {
      ++line;
      start = i + 1;
    }
  }
  const auto line_of = [&](std::string_view text) {
    return text.substr(std::min(start, text.size()), text.find('\n', start) - start);
  };
  return fmt::format("line {}:\n  {}\n  is now\n  {}", line, line_of(before), line_of(now));
}

bool compare(const std::string& folder) {
  bool same = true;
  for (const Section& section : all_sections()) {
    const std::string path = path_of(folder, section).string();
    const std::string before = content_of(path, "folder");
    const std::optional<std::string> now = proved_text(section);
    if (now && *now == before) {
      fmt::print("{}: {} cases, as regenerated\n", path, section.problems.size());
      continue;
    }
    same = false;
    if (now) {
      fmt::print("FAILS  {}, {}\n", path, first_difference(*now, before));
    }
  }
  return same;
}

std::vector<ReadFile> read_files(const std::string& folder) {
  std::vector<ReadFile> files;
  for (const Section& section : all_sections()) {
    const std::string path = path_of(folder, section).string();
    try {
      files.push_back(read_file(content_of(path, "folder")));
    } catch (const std::runtime_error& error) {
      throw InvalidArgument("folder", path, error.what());
    }
  }
  return files;
}

bool check(const Options& options) {
  std::vector<Given> answers;
  for (const std::string& file : options.check) {
    try {
      std::vector<Given> more = read_answers(content_of(file, "check"));
      answers.insert(answers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    } catch (const std::runtime_error& error) {
      throw InvalidArgument("check", file, error.what());
    }
  }
  require(!answers.empty(), "check", options.check.front(), "must hold an answer");
  std::vector<Tally> tallies;
  try {
    tallies = judge(read_files(options.folder), answers);
  } catch (const std::runtime_error& error) {
    throw InvalidArgument("check", options.check.front(), error.what());
  }
  fmt::print("{:9} {:20} {:>9} {:>10} {:>10}  {}\n", "file", "quantity", "answered", "median", "max [ulp]",
             "worst case");
  bool all = true;
  for (const Tally& tally : tallies) {
    if (tally.errors.empty()) {
      continue;
    }
    const double most = tally.errors.back();
    const bool holds = std::isfinite(most) && (!options.within || most <= *options.within);
    fmt::print("{:9} {:20} {:>4}/{:<4} {:>10.3g} {:>10.3g}  {}{}\n", tally.section, tally.quantity, tally.errors.size(),
               tally.cases, median_of(tally), most, tally.worst, holds ? "" : "  FAILS");
    all = all && holds;
  }
  return all;
}

}  // namespace

CLI::App* define_reference(CLI::App& app, Options& options) {
  CLI::App* reference = app.add_subcommand("reference",
                                           "The reference set: regenerates its files and compares them with those of "
                                           "the folder; or checks anybody's answers "
                                           "to them.");
  reference->add_option("--folder", options.folder, "the folder of the files")->capture_default_str()->type_name("DIR");
  CLI::Option* const write =
      reference->add_option("--write", options.write, "write the files into this folder")->type_name("DIR");
  CLI::Option* const answers =
      reference
          ->add_option("--answers", options.answers,
                       "write the library's own answers, in double, as CSV; -: standard output")
          ->type_name("FILE");
  CLI::Option* const check =
      reference
          ->add_option(
              "--check", options.check,
              "print how far off the answers in a file are: CSV with lines id,quantity,value[,value...], or JSON, "
              "{\"id\": {\"quantity\": value}}; -: standard input")
          ->type_name("FILE");
  reference->add_option("--within", options.within, "an error above this fails; by default only what is no number does")
      ->check(CLI::NonNegativeNumber)
      ->type_name("ULPS")
      ->needs(check);
  write->excludes(answers, check);
  answers->excludes(check);
  reference->footer(
      "Exit status: 0 the files are as regenerated, or no error is above the limit; 1 one is, a file differs, or an "
      "enclosure is not proved; 2 bad usage, as an answer to what no case asks.\n"
      "Example: goishi-verify reference --answers own.csv && goishi-verify reference --check own.csv --within 100");
  return reference;
}

bool run_reference_command(const Options& options) {
  if (!options.write.empty()) {
    return write_files(options.write);
  }
  if (!options.answers.empty()) {
    write_answers(options.answers);
    return true;
  }
  return options.check.empty() ? compare(options.folder) : check(options);
}

}  // namespace goishi::verify::reference
