#pragma once
/// \file
/// Rest as a statement of statics: a stone that does not move stays where it is if there are forces at its contacts, each
/// inside its cone of friction, and torques of resistance, each inside its bounds, that together balance gravity.

#include <array>
#include <cstddef>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/schemes/cholesky.hpp>
#include <limits>

namespace goishi {

namespace detail {

/// Where a stone is held.
template <class T>
struct Support {
  Vec3<T> r;  // [m] from the centre of mass to the contact
  Vec3<T> n;  // unit, out of what is touched
};

/// What friction can do without slip: the laws that are smooth in the slip do nothing.
template <class T>
[[nodiscard]] T static_friction(const ContactBody<T>& body) {
  return body.model == FrictionModel::dry ? body.friction : T(0);
}

/// A share of a size that is round-off.
template <class T>
[[nodiscard]] constexpr T round_off_share() {
  return T(512) * std::numeric_limits<T>::epsilon();
}

}  // namespace detail

namespace formula {

/// What share a torque has of the most that the resistance at a support can bear, δ N against rolling and κ N about
/// the normal n, along an ellipsoid: √((τ_∥/(δ N))² + (τ_n/(κ N))²).
/// Domain  N, δ, κ > 0.   Proof  derivations/contact_phase.cpp.
template <Elementary T>
[[nodiscard]] T resistance_share(const Vec3<T>& n, const Vec3<T>& torque, const T& normal, const T& delta,
                                 const T& kappa) {
  const T along = formula::dot(n, torque);
  const Vec3<T> across = formula::plus(torque, T(-along), n);
  const T roll = T(1) / (normal * delta);
  const T pivot = T(1) / (normal * kappa);
  return scalar::sqrt(T(scalar::sq(roll) * formula::dot(across, across) + scalar::sq(T(along * pivot))));
}

}  // namespace formula

namespace detail {

/// The share of the resistance at a support that the torque of gravity and of a force there takes: below 1, a stone that
/// does not turn goes on so.
template <Ordered T>
[[nodiscard]] T resistance_share(const ContactBody<T>& body, const Support<T>& at, const Vec3<T>& force) {
  const Vec3<T> torque = formula::cross(at.r, force);
  // Round-off of a torque that is zero, so that without any resistance a stone still can stand.
  const T slack = round_off_share<T>() * body.stone.width;
  return formula::resistance_share(at.n, torque, formula::dot(at.n, force), T(body.rolling_resistance + slack),
                                   T(body.pivot_radius + slack));
}

/// Whether static friction at a support takes a force there.
template <Ordered T>
[[nodiscard]] bool is_in_cone(const ContactBody<T>& body, const Vec3<T>& n, const Vec3<T>& force) {
  const T normal = formula::dot(n, force);
  const Vec3<T> across = formula::plus(force, T(-normal), n);
  const T mu = static_friction(body);
  return T(0) < normal && (!(mu < std::numeric_limits<T>::infinity()) ||
                           formula::dot(across, across) <= scalar::sq(T((mu + round_off_share<T>()) * normal)));
}

/// A force at a support, and a torque of its resistance.
template <class T>
struct Reaction {
  std::size_t support = 0;
  Vec3<T> force = Vec3<T>::Zero(), torque = Vec3<T>::Zero();
};

/// Whether gravity is balanced at several supports: the point of their cone of wrenches that is nearest to what balances it,
/// by rays that are added where they help most (Gilbert), the weights of all of them chosen anew each time (Lawson and
/// Hanson). It ends with forces that balance, or with a wrench against which no support does any work: none can.
template <Ordered T, std::size_t most>
class Balance {
 public:
  Balance(const ContactBody<T>& body, const std::array<Support<T>, most>& supports, std::size_t count)
      : body_(body), supports_(supports), count_(count), length_(body.stone.width) {}

  [[nodiscard]] bool operator()() {
    constexpr int most_rays = 100;
    for (int i = 0; i < most_rays; ++i) {
      const Wrench left = residual();
      const T size = scalar::sqrt(dot(left, left));
      if (size <= small) {
        return true;
      }
      Ray best = {};
      T value(0);
      for (std::size_t k = 0; k < count_; ++k) {
        consider(k, left, best, value);
      }
      if (!(small * size < value) || used_ == rays_.size()) {
        return false;
      }
      rays_[used_] = best.wrench;
      reactions_[used_] = best.reaction;
      weights_[used_] = T(0);
      ++used_;
      if (!reweigh()) {
        return false;
      }
    }
    return false;
  }

  /// The reactions found, over gravity: `used` of them, each to be taken `weight` times.
  [[nodiscard]] std::size_t used() const { return used_; }
  [[nodiscard]] const Reaction<T>& reaction(std::size_t k) const { return reactions_[k]; }
  [[nodiscard]] const T& weight(std::size_t k) const { return weights_[k]; }

 private:
  using Wrench = std::array<T, 6>;  // force over gravity, torque over gravity and width
  struct Ray {
    Wrench wrench = {};
    Reaction<T> reaction = {};
  };
  static constexpr T small = T(1e5) * round_off_share<T>() < T(1e-3) ? T(1e5) * round_off_share<T>() : T(1e-3);

  [[nodiscard]] static T dot(const Wrench& a, const Wrench& b) {
    T sum(0);
    for (std::size_t i = 0; i < 6; ++i) {
      sum = sum + a[i] * b[i];
    }
    return sum;
  }

  /// What is still to be balanced.
  [[nodiscard]] Wrench residual() const {
    Wrench left = {};
    for (std::size_t i = 0; i < 3; ++i) {
      left[i] = -(body_.gravity[static_cast<Eigen::Index>(i)] / body_.strength);
    }
    for (std::size_t k = 0; k < used_; ++k) {
      for (std::size_t i = 0; i < 6; ++i) {
        left[i] = left[i] - weights_[k] * rays_[k][i];
      }
    }
    return left;
  }

