#include "verify/work_precision/curve.hpp"

#include <algorithm>
#include <cmath>

namespace goishi::verify::bench {

namespace {

/// Round-off, for the purpose of stopping: a step error seldom stays above half of the one before below this.
constexpr double small_error = 1e-9;

/// A power of two; about two steps a turn.
double coarsest_steps(const Problem& problem) {
  return std::exp2(std::ceil(std::log2(problem.spin_B.norm() * problem.duration / 4)));
}

double interpolated(const Point& coarse, const Point& fine, double error) {
  const double part =
      std::log(coarse.errors.attitude / error) / std::log(coarse.errors.attitude / fine.errors.attitude);
  return coarse.cost.median * std::pow(fine.cost.median / coarse.cost.median, part);
}

}  // namespace

CurveMeasurement::CurveMeasurement(const Contestant& contestant, const Problem& problem, const Reference& reference,
                                   const Effort& effort)
    : contestant_(&contestant),
      problem_(&problem),
      reference_(&reference),
      effort_(effort),
      solver_(contestant.enter(problem)) {
  switch (contestant.kind) {
    case Kind::closed_form:
      add(1, problem.duration);
      break;
    case Kind::tolerance:
      for (int exponent = -2; exponent >= -15 && !ended_; --exponent) {
        const double tolerance = std::pow(10.0, exponent);
        add(tolerance, tolerance);
      }
      break;
    case Kind::step:
      for (double steps = coarsest_steps(problem); !ended_; steps *= 2) {
        add(steps, problem.duration / steps);
      }
      break;
  }
}

Loop CurveMeasurement::loop_at(double argument) const {
  return [solver = solver_.get(), argument](std::size_t calls) {
    for (std::size_t i = 0; i < calls; ++i) {
      solver->run(argument);
    }
  };
}

void CurveMeasurement::add(double argument, double setting) {
  const Batch batch = make_batch(loop_at(argument), effort_.batch);
  const Outcome outcome = solver_->outcome();
  const Errors errors = errors_of(outcome, *problem_, *reference_);
  timed_.push_back({.point = {.setting = setting, .work = outcome.work, .cost = {}, .errors = errors},
                    .argument = argument,
                    .batch = batch,
                    .each = {}});
  stalled_ += errors.attitude < small_error && errors.attitude > best_ / 2 ? 1 : 0;
  best_ = std::fmin(best_, errors.attitude);
  ended_ = stalled_ == 2 || batch.rough > 1e9 * effort_.dearest;
}

void CurveMeasurement::time_once() {
  for (Timed& one : timed_) {
    one.each.push_back(time_batch(loop_at(one.argument), one.batch));
  }
}

Curve CurveMeasurement::curve() const {
  Curve curve{.contestant = contestant_, .points = {}};
  for (const Timed& one : timed_) {
    curve.points.push_back(one.point);
    curve.points.back().cost = summary(one.each).per(problem_->duration);
  }
  return curve;
}

std::optional<double> cost_at(const Curve& curve, double attitude_error) {
  const std::vector<Point>& points = curve.points;
  const auto reaches = [&](std::size_t i) { return points[i].errors.attitude <= attitude_error; };  // not if NaN
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (reaches(i) && (i + 1 == points.size() || reaches(i + 1))) {
      const bool has_coarser = i > 0 && std::isfinite(points[i - 1].errors.attitude);
      return has_coarser ? interpolated(points[i - 1], points[i], attitude_error) : points[i].cost.median;
    }
  }
  return std::nullopt;
}

std::optional<Point> most_accurate(const Curve& curve) {
  std::optional<Point> best;
  for (const Point& point : curve.points) {
    if (std::isfinite(point.errors.attitude) && !(best && best->errors.attitude <= point.errors.attitude)) {
      best = point;
    }
  }
  return best;
}

}  // namespace goishi::verify::bench
