/// goishi-verify: measures and judges the claims, and writes the report.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <goishi/error.hpp>
#include <map>
#include <thread>

#include "verify/bench/command.hpp"
#include "verify/bits/command.hpp"
#include "verify/bits/section.hpp"
#include "verify/certify/command.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/stone/quadrature.hpp"
#include "verify/reference/command.hpp"
#include "verify/report/markdown.hpp"
#include "verify/report/report.hpp"
#include "verify/stress/command.hpp"
#include "verify/suite/run.hpp"

namespace {

using namespace goishi::verify;

constexpr int all_hold = 0;
constexpr int claim_failed = 1;
constexpr int bad_usage = 2;

struct Options {
  bool list = false;
  std::string filter = "*";
  std::string tier = "quick";
  std::uint64_t seed = 1;
  std::string seeds;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string report_folder;
  std::string json_file;
  std::string junit_file;
  bool no_bench = false;
  std::string write_tables;
  std::string check_tables;
};

void define(CLI::App& app, Options& options) {
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_flag("--list", options.list, "list the claims, and measure nothing");
  app.add_option("--filter", options.filter,
                 "only claims whose id matches: * and ? as in a shell, several separated by commas")
      ->type_name("GLOB");
  app.add_option("--tier", options.tier, "quick: some 10 s; full: more samples, some two minutes")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "seed of all random samples")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--seeds", options.seeds, "run them all, and say which claims fail with which: FIRST-LAST")
      ->type_name("A-B");
  app.add_option("--threads", options.threads, "claims measured at once; the results do not depend on it")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--report", options.report_folder,
                 "write report.html, report.json and junit.xml into this folder; in the full tier the page also shows "
                 "run time against error (see bench), and work_precision.csv has its points")
      ->type_name("DIR");
  app.add_option("--json", options.json_file, "write the report as JSON")->type_name("FILE");
  app.add_option("--junit", options.junit_file, "write the report as JUnit XML")->type_name("FILE");
  app.add_flag("--no-bench", options.no_bench, "leave run time against error out of the full report");
  CLI::Option* const write =
      app.add_option("--write-tables", options.write_tables,
                     "write the tables of this run into README.md and verify/README.md of the source tree in DIR; only "
                     "of all claims, in the full tier, with seed 1, and if all hold")
          ->type_name("DIR");
  app.add_option("--check-tables", options.check_tables,
                 "compare them with this run, likewise: text and bounds must be the same, an error may differ by a "
                 "factor of 1.5")
      ->excludes(write)
      ->type_name("DIR");
  for (const char* const one :
       {"--list", "--seed", "--report", "--json", "--junit", "--write-tables", "--check-tables"}) {
    app.get_option("--seeds")->excludes(app.get_option(one));  // they are of one run
  }
  app.footer(
      "Exit status: 0 all claims hold, 1 a claim failed or a table differs, 2 bad usage.\n"
      "Example: goishi-verify --tier full --filter 'GSL-*,MASS-*' --report build/report");
}

void list(const std::vector<Claim>& claims) {
  for (const Claim& claim : claims) {
    fmt::print("{:19} {:10} {}\n", claim.id, claim.subject(), claim.statement);
  }
}

/// On a terminal the running count stands in one line that the next result overwrites.
void show_progress(std::size_t finished, std::size_t total) {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{}", finished < total ? fmt::format("{} of {} measured …", finished, total) : "");
    std::fflush(stderr);
  }
}

/// The tables are of all claims; with another seed, an error may be any within its bound.
void require_whole_run(const Options& options) {
  const std::string& root = options.write_tables.empty() ? options.check_tables : options.write_tables;
  if (root.empty()) {
    return;
  }
  goishi::require(options.tier == "full", "tier", options.tier, "must be full where tables are written or compared");
  goishi::require(options.filter == "*", "filter", options.filter, "must be * where tables are written or compared");
  goishi::require(options.seed == 1, "seed", options.seed, "must be 1 where tables are written or compared");
  markdown::require_parts(root);
}

/// Whether the tables are as asked.
bool settle_tables(const Run& run, const Options& options) {
  if (!options.write_tables.empty()) {
    if (run.failures() > 0) {
      fmt::print("The tables are not written, since not all claims hold.\n");
      return false;
    }
    markdown::write_tables(run, options.write_tables);
  }
  if (options.check_tables.empty()) {
    return true;
  }
  const std::vector<std::string> differences = markdown::table_differences(run, options.check_tables);
  for (const std::string& difference : differences) {
    fmt::print("FAILS  {}\n", difference);
  }
  if (!differences.empty()) {
    fmt::print("Where the run is right: goishi-verify --tier full --write-tables {}\n", options.check_tables);
  }
  return differences.empty();
}

/// Bad usage is better said before the claims are measured than after.
void require_folders(const Options& options) {
  const auto require_folder_of = [](const char* argument, const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    goishi::require(std::filesystem::is_directory(folder), argument, file.string(), "must be in a folder that exists");
  };
  if (!options.json_file.empty()) {
    require_folder_of("json", options.json_file);
  }
  if (!options.junit_file.empty()) {
    require_folder_of("junit", options.junit_file);
  }
  if (!options.report_folder.empty() && !std::filesystem::is_directory(options.report_folder)) {
    require_folder_of("report", options.report_folder);
    std::filesystem::create_directory(options.report_folder);
  }
}

