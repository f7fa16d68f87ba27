#pragma once
/// \file
/// `goishi-verify bench`.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "verify/bench/report.hpp"

namespace goishi::verify::bench {

struct BenchOptions {
  bool list = false;
  std::vector<std::string> problems;
  std::string tier = "full";
  std::string csv_file;
  std::string markdown_file;
  std::string report_folder;
  std::string write_tables;
  std::string write_history;
  std::string check_tables;
};

/// The subcommand, with its options.
[[nodiscard]] CLI::App* define_bench(CLI::App& app, BenchOptions& options);

/// Measures, prints, and writes what was asked for; false where tables do not fit. Throws InvalidArgument when an option
/// is wrong.
[[nodiscard]] bool run_bench_command(const BenchOptions& options);

/// The shorter run (about half a minute) that the report of the claims shows, with a running count on a terminal.
[[nodiscard]] Bench run_bench_for_report();

inline constexpr const char* page_name = "work_precision.html";
inline constexpr const char* csv_name = "work_precision.csv";

}  // namespace goishi::verify::bench
