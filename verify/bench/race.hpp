#pragma once
/// \file
/// Error against run time: problems × contestants × settings. A problem has cases and their right answers; a contestant
/// with a setting answers them, and is told what its answers are worth.

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "verify/bench/clock.hpp"

namespace goishi::verify::bench {

/// What a run is judged by beside its cost. The first of a problem is the leading one.
struct Quantity {
  std::string name;  // "attitude error"
  std::string unit;  // "rad"; empty for what is counted
  bool plotted = true;
};

enum class Kind {
  direct,     // no setting
  step,       // setting: the time step [s]
  tolerance,  // setting: the tolerance
  vertices,   // setting: points of the hull in place of the stone
  rings,      // setting: of triangles, from the middle of a cap to its rim
  stones      // setting: how many, of which one is timed
};
[[nodiscard]] std::string_view to_string(Kind kind);

struct Who {
  std::string name;    // "runge-kutta-4", as in the CSV file
  std::string label;   // for people
  std::string family;  // "ours", or whose it is
  Kind kind = Kind::direct;
  std::vector<double> settings = {0};  // from coarse to fine
};

/// One contestant with one setting.
struct Entry {
  std::function<void(std::size_t first, std::size_t last)> run;  // answers these cases. This alone is timed.
  std::function<std::vector<double>()> judge;                    // what the answers are worth, in each quantity
  double items = 1;                                              // that a case consists of: the cost is of one
  bool at_once = false;                                          // all cases are answered in one go
};

/// `ask(i)` answers case i; `judge(answers)` says what they are worth.
template <class Ask, class Judge>
[[nodiscard]] Entry make_entry(std::size_t cases, Ask ask, Judge judge) {
  using Answers = std::vector<std::invoke_result_t<Ask&, std::size_t>>;
  const auto answers = std::make_shared<Answers>(cases);
  return {.run =
              [ask, answers](std::size_t first, std::size_t last) mutable {
                for (std::size_t i = first; i < last; ++i) {
                  (*answers)[i] = ask(i);
                  benchmark::ClobberMemory();
                }
              },
          .judge = [judge, answers]() -> std::vector<double> { return judge(*answers); }};
}

/// For `make_entry`, where nothing but the cost counts.
inline constexpr auto no_quantities = [](const auto& /*answers*/) { return std::vector<double>{}; };

struct Point {
  double setting = 0;
  Timing cost;                 // [ns]
  std::vector<double> values;  // of the problem's quantities; NaN where there was no answer
};

struct Curve {
  Who who;
  std::function<Entry(double setting)> enter;  // empty for who cannot take part
  std::vector<Point> points = {};              // from coarse to fine
};

/// Who has no setting: `ask(i)` answers case i, `judge(answers)` says what the answers are worth.
template <class Ask, class Judge>
[[nodiscard]] Curve make_curve(std::size_t cases, std::string name, std::string label, Ask ask, Judge judge) {
  return {.who = {std::move(name), std::move(label), "ours"},
          .enter = [=](double /*no setting*/) { return make_entry(cases, ask, judge); }};
}

struct Race {
  std::string name = {}, title = {};  // its problem's
  std::string note;                   // who gave the right answers, and what was the same for all
  std::string cost;                   // "run time of a query"
  std::vector<Quantity> quantities;
  std::string others = {};         // "grey is Odeint", where others take part
  std::vector<int> compared = {};  // powers of ten: at which leading errors to compare
  std::size_t cases = 1;           // of all contestants the same
  std::size_t block = 0;           // that a call answers, a part of all; 0: all
  bool by_case = false;            // the spread is over the cases, not over the repeats
  bool long_runs = false;          // three repeats do, and no curve ends because a run is dear
  std::vector<Curve> curves = {};  // of each contestant
};

/// Who takes part in a subject, whose problems are scenes of one type.
template <class Scene>
struct Contestant {
  Who who;
  std::function<Entry(const Scene& scene, double setting)> enter;
  std::function<bool(const Scene& scene)> can_enter = {};  // empty: all
};

/// A curve for each.
template <class Scene>
void let_enter(Race& race, const std::vector<Contestant<Scene>>& all, std::shared_ptr<const Scene> scene) {
  for (const Contestant<Scene>& one : all) {
    Curve& curve = race.curves.emplace_back(Curve{.who = one.who, .enter = {}});
    if (!one.can_enter || one.can_enter(*scene)) {
      curve.enter = [enter = one.enter, scene](double setting) { return enter(*scene, setting); };
    }
  }
}

struct Problem {
  std::string name;                                   // "spin", as on the command line and in the CSV file
  std::string title;                                  // for people
  std::function<Race(const Effort& effort)> prepare;  // finds the right answers
};

struct Subject {
  std::string name, title;  // "contact": stands for all of its problems
  std::string note;         // what is the same for all of them
  std::vector<Problem> problems;
  std::vector<Who> contestants;
  bool all_points = false;  // the document has everyone's, in all quantities
};
[[nodiscard]] const std::vector<Subject>& subjects();

/// Takes every curve's points until its settings are over, or round-off has stopped the leading error from falling
/// twice, or a run gets too dear (not where `long_runs` are meant); then times all points of all curves by turns.
void run_race(Race& race, const Effort& effort);

/// Null where it is not there.
[[nodiscard]] const Curve* curve_named(const Race& race, std::string_view name);
[[nodiscard]] const Point* point_at(const Curve& curve, double setting);
/// Of a quantity; nothing where the race does not have it.
[[nodiscard]] std::optional<double> value_of(const Race& race, const Point& point, std::string_view quantity);

/// A bound of an error, which must be reached.
struct Target {
  std::size_t quantity;
  double value;
};
struct Cost {
  double time;   // [ns]
  bool reached;  // else by the order that the last two points show
};
/// What it costs to reach all targets, interpolated with straight lines on logarithmic axes. A single point that reaches
/// them between points that do not is luck, and does not count. Nothing where the errors do not fall.
[[nodiscard]] std::optional<Cost> cost_at(const Curve& curve, const std::vector<Target>& targets);

/// The point with the least leading error; null if there is none.
[[nodiscard]] const Point* most_accurate(const Curve& curve);

}  // namespace goishi::verify::bench