void write_report(const Run& run, const std::filesystem::path& folder, bool with_bench) {
  std::vector<Section> sections;
  if (with_bench) {
    const bench::Bench measured = bench::run_bench_for_report();
    sections.push_back(bench::page_section(measured));
    write_file(folder / bench::csv_name, bench::csv_report(measured));
  }
  sections.push_back(bits::page_section(run));
  const auto if_there = [&folder](const std::string& file) {
    return std::filesystem::exists(folder / file) ? file : "";
  };
  write_file(folder / "report.html",
             html_report(run, sections,
                         {.derivations = if_there("derivations.html"),   // by derivations/document
                          .in_browser = if_there("../web/goishi.html"),  // by src/web/build
                          .changes = if_there("mutants.html")}));        // by verify/mutants
  write_file(folder / "report.json", json_report(run));
  write_file(folder / "junit.xml", junit_report(run));
}

/// FIRST-LAST.
std::pair<std::uint64_t, std::uint64_t> range_of(const std::string& seeds) {
  std::uint64_t first = 0, last = 0;
  const char* const end = seeds.data() + seeds.size();
  const auto [dash, first_error] = std::from_chars(seeds.data(), end, first);
  const bool dashed = first_error == std::errc() && dash != end && *dash == '-';
  const auto [rest, last_error] = std::from_chars(dashed ? dash + 1 : dash, end, last);
  goishi::require(dashed && last_error == std::errc() && rest == end && first <= last && last - first < 100'000,
                  "seeds", seeds, "must be FIRST-LAST, as 1-100");
  return {first, last};
}

/// How often each claim fails.
int verify_seeds(const std::vector<Claim>& claims, const Options& options, Tier tier) {
  const auto [first, last] = range_of(options.seeds);
  std::map<std::string, std::vector<std::uint64_t>> failed;
  bool hangs = false;
  std::uint64_t run_of_them = 0;
  for (std::uint64_t seed = first; seed <= last && !hangs; ++seed, ++run_of_them) {
    const Run run = run_claims(claims, make_stamp(seed, tier), options.threads, [](const Result&, std::size_t) {});
    for (const Result& result : run.results) {
      if (!result.verdict.holds) {
        failed[result.claim->id].push_back(seed);
        fmt::print("FAILS  {:13} seed {}: {}\n", result.claim->id, seed, result.verdict.why);
      }
    }
    hangs = run.hangs;
    show_progress(seed - first + 1, last - first + 1);
  }
  std::size_t failures = 0;
  for (const auto& [id, seeds] : failed) {
    failures += seeds.size();
    fmt::print("{:13} fails with {} of {} seeds: {}\n", id, seeds.size(), run_of_them, fmt::join(seeds, ", "));
  }
  fmt::print("{} failures of {} claims with {} seeds, tier {}\n", failures, claims.size(), run_of_them,
             to_string(tier));
  std::fflush(stdout);
  if (hangs) {
    std::_Exit(claim_failed);
  }
  return failures == 0 ? all_hold : claim_failed;
}

int verify(const Options& options) {
  std::vector<Claim> claims = all_claims();
  std::erase_if(claims, [&](const Claim& claim) { return !matches(claim.id, options.filter); });
  if (claims.empty()) {
    fmt::print(stderr, "goishi-verify: error: filter = {}: must match at least one claim (see --list)\n",
               options.filter);
    return bad_usage;
  }
  if (options.list) {
    list(claims);
    return all_hold;
  }
  require_folders(options);
  require_whole_run(options);
  silence_gsl();
  const Tier tier = options.tier == "full" ? Tier::full : Tier::quick;
  if (!options.seeds.empty()) {
    return verify_seeds(claims, options, tier);
  }
  show_progress(0, claims.size());
  const Run run = run_claims(claims, make_stamp(options.seed, tier), options.threads,
                             [&](const Result&, std::size_t finished) { show_progress(finished, claims.size()); });
  for (const Result& result : run.results) {
    fmt::print("{}\n", text_line(result));
  }
  fmt::print("{}", text_summary(run));
  if (!options.report_folder.empty()) {
    write_report(run, options.report_folder, tier == Tier::full && !options.no_bench);
  }
  if (!options.json_file.empty()) {
    write_file(options.json_file, json_report(run));
  }
  if (!options.junit_file.empty()) {
    write_file(options.junit_file, junit_report(run));
  }
  const bool as_in_tables = settle_tables(run, options);
  if (run.hangs) {
    std::fflush(nullptr);
    std::_Exit(claim_failed);
  }
  return run.failures() == 0 && as_in_tables ? all_hold : claim_failed;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Verifies Goishi: each claim's production function against an oracle, as independent of it as can be.",
               "goishi-verify");
  Options options;
  bench::BenchOptions bench_options;
  define(app, options);
  stress::Options stress_options;
  bits::Options bits_options;
  const CLI::App* const bench_command = bench::define_bench(app, bench_options);
  certify::Options certify_options;
  const CLI::App* const stress_command = stress::define_stress(app, stress_options);
  const CLI::App* const bits_command = bits::define_bits(app, bits_options);
  const CLI::App* const certify_command = certify::define_certify(app, certify_options);
  reference::Options reference_options;
  const CLI::App* const reference_command = reference::define_reference(app, reference_options);
  try {
    app.parse(argc, argv);
    if (bench_command->parsed()) {
      return bench::run_bench_command(bench_options) ? all_hold : claim_failed;
    }
    if (bits_command->parsed()) {
      return bits::run_bits_command(bits_options) ? all_hold : claim_failed;
    }
    if (stress_command->parsed()) {
      return stress::run_stress_command(stress_options) ? all_hold : claim_failed;
    }
    if (certify_command->parsed()) {
      return certify::run_certify_command(certify_options) ? all_hold : claim_failed;
    }
    if (reference_command->parsed()) {
      return reference::run_reference_command(reference_options) ? all_hold : claim_failed;
    }
    return verify(options);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      return app.exit(error);  // --help
    }
    fmt::print(stderr, "goishi-verify: error: {}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "goishi-verify: error: {}\n", error.what());
  }
  return bad_usage;
}
