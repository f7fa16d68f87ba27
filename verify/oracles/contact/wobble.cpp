#include "verify/oracles/contact/wobble.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

namespace goishi::verify {

namespace {

using Long = long double;
namespace odeint = boost::numeric::odeint;

constexpr Long step = 5e-4L;

/// Height of the centre and its derivatives by the tilt.
struct Height {
  Long S, slope, curvature;
};

Height height_on_cap(const Rocker& stone, Long tilt) {
  const Long s = std::sin(tilt), c = std::cos(tilt);
  return {stone.sphere_radius - stone.sphere_offset * c, stone.sphere_offset * s, stone.sphere_offset * c};
}

Height height_on_rim(const Rocker& stone, Long tilt) {
  const Long s = std::sin(tilt), c = std::cos(tilt);
  return {stone.torus_radius * s + stone.tube_radius, stone.torus_radius * c, -stone.torus_radius * s};
}

using Phase = std::array<Long, 4>;  // θ, θ̇, x, ẋ

/// The equations of the file's comment, with the signs of θ̇ and of the slip held.
struct Equations {
  const Rocker& stone;
  Losses losses;
  bool rolling, sliding;
  Long sign;  // of θ̇

  void operator()(const Phase& y, Phase& rate, Long /*time*/) const {
    const auto [S, slope, curvature] = height_on_cap(stone, y[0]);
    const Long w = y[1], c = losses.damping, delta = losses.rolling_resistance * sign;
    const Long still = stone.gravity + curvature * w * w + c * slope * w;  // N without θ̈
    // F = a θ̈ + b in rolling, −μ N in sliding.
    const Long a = rolling ? S : 0, b = rolling ? slope * w * w + c * S * w : 0;
    const Long lever = slope + delta - (sliding ? losses.friction * S : 0);
    const Long turn = -(lever * still + S * b + c * stone.transverse * w) / (stone.transverse + lever * slope + S * a);
    const Long force = sliding ? -losses.friction * (still + slope * turn) : a * turn + b;
    rate = {w, turn, y[3], force - c * y[3]};
  }
};

Phase phase_of(const PlanarMotion& motion) {
  return {motion.tilt, motion.rate, motion.x, motion.v};
}

PlanarMotion motion_of(const Phase& y, Long time) {
  return {time, y[0], y[1], y[2], y[3]};
}

void take(const Equations& equations, Phase& y, Long h) {
  odeint::runge_kutta_fehlberg78<Phase, Long, Phase, Long, odeint::array_algebra> stepper;
  stepper.do_step(equations, y, Long(0), h);
}

/// Steps until value(y) changes its sign, then Newton with value's slope: to where it vanishes.
template <class F, class Slope>
PlanarMotion until(const Equations& equations, const PlanarMotion& start, F&& value, Slope&& slope) {
  Phase y = phase_of(start);
  Long time = start.time;
  take(equations, y, step);  // off a turning point
  time += step;
  const bool positive = value(y) > 0;
  while ((value(y) > 0) == positive) {
    take(equations, y, step);
    time += step;
    if (time > 100) {
      throw std::runtime_error("a stone that rocks without end");
    }
  }
  for (int i = 0; i < 8; ++i) {
    Phase rate;
    equations(y, rate, time);
    const Long h = -value(y) / slope(y, rate);
    take(equations, y, h);
    time += h;
  }
  return motion_of(y, time);
}

}  // namespace

Long Rocker::joint() const {
  return std::atan2(torus_radius, sphere_offset);
}

Long rocking_period(const Rocker& rocker, Footing footing, Long amplitude) {
  using Rule = boost::math::quadrature::gauss_kronrod<Long, 61>;
  const Long joint = std::fmin(rocker.joint(), amplitude), d = rocker.sphere_offset, r1 = rocker.torus_radius;
  // S(b) − S(a), without cancellation.
  const auto on_cap = [&](Long a, Long b) { return 2 * d * std::sin((b + a) / 2) * std::sin((b - a) / 2); };
  const auto on_rim = [&](Long a, Long b) { return 2 * r1 * std::cos((b + a) / 2) * std::sin((b - a) / 2); };
  const auto inertia = [&](const Height& at) {
    return rocker.transverse + at.slope * at.slope + (footing == Footing::rolling ? at.S * at.S : 0);
  };
  // dt/dx with tilt = end − (end − start) x², which takes the root at a turning point away.
  const auto piece = [&](Long start, Long end, auto&& slowness) {
    const auto f = [&](Long x) {
      const Long left = (end - start) * x * x;
      return slowness(end - left, left) * 2 * (end - start) * x;
    };
    return Rule::integrate(f, Long(0), Long(1), 10, 1e-14L);
  };
  const Long above = amplitude > joint ? on_rim(joint, amplitude) : 0;
  Long quarter = piece(0, joint, [&](Long tilt, Long left) {
    const Long fall = on_cap(joint - left, joint) + above;
    return std::sqrt(inertia(height_on_cap(rocker, tilt)) / (2 * rocker.gravity * fall));
  });
  if (amplitude > joint) {
    quarter += piece(joint, amplitude, [&](Long tilt, Long left) {
      const Long fall = on_rim(amplitude - left, amplitude);
      return std::sqrt(inertia(height_on_rim(rocker, tilt)) / (2 * rocker.gravity * fall));
    });
  }
  return 4 * quarter;
}

PlanarMotion rocked(const Rocker& rocker, Footing footing, const Losses& losses, const PlanarMotion& start,
                    Long duration) {
  const Equations equations{rocker, losses, footing == Footing::rolling, false, 0};
  Phase y = phase_of(start);
  const int steps = static_cast<int>(std::ceil(duration / step));
  for (int i = 0; i < steps; ++i) {
    take(equations, y, duration / steps);
  }
  return motion_of(y, start.time + duration);
}

std::vector<PlanarMotion> turning_points(const Rocker& rocker, Footing footing, const Losses& losses, Long tilt) {
  std::vector<PlanarMotion> result;
  PlanarMotion motion{.tilt = tilt};
  // Gravity's lever d sin θ against resistance's δ.
  while (rocker.sphere_offset * std::sin(std::fabs(motion.tilt)) > losses.rolling_resistance) {
    const Equations equations{rocker, losses, footing == Footing::rolling, false, motion.tilt > 0 ? -1.0L : 1.0L};
    motion = until(
        equations, motion, [](const Phase& y) { return y[1]; },
        [](const Phase&, const Phase& rate) { return rate[1]; });
    motion.rate = 0;
    result.push_back(motion);
  }
  return result;
}

PlanarMotion end_of_slide(const Rocker& rocker, const Losses& losses, const PlanarMotion& start) {
  const Equations equations{rocker, losses, false, true, 0};
  const auto slip = [&](const Phase& y) { return y[3] - height_on_cap(rocker, y[0]).S * y[1]; };
  return until(equations, start, slip, [&](const Phase& y, const Phase& rate) {
    const auto [S, slope, curvature] = height_on_cap(rocker, y[0]);
    return rate[3] - S * rate[1] - slope * y[1] * y[1];
  });
}

}  // namespace goishi::verify
