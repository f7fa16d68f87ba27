#include <fmt/format.h>

#include <algorithm>

#include "verify/work_precision/bench.hpp"
#include "verify/work_precision/contact/report.hpp"

namespace goishi::verify::bench {

namespace {

/// Columns that only drops have, empty.
std::string padded(const std::string& rows) {
  const std::string columns = drops::csv_columns;
  const auto missing = static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ',')) + 1;
  std::string out;
  for (const char letter : rows) {
    out += letter == '\n' ? std::string(missing, ',') + "\n" : std::string(1, letter);
  }
  return out;
}

}  // namespace

/// One line a point; an error that does not exist, because the run did not complete, is `nan`. What a problem of
/// motion, of contact or of drops does not have is empty.
std::string csv_report(const Bench& bench) {
  std::string out =
      "problem,contestant,family,kind,setting,steps_or_evaluations,ns_per_simulated_second,"
      "ns_per_simulated_second_q1,ns_per_simulated_second_q3,attitude_error,energy_error,momentum_error,"
      "ns_per_query,ns_per_query_q1,ns_per_query_q3,greatest_gap_error_m,median_gap_error_m,unanswered,";
  out += std::string(drops::csv_columns) + "\n";
  std::string rows;
  for (const Race& race : bench.races) {
    for (const Curve& curve : race.curves) {
      const Contestant& who = *curve.contestant;
      for (const Point& point : curve.points) {
        const auto& [setting, work, cost, errors] = point;
        rows += fmt::format("{},{},{},{},{},{},{:.5g},{:.5g},{:.5g},{:.4g},{:.4g},{:.4g},,,,,,\n", race.problem->name,
                            who.name, who.family == Family::ours ? "ours" : "odeint",
                            who.kind == Kind::tolerance ? "tolerance" : "step", setting, work, cost.median, cost.lower,
                            cost.upper, errors.attitude, errors.energy, errors.momentum);
      }
    }
  }
  for (const contact::Race& race : bench.contact_races) {
    rows += contact::csv_rows(race);
  }
  out += padded(rows);
  return bench.drops ? out + drops::csv_rows(*bench.drops) : out;
}

}  // namespace goishi::verify::bench
