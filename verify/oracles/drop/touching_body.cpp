#include "verify/oracles/drop/touching_body.hpp"

// Odeint copies a stepper's empty scratch space.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#pragma GCC diagnostic pop

#include <cmath>
#include <limits>
#include <numbers>

#include "verify/oracles/drop/touching_upright.hpp"

namespace goishi::verify {

namespace {

using namespace touching;
namespace odeint = boost::numeric::odeint;

enum class Mode { rolling, sliding };
enum class Chart { about_z, about_x };

class Follower {
 public:
  Follower(const TouchingBody& body, const TouchingPose& start, Long duration)
      : body_(body), duration_(duration), part_(part_at(body.hull, tilt_of(start))) {
    y_ = coordinates(Chart::about_z, start);
    if (dry() && std::isinf(body.mu)) {
      y_ = Equations(body_, part_, y_).stuck_at_once();
    }
    choose_chart();
    const auto [s_e, s_n] = slip_at(y_);
    const bool rolls = std::isinf(body.mu) || std::hypot(s_e, s_n) <= stuck;
    mode_ = dry() && rolls ? Mode::rolling : Mode::sliding;
  }

  TouchingPath operator()() {
    while (path_.time < duration_ && !path_.lifted && !path_.gave_up) {
      choose_chart();
      stretch();
    }
    path_.pose = pose(y_);
    path_.end = coordinates(Chart::about_z, path_.pose);
    return path_;
  }

 private:
  static constexpr long most_steps = 5000;
  static constexpr Long stuck = 1e-13L;  // [m/s] slip that counts as none

  [[nodiscard]] bool dry() const { return body_.law == TouchingBody::Law::dry; }

  /// What a use of the equations of the present chart gives.
  template <class Use>
  [[nodiscard]] auto with_equations(const TouchingState& y, Use&& use) const {
    return chart_ == Chart::about_z ? use(Equations(body_, part_, y)) : use(UprightEquations(body_, part_, y));
  }
  [[nodiscard]] std::array<Long, 2> slip_at(const TouchingState& y) const {
    return with_equations(y, [](const auto& now) { return now.slip(); });
  }
  [[nodiscard]] Answer answer_at(const TouchingState& y) const {
    return with_equations(y, [&](auto now) {
      if (mode_ == Mode::rolling) {
        return now.rolling();
      }
      const auto [s_e, s_n] = now.slip();
      const Long size = std::hypot(s_e, s_n);
      const Long k = dry() ? (size > 0 ? body_.mu / size : 0) : now.smooth(size);
      return now.at_ratio(-k * s_e, -k * s_n);
    });
  }

  /// Of the axis from the nearer vertical.
  [[nodiscard]] Long from_pole(const TouchingState& y) const {
    const Long c = std::fabs(chart_ == Chart::about_z ? std::cos(y[2]) : std::sin(y[2]) * std::sin(y[3]));
    return chart_ == Chart::about_z ? std::atan2(std::fabs(std::sin(y[2])), c)
                                    : std::atan2(std::hypot(std::cos(y[2]), std::sin(y[2]) * std::cos(y[3])), c);
  }
  /// Between these tilts either chart does.
  [[nodiscard]] Long upright_below() const { return std::min(0.2L, joint_of(body_.hull) / 2); }
  [[nodiscard]] bool chart_fits(const TouchingState& y) const {
    const Long tilt = from_pole(y);
    return part_ == Part::rim || (chart_ == Chart::about_z ? upright_below() / 2 < tilt : tilt < upright_below());
  }
  void choose_chart() {
    if (!chart_fits(y_)) {
      const TouchingPose now = pose(y_);
      chart_ = chart_ == Chart::about_z ? Chart::about_x : Chart::about_z;
      y_ = coordinates(chart_, now);
    }
  }

