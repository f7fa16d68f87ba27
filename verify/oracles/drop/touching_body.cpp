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

namespace goishi::verify {

namespace {

using Long = long double;
namespace odeint = boost::numeric::odeint;

enum class Mode { rolling, sliding };

/// S(θ) and its derivatives.
struct Support {
  Long S, a, a_slope;
};

/// Of the part that touches: the lower cap, the rim, the upper cap.
enum class Part { lower, rim, upper };

Support support_at(const Hull<Long>& hull, Part part, Long theta) {
  const Long c = std::cos(theta), s = std::sin(theta);
  if (part == Part::rim) {
    return {hull.torus_radius * s + hull.tube_radius, hull.torus_radius * c, -hull.torus_radius * s};
  }
  const Long d = part == Part::lower ? hull.sphere_offset : -hull.sphere_offset;
  return {hull.sphere_radius - d * c, d * s, d * c};
}

/// Tilt at which the lower cap ends.
Long joint_of(const Hull<Long>& hull) {
  return std::atan2(hull.joint_radius, hull.band + hull.sphere_offset);
}

Part part_at(const Hull<Long>& hull, Long theta) {
  const Long joint = joint_of(hull);
  return theta < joint ? Part::lower : std::numbers::pi_v<Long> - joint < theta ? Part::upper : Part::rim;
}

/// The equations at one state, for any contact force.
class Equations {
 public:
  Equations(const TouchingBody& body, Part part, const TouchingState& y) : body_(body), y_(y) {
    const auto [S, a, a_slope] = support_at(body.hull, part, y[2]);
    S_ = S;
    a_ = a;
    a_slope_ = a_slope;
    sin_ = std::sin(y[2]);
    cos_ = std::cos(y[2]);
    e_ = {std::cos(y[3]), std::sin(y[3])};
    spin_ = y[9] / body.axial;
    phi_rate_ = (y[8] - y[9] * cos_) / (body.transverse * sin_ * sin_);
    psi_rate_ = spin_ - phi_rate_ * cos_;
    arm_ = S_ * sin_ + a_ * cos_;
    v_e_ = y[5] * e_[0] + y[6] * e_[1];
    v_n_ = -y[5] * e_[1] + y[6] * e_[0];
    const Long w_e = psi_rate_ * sin_, w_n = y[7], w_z = phi_rate_ + psi_rate_ * cos_;
    const Long d2 = body.rolling_resistance * body.rolling_resistance, k2 = body.pivot_radius * body.pivot_radius;
    const Long root = std::sqrt(d2 * (w_e * w_e + w_n * w_n) + k2 * w_z * w_z);
    if (root > 0) {
      torque_ = {-d2 * w_e / root, -d2 * w_n / root, -k2 * w_z / root};
    }
    w_z_ = w_z;
    gyration_ = body.transverse * phi_rate_ * phi_rate_ * sin_ * cos_ - body.axial * spin_ * phi_rate_ * sin_;
  }

  /// In the frame (e, n) of the tilt.
  [[nodiscard]] std::array<Long, 2> slip() const {
    return {v_e_ - S_ * y_[7], v_n_ + phi_rate_ * a_ + psi_rate_ * arm_};
  }

  /// Rates for a horizontal force (F_e, F_n) = N (f_e, f_n), or (F_e, F_n) as it is.
  struct Answer {
    TouchingState rate;
    Long N;
    Long F_e, F_n;
    Long slip_e_rate, slip_n_rate;  // in the turning frame: of the components
  };

  [[nodiscard]] Answer at_ratio(Long f_e, Long f_n) const {
    const Long lever = -S_ * f_e - a_ + torque_[1];
    const Long N = press() / (1 - a_ * lever / body_.transverse);
    return answer((gyration_ + N * lever) / body_.transverse, N * f_e, N * f_n);
  }

  /// How fast the contact point would be accelerated into the plane if nothing held it.
  [[nodiscard]] Long press() const {
    return body_.gravity + a_slope_ * y_[7] * y_[7] + a_ * gyration_ / body_.transverse;
  }

  /// Resistance goes by the size of the normal force: an infinitely rough contact may pull.
  [[nodiscard]] Answer rolling() {
    const Answer pressed = rolled();
    if (!(pressed.N < 0)) {
      return pressed;
    }
    for (Long& part : torque_) {
      part = -part;
    }
    return rolled();
  }

  /// Friction per normal force and slip of the smooth laws.
  [[nodiscard]] Long smooth(Long slip) const {
    if (body_.law == TouchingBody::Law::slip_proportional) {
      return body_.coefficient;
    }
    const Long turn = body_.patch * w_z_;
    return body_.mu / std::sqrt(slip * slip + turn * turn + body_.creep * body_.creep);
  }

