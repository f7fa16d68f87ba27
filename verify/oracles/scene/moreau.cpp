#include "verify/oracles/scene/moreau.hpp"

#include <algorithm>
#include <cmath>

namespace goishi::verify {

namespace {

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector sum(const Vector& a, double k, const Vector& b) {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

Vector unit(const Vector& a) {
  return sum({0.0, 0.0, 0.0}, 1.0 / std::sqrt(dot(a, a)), a);
}

/// Two unit vectors across n.
std::array<Vector, 2> across(const Vector& n) {
  const Vector e = std::fabs(n[0]) < 0.6 ? Vector{1.0, 0.0, 0.0} : Vector{0.0, 1.0, 0.0};
  const Vector s = unit(cross(n, e));
  return {s, cross(n, s)};
}

/// The point of a stone that is farthest along n, of any length.
Vector farthest(const HeavyBody& body, const Vector& n) {
  const double axial = dot(n, body.u), side = axial < 0.0 ? -1.0 : 1.0;
  const Vector radial = sum(n, -axial, body.u);
  const double n_r = std::sqrt(dot(radial, radial)), size = std::sqrt(dot(n, n));
  const Hull<double>& hull = body.hull;
  if (n_r * (hull.sphere_offset + hull.band) <= std::fabs(axial) * hull.joint_radius) {
    return sum(sum(body.p, -side * hull.sphere_offset, body.u), hull.sphere_radius / size, n);
  }
  return sum(sum(body.p, hull.torus_radius / n_r, radial), hull.tube_radius / size, n);
}

/// ω of what has momentum L.
Vector turning(const HeavyBody& body, const Vector& L) {
  const double along = dot(L, body.u);
  return sum(sum({0.0, 0.0, 0.0}, 1.0 / body.transverse, sum(L, -along, body.u)), along / body.axial, body.u);
}

/// Turned by a rotation vector.
Vector turned(const Vector& a, const Vector& by) {
  const double angle = std::sqrt(dot(by, by));
  if (!(angle > 0.0)) {
    return a;
  }
  const Vector k = sum({0.0, 0.0, 0.0}, 1.0 / angle, by), b = cross(k, a);
  return sum(sum(sum({0.0, 0.0, 0.0}, std::cos(angle), a), std::sin(angle), b), (1.0 - std::cos(angle)) * dot(k, a), k);
}

}  // namespace

HullGap gap_between(const HeavyBody& one, const HeavyBody& two, const Vector& guess) {
  // The least w · n over the first less the greatest over the second: its slope is the difference of the points.
  const auto at = [&](const Vector& n) {
    const Vector first = farthest(one, {-n[0], -n[1], -n[2]}), second = farthest(two, n);
    return HullGap{dot(n, sum(first, -1.0, second)), n, first, second};
  };
  HullGap best = at(unit(guess));
  for (int i = 0; i < 60; ++i) {
    const auto [s, t] = across(best.n);
    const auto slope = [&](const HullGap& of) {
      const Vector w = sum(of.first, -1.0, of.second);
      return std::array<double, 2>{dot(w, s), dot(w, t)};
    };
    const auto off = [&](double a, double b) { return at(unit(sum(sum(best.n, a, s), b, t))); };
    const double e = 1e-5;
    const std::array<double, 2> here = slope(best), plus_s = slope(off(e, 0.0)), plus_t = slope(off(0.0, e));
    // On the sphere: w · (n + x) over its length, so that the gap comes off the slopes' slopes.
    const double ss = (plus_s[0] - here[0]) / e - best.gap, tt = (plus_t[1] - here[1]) / e - best.gap;
    const double st = ((plus_s[1] - here[1]) + (plus_t[0] - here[0])) / (2.0 * e);
    const double det = ss * tt - st * st;
    double a = here[0], b = here[1];  // uphill
    const bool concave = ss < 0.0 && 0.0 < det;
    if (concave) {
      a = -(tt * here[0] - st * here[1]) / det;
      b = -(ss * here[1] - st * here[0]) / det;
    } else {
      const double size = std::hypot(a, b);
      a *= 0.1 / (size + 1e-300);
      b *= 0.1 / (size + 1e-300);
    }
    const double size = std::hypot(a, b);
    if (concave && size < 1e-11) {
      return best;
    }
    double share = size > 0.3 ? 0.3 / size : 1.0;
    HullGap next = off(share * a, share * b);
    for (int k = 0; k < 40 && next.gap < best.gap; ++k) {
      share /= 2.0;
      next = off(share * a, share * b);
    }
    if (!(best.gap < next.gap)) {
      return best;
    }
    best = next;
  }
  return best;
}

Moreau::Moreau(std::vector<HeavyBody> bodies, const MoreauLaws& laws) : bodies_(std::move(bodies)), laws_(laws) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
      pairs_.push_back({i, j, unit(sum(bodies_[i].p, -1.0, bodies_[j].p))});
    }
  }
  memories_.assign(bodies_.size() + pairs_.size(), {});
}