  /// Angles about z, or by an exchange of axes about x.
  [[nodiscard]] static Triple3 seen_in(Chart chart, const Triple3& v) {
    return chart == Chart::about_z ? v : Triple3{v[1], v[2], v[0]};
  }
  [[nodiscard]] static Triple3 seen_from(Chart chart, const Triple3& v) {
    return chart == Chart::about_z ? v : Triple3{v[2], v[0], v[1]};
  }
  [[nodiscard]] static Long tilt_of(const TouchingPose& now) {
    return std::atan2(std::hypot(now.u[0], now.u[1]), now.u[2]);
  }
  [[nodiscard]] TouchingState coordinates(Chart chart, const TouchingPose& now) const {
    const Triple3 u = seen_in(chart, now.u), e = seen_in(chart, now.e), L = seen_in(chart, now.L);
    const Long radial = std::hypot(u[0], u[1]);
    const Triple3 nodes = radial > 0 ? Triple3{-u[1] / radial, u[0] / radial, 0} : Triple3{0, 1, 0};
    const Triple3 down = cross(nodes, u);
    return {now.p[0],
            now.p[1],
            std::atan2(radial, u[2]),
            std::atan2(-nodes[0], nodes[1]),
            std::atan2(dot(e, nodes), dot(e, down)),
            now.v[0],
            now.v[1],
            dot(L, nodes) / body_.transverse,
            L[2],
            dot(L, u)};
  }
  [[nodiscard]] TouchingPose pose(const TouchingState& y) const {
    const Long s = std::sin(y[2]), c = std::cos(y[2]), sp = std::sin(y[3]), cp = std::cos(y[3]);
    const Triple3 u{s * cp, s * sp, c}, down{c * cp, c * sp, -s}, nodes{-sp, cp, 0};
    const Long precession_rate = (y[8] - y[9] * c) / (body_.transverse * s * s);
    const Triple3 e = std::cos(y[4]) * down + std::sin(y[4]) * nodes;
    const Triple3 L = body_.transverse * (y[7] * nodes + -precession_rate * s * down) + y[9] * u;
    TouchingPose now{{y[0], y[1], 0}, seen_from(chart_, u), seen_from(chart_, e), {y[5], y[6]}, seen_from(chart_, L)};
    now.p[2] = support_at(body_.hull, part_, tilt_of(now)).S;
    return now;
  }

  /// Guards of the present equations, positive while they hold: part, normal force, friction.
  [[nodiscard]] std::array<Long, 3> guards(const TouchingState& y) const {
    const Long joint = joint_of(body_.hull), tilt = from_pole(y);
    const Answer now = answer_at(y);
    Long friction = 1;
    if (dry()) {
      const auto [s_e, s_n] = slip_at(y);
      friction = mode_ == Mode::sliding ? std::hypot(s_e, s_n) - stuck
                 : std::isinf(body_.mu) ? Long(1)
                                        : (body_.mu * now.N - std::hypot(now.F_e, now.F_n)) / body_.gravity;
    }
    // What rolls slips before it lifts off, and slipping decides whether it does. Infinite friction has no cone: as teeth
    // that interlock it holds the stone as long as that presses.
    const bool rolls = dry() && mode_ == Mode::rolling;
    const Long normal = !rolls ? now.N / body_.gravity
                        : std::isinf(body_.mu)
                            ? with_equations(y, [](const auto& at) { return at.press(); }) / body_.gravity
                            : Long(1);
    return {part_ == Part::rim ? tilt - joint : joint - tilt, normal, friction};
  }

  /// The time in which dry slip loses half of itself at its present rate. A longer step may pass its zero, and Fehlberg's
  /// estimate of the error does not see that where the force depends on nothing else.
  [[nodiscard]] Long half_life_of_slip() const {
    if (!dry() || mode_ != Mode::sliding) {
      return duration_;
    }
    const auto [s_e, s_n] = slip_at(y_);
    const Answer now = answer_at(y_);
    return std::hypot(s_e, s_n) / (2 * std::hypot(now.slip_e_rate, now.slip_n_rate));
  }

  /// One set of equations, to its end.
  void stretch() {
    auto stepper = odeint::make_controlled(1e-18L, 1e-15L,
                                           odeint::runge_kutta_fehlberg78<TouchingState, Long, TouchingState, Long>());
    const auto system = [&](const TouchingState& y, TouchingState& rate, Long) { rate = answer_at(y).rate; };
    Long h = std::min<Long>(1e-5L, duration_ - path_.time);
    std::array<Long, 3> old = guards(y_);
    // A new part of the stone may ask more of the contact than there is.
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      if (old[i] < (i == 2 && mode_ == Mode::sliding ? -1 : -1e-12L)) {
        change(i);
        return;
      }
    }
    while (path_.time < duration_ && chart_fits(y_)) {
      if (most_steps < ++steps_) {
        path_.gave_up = true;
        return;
      }
      TouchingState y = y_;
      Long t = path_.time, tried = std::min<Long>({h, Long(1e-2L), duration_ - t, half_life_of_slip()});
      const Long asked = tried;
      if (asked < 1e-18L) {
        path_.gave_up = 1e-18L < duration_ - t;
        path_.time = duration_;
        return;
      }
      if (stepper.try_step(system, y, t, tried) == odeint::fail) {
        h = tried;
        continue;
      }
      const std::array<Long, 3> now = guards(y);
      for (std::size_t i = 0; i < 3; ++i) {
        if (now[i] < 0 && now[i] < old[i]) {
          locate(i, t - path_.time);
          change(i);
          return;
        }
      }
      h = tried;
      y_ = y;
      path_.time = t;
      old = now;
    }
  }

  /// The state after h, by steps of the present equations that are short enough.
  [[nodiscard]] TouchingState after(Long h) const {
    TouchingState y = y_;
    const auto system = [&](const TouchingState& at, TouchingState& rate, Long) { rate = answer_at(at).rate; };
    auto stepper = odeint::make_controlled(1e-18L, 1e-15L,
                                           odeint::runge_kutta_fehlberg78<TouchingState, Long, TouchingState, Long>());
    odeint::integrate_adaptive(stepper, system, y, Long(0), h, h);
    return y;
  }

