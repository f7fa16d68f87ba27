#pragma once
/// \file
/// Error against run time of one contestant on one problem.

#include <optional>
#include <string>
#include <vector>

#include "verify/work_precision/contestant.hpp"
#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench {

struct Point {
  double setting = 0;      // step [s], or tolerance
  std::uint64_t work = 0;  // steps, or evaluations
  Timing cost;             // [ns] per simulated second
  Errors errors{};         // NaN where the run did not complete
};

struct Curve {
  const Contestant* contestant = nullptr;
  std::vector<Point> points;  // from coarse to fine
};

/// One contestant on one problem: first its points with their errors, then times, one batch of each point a round. So
/// the rounds of all contestants can take turns, and whatever slows the machine for a while slows them all.
class CurveMeasurement {
 public:
  /// Takes the points: from a step of about half a turn, halved each time, or from the tolerance 1e-2, a tenth each
  /// time, until round-off has stopped the error from falling twice, or a run gets too dear.
  CurveMeasurement(const Contestant& contestant, const Problem& problem, const Reference& reference,
                   const Effort& effort);

  void time_once();
  [[nodiscard]] Curve curve() const;

 private:
  struct Timed {
    Point point;
    double argument = 0;  // of Solver::run
    Batch batch;
    std::vector<double> each;
  };

  void add(double argument, double setting);
  [[nodiscard]] Loop loop_at(double argument) const;

  const Contestant* contestant_;
  const Problem* problem_;
  const Reference* reference_;
  Effort effort_;
  std::unique_ptr<Solver> solver_;
  std::vector<Timed> timed_;
  double best_ = 1;
  int stalled_ = 0;
  bool ended_ = false;
};

/// What an attitude error costs [ns per simulated second], interpolated with straight lines on logarithmic axes; nothing
/// if the curve does not reach it. A single point below it between points above it is luck, and does not count.
[[nodiscard]] std::optional<double> cost_at(const Curve& curve, double attitude_error);

/// The point with the least attitude error; nothing if no run completed.
[[nodiscard]] std::optional<Point> most_accurate(const Curve& curve);

}  // namespace goishi::verify::bench
