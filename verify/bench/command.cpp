#include "verify/bench/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <goishi/error.hpp>

#include "verify/report/markdown.hpp"

namespace goishi::verify::bench {

namespace {

void show_progress(std::size_t finished, std::size_t total) {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{}", finished < total ? fmt::format("{} of {} races run …", finished, total) : "");
    std::fflush(stderr);
  }
}

/// By their names, or by their subjects'; all where no names are given.
std::vector<const Problem*> chosen_problems(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  std::vector<const Problem*> chosen;
  const auto is_named = [&](const std::string& name) {
    known.push_back(name);
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const Subject& subject : subjects()) {
    const bool whole = is_named(subject.name) || names.empty();
    for (const Problem& problem : subject.problems) {
      if (is_named(problem.name) || whole) {
        chosen.push_back(&problem);
      }
    }
  }
  for (const std::string& name : names) {
    goishi::require(std::find(known.begin(), known.end(), name) != known.end(), "problem", name, "must be one of ",
                    fmt::format("{}", fmt::join(known, ", ")));
  }
  return chosen;
}

/// All right answers at once, before anything is timed: some take a second.
std::vector<Race> prepared(const std::vector<const Problem*>& problems, const Effort& effort) {
  std::vector<std::future<Race>> running;
  for (const Problem* problem : problems) {
    running.push_back(std::async(std::launch::async, problem->prepare, effort));
  }
  std::vector<Race> races;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    races.push_back(running[i].get());
    races.back().name = problems[i]->name;
    races.back().title = problems[i]->title;
  }
  return races;
}

Bench run_bench(const std::vector<const Problem*>& problems, const Effort& effort, const Stamp& stamp) {
  const auto start = std::chrono::steady_clock::now();
  Bench bench{.stamp = stamp, .races = prepared(problems, effort)};
  for (std::size_t i = 0; i < bench.races.size(); ++i) {
    show_progress(i, bench.races.size());
    run_race(bench.races[i], effort);
  }
  show_progress(bench.races.size(), bench.races.size());
  bench.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return bench;
}

void print_list() {
  for (const Subject& subject : subjects()) {
    fmt::print("{}: {}\n", subject.name, subject.title);
    for (const Problem& problem : subject.problems) {
      fmt::print("  {:24} {}\n", problem.name, problem.title);
    }
    fmt::print("  Contestants\n");
    for (const Who& who : subject.contestants) {
      fmt::print("    {:22} {}\n", who.name, who.label);
    }
  }
}

/// Whether the document's tables have the rows that they should.
bool check_tables(const std::filesystem::path& root) {
  std::vector<std::string> found = document_differences(markdown::part_of_file(root / document_name, document_part));
  if (markdown::part_of_file(root / document_name, history_part) + "\n" !=
      history_text(history::read(history::recorded()))) {
    found.push_back(
        fmt::format("the part '{}' is not what drops.csv says: bench --write-history {}", history_part, root.string()));
  }
  for (const std::string& difference : found) {
    fmt::print("FAILS  {}: {}\n", document_name, difference);
  }
  if (!found.empty()) {
    fmt::print("On a quiet machine: goishi-verify bench --write-tables {}\n", root.string());
  }
  return found.empty();
}

/// Bad usage is better said before the measurement than after.
void require_places(const BenchOptions& options) {
  if (!options.write_tables.empty()) {
    goishi::require(options.tier == "full", "tier", options.tier, "must be full where tables are written");
    goishi::require(options.problems.empty(), "problem", fmt::format("{}", fmt::join(options.problems, ",")),
                    "must not be given where tables are written");
    (void)markdown::part_of_file(std::filesystem::path(options.write_tables) / document_name, document_part);
  }
  for (const auto& [argument, name] :
       {std::pair("csv", options.csv_file), std::pair("markdown", options.markdown_file)}) {
    const std::filesystem::path file = name;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    goishi::require(std::filesystem::is_directory(folder), argument, name, "must be in a folder that exists");
  }
  if (!options.report_folder.empty()) {
    std::filesystem::create_directories(options.report_folder);
  }
}

}  // namespace

