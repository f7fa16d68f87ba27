#include "verify/stress/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace goishi::verify::stress {

namespace {

bool is_finite(const State<double>& state) {
  return state.p_WB.allFinite() && state.v_WB.allFinite() && state.L_W.allFinite() && state.q_WB.coeffs().allFinite();
}

/// Gap to the nearest of what the scene has   [m].
double gap_of(const Scene& scene, const State<double>& state) {
  const Pose<double> pose{state.p_WB, state.q_WB};
  if (!scene.board) {
    return separation(scene.stone, pose, Plane<double>{Vec3<double>::UnitZ(), 0.0}).gap;
  }
  const double over_floor = separation(scene.stone, pose, Plane<double>{Vec3<double>::UnitZ(), scene.board->floor}).gap;
  return std::fmin(over_floor, separation(scene.stone, pose, *scene.board).gap);
}

bool starts_flight(EventKind kind) {
  return kind == EventKind::start || kind == EventKind::woken || kind == EventKind::impact ||
         kind == EventKind::lift_off || kind == EventKind::board_edge || kind == EventKind::side;
}

/// What holds a stone at rest: friction, and the lengths of resistance.
struct Hold {
  double friction, rolling, pivot;
};

class Judge {
 public:
  Judge(const Scene& scene, const DropResult<double>& drop)
      : scene_(scene), drop_(drop), width_(outer_width(scene.stone)), mobility_(formula::mobility(scene.body)) {}

  Verdict operator()() {
    verdict_.status = drop_.status;
    verdict_.lower_order = drop_.lower_order;
    if (!numbers()) {
      return verdict_;
    }
    if (drop_.status != DropStatus::start_inside) {
      depths();
      energies();
    }
    status();
    return verdict_;
  }

 private:
  void fault(std::string what) { verdict_.faults.push_back(std::move(what)); }

  bool numbers() {
    double last = 0.0;
    for (const Event<double>& event : drop_.events) {
      if (!(last <= event.time)) {
        fault(fmt::format("time {} after {}", event.time, last));
      }
      last = event.time;
      if (!is_finite(event.before) || !is_finite(event.after) || !std::isfinite(event.energy) ||
          !event.impulse_W.allFinite()) {
        fault(fmt::format("not a number at {} s, {}", event.time, to_string(event.kind)));
        return false;
      }
    }
    if (!is_finite(drop_.state) || drop_.events.empty()) {
      fault("no end");
      return false;
    }
    return true;
  }

  void see_depth(const State<double>& state, double time, std::string_view where) {
    const double depth = -gap_of(scene_, state) / width_;
    verdict_.depth = std::max(verdict_.depth, depth);
    // Touching is allowed to 1e-9 of the width at the start; all that follows is to round-off of the place.
    if (!(depth <= 2e-9)) {
      fault(fmt::format("{:.3g} widths deep at {} s, {}", depth, time, where));
    }
  }

  /// At events, and between two that a free flight joins (not a contact on an edge, which is passed by unrecorded hops).
  void depths() {
    const std::vector<Event<double>>& events = drop_.events;
    const std::size_t stride = events.size() / 500 + 1;
    for (std::size_t i = 0; i + 1 < events.size(); i += stride) {
      see_depth(events[i].after, events[i].time, to_string(events[i].kind));
      const double t = events[i + 1].time - events[i].time;
      const State<double> flown = formula::free_flight(events[i].after, mobility_, scene_.settings.gravity, t);
      const bool flies = starts_flight(events[i].kind) && 0.0 < t &&
                         (flown.p_WB - events[i + 1].before.p_WB).norm() <= 1e-9 * width_ &&
                         (flown.v_WB - events[i + 1].before.v_WB).norm() <= 1e-9;
      if (!flies) {
        continue;
      }
      for (const double share : {0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.98}) {
        see_depth(formula::free_flight(events[i].after, mobility_, scene_.settings.gravity, share * t),
                  events[i].time + share * t, "in flight");
      }
    }
    see_depth(drop_.state, drop_.time, "end");
    if (scene_.board) {
      see_motion();
    }
  }

  /// At times of the motion that is kept, in contact too, where the polynomial along a step is off by its tolerance.
  void see_motion() {
    Drop<double> again(scene_.stone, scene_.body, scene_.start, *scene_.board, scene_.settings);
    again.keep_motion(5000);
    static_cast<void>(again.advance_to(drop_.time));
    constexpr int looks = 200;
    const double begin = again.motion_begin(), allowed = 2e-9 + 20.0 * scene_.settings.tolerance;
    for (int i = 1; i < looks; ++i) {
      const double time = begin + i * (again.time() - begin) / looks;
      const double depth = -gap_of(scene_, again.state_at(time)) / width_;
      if (!(depth <= allowed)) {
        fault(fmt::format("{:.3g} widths deep at {} s, under way", depth, time));
        return;
      }
    }
  }

