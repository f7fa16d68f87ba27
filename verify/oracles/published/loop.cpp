#include "verify/oracles/published/loop.hpp"

#include <algorithm>
#include <cmath>

namespace goishi::verify {

namespace {

using Vector = std::array<double, 3>;

constexpr double frame = 1.0 / 60.0;  // [s]
constexpr double least_slip = 1e-5;   // [m/s] that friction answers to: the original program's 0.001 cm/s

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(double k, const Vector& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Third column of the rotation matrix.
Vector axis_of(const std::array<double, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)};
}

/// I a, or I⁻¹ a, with the moments given about and across the axis u.
Vector times_inertia(double axial, double transverse, const Vector& u, const Vector& a) {
  return transverse * a + ((axial - transverse) * dot(u, a)) * u;
}

/// q + ½ (0, ω) q Δt, normalised.
std::array<double, 4> turned(const std::array<double, 4>& q, const Vector& w, double dt) {
  const double h = dt / 2.0;
  std::array<double, 4> next = {
      q[0] - h * (w[0] * q[1] + w[1] * q[2] + w[2] * q[3]), q[1] + h * (w[0] * q[0] + w[1] * q[3] - w[2] * q[2]),
      q[2] + h * (w[1] * q[0] + w[2] * q[1] - w[0] * q[3]), q[3] + h * (w[2] * q[0] + w[0] * q[2] - w[1] * q[1])};
  const double length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2] + next[3] * next[3]);
  for (double& part : next) {
    part /= length;
  }
  return next;
}

/// The lowest point of the stone, from its centre: on a cap's ball, where that lies beyond the bevel, or on the bevel's
/// torus.
Vector lowest(const PublishedStone& stone, const Vector& u) {
  const double sign = u[2] < 0.0 ? 1.0 : -1.0;  // which pole is below
  const double across = std::sqrt(u[0] * u[0] + u[1] * u[1]);
  if (across * stone.sphere_offset <= std::fabs(u[2]) * stone.ring_radius) {
    return (-sign * stone.sphere_offset) * u + Vector{0.0, 0.0, -stone.sphere_radius};
  }
  // Down, less its part along the axis, as long as the ring's radius.
  const double scale = stone.ring_radius / across;
  return {scale * u[2] * u[0], scale * u[2] * u[1], -scale * across * across - stone.tube_radius};
}

}  // namespace

double published_energy(const PublishedStone& stone, const PublishedRules& rules, const PublishedState& state) {
  const Vector u = axis_of(state.q);
  return (dot(state.v, state.v) + dot(state.w, times_inertia(stone.axial, stone.transverse, u, state.w))) / 2.0 +
         rules.gravity * state.p[2];
}

PublishedPath run_published_loop(const PublishedStone& stone, const PublishedRules& rules, const PublishedState& start,
                                 double dt, std::int64_t steps, bool watch_energy) {
  const double inverse_axial = 1.0 / stone.axial, inverse_transverse = 1.0 / stone.transverse;
  const bool keeps_momentum = rules.turning == PublishedTurning::momentum;
  const double kept = std::pow(rules.kept, dt / frame);
  const double kept_in_contact = std::pow(rules.kept_in_contact, dt / frame);
  const double highest = std::max(stone.ring_radius + stone.tube_radius, stone.sphere_radius - stone.sphere_offset);
  PublishedPath path{.end = start};
  auto& [p, v, q, w] = path.end;
  Vector u = axis_of(q);
  Vector L = times_inertia(stone.axial, stone.transverse, u, w);
  double energy = watch_energy ? published_energy(stone, rules, start) : 0.0;
  for (std::int64_t i = 0; i < steps; ++i) {
    v[2] -= rules.gravity * dt;
    if (keeps_momentum) {
      w = times_inertia(inverse_axial, inverse_transverse, u, L);
    }
    p = p + dt * v;
    q = turned(q, w, dt);
    u = axis_of(q);
    if (p[2] < highest) {
      const Vector r = lowest(stone, u);
      const double depth = -(p[2] + r[2]);
      if (0.0 <= depth) {
        ++path.contacts;
        path.raised += depth;
        p[2] += depth;
        if (keeps_momentum) {
          w = times_inertia(inverse_axial, inverse_transverse, u, L);
        }
        const auto push = [&](const Vector& impulse) {
          v = v + impulse;
          const Vector turn = cross(r, impulse);
          w = w + times_inertia(inverse_axial, inverse_transverse, u, turn);
          L = L + turn;
        };
        const auto mobility = [&](const Vector& n) {
          const Vector arm = cross(r, n);
          return 1.0 + dot(arm, times_inertia(inverse_axial, inverse_transverse, u, arm));
        };
        const Vector n = {0.0, 0.0, 1.0};
        const double approach = std::min(0.0, (v + cross(w, r))[2]);
        const double j = -(1.0 + rules.restitution) * approach / mobility(n);
        push(j * n);
        Vector slip = v + cross(w, r);
        slip[2] = 0.0;
        const double speed = std::sqrt(dot(slip, slip));
        if (speed > least_slip) {
          const Vector t = (1.0 / speed) * slip;
          const double limit = rules.friction * j;
          push(std::clamp(-speed / mobility(t), -limit, limit) * t);
        }
        w = kept_in_contact * w;
        L = kept_in_contact * L;
      }
    }
    v = kept * v;
    w = kept * w;
    L = kept * L;
    if (watch_energy) {
      const double now = published_energy(
          stone, rules, {p, v, q, keeps_momentum ? times_inertia(inverse_axial, inverse_transverse, u, L) : w});
      path.greatest_rise = std::max(path.greatest_rise, now - energy);
      energy = now;
    }
  }
  if (keeps_momentum) {
    w = times_inertia(inverse_axial, inverse_transverse, u, L);
  }
  return path;
}

}  // namespace goishi::verify
