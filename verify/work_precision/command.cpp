#include "verify/work_precision/command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <goishi/error.hpp>

namespace goishi::verify::bench {

namespace {

void show_progress(std::size_t finished, std::size_t total) {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{}",
               finished < total ? fmt::format("{} of {} rounds measured …", finished, total) : "");
    std::fflush(stderr);
  }
}

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const Problem& problem : problems()) {
    names.push_back(problem.name);
  }
  for (const contact::Problem& problem : contact::problems()) {
    names.push_back(problem.name);
  }
  names.emplace_back(drops::name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// All where no names are given.
template <class AnyProblem>
std::vector<const AnyProblem*> chosen_of(const std::vector<AnyProblem>& problems,
                                         const std::vector<std::string>& names) {
  std::vector<const AnyProblem*> chosen;
  for (const AnyProblem& problem : problems) {
    if (names.empty() || contains(names, problem.name)) {
      chosen.push_back(&problem);
    }
  }
  return chosen;
}

Programme chosen_programme(const std::vector<std::string>& names) {
  const std::vector<std::string> known = known_names();
  for (const std::string& name : names) {
    goishi::require(contains(known, name), "problem", name, "must be one of ",
                    fmt::format("{}", fmt::join(known, ", ")));
  }
  return {.motion = chosen_of(problems(), names),
          .contact = chosen_of(contact::problems(), names),
          .drops = names.empty() || contains(names, drops::name)};
}

void print_list() {
  fmt::print("Problems of motion\n");
  for (const Problem& problem : problems()) {
    fmt::print("  {:22} {}\n", problem.name, problem.title);
  }
  fmt::print("Contestants\n");
  for (const Contestant& contestant : contestants()) {
    fmt::print("  {:22} {}{}\n", contestant.name, contestant.label,
               contestant.needs_symmetry ? " (bodies with a symmetry axis)" : "");
  }
  fmt::print("Problems of contact\n");
  for (const contact::Problem& problem : contact::problems()) {
    fmt::print("  {:22} {}\n", problem.name, problem.title);
  }
  fmt::print("Contestants\n");
  for (const contact::Contestant& contestant : contact::contestants()) {
    fmt::print("  {:22} {}\n", contestant.name, contestant.label);
  }
  fmt::print("Drops\n  {:22} {}\n", drops::name, drops::title);
}

/// Bad usage is better said before the measurement than after.
void require_places(const BenchOptions& options) {
  const std::filesystem::path file = options.csv_file;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  goishi::require(std::filesystem::is_directory(folder), "csv", options.csv_file, "must be in a folder that exists");
  if (!options.report_folder.empty()) {
    std::filesystem::create_directories(options.report_folder);
  }
}

}  // namespace

CLI::App* define_bench(CLI::App& app, BenchOptions& options) {
  CLI::App* bench = app.add_subcommand(
      "bench",
      "Measures run time against error: every stepper and the exact flight, beside Odeint's steppers; every contact "
      "query, beside libccd and FCL; whole drops, beside the talk's loop.");
  bench->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  bench->add_flag("--list", options.list, "list problems and contestants, and measure nothing");
  bench->add_option("--problem", options.problems, "only these problems, separated by commas")
      ->delimiter(',')
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME");
  bench->add_option("--tier", options.tier, "quick: under 10 s; full: longer curves and more repeats, under 60 s")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  bench->add_option("--csv", options.csv_file, "write every point as CSV")->type_name("FILE");
  bench
      ->add_option("--report", options.report_folder,
                   fmt::format("write {} (tables and plots) and {} into this folder", page_name, csv_name))
      ->type_name("DIR");
  bench->footer(
      "Prints what each contestant costs, at equal attitude error where it has steps, and the bars. Times depend on "
      "the\n"
      "machine, so a bar that is not held does not change the exit status: 0, or 2 for bad usage.\n"
      "Example: goishi-verify bench --problem spin,edge --csv points.csv");
  return bench;
}

void run_bench_command(const BenchOptions& options) {
  const Programme chosen = chosen_programme(options.problems);
  if (options.list) {
    print_list();
    return;
  }
  require_places(options);
  const bool quick = options.tier == "quick";
  const Bench bench = run_bench(chosen, quick ? quick_effort : full_effort,
                                make_stamp(0, quick ? Tier::quick : Tier::full), show_progress);
  fmt::print("{}", text_report(bench));
  if (!options.csv_file.empty()) {
    write_file(options.csv_file, csv_report(bench));
  }
  if (!options.report_folder.empty()) {
    const std::filesystem::path folder = options.report_folder;
    write_file(folder / page_name, html_page(page_section(bench), bench.stamp, bench.seconds));
    write_file(folder / csv_name, csv_report(bench));
  }
}

Bench run_bench_for_report() {
  return run_bench(chosen_programme({}), report_effort, make_stamp(0, Tier::full), show_progress);
}

}  // namespace goishi::verify::bench
