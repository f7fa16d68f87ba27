#include "verify/report/markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::markdown {

namespace {

/// By the folders of verify/claims. A folder without a title here stands behind these, by its name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> subjects = {{
    {"scalar", "Elementary functions"},
    {"shape", "Shape: surface, board, rays"},
    {"mass", "Mass: volume, inertia, table"},
    {"mesh", "Meshes: triangles, what they enclose, boxes"},
    {"motion", "Motion: free flight, steppers"},
    {"contact", "Contact: gaps, time of impact"},
    {"impact", "Impact: laws, friction"},
    {"drop", "Drop: from a fall to rest"},
    {"scene", "Scene: a board with many stones"},
    {"enclosure", "Enclosures: the formulas on balls"},
    {"published", "Published: the talk's numbers"},
}};

constexpr std::size_t statement_width = 140;

constexpr std::string_view subjects_head =
    "| subject | claims | witnesses | weakest check | error | bound |\n"
    "|---|---:|---|---|---:|---|\n";
constexpr std::string_view claims_head =
    "| claim | statement | witness | weakest check | error | bound |\n"
    "|---|---|---|---|---:|---|\n";

/// Text in a cell: one line, and no character of it is markup.
std::string cell(std::string_view text) {
  const std::string plain = printable(text);
  const auto is_word = [&](std::size_t at) {
    return at < plain.size() && std::isalnum(static_cast<unsigned char>(plain[at]));
  };
  std::string result;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const bool joins = plain[i] == '_' && 0 < i && is_word(i - 1) && is_word(i + 1);  // as in I_a
    if (std::string_view("\\`*_|<[]~$&").find(plain[i]) != std::string_view::npos && !joins) {
      result += '\\';
    }
    result += plain[i];
  }
  return result;
}

std::string cut(std::string_view text) {
  const std::vector<std::string> lines = wrapped(text, statement_width);
  return lines.size() == 1 ? lines.front() : lines.front() + " …";
}

/// A row: the cells before its error, the error, and the cells behind it.
struct Row {
  std::string before;
  double error = 0.0;
  double resolution = 0.0;  // a smaller error counts as this much
  int digits = 2;
  std::string after;

  [[nodiscard]] std::string text() const { return fmt::format("{}{}{}", before, plain_number(error, digits), after); }
};

/// A line of a table. The first row is written; the others, with a check that is nearly as weak, may stand there, too.
struct Line {
  std::string name;
  std::vector<Row> rows;
};

/// A check of a claim.
struct Candidate {
  const Result* result;
  std::size_t check;

  [[nodiscard]] const Claim& claim() const { return *result->claim; }
  [[nodiscard]] Checked checked() const { return result->checked(check); }
  /// The greatest is the weakest; one that fails is weaker than all that hold.
  [[nodiscard]] double part() const {
    const Judgement& judgement = checked().judgement;
    return judgement.holds ? judgement.part : std::numeric_limits<double>::infinity();
  }
};

/// The checks of these results that are the weakest, or may be on another processor; the weakest first.
std::vector<Candidate> weakest(const std::vector<const Result*>& results) {
  std::vector<Candidate> found;
  for (const Result* result : results) {
    for (std::size_t i = 0; i < result->claim->checks.size(); ++i) {
      found.push_back({result, i});
    }
  }
  const auto is_exact = [](const Candidate& candidate) { return candidate.checked().check.bound == 0.0; };
  if (!std::ranges::all_of(found, is_exact)) {
    std::erase_if(found, is_exact);
  }
  std::ranges::stable_sort(found, std::greater<>(), &Candidate::part);
  std::erase_if(found, [&, most = found.empty() ? 0.0 : found.front().part()](const Candidate& candidate) {
    return candidate.part() * greatest_change * greatest_change < most;
  });
  return found;
}

Row row(const std::string& before, const Candidate& candidate) {
  const Check& check = candidate.checked().check;
  const double error = candidate.checked().measured.error;
  const int digits = digits_to_tell(error, check.bound, 2);
  return {.before = before,
          .error = error,
          .resolution = check.resolution,
          .digits = digits,
          .after = fmt::format(" | {}{}{} |", plain_number(check.bound, std::max(3, digits)),
                               check.unit.empty() ? "" : " ", cell(check.unit))};
}