void Moreau::advance(double duration, int steps) {
  for (int i = 0; i < steps; ++i) {
    step(duration / steps);
  }
}

/// Half a way with the old velocities, the contacts there, new velocities, half a way with these.
void Moreau::step(double h) {
  const auto drift = [&] {
    for (HeavyBody& body : bodies_) {
      body.p = sum(body.p, h / 2.0, body.v);
      const Vector by = sum({0.0, 0.0, 0.0}, h / 2.0 / body.transverse, body.L);  // of the axis, by L/I_t
      body.u = unit(turned(body.u, by));
    }
  };
  drift();
  find_contacts();
  solve(h);
  drift();
}

void Moreau::find_contacts() {
  contacts_.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Vector low = farthest(bodies_[i], {0.0, 0.0, -1.0});
    if (low[2] <= 0.0) {
      add(i, std::nullopt, i, {0.0, 0.0, 1.0}, low);
    }
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    Pair& pair = pairs_[k];
    const HeavyBody &one = bodies_[pair.one], &two = bodies_[pair.two];
    const Vector between = sum(one.p, -1.0, two.p);
    const double reach = one.hull.torus_radius + one.hull.tube_radius + two.hull.torus_radius + two.hull.tube_radius;
    if (std::sqrt(dot(between, between)) > 1.05 * std::max(reach, one.hull.height)) {
      pair.n = unit(between);
      continue;
    }
    const HullGap found = gap_between(one, two, pair.n);
    pair.n = found.n;
    if (found.gap <= laws_.apart) {
      add(pair.one, pair.two, bodies_.size() + k, found.n,
          sum(sum({0.0, 0.0, 0.0}, 0.5, found.first), 0.5, found.second));
    }
  }
}

void Moreau::add(std::size_t one, std::optional<std::size_t> two, std::size_t memory, const Vector& n,
                 const Vector& p) {
  Contact contact;
  contact.one = one;
  contact.two = two;
  contact.memory = memory;
  contact.n = n;
  const auto [s, t] = across(n);
  contact.s = s;
  contact.t = t;
  contact.mu = two ? laws_.friction : laws_.board_friction;
  double stiff = 0.0, turns = 0.0;  // bounds of what an impulse and a torque do
  const auto see = [&](std::size_t i, Vector& arm) {
    const HeavyBody& body = bodies_[i];
    arm = sum(p, -1.0, body.p);
    stiff += 1.0 / body.mass + dot(arm, arm) / body.transverse;
    turns += 1.0 / body.transverse;
  };
  see(one, contact.arm);
  if (two) {
    see(*two, contact.other_arm);
  }
  contact.scale = 1.0 / stiff;
  const double length = std::max(laws_.rolling, laws_.pivot);
  contact.turning = length > 0.0 ? 1.0 / (length * length * turns) : 0.0;
  contacts_.push_back(contact);
}

