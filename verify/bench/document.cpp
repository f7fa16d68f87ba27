#include <fmt/format.h>

#include <algorithm>

#include "verify/bench/native.hpp"
#include "verify/bench/report.hpp"

namespace goishi::verify::bench {

namespace {

std::string heading(const Subject& subject) {
  return fmt::format("### {}", subject.title);
}

/// How the first row of a problem begins.
std::string row_begin(const Problem& problem) {
  return fmt::format("`{}`: {}", problem.name, problem.title);
}

/// The heading of a problem of which all points are there.
std::string problem_heading(const Problem& problem) {
  return fmt::format("#### `{}`: {}", problem.name, problem.title);
}

constexpr std::string_view measured_begin = "Measured on ";

/// Nothing of what is counted.
std::string error_text(const Race& race, const Point& point) {
  if (race.quantities.empty() || race.quantities.front().unit.empty()) {
    return "";
  }
  const Quantity& leading = race.quantities.front();
  return fmt::format("{} {}", leading.name, value_text(leading, point.values.front()));
}

void add_rows(const Problem& problem, const Race& race, Table& table) {
  auto add = [&, first = true](const Who& who, const Point& point) mutable {
    table.rows.push_back({.cells = {first ? fmt::format("{} ({})", row_begin(problem), race.cost) : "",
                                    point_name(who, point.setting), time_text(point.cost.median),
                                    race.by_case ? time_text(point.cost.late) : "", error_text(race, point)},
                          .holds = {}});
    first = false;
  };
  const Curve* other = nullptr;
  const Point* best = nullptr;
  for (const Curve& curve : race.curves) {
    if (curve.who.family != "ours") {
      const Point* const one = most_accurate(curve);
      if (one != nullptr && (best == nullptr || one->values.front() < best->values.front())) {
        other = &curve;
        best = one;
      }
    } else if (curve.who.kind != Kind::step) {
      for (const Point& point : curve.points) {
        add(curve.who, point);
      }
    }
  }
  if (best != nullptr) {
    add(other->who, *best);
  }
}

/// Without the columns in which nothing stands.
Table table_of(const Subject& subject, const Bench& bench) {
  Table table{.caption = "", .head = {"problem", "who", "median", "ninetieth percentile", "error"}, .rows = {}};
  for (const Problem& problem : subject.problems) {
    for (const Race& race : bench.races) {
      if (race.name == problem.name) {
        add_rows(problem, race, table);
      }
    }
  }
  for (std::size_t i = table.head.size(); i-- > 0;) {
    if (std::ranges::all_of(table.rows, [&](const Table::Row& row) { return row.cells[i].empty(); })) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      table.head.erase(table.head.begin() + at);
      for (Table::Row& row : table.rows) {
        row.cells.erase(row.cells.begin() + at);
      }
    }
  }
  return table;
}

/// What is the same for all, and each problem's table as the page has it.
std::string all_points(const Subject& subject, const Bench& bench) {
  std::string out = subject.note + "\n";
  const Section page = page_section(bench);
  for (const Problem& problem : subject.problems) {
    for (std::size_t i = 0; i < bench.races.size(); ++i) {
      if (bench.races[i].name == problem.name) {
        const Section& part = page.parts[i];
        out += fmt::format("\n{}\n\n{}\n\n{}", problem_heading(problem), part.paragraphs.front(),
                           piped(part.tables.front()));
      }
    }
  }
  return out;
}

}  // namespace

std::string document_text(const Bench& bench) {
  const Stamp& stamp = bench.stamp;
  std::string out = fmt::format("{}{}, by {}, on {}; the SIMD batch is compiled for {}.\n", measured_begin,
                                stamp.machine, stamp.compiler, stamp.time.substr(0, stamp.time.find('T')),
                                native_level().empty() ? "the compiler's default" : native_level());
  for (const Subject& subject : subjects()) {
    out += fmt::format("\n{}\n\n{}", heading(subject),
                       subject.all_points ? all_points(subject, bench) : piped(table_of(subject, bench)));
  }
  return out;
}

std::vector<std::string> document_differences(std::string_view part) {
  std::vector<std::string> wanted = {std::string(measured_begin)};
  for (const Subject& subject : subjects()) {
    wanted.push_back(heading(subject));
    for (const Problem& problem : subject.problems) {
      wanted.push_back(subject.all_points ? problem_heading(problem) : fmt::format("| {} (", row_begin(problem)));
    }
  }
  std::vector<std::string> found;
  auto next = wanted.begin();
  for (std::size_t begin = 0; begin < part.size();) {
    const std::size_t end = std::min(part.find('\n', begin), part.size());
    const std::string_view line = part.substr(begin, end - begin);
    begin = end + 1;
    if (next != wanted.end() && line.starts_with(*next)) {
      ++next;
    } else if (line.starts_with("### ") || line.starts_with("#### ") || line.starts_with("| `")) {
      found.push_back(fmt::format("no problem is called so, or it stands elsewhere: {}", line));
    }
  }
  for (; next != wanted.end(); ++next) {
    found.push_back(fmt::format("nothing begins with: {}", *next));
  }
  return found;
}

}  // namespace goishi::verify::bench