/// "exact solution 3, relation 2", in the order of the families.
std::string families_of(const std::vector<const Result*>& results) {
  std::map<OracleFamily, int> counts;
  for (const Result* result : results) {
    ++counts[result->claim->family];
  }
  std::vector<std::string> parts;
  for (const auto& [family, count] : counts) {
    parts.push_back(fmt::format("{} {}", to_string(family), count));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<Line> subject_lines(const Run& run) {
  std::vector<std::pair<std::string, std::vector<const Result*>>> folders;
  for (const auto& [folder, title] : subjects) {
    folders.emplace_back(folder, std::vector<const Result*>());
  }
  for (const Result& result : run.results) {
    const std::string folder = result.claim->subject();
    auto found = std::ranges::find(folders, folder, &decltype(folders)::value_type::first);
    if (found == folders.end()) {
      found = folders.insert(folders.end(), {folder, {}});
    }
    found->second.push_back(&result);
  }
  std::vector<Line> lines;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const auto& [folder, results] = folders[i];
    if (results.empty()) {
      continue;
    }
    const std::string name(i < subjects.size() ? subjects[i].second : cell(folder));
    Line line{name, {}};
    for (const Candidate& candidate : weakest(results)) {
      const std::string& check = candidate.checked().check.name;
      line.rows.push_back(row(fmt::format("| {} | {} | {} | {}{} | ", name, results.size(), families_of(results),
                                          cell(candidate.claim().id), check.empty() ? "" : ": " + cell(check)),
                              candidate));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> claim_lines(const Run& run) {
  std::vector<Line> lines;
  for (const Result& result : run.results) {
    const Claim& claim = *result.claim;
    Line line{cell(claim.id), {}};
    for (const Candidate& candidate : weakest({&result})) {
      line.rows.push_back(row(fmt::format("| {} | {} | {} | {} | ", cell(claim.id), cell(cut(claim.statement)),
                                          to_string(claim.family), cell(candidate.checked().check.name)),
                              candidate));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string table(std::string_view head, const std::vector<Line>& lines) {
  std::string result(head);
  for (const Line& line : lines) {
    if (!line.rows.empty()) {
      result += line.rows.front().text() + "\n";
    }
  }
  return result;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool is_near(double printed, double error, double resolution) {
  const double a = std::max(printed, resolution), b = std::max(error, resolution);
  return a == b || (a <= greatest_change * b && b <= greatest_change * a);
}

bool matches(std::string_view written, const Row& row) {
  if (written.size() < row.before.size() + row.after.size() || !written.starts_with(row.before) ||
      !written.ends_with(row.after)) {
    return false;
  }
  const std::string_view number =
      written.substr(row.before.size(), written.size() - row.before.size() - row.after.size());
  double printed = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), printed);
  return error == std::errc() && end == number.data() + number.size() && is_near(printed, row.error, row.resolution);
}

std::vector<std::string> differences(std::string_view written, std::string_view head, const std::vector<Line>& lines) {
  if (!written.starts_with(head)) {
    return {fmt::format("the table does not begin with {}", lines_of(head).front())};
  }
  const std::vector<std::string_view> rows = lines_of(written.substr(head.size()));
  std::vector<std::string> found;
  std::vector<std::string> names;
  for (const Line& line : lines) {
    names.push_back(fmt::format("| {} |", line.name));
    const auto row = std::ranges::find_if(rows, [&](std::string_view text) { return text.starts_with(names.back()); });
    if (row == rows.end()) {
      found.push_back(fmt::format("{}: the row is missing", line.name));
    } else if (std::ranges::none_of(line.rows, [&](const Row& one) { return matches(*row, one); })) {
      found.push_back(fmt::format("{}: it says\n  {}\nand the run gives\n  {}", line.name, *row,
                                  line.rows.empty() ? "nothing" : line.rows.front().text()));
    }
  }
  std::size_t in_order = 0;
  for (const std::string_view row : rows) {
    if (in_order < names.size() && row.starts_with(names[in_order])) {
      ++in_order;
    } else if (std::ranges::none_of(names, [&](const std::string& name) { return row.starts_with(name); })) {
      found.push_back(fmt::format("nothing in the run is called as this row: {}", row));
    }
  }
  if (found.empty() && (in_order != names.size() || rows.size() != names.size())) {
    found.emplace_back("the rows are not in the order of the run, or there twice");
  }
  return found;
}

}  // namespace

std::string subjects_table(const Run& run) {
  return table(subjects_head, subject_lines(run));
}

std::string claims_table(const Run& run) {
  return table(claims_head, claim_lines(run));
}

std::vector<std::string> subjects_differences(std::string_view table, const Run& run) {
  return differences(table, subjects_head, subject_lines(run));
}

std::vector<std::string> claims_differences(std::string_view table, const Run& run) {
  return differences(table, claims_head, claim_lines(run));
}

}  // namespace goishi::verify::markdown
