#include <fmt/format.h>

#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench::contact {

namespace {

constexpr std::size_t name_width = 42;
constexpr std::size_t number_width = 12;

std::string text_table(const Race& race) {
  std::string out = fmt::format("\n{}: {}\n  right answer: {}\n  {}", race.problem->name, race.problem->title,
                                race.witness, padded("", name_width));
  for (const char* head : {"a query", "greatest", "median", "unanswered"}) {
    out += right_aligned(head, number_width);
  }
  out += "\n";
  for (const Curve& curve : race.curves) {
    for (const Point& point : curve.points) {
      out += "  " + padded(point_name(*curve.contestant, point.setting), name_width);
      out += right_aligned(time_text(point.cost.median), number_width);
      out += right_aligned(plain_number(point.errors.greatest, 2), number_width);
      out += right_aligned(plain_number(point.errors.median, 2), number_width);
      out += right_aligned(point.errors.unanswered == 0 ? "" : std::to_string(point.errors.unanswered), number_width);
      out += "\n";
    }
  }
  return out;
}

}  // namespace

std::string text_tables(const std::vector<Race>& races) {
  std::string out;
  if (!races.empty()) {
    out = fmt::format("\nContact: run time of a query, and its error [m], over {} poses\n", races.front().poses);
  }
  for (const Race& race : races) {
    out += text_table(race);
  }
  return out;
}

/// The columns of motion between are empty, and so is the work.
std::string csv_rows(const Race& race) {
  std::string out;
  for (const Curve& curve : race.curves) {
    const Contestant& who = *curve.contestant;
    const char* kind = who.kind == Kind::direct ? "direct" : who.kind == Kind::vertices ? "vertices" : "tolerance";
    for (const auto& [setting, cost, errors] : curve.points) {
      out += fmt::format("{},{},{},{},{},,,,,,,,{:.5g},{:.5g},{:.5g},{:.4g},{:.4g},{}\n", race.problem->name, who.name,
                         who.ours ? "ours" : "rival", kind, who.kind == Kind::direct ? "" : fmt::format("{}", setting),
                         cost.median, cost.lower, cost.upper, errors.greatest, errors.median, errors.unanswered);
    }
  }
  return out;
}

}  // namespace goishi::verify::bench::contact
