#include "verify/work_precision/contact/race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/report/number.hpp"

namespace goishi::verify::bench::contact {

namespace {

Errors errors_of(const std::vector<double>& answers, const Scene& scene) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (std::isfinite(answers[i])) {
      errors.push_back(std::fabs(answers[i] - scene.right[i]) * scene.rate[i]);
    }
  }
  const std::size_t unanswered = answers.size() - errors.size();
  if (errors.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {.greatest = none, .median = none, .unanswered = unanswered};
  }
  std::sort(errors.begin(), errors.end());
  return {.greatest = errors.back(), .median = errors[errors.size() / 2], .unanswered = unanswered};
}

/// One contestant with one setting.
class PointMeasurement {
 public:
  PointMeasurement(const Contestant& contestant, double setting, const Scene& scene, const Effort& effort)
      : contestant_(&contestant), setting_(setting), scene_(&scene), asker_(contestant.enter(scene, setting)) {
    batch_ = make_batch(loop(), effort.batch);
    const auto rounds = static_cast<std::size_t>(effort.repeats);
    batch_.calls = std::max(batch_.calls, (scene.size() + rounds - 1) / rounds);
  }

  void time_once() { each_.push_back(time_batch(loop(), batch_)); }

  [[nodiscard]] const Contestant* contestant() const { return contestant_; }
  [[nodiscard]] Point point() const {
    return {.setting = setting_, .cost = summary(each_), .errors = errors_of(asker_->answers(), *scene_)};
  }

 private:
  [[nodiscard]] Loop loop() {
    return [this](std::size_t calls) {
      asker_->ask(next_, calls);
      next_ = (next_ + calls) % scene_->size();
    };
  }

  const Contestant* contestant_;
  double setting_;
  const Scene* scene_;
  std::unique_ptr<Asker> asker_;
  Batch batch_;
  std::size_t next_ = 0;
  std::vector<double> each_;
};

}  // namespace

Race run_race(const Scene& scene, const Effort& effort, const std::function<void()>& round_done) {
  std::vector<PointMeasurement> running;
  for (const Contestant& contestant : contestants()) {
    if (!contestant.can_enter(*scene.problem)) {
      continue;
    }
    for (const double setting : contestant.settings) {
      running.emplace_back(contestant, setting, scene, effort);
    }
  }
  for (int i = 0; i < effort.repeats; ++i) {
    for (PointMeasurement& one : running) {
      one.time_once();
    }
    round_done();
  }
  Race race{.problem = scene.problem, .witness = scene.witness, .poses = scene.size(), .curves = {}};
  for (const PointMeasurement& one : running) {
    if (race.curves.empty() || race.curves.back().contestant != one.contestant()) {
      race.curves.push_back({.contestant = one.contestant(), .points = {}});
    }
    race.curves.back().points.push_back(one.point());
  }
  return race;
}

const Curve* curve_named(const Race& race, std::string_view name) {
  const auto found = std::find_if(race.curves.begin(), race.curves.end(),
                                  [&](const Curve& curve) { return curve.contestant->name == name; });
  return found == race.curves.end() ? nullptr : &*found;
}

std::string point_name(const Contestant& who, double setting) {
  switch (who.kind) {
    case Kind::vertices:
      return fmt::format("{} of {} points", who.label, setting);
    case Kind::tolerance:
      return fmt::format("{}, tolerance {}", who.label, plain_number(setting));
    case Kind::direct:
      break;
  }
  return who.label;
}

}  // namespace goishi::verify::bench::contact