CLI::App* define_bench(CLI::App& app, BenchOptions& options) {
  CLI::App* bench = app.add_subcommand(
      "bench",
      "Measures run time against error: every stepper and the exact flight, beside Odeint's steppers; every contact "
      "query, beside libccd and FCL; whole drops, beside the talk's loop; one stone and a whole board, beside "
      "Bullet, ODE, Siconos and Simbody.");
  bench->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  bench->add_flag("--list", options.list, "list problems and contestants, and measure nothing");
  bench->add_option("--problem", options.problems, "only these problems, or all of a subject, separated by commas")
      ->delimiter(',')
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME");
  bench
      ->add_option("--tier", options.tier,
                   "quick: longer than half a minute; full: longer curves and more repeats, minutes")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  bench->add_option("--csv", options.csv_file, "write every point as CSV")->type_name("FILE");
  bench->add_option("--markdown", options.markdown_file, "write all tables as Markdown")->type_name("FILE");
  bench
      ->add_option("--report", options.report_folder,
                   fmt::format("write {} (tables and plots) and {} into this folder", page_name, csv_name))
      ->type_name("DIR");
  CLI::Option* const write =
      bench
          ->add_option("--write-tables", options.write_tables,
                       fmt::format("write the costs into {} of the source tree in DIR; only of all problems, in the "
                                   "full tier",
                                   document_name))
          ->type_name("DIR");
  bench
      ->add_option("--write-history", options.write_history,
                   fmt::format("write what was measured of earlier commits into {} of the source tree in DIR, and "
                               "measure nothing",
                               document_name))
      ->excludes(write)
      ->type_name("DIR");
  bench
      ->add_option("--check-tables", options.check_tables,
                   "look whether its rows are of the problems that there are, and measure nothing")
      ->excludes(write)
      ->type_name("DIR");
  bench->footer(
      "Prints what each contestant costs, at equal attitude error where it has steps, and the bars. Times depend on "
      "the\n"
      "machine, so a bar that is not held does not change the exit status: 0, 1 where the rows of a table are "
      "not as they should be, 2 for bad usage.\n"
      "Example: goishi-verify bench --problem spin,edge --csv points.csv");
  return bench;
}

bool run_bench_command(const BenchOptions& options) {
  const std::vector<const Problem*> chosen = chosen_problems(options.problems);
  if (options.list) {
    print_list();
    return true;
  }
  if (!options.check_tables.empty()) {
    return check_tables(options.check_tables);
  }
  if (!options.write_history.empty()) {
    const std::filesystem::path document = std::filesystem::path(options.write_history) / document_name;
    write_file(document,
               markdown::file_with_part(document, history_part, history_text(history::read(history::recorded()))));
    return true;
  }
  require_places(options);
  const bool quick = options.tier == "quick";
  const Bench bench =
      run_bench(chosen, quick ? quick_effort : full_effort, make_stamp(0, quick ? Tier::quick : Tier::full));
  fmt::print("{}", text_report(bench));
  if (!options.csv_file.empty()) {
    write_file(options.csv_file, csv_report(bench));
  }
  if (!options.markdown_file.empty()) {
    write_file(options.markdown_file, markdown_report(bench));
  }
  if (!options.report_folder.empty()) {
    const std::filesystem::path folder = options.report_folder;
    write_file(folder / page_name, html_page(page_section(bench), bench.stamp, bench.seconds));
    write_file(folder / csv_name, csv_report(bench));
  }
  if (!options.write_tables.empty()) {
    const std::filesystem::path document = std::filesystem::path(options.write_tables) / document_name;
    write_file(document, markdown::file_with_part(document, document_part, document_text(bench)));
  }
  return true;
}

Bench run_bench_for_report() {
  return run_bench(chosen_problems({}), report_effort, make_stamp(0, Tier::full));
}

}  // namespace goishi::verify::bench
