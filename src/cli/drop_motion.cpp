#include "drop_motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "compiled/drop.hpp"

namespace goishi::cli {

namespace {

/// The states between two events.
class Between {
 public:
  Between(const DropScene& scene, const Event<double>& from, const Event<double>& to)
      : scene_(scene),
        from_(from),
        to_(to),
        rates_(formula::top_rates(
            Moments<double>{.axial = scene.body.moments.z(), .transverse = scene.body.moments.x()})) {}

  /// At times that rise, all of them between the events.
  [[nodiscard]] std::vector<State<double>> at(const std::vector<double>& times) const {
    if (to_.kind == EventKind::bounces_close) {
      return each(times, [this](double t) { return bouncing(t); });
    }
    if (flies()) {
      return each(times, [this](double t) { return flown(t); });
    }
    std::vector<State<double>> states = continued(times);
    if (!leads_there(states.back())) {
      return each(times, [this](double t) { return dropped(t).state; });
    }
    states.pop_back();
    return states;
  }

 private:
  template <class Function>
  [[nodiscard]] static std::vector<State<double>> each(const std::vector<double>& times, const Function& state) {
    std::vector<State<double>> states;
    std::ranges::transform(times, std::back_inserter(states), state);
    return states;
  }

  [[nodiscard]] const Vec3<double>& gravity() const { return scene_.settings.gravity; }

  [[nodiscard]] State<double> flown(double t) const {
    return formula::free_flight(from_.after, rates_, gravity(), t - from_.time);
  }

  /// Whether flight leads from the one event to the other: a contact that bears weight for a time t changes the velocity
  /// by about g t. A lift-off may change it by `contact_speed`.
  [[nodiscard]] bool flies() const {
    const State<double> there = flown(to_.time);
    const double slack = 2 * *filled(scene_.settings, scene_.stone, gravity().norm()).contact_speed;
    const double round_off = 1e-12;
    const double t = to_.time - from_.time;
    return (there.v_WB - to_.before.v_WB).norm() <= slack + round_off * there.v_WB.norm() &&
           (there.p_WB - to_.before.p_WB).norm() <= slack * t + round_off * (1 + there.p_WB.norm());
  }

  /// Within the bounces that the drop sums: after v come e v, e² v …, each of which lasts 2 v/g.
  [[nodiscard]] State<double> bouncing(double t) const {
    State<double> state = from_.after;
    const double v = state.v_WB.z(), g = -gravity().z(), e = scene_.settings.restitution;
    const double first = 2 * v / g;
    const double log_e = std::log(e);  // e = 0 leaves nothing to sum
    const auto begin = [&](double bounce) { return -first * std::expm1(bounce * log_e) / (1 - e); };
    const double past = t - from_.time;
    const double left = 1 - past * (1 - e) / first;
    double bounce = 0 < left ? std::floor(std::log(left) / log_e) : 0;
    bounce = begin(bounce + 1) <= past ? bounce + 1 : bounce;
    const double s = std::max(0.0, past - begin(bounce));
    const double up = v * std::pow(e, bounce);
    state.v_WB.z() = 0;
    state = formula::free_flight(state, rates_, Vec3<double>(Vec3<double>::Zero()), past);
    if (0 < left) {
      state.p_WB.z() += std::max(0.0, s * (up - g * s / 2));
      state.v_WB.z() = up - g * s;
    }
    return state;
  }

  /// Goes on from row to row, and to the next event: one state more than times.
  [[nodiscard]] std::vector<State<double>> continued(std::vector<double> times) const {
    times.push_back(to_.time);
    DropSettings<double> settings = scene_.settings;
    settings.maximum_impacts = std::numeric_limits<int>::max();
    Drop<double> here;
    here.state = from_.after;
    here.time = from_.time;
    return each(times, [&](double t) {
      if (here.time < t) {
        settings.horizon = t;
        here = woken(here, scene_.stone, scene_.body, scene_.board ? &*scene_.board : nullptr, settings);
        here.time = t;  // whatever stopped it, such as rest
      }
      return here.state;
    });
  }

  /// Whether a state is that of the next event. Going on from row to row costs 10 tolerances, as a rule, and not less
  /// than 1e-8 of the width (measured 2026-11-22); a plot shows 1e-3.
  [[nodiscard]] bool leads_there(const State<double>& state) const {
    const double slack = std::clamp(1e3 * scene_.settings.tolerance, 1e-6, 1e-3);
    const double off = (formula::symmetry_axis(state.q_WB) - formula::symmetry_axis(to_.before.q_WB)).norm();
    return off <= slack && (state.p_WB - to_.before.p_WB).norm() <= slack * outer_width(scene_.stone);
  }

  [[nodiscard]] Drop<double> dropped(double t) const {
    DropScene scene = scene_;
    scene.settings.horizon = t;
    return drop_of(scene);
  }

  const DropScene& scene_;
  const Event<double>& from_;
  const Event<double>& to_;
  TopRates<double> rates_;
};

}  // namespace

DropSample sample_of(const DropScene& scene, double time, const State<double>& state) {
  const Vec3<double> u = formula::symmetry_axis(state.q_WB);
  return {.time = time,
          .state = state,
          .w_WB_B = formula::angular_velocity_B(state, scene.body),
          .tilt = std::atan2(std::hypot(u.x(), u.y()), u.z()) * 180 / std::numbers::pi,
          .energy = formula::energy(state, scene.body, scene.settings.gravity)};
}

Drop<double> drop_of(const DropScene& scene) {
  return scene.board ? drop(scene.stone, scene.body, scene.start, *scene.board, scene.settings)
                     : drop(scene.stone, scene.body, scene.start, scene.settings);
}

std::string_view to_string(Touched touched) {
  constexpr std::string_view names[] = {"nothing", "board", "plane", "floor"};
  return names[static_cast<std::size_t>(touched)];
}

Touched touched_at(const DropScene& scene, const Event<double>& event) {
  if (!event.contact_W.allFinite()) {
    return Touched::nothing;
  }
  if (!scene.board) {
    return Touched::plane;
  }
  const bool low = event.contact_W.z() < scene.board->floor / 2;
  return low && event.other_feature == OtherFeature::surface ? Touched::floor : Touched::board;
}

Touched touched_last(const DropScene& scene, const Drop<double>& drop) {
  switch (drop.ground) {
    case Ground::none:
      return Touched::nothing;
    case Ground::board:
      return scene.board ? Touched::board : Touched::plane;
    case Ground::floor:
      break;
  }
  return Touched::floor;
}

std::vector<DropSample> series_of(const DropScene& scene, const Drop<double>& drop, int rows) {
  std::vector<DropSample> samples;
  samples.reserve(static_cast<std::size_t>(rows));
  std::vector<double> times;
  const auto time_of = [&](int row) { return drop.time * row / (rows - 1); };
  int row = 0;
  for (std::size_t i = 0; i + 1 < drop.events.size(); ++i) {
    const Event<double>& from = drop.events[i];
    const Event<double>& to = drop.events[i + 1];
    times.clear();
    for (; row + 1 < rows && time_of(row) < to.time; ++row) {
      times.push_back(time_of(row));
    }
    if (times.empty()) {
      continue;
    }
    const std::vector<State<double>> states = Between(scene, from, to).at(times);
    for (std::size_t j = 0; j < times.size(); ++j) {
      samples.push_back(sample_of(scene, times[j], states[j]));
    }
  }
  for (; row < rows; ++row) {
    samples.push_back(sample_of(scene, time_of(row), drop.state));
  }
  return samples;
}

}  // namespace goishi::cli