void Moreau::push(const Contact& contact, const std::array<double, 3>& P, const std::array<double, 3>& torque) {
  const auto in_world = [&](const std::array<double, 3>& x) {
    return sum(sum(sum({0.0, 0.0, 0.0}, x[0], contact.n), x[1], contact.s), x[2], contact.t);
  };
  const Vector impulse = in_world(P), twist = in_world(torque);
  const auto give = [&](std::size_t i, const Vector& arm, double sign) {
    HeavyBody& body = bodies_[i];
    body.v = sum(body.v, sign / body.mass, impulse);
    const Vector gain = sum(cross(arm, impulse), 1.0, twist);
    body.L = sum(body.L, sign, gain);
    w_[i] = sum(w_[i], sign, turning(body, gain));
  };
  give(contact.one, contact.arm, 1.0);
  if (contact.two) {
    give(*contact.two, contact.other_arm, -1.0);
  }
}

/// P ← P − ρ (v + μ |v_t| n), onto the cone (De Saxcé); y ← y − ρ' S ω, onto the ball of radius P_n, S the lengths of
/// resistance. How much a velocity has changed by it.
double Moreau::sweep(Contact& contact) {
  const auto relative = [&](const Vector& a, const Vector& b) {
    return std::array<double, 3>{dot(a, contact.n) - dot(b, contact.n), dot(a, contact.s) - dot(b, contact.s),
                                 dot(a, contact.t) - dot(b, contact.t)};
  };
  const auto velocity = [&](std::size_t i, const Vector& arm) { return sum(bodies_[i].v, 1.0, cross(w_[i], arm)); };
  const Vector none = {0.0, 0.0, 0.0};
  const std::array<double, 3> v =
      relative(velocity(contact.one, contact.arm), contact.two ? velocity(*contact.two, contact.other_arm) : none);
  const double mu = contact.mu, rho = contact.scale;
  std::array<double, 3> P = {contact.P[0] - rho * (v[0] + mu * std::hypot(v[1], v[2])), contact.P[1] - rho * v[1],
                             contact.P[2] - rho * v[2]};
  const double side = std::hypot(P[1], P[2]);
  if (side > mu * P[0]) {
    const double normal = mu * side <= -P[0] ? 0.0 : (P[0] + mu * side) / (1.0 + mu * mu);
    const double share = side > 0.0 ? mu * normal / side : 0.0;
    P = {normal, share * P[1], share * P[2]};
  }
  std::array<double, 3> more, twist = {0.0, 0.0, 0.0};
  double change = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    more[i] = P[i] - contact.P[i];
    change = std::max(change, std::fabs(more[i]) / rho);
  }
  contact.P = P;
  if (contact.turning > 0.0) {
    const std::array<double, 3> w = relative(w_[contact.one], contact.two ? w_[*contact.two] : none);
    const std::array<double, 3> lengths = {laws_.pivot, laws_.rolling, laws_.rolling};
    std::array<double, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] = contact.y[i] - contact.turning * lengths[i] * w[i];
    }
    const double size = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
    const double share = size > P[0] ? P[0] / size : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      y[i] *= share;
      twist[i] = lengths[i] * (y[i] - contact.y[i]);
      change = std::max(change, std::fabs(y[i] - contact.y[i]) / contact.turning /
                                    std::max(laws_.rolling, laws_.pivot) * bodies_[contact.one].hull.torus_radius);
    }
    contact.y = y;
  }
  push(contact, more, twist);
  return change;
}

void Moreau::solve(double h) {
  const double g = std::sqrt(dot(laws_.gravity, laws_.gravity));
  w_.clear();
  for (HeavyBody& body : bodies_) {
    body.v = sum(body.v, h, laws_.gravity);
    w_.push_back(turning(body, body.L));
  }
  for (Contact& contact : contacts_) {  // from the impulses of the last step
    const auto& [P, y] = memories_[contact.memory];
    contact.P = P;
    contact.y = y;
    push(contact, P, {laws_.pivot * y[0], laws_.rolling * y[1], laws_.rolling * y[2]});
  }
  double change = 0.0;
  for (int i = 0; i < 2000; ++i) {
    change = 0.0;
    for (Contact& contact : contacts_) {
      change = std::max(change, sweep(contact));
    }
    if (change <= 1e-7 * g * h) {
      break;
    }
  }
  unsolved_ = std::max(unsolved_, change / (g * h));
  memories_.assign(memories_.size(), {});
  for (const Contact& contact : contacts_) {
    memories_[contact.memory] = {contact.P, contact.y};
  }
}

}  // namespace goishi::verify