 private:
  [[nodiscard]] Answer rolled() const {
    // Affine in (θ̈, F_e, F_n): the θ equation and both slips' rates.
    const auto residual = [&](const std::array<Long, 3>& x) {
      const Answer now = answer(x[0], x[1], x[2]);
      return std::array<Long, 3>{body_.transverse * x[0] - (gyration_ - S_ * x[1] + now.N * (torque_[1] - a_)),
                                 now.slip_e_rate, now.slip_n_rate};
    };
    const std::array<Long, 3> zero = residual({0, 0, 0});
    Long m[3][4];
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<Long, 3> unit{0, 0, 0};
      unit[j] = 1;
      const std::array<Long, 3> there = residual(unit);
      for (std::size_t i = 0; i < 3; ++i) {
        m[i][j] = there[i] - zero[i];
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      m[i][3] = -zero[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t pivot = i;
      for (std::size_t k = i + 1; k < 3; ++k) {
        pivot = std::fabs(m[pivot][i]) < std::fabs(m[k][i]) ? k : pivot;
      }
      std::swap(m[i], m[pivot]);
      for (std::size_t k = 0; k < 3; ++k) {
        if (k != i) {
          const Long factor = m[k][i] / m[i][i];
          for (std::size_t j = i; j < 4; ++j) {
            m[k][j] -= factor * m[i][j];
          }
        }
      }
    }
    return answer(m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]);
  }

  [[nodiscard]] Answer answer(Long theta_bend, Long F_e, Long F_n) const {
    Answer result;
    const Long theta_rate = y_[7];
    const Long N = body_.gravity + a_ * theta_bend + a_slope_ * theta_rate * theta_rate;
    const Long p_phi_rate = a_ * F_n + N * torque_[2];
    const Long p_psi_rate = arm_ * F_n + N * (torque_[0] * sin_ + torque_[2] * cos_);
    const Long phi_bend =
        (p_phi_rate - p_psi_rate * cos_ + y_[9] * sin_ * theta_rate) / (body_.transverse * sin_ * sin_) -
        2 * cos_ / sin_ * theta_rate * phi_rate_;
    const Long psi_bend = p_psi_rate / body_.axial - phi_bend * cos_ + phi_rate_ * sin_ * theta_rate;
    result.rate = {
        y_[5],      y_[6],      theta_rate, phi_rate_, psi_rate_, F_e * e_[0] - F_n * e_[1], F_e * e_[1] + F_n * e_[0],
        theta_bend, p_phi_rate, p_psi_rate};
    result.N = N;
    result.F_e = F_e;
    result.F_n = F_n;
    result.slip_e_rate = F_e + phi_rate_ * v_n_ - a_ * theta_rate * theta_rate - S_ * theta_bend;
    result.slip_n_rate = F_n - phi_rate_ * v_e_ + phi_bend * a_ + phi_rate_ * a_slope_ * theta_rate + psi_bend * arm_ +
                         psi_rate_ * (S_ + a_slope_) * cos_ * theta_rate;
    return result;
  }

  const TouchingBody& body_;
  TouchingState y_;
  Long S_, a_, a_slope_, sin_, cos_, spin_, phi_rate_, psi_rate_, arm_, v_e_, v_n_, w_z_, gyration_;
  std::array<Long, 2> e_;
  std::array<Long, 3> torque_ = {0, 0, 0};  // along e, n, z, per normal force
};

class Follower {
 public:
  Follower(const TouchingBody& body, const TouchingState& start, Long duration)
      : body_(body), duration_(duration), part_(part_at(body.hull, start[2])) {
    path_.end = start;
    const auto [s_e, s_n] = Equations(body_, part_, start).slip();
    mode_ = dry() && std::hypot(s_e, s_n) <= stuck ? Mode::rolling : Mode::sliding;
  }

  TouchingPath operator()() {
    while (path_.time < duration_ && !path_.lifted && !path_.gave_up) {
      stretch();
    }
    return path_;
  }

 private:
  static constexpr long most_steps = 5000;
  static constexpr Long stuck = 1e-13L;  // [m/s] slip that counts as none

  [[nodiscard]] bool dry() const { return body_.law == TouchingBody::Law::dry; }

  [[nodiscard]] Equations::Answer answer_at(const TouchingState& y) const {
    Equations now(body_, part_, y);
    if (mode_ == Mode::rolling) {
      return now.rolling();
    }
    const auto [s_e, s_n] = now.slip();
    const Long size = std::hypot(s_e, s_n);
    const Long k = dry() ? (size > 0 ? body_.mu / size : 0) : now.smooth(size);
    return now.at_ratio(-k * s_e, -k * s_n);
  }

