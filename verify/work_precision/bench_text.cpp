#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"
#include "verify/work_precision/bench.hpp"
#include "verify/work_precision/contact/report.hpp"
#include "verify/work_precision/native.hpp"

namespace goishi::verify::bench {

namespace {

constexpr std::size_t name_width = 24;
constexpr std::size_t cost_width = 10;

std::string race_table(const Race& race) {
  std::string out = fmt::format("\n{}: {}\n  right answer: {}\n  {}", race.problem->name, race.problem->title,
                                race.witness, padded("run time per second, at", name_width + 2));
  for (const int exponent : compared_errors) {
    out += right_aligned(fmt::format("1e{}", exponent), cost_width);
  }
  out += right_aligned("least error", 15) + "\n";
  for (const Curve& curve : race.curves) {
    out += "  " + padded(curve.contestant->label, name_width + 2);
    for (const int exponent : compared_errors) {
      const std::optional<double> cost = cost_at(curve, std::pow(10.0, exponent));
      out += right_aligned(cost ? time_text(*cost) : "-", cost_width);
    }
    const std::optional<Point> best = most_accurate(curve);
    out += right_aligned(best ? plain_number(best->errors.attitude, 2) : "-", 15) + "\n";
  }
  return out;
}

std::string bar_table(const std::vector<Bar>& bars) {
  std::size_t name = 0;
  std::size_t wanted = 0;
  for (const Bar& bar : bars) {
    name = std::max(name, columns(bar.name));
    wanted = std::max(wanted, columns(bar.wanted));
  }
  std::string out = "\nBars\n";
  for (const Bar& bar : bars) {
    out += fmt::format("  {}  {}  {}  {}\n", padded(bar.held ? "held" : "NOT HELD", 8), padded(bar.name, name),
                       padded(bar.wanted, wanted), bar.measured);
  }
  return out;
}

}  // namespace

std::string time_text(double nanoseconds) {
  const int digits = 3;
  if (nanoseconds < 999.5) {
    return plain_number(nanoseconds, digits) + " ns";
  }
  if (nanoseconds < 999.5e3) {
    return plain_number(nanoseconds / 1e3, digits) + " µs";
  }
  return plain_number(nanoseconds / 1e6, digits) + " ms";
}

std::string text_report(const Bench& bench) {
  const Stamp& stamp = bench.stamp;
  std::string out = fmt::format("Medians of processor time.\n{}\n{}\ncommit {}, {}\nSIMD batch compiled for {}\n",
                                stamp.machine, stamp.compiler, stamp.commit, stamp.time,
                                native_level().empty() ? "the compiler's default" : native_level());
  if (!bench.races.empty()) {
    out += "\nMotion: run time per simulated second, interpolated at equal attitude error [rad]\n";
  }
  for (const Race& race : bench.races) {
    out += race_table(race);
  }
  out += contact::text_tables(bench.contact_races);
  if (bench.drops) {
    out += drops::text_tables(*bench.drops);
  }
  out += bar_table(bars_of(bench));
  return out + fmt::format("\nTook {}\n", duration(bench.seconds));
}

}  // namespace goishi::verify::bench