  void see(std::size_t k, const Vec3<T>& force, const Vec3<T>& torque, const Wrench& left, Ray& best, T& value) const {
    const Vec3<T> moment = formula::plus(formula::cross(supports_[k].r, force), torque);
    Wrench ray = {
        force.x(), force.y(), force.z(), T(moment.x() / length_), T(moment.y() / length_), T(moment.z() / length_)};
    const T size = scalar::sqrt(dot(ray, ray));
    for (T& component : ray) {
      component = component / size;
    }
    const T work = dot(ray, left);
    if (value < work) {
      value = work;
      best = {ray, {k, formula::scaled(T(T(1) / size), force), formula::scaled(T(T(1) / size), torque)}};
    }
  }

  /// The ray of a support's cone that does most against what is left.
  void consider(std::size_t k, const Wrench& left, Ray& best, T& value) const {
    const Support<T>& at = supports_[k];
    const Vec3<T> f(left[0], left[1], left[2]);
    const Vec3<T> t(T(left[3] / length_), T(left[4] / length_), T(left[5] / length_));
    const Vec3<T> a = formula::plus(f, formula::cross(t, at.r));
    const Vec3<T> across = formula::plus(a, T(-formula::dot(a, at.n)), at.n);
    const T size = scalar::sqrt(formula::dot(across, across));
    const Vec3<T> way = T(0) < size ? formula::scaled(T(T(1) / size), across) : Vec3<T>(Vec3<T>::Zero());
    const Vec3<T> turn = formula::scaled(formula::dot(t, at.n), at.n), roll = formula::minus(t, turn);
    const T root = scalar::sqrt(T(scalar::sq(body_.rolling_resistance) * formula::dot(roll, roll) +
                                  scalar::sq(body_.pivot_radius) * formula::dot(turn, turn)));
    const Vec3<T> torque = T(0) < root ? formula::combination(T(scalar::sq(body_.rolling_resistance) / root), roll,
                                                              T(scalar::sq(body_.pivot_radius) / root), turn)
                                       : Vec3<T>(Vec3<T>::Zero());
    const T mu = static_friction(body_);
    if (mu < std::numeric_limits<T>::infinity()) {
      see(k, formula::plus(at.n, mu, way), torque, left, best, value);
      return;
    }
    see(k, at.n, torque, left, best, value);
    if (T(0) < size) {
      see(k, way, Vec3<T>::Zero(), left, best, value);
    }
  }

  /// Weights of least squares, none negative: towards those without that bound, and what gets to zero on the way drops out.
  /// False where two rays are the same.
  [[nodiscard]] bool reweigh() {
    while (0 < used_) {
      std::array<T, 8> wanted = {};
      if (!least_squares(wanted)) {
        return false;
      }
      T share(1);
      for (std::size_t k = 0; k < used_; ++k) {
        if (!(T(0) < wanted[k])) {
          const T until = weights_[k] / (weights_[k] - wanted[k]);
          share = until < share ? until : share;
        }
      }
      std::size_t kept = 0;
      for (std::size_t k = 0; k < used_; ++k) {
        const T weight = weights_[k] + share * (wanted[k] - weights_[k]);
        if (!(share < T(1)) || std::numeric_limits<T>::epsilon() < weight) {
          weights_[kept] = weight;
          reactions_[kept] = reactions_[k];
          rays_[kept++] = rays_[k];
        }
      }
      const bool done = kept == used_ && !(share < T(1));
      used_ = kept;
      if (done) {
        return true;
      }
    }
    return true;
  }

  /// Of the normal equations.
  [[nodiscard]] bool least_squares(std::array<T, 8>& x) const {
    typename Cholesky<T, 8>::Matrix products = {};
    Wrench load = {};
    for (std::size_t i = 0; i < 3; ++i) {
      load[i] = -(body_.gravity[static_cast<Eigen::Index>(i)] / body_.strength);
    }
    for (std::size_t i = 0; i < used_; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        products[i][j] = dot(rays_[i], rays_[j]);
      }
      x[i] = dot(rays_[i], load);
    }
    Cholesky<T, 8> factors;
    if (!factors.factor(products, used_)) {
      return false;
    }
    factors.solve(x);
    return true;
  }

  const ContactBody<T>& body_;
  const std::array<Support<T>, most>& supports_;
  std::size_t count_;
  T length_;
  std::array<Wrench, 8> rays_ = {};
  std::array<Reaction<T>, 8> reactions_ = {};
  std::array<T, 8> weights_ = {};
  std::size_t used_ = 0;
};

/// Whether a stone that does not move stays where it is. Of several supports, forces may be there that balance although
/// others would not: that is rest, too, as that of a ladder.
template <Ordered T, std::size_t most>
[[nodiscard]] bool is_held(const ContactBody<T>& body, const std::array<Support<T>, most>& supports,
                           std::size_t count) {
  const Vec3<T> load = -body.gravity;
  if (!(T(0) < formula::dot(load, load))) {
    return true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (is_in_cone(body, supports[i].n, load) && resistance_share(body, supports[i], load) < T(1)) {
      return true;
    }
  }
  return 1 < count && Balance<T, most>(body, supports, count)();
}

/// The same at the one contact of the contact phase.
template <Ordered T>
[[nodiscard]] bool is_held(const ContactBody<T>& body, const Vec3<T>& r) {
  return is_held(body, std::array<Support<T>, 1>{Support<T>{r, {T(0), T(0), T(1)}}}, 1);
}

}  // namespace detail
}  // namespace goishi