  /// Guards of the present equations, positive while they hold: part, normal force, friction.
  [[nodiscard]] std::array<Long, 3> guards(const TouchingState& y) const {
    const Long joint = joint_of(body_.hull), theta = y[2];
    const Long from_pole = theta < std::numbers::pi_v<Long> / 2 ? theta : std::numbers::pi_v<Long> - theta;
    const Equations::Answer now = answer_at(y);
    Long friction = 1;
    if (dry()) {
      const auto [s_e, s_n] = Equations(body_, part_, y).slip();
      friction = mode_ == Mode::sliding ? std::hypot(s_e, s_n) - stuck
                 : std::isinf(body_.mu) ? Long(1)
                                        : (body_.mu * now.N - std::hypot(now.F_e, now.F_n)) / body_.gravity;
    }
    // What rolls slips before it lifts off, and slipping decides whether it does. Infinite friction has no cone: as teeth
    // that interlock it holds the stone as long as that presses.
    const bool rolls = dry() && mode_ == Mode::rolling;
    const Long normal = !rolls                 ? now.N / body_.gravity
                        : std::isinf(body_.mu) ? Equations(body_, part_, y).press() / body_.gravity
                                               : Long(1);
    return {part_ == Part::rim ? from_pole - joint : joint - from_pole, normal, friction};
  }

  /// The time in which dry slip loses half of itself at its present rate. A longer step may pass its zero, and Fehlberg's
  /// estimate of the error does not see that where the force depends on nothing else.
  [[nodiscard]] Long half_life_of_slip() const {
    if (!dry() || mode_ != Mode::sliding) {
      return duration_;
    }
    const auto [s_e, s_n] = Equations(body_, part_, path_.end).slip();
    const Equations::Answer now = answer_at(path_.end);
    return std::hypot(s_e, s_n) / (2 * std::hypot(now.slip_e_rate, now.slip_n_rate));
  }

  /// One set of equations, to its end.
  void stretch() {
    auto stepper = odeint::make_controlled(1e-18L, 1e-15L,
                                           odeint::runge_kutta_fehlberg78<TouchingState, Long, TouchingState, Long>());
    const auto system = [&](const TouchingState& y, TouchingState& rate, Long) { rate = answer_at(y).rate; };
    Long h = std::min<Long>(1e-5L, duration_ - path_.time);
    std::array<Long, 3> old = guards(path_.end);
    // A new part of the stone may ask more of the contact than there is.
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      if (old[i] < (i == 2 && mode_ == Mode::sliding ? -1 : -1e-12L)) {
        change(i);
        return;
      }
    }
    while (path_.time < duration_) {
      if (most_steps < ++steps_) {
        path_.gave_up = true;
        return;
      }
      TouchingState y = path_.end;
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
      path_.end = y;
      path_.time = t;
      old = now;
    }
  }

  /// The state after h, by steps of the present equations that are short enough.
  [[nodiscard]] TouchingState after(Long h) const {
    TouchingState y = path_.end;
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
        path_.end = middle;
        path_.time += h;
      }
    }
  }

  void note(const char* kind) { path_.events.push_back({path_.time, kind}); }

  void change(std::size_t which) {
    if (which == 0) {
      part_ = part_ != Part::rim ? Part::rim : path_.end[2] < std::numbers::pi_v<Long> / 2 ? Part::lower : Part::upper;
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
    const Equations now(body_, part_, path_.end);
    const auto [s_e, s_n] = now.slip();
    add_velocity(-s_e, -s_n);
    const Equations::Answer held = Equations(body_, part_, path_.end).rolling();
    if (std::hypot(held.F_e, held.F_n) <= body_.mu * held.N) {
      mode_ = Mode::rolling;
      note("stick");
    } else {
      slip_away();
    }
  }

  void add_velocity(Long v_e, Long v_n) {
    const Long c = std::cos(path_.end[3]), s = std::sin(path_.end[3]);
    path_.end[5] += v_e * c - v_n * s;
    path_.end[6] += v_e * s + v_n * c;
  }

  /// A slip that starts keeps its direction: where its rate across is zero and falling, and its rate along positive.
  void slip_away() {
    const Equations now(body_, part_, path_.end);
    const auto across = [&](Long angle) {
      const Long c = std::cos(angle), s = std::sin(angle);
      const Equations::Answer then = now.at_ratio(-body_.mu * c, -body_.mu * s);
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
      const Equations::Answer then = now.at_ratio(-body_.mu * c, -body_.mu * s);
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
  TouchingPath path_;
  long steps_ = 0;
};

}  // namespace

TouchingPath follow(const TouchingBody& body, const TouchingState& start, long double duration) {
  return Follower(body, start, duration)();
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