  void energies() {
    const DropSettings<double>& set = scene_.settings;
    const double m = scene_.body.mass, g = set.gravity.norm();
    const double first = drop_.events.front().energy;
    // A step of the contact phase may be wrong by its tolerance of m g w/2, and a few may add up where the stone all but
    // stands still; what is added up has round-off of the whole.
    const double allowed = 10.0 * set.tolerance * m * g * width_;
    double last = first;
    for (const Event<double>& event : drop_.events) {
      const State<double>& now = event.after;
      const double size = m * (g * now.p_WB.norm() + now.v_WB.squaredNorm()) + std::fabs(event.energy);
      const double hops = drop_.lower_order ? m * *set.edge_speed * *set.edge_speed : 0.0;
      const double rise = (event.energy - last) / (allowed + hops + 1e-13 * size + std::numeric_limits<double>::min());
      if (verdict_.energy_rise < rise) {
        verdict_.energy_rise = rise;
      }
      if (!(rise <= 1.0)) {
        fault(fmt::format("energy rises by {:.3g} J ({:.3g} of what is allowed) at {} s, {}", event.energy - last, rise,
                          event.time, to_string(event.kind)));
      }
      last = event.energy;
    }
  }

  void status() {
    const DropSettings<double>& set = scene_.settings;
    const DropCounters& done = drop_.counters;
    switch (drop_.status) {
      case DropStatus::rest:
      case DropStatus::rest_leaning:
        if (0.0 < drop_.state.v_WB.norm() + drop_.state.L_W.norm()) {
          fault("rests, and moves");
        }
        if (!(0.0 < set.gravity.norm())) {
          break;
        }
        if (drop_.status == DropStatus::rest) {
          is_balanced();
          goes_on_resting();
        } else {
          is_balanced_leaning();
        }
        break;
      case DropStatus::moving:
        if (drop_.time < *set.horizon * (1.0 - 1e-14) && done.impacts < set.maximum_impacts) {
          fault("stopped before the horizon");
        }
        break;
      case DropStatus::flies_on:
        fault("flies on, and the horizon is finite");
        break;
      case DropStatus::start_inside:
        if (!(1e-9 * width_ < drop_.depth) || !(std::fabs(gap_of(scene_, scene_.start) + drop_.depth) < 1e-12)) {
          fault("the start is not inside by the depth that it says");
        }
        break;
      case DropStatus::too_many_events:
        given_up();
        if (drop_.events.size() < static_cast<std::size_t>(set.maximum_events)) {
          fault("gave up at fewer events than allowed");
        }
        break;
      case DropStatus::too_many_steps:
        given_up();
        if (done.work() < set.maximum_steps) {
          fault("gave up at fewer steps than allowed");
        }
        break;
      case DropStatus::not_converged:
        given_up();
        break;
    }
  }

  void given_up() {
    if (scene_.physical) {
      fault(fmt::format("{} after {} s", to_string(drop_.status), drop_.time));
    }
  }

  /// Friction and resistance that a stone at rest can count on.
  [[nodiscard]] Hold hold() const {
    const DropSettings<double>& set = scene_.settings;
    const bool patch = 0.0 < *set.patch_radius && std::isfinite(set.friction);
    const bool dry =
        set.friction_model == FrictionModel::dry || (set.friction_model == FrictionModel::coulomb_contensou && !patch);
    return {.friction = dry ? set.friction : 0.0,
            .rolling = std::fmax(*set.rolling_resistance, *set.pivot_radius / 100.0),
            .pivot = std::fmax(*set.pivot_radius, *set.rolling_resistance / 100.0)};
  }

