#include "verify/bench/history/history.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace goishi::verify::bench::history {

namespace {

constexpr std::string_view columns = "problem,commit,tolerance,ns,ns_p90,error,error_p90";
constexpr std::array<std::string_view, 9> names = {"old",     "old-date", "new",   "new-date", "measured",
                                                   "machine", "compiler", "drops", "rounds"};

[[noreturn]] void fail(int line, const std::string& what) {
  throw std::runtime_error("drops.csv, line " + std::to_string(line) + ": " + what);
}

/// The parts of a line between commas.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

double positive(std::string_view text, int line) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(0 < value) || !std::isfinite(value)) {
    fail(line, "'" + std::string(text) + "' is no positive number");
  }
  return value;
}

void take_fact(std::string_view text, int line, History& history) {
  const std::size_t colon = text.find(": ");
  const std::string name(text.substr(0, colon));
  if (colon == std::string_view::npos || std::find(names.begin(), names.end(), name) == names.end() ||
      text.size() == colon + 2) {
    fail(line, "no fact '" + name + "' is known");
  }
  history.facts[name] = text.substr(colon + 2);
}

void take_point(std::string_view text, int line, History& history) {
  const std::vector<std::string_view> cells = cells_of(text);
  if (cells.size() != 7) {
    fail(line, "there must be 7 cells");
  }
  if (history.curves.empty() || history.curves.back().problem != cells[0] || history.curves.back().commit != cells[1]) {
    history.curves.push_back({std::string(cells[0]), std::string(cells[1]), {}});
  }
  std::vector<Point>& points = history.curves.back().points;
  const Point point{positive(cells[2], line), positive(cells[3], line), positive(cells[4], line),
                    positive(cells[5], line), positive(cells[6], line)};
  if (!points.empty() && !(point.tolerance < points.back().tolerance)) {
    fail(line, "the tolerances of a curve must fall");
  }
  points.push_back(point);
}

void require_whole(const History& history, int line) {
  for (const std::string_view name : names) {
    if (!history.facts.contains(std::string(name))) {
      fail(line, "there is no fact '" + std::string(name) + "'");
    }
  }
  const std::vector<Curve>& curves = history.curves;
  if (curves.empty() || curves.size() % 2 != 0) {
    fail(line, "there must be two curves of each problem");
  }
  for (std::size_t i = 0; i < curves.size(); i += 2) {
    const Curve &old = curves[i], &now = curves[i + 1];
    if (old.problem != now.problem || old.commit != history.facts.at("old") || now.commit != history.facts.at("new")) {
      fail(line, "of '" + old.problem + "' there must be the old curve, and then the new one");
    }
    const auto same = [](const Point& a, const Point& b) { return a.tolerance == b.tolerance; };
    if (!std::equal(old.points.begin(), old.points.end(), now.points.begin(), now.points.end(), same)) {
      fail(line, "both curves of '" + old.problem + "' must have the same tolerances");
    }
  }
}

}  // namespace

History read(std::string_view file) {
  History history;
  bool has_columns = false;
  int line = 0;
  for (std::size_t begin = 0; begin < file.size();) {
    const std::size_t end = std::min(file.find('\n', begin), file.size());
    const std::string_view text = file.substr(begin, end - begin);
    begin = end + 1;
    ++line;
    if (text.starts_with("# ")) {
      take_fact(text.substr(2), line, history);
    } else if (has_columns) {
      take_point(text, line, history);
    } else if (text == columns) {
      has_columns = true;
    } else {
      fail(line, "the columns must be " + std::string(columns));
    }
  }
  require_whole(history, line);
  return history;
}

}  // namespace goishi::verify::bench::history