  /// To the first zero of a guard within h, by bisection: to just before it. What is known to be before is kept.
  void locate(std::size_t which, Long h) {
    while (1e-18L < h) {
      const TouchingState middle = after(h / 2);
      h /= 2;
      if (!(guards(middle)[which] < 0)) {
        y_ = middle;
        path_.time += h;
      }
    }
  }

  void note(const char* kind) { path_.events.push_back({path_.time, kind}); }

  void change(std::size_t which) {
    if (which == 0) {
      part_ = part_ != Part::rim ? Part::rim : y_[2] < std::numbers::pi_v<Long> / 2 ? Part::lower : Part::upper;
      note("feature");
    } else if (which == 1) {
      path_.lifted = true;
    } else if (mode_ == Mode::sliding) {
      stop_slip();
    } else {
      mode_ = Mode::sliding;
      slip_away();
      note("slip");
    }
  }

  /// Takes what is left of the slip, and rolls if friction can hold that; else slips on, the other way.
  void stop_slip() {
    const auto [s_e, s_n] = slip_at(y_);
    add_velocity(-s_e, -s_n);
    const Answer held = with_equations(y_, [](auto now) { return now.rolling(); });
    if (std::hypot(held.F_e, held.F_n) <= body_.mu * held.N) {
      mode_ = Mode::rolling;
      note("stick");
    } else {
      slip_away();
    }
  }

  void add_velocity(Long v_e, Long v_n) {
    const Long angle = with_equations(y_, [](const auto& now) { return now.heading(); });
    const Long c = std::cos(angle), s = std::sin(angle);
    y_[5] += v_e * c - v_n * s;
    y_[6] += v_e * s + v_n * c;
  }

  /// A slip that starts keeps its direction: where its rate across is zero and falling, and its rate along positive.
  void slip_away() {
    const auto against = [&](Long c, Long s) {
      return with_equations(y_, [&](const auto& now) { return now.at_ratio(-body_.mu * c, -body_.mu * s); });
    };
    const auto across = [&](Long angle) {
      const Long c = std::cos(angle), s = std::sin(angle);
      const Answer then = against(c, s);
      return then.slip_n_rate * c - then.slip_e_rate * s;
    };
    constexpr int parts = 720;
    const Long turn = 2 * std::numbers::pi_v<Long> / parts;
    for (int i = 0; i < parts; ++i) {
      Long low = turn * static_cast<Long>(i), high = low + turn;
      if (!(0 <= across(low) && across(high) < 0)) {
        continue;
      }
      for (int k = 0; k < 70; ++k) {
        const Long middle = (low + high) / 2;
        (0 <= across(middle) ? low : high) = middle;
      }
      const Long c = std::cos(low), s = std::sin(low);
      const Answer then = against(c, s);
      if (0 < then.N && -1e-6L < then.slip_e_rate * c + then.slip_n_rate * s) {  // at the cone's edge it is zero
        add_velocity(3 * stuck * c, 3 * stuck * s);
        return;
      }
    }
    path_.gave_up = true;
  }

  const TouchingBody& body_;
  Long duration_;
  Part part_;
  Mode mode_ = Mode::rolling;
  Chart chart_ = Chart::about_z;
  TouchingState y_ = {};
  TouchingPath path_;
  long steps_ = 0;
};

}  // namespace

TouchingPath follow(const TouchingBody& body, const TouchingPose& start, long double duration) {
  return Follower(body, start, duration)();
}

TouchingPath follow(const TouchingBody& body, const TouchingState& y, long double duration) {
  const Long s = std::sin(y[2]), c = std::cos(y[2]), sp = std::sin(y[3]), cp = std::cos(y[3]);
  const Triple3 u{s * cp, s * sp, c}, down{c * cp, c * sp, -s}, nodes{-sp, cp, 0};
  const Triple3 L = body.transverse * y[7] * nodes + -(y[8] - y[9] * c) / s * down + y[9] * u;
  return follow(body,
                TouchingPose{.p = {y[0], y[1], height_of(body, y[2])},
                             .u = u,
                             .e = std::cos(y[4]) * down + std::sin(y[4]) * nodes,
                             .v = {y[5], y[6]},
                             .L = L},
                duration);
}

std::array<long double, 2> slip_of(const TouchingBody& body, const TouchingState& state) {
  const auto [s_e, s_n] = Equations(body, part_at(body.hull, state[2]), state).slip();
  const Long c = std::cos(state[3]), s = std::sin(state[3]);
  return {s_e * c - s_n * s, s_e * s + s_n * c};
}

long double height_of(const TouchingBody& body, long double theta) {
  return support_at(body.hull, part_at(body.hull, theta), theta).S;
}

}  // namespace goishi::verify