  /// On one contact, by the definition: gravity through the contact point, within the cone, its lever within the
  /// resistance.
  void is_balanced() {
    const Vec3<double>& g = scene_.settings.gravity;
    const double floor = drop_.ground == Ground::floor ? scene_.board->floor : 0.0;
    const Vec3<double> r = contact_with(Plane<double>{Vec3<double>::UnitZ(), floor}).p_stone - drop_.state.p_WB;
    const Vec3<double> torque = r.cross(-g);
    const Hold by = hold();
    const double pull = std::hypot(g.x(), g.y()), slack = 1e-12 * width_;
    const double load = std::hypot(torque.x(), torque.y()) / (by.rolling + slack),
                 pivot = torque.z() / (by.pivot + slack);
    if (!(g.z() < 0.0) || !(pull <= (by.friction + 1e-12) * -g.z())) {
      fault(fmt::format("rests where friction does not hold it: {} of {}", pull, by.friction * -g.z()));
    }
    if (!(std::hypot(load, pivot) <= -g.z() * (1.0 + 1e-9))) {
      fault(fmt::format("rests where resistance does not hold it: {:.6g} of 1", std::hypot(load, pivot) / -g.z()));
    }
  }

  template <class Other>
  [[nodiscard]] Separation<double> contact_with(const Other& other) const {
    return separation(scene_.stone, Pose<double>{drop_.state.p_WB, drop_.state.q_WB}, other);
  }

  /// On an edge or at two places: the forces that the library finds are inside the cones and the resistance, and balance.
  void is_balanced_leaning() {
    const Vec3<double>& p = drop_.state.p_WB;
    const double g = scene_.settings.gravity.norm();
    std::array<detail::Support<double>, 2> supports;
    std::size_t count = 0;
    for (const Separation<double>& contact :
         {contact_with(*scene_.board), contact_with(Plane<double>{Vec3<double>::UnitZ(), scene_.board->floor})}) {
      if (contact.gap < 1e-5 * scene_.stone.width) {
        supports[count++] = {contact.p_stone - p, contact.n_W};
      }
    }
    const Moments<double> per_mass{.axial = scene_.body.moments.z() / scene_.body.mass,
                                   .transverse = scene_.body.moments.x() / scene_.body.mass};
    const auto body = detail::contact_body(scene_.stone, per_mass, scene_.settings, g);
    detail::Balance<double, 2> balance(body, supports, count);
    static_cast<void>(balance());
    const Hold by = hold();
    Vec3<double> force = scene_.settings.gravity / g, moment = Vec3<double>::Zero();
    double greatest = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      Vec3<double> f = Vec3<double>::Zero(), torque = Vec3<double>::Zero();
      for (std::size_t i = 0; i < balance.used(); ++i) {
        if (balance.reaction(i).support == k) {
          f += balance.weight(i) * balance.reaction(i).force;
          torque += balance.weight(i) * balance.reaction(i).torque;
        }
      }
      const auto& [r, n] = supports[k];
      const double normal = f.dot(n), round_off = 1e-9 * (1.0 + f.norm());
      const Vec3<double> roll = torque - torque.dot(n) * n;
      const double share =
          std::hypot(roll.norm() / (by.rolling + 1e-12 * width_), torque.dot(n) / (by.pivot + 1e-12 * width_));
      if (!(-round_off <= normal) ||
          !((f - normal * n).norm() <= by.friction * normal + round_off || !std::isfinite(by.friction)) ||
          !(share <= normal * (1.0 + 1e-9) + round_off)) {
        fault(fmt::format("leans on a force outside its cone: {} along the normal, {} across, {} of the resistance",
                          normal, (f - normal * n).norm(), share));
      }
      greatest = std::fmax(greatest, f.norm());
      force += f;
      moment += r.cross(f) + torque;
    }
    const double left = std::hypot(force.norm(), moment.norm() / width_);
    if (!(left <= 1e-6 * greatest)) {
      fault(fmt::format("leans where nothing holds it: {:.3g} of its weight is not balanced", left));
    }
  }

  /// A drop from the place of rest rests at once, and there.
  void goes_on_resting() {
    Scene again = scene_;
    again.start = drop_.state;
    const DropResult<double> then = run(again);
    const double moved = (then.state.p_WB - drop_.state.p_WB).norm() / width_;
    const bool rests = then.status == DropStatus::rest || then.status == DropStatus::rest_leaning;
    // Beside a side it may touch that, too, and hop.
    const double hop = drop_.lower_order ? 20.0 * *scene_.settings.edge_speed * *scene_.settings.edge_speed /
                                               (scene_.settings.gravity.norm() * width_)
                                         : 0.0;
    if (!rests || !(moved <= 1e-9 + hop)) {
      fault(fmt::format("dropped from its place of rest it ends as '{}' after {} s, {:.3g} widths away",
                        to_string(then.status), then.time, moved));
    }
  }

  const Scene& scene_;
  const DropResult<double>& drop_;
  double width_;
  Mobility<double> mobility_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(const Scene& scene, const DropResult<double>& drop) {
  return Judge(scene, drop)();
}

}  // namespace goishi::verify::stress
