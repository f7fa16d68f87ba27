#pragma once
/// \file
/// What a contact does next where its equations do not say: where a slip or a turning begins or ceases, or no normal force
/// fits both. Slip, turning and normal force are then chosen together, as the end of one implicit step of Euler's that is
/// so short that nothing else changes.
///
/// For a given normal impulse N, friction (at most μ N, against the slip that is left) and the torque of resistance (in N
/// times its ellipsoid, against the turning that is left) are those that leave the least energy: a convex problem, with one
/// answer, continuous in N. The more N, the more of slip and turning is held, until only N itself moves the stone: then the
/// contact point leaves the plane, with N = 0 it goes into it, so that an N between leaves it there. Painlevé's case is no
/// exception: its N does not vanish with the step, and is an impulse.
///
/// Source  Moreau, in Nonsmooth Mechanics and Applications (1988), for the step and the least energy.

#include <array>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/schemes/cholesky.hpp>
#include <limits>

namespace goishi::detail {

/// The motion after the step, per unit of mass.
template <class T>
struct Onset {
  bool closed = false;  // the contact stays; else there is no more than that
  bool slips = false, turns = false;
  T slip_x = T(0), slip_y = T(0);        // [m/s]
  Vec3<T> L = Vec3<T>::Zero();           // [m²/s]
  Vec3<T> impulse = Vec3<T>::Zero();     // [m/s] on the contact point
  Vec3<T> resistance = Vec3<T>::Zero();  // [m²/s] what resistance gave to L
};

template <Ordered T>
class OnsetSolver {
 public:
  /// Of a stone with this motion whose contact point slips with (s_x, s_y), after a time h.
  OnsetSolver(const ContactBody<T>& body, const Kinetics<T>& now, const T& s_x, const T& s_y, const T& h)
      : body_(body),
        now_(now),
        h_(h),
        smooth_(body.model != FrictionModel::dry),
        rough_(!smooth_ && !(body.friction < std::numeric_limits<T>::infinity())) {
    const T kept = T(1) - h * body.damping;
    c_ = {T(kept * s_x - h * now.need.x()), T(kept * s_y - h * now.need.y()), T(-(h * now.need.z()))};
    L_ = formula::scaled(kept, now.L);
    if (smooth_) {
      per_slip_ = smooth_friction(body, T(scalar::sq(s_x) + scalar::sq(s_y)), T(now.w.z()));
    }
    const bool rubs = smooth_ ? T(0) < per_slip_ : T(0) < body.friction;
    const T unit = smooth_ || rough_ ? T(1) : body.friction;
    if (rubs) {
      add({unit, T(0), T(0)}, Vec3<T>::Zero());
      add({T(0), unit, T(0)}, Vec3<T>::Zero());
      forces_ = 2;
    }
    if (body.resists) {
      const T &delta = body.rolling_resistance, &kappa = body.pivot_radius;
      add(Vec3<T>::Zero(), {delta, T(0), T(0)});
      add(Vec3<T>::Zero(), {T(0), delta, T(0)});
      add(Vec3<T>::Zero(), {T(0), T(0), kappa});
    }
    normal_ = made_by({T(0), T(0), T(1)}, Vec3<T>::Zero());
    for (std::size_t i = 0; i < used_; ++i) {
      for (std::size_t j = 0; j < used_; ++j) {
        A_[i][j] = work(ways_[i], made_[j]);
      }
      free_[i] = work(ways_[i], Motion{c_, formula::turning(body.mobility, now.u, L_)});
      pressed_[i] = work(ways_[i], normal_);
    }
  }

  /// How often its equations were solved.
  [[nodiscard]] int evaluations() const { return evaluations_; }

  [[nodiscard]] Onset<T> operator()() {
    if (body_.model != FrictionModel::coulomb_contensou) {
      return balanced();
    }
    // The friction for each slip that goes with the slip it leaves: further each time until it lies between two, then by
    // false position (Illinois).
    constexpr int most_patches = 100;
    const T exact = scalar::max(T(1e-11), T(16) * std::numeric_limits<T>::epsilon());
    T low(0), high(0), low_off(0), high_off(0), far(1);
    int last = 0;
    for (int i = 0; i < most_patches; ++i) {
      Onset<T> result = balanced();
      const T w_z = formula::turning(body_.mobility, now_.u, result.L).z();
      const T fits = smooth_friction(body_, T(scalar::sq(result.slip_x) + scalar::sq(result.slip_y)), w_z);
      const T off = fits - per_slip_;
      const int side = off < T(0) ? -1 : 1;
      if (!result.closed || T(side) * off <= exact * fits) {
        return result;
      }
      (side < 0 ? high : low) = per_slip_;
      (side < 0 ? high_off : low_off) = off;
      if (T(0) < low && T(0) < high) {
        if (side == last) {
          (side < 0 ? low_off : high_off) = (side < 0 ? low_off : high_off) / T(2);
        }
        last = side;
        per_slip_ = i % 4 == 3 ? T((low + high) / T(2)) : T(low + (high - low) * (low_off / (low_off - high_off)));
      } else {
        per_slip_ = side < 0 ? T(fits / far) : T(per_slip_ + far * off);
        far = far + far;
      }
    }
    return balanced();
  }

 private:
  static constexpr std::size_t most = 5;
  using Vector = std::array<T, most>;

  /// A force at the contact and a torque, per normal force.
  struct Way {
    Vec3<T> force, torque;
  };
  using Motion = ContactGain<T>;  // or a change of it

  [[nodiscard]] Motion made_by(const Vec3<T>& force, const Vec3<T>& torque) const {
    return formula::contact_gain<T>(body_.mobility, now_, force, torque);
  }

  [[nodiscard]] static T work(const Way& way, const Motion& motion) {
    return formula::contact_work(way.force, way.torque, motion);
  }

  void add(const Vec3<T>& force, const Vec3<T>& torque) {
    ways_[used_] = {force, torque};
    made_[used_++] = made_by(force, torque);
  }

  /// The friction and resistance that go with a normal impulse, each a share of what it can be at most: λ x against the
  /// motion, |x| = 1 where λ > 0 and |x| <= 1 where nothing moves.
  struct Shares {
    Vector x = {};
    T slip = T(0), turning = T(0);  // λ
  };

  /// |x| of a part of x, and x over it. Of numbers of any size: no square leaves the range of T.
  struct Part {
    T size = T(0);
    Vector x = {};
  };
  [[nodiscard]] static Part part_of(const Vector& x, std::size_t from, std::size_t to) {
    Part part;
    T largest(0);
    for (std::size_t i = from; i < to; ++i) {
      largest = scalar::max(scalar::abs(T(x[i])), largest);
    }
    if (!(T(0) < largest)) {
      return part;
    }
    T sum(0);
    for (std::size_t i = from; i < to; ++i) {
      part.x[i] = x[i] / largest;
      sum = sum + scalar::sq(part.x[i]);
    }
    const T size = scalar::sqrt(sum);
    for (std::size_t i = from; i < to; ++i) {
      part.x[i] = part.x[i] / size;
    }
    part.size = largest * size;
    return part;
  }

  /// x of (A + diag λ) x = −b.
  void solve(const Vector& b, Shares& at) {
    ++evaluations_;
    typename Cholesky<T, most>::Matrix M = A_;
    for (std::size_t i = 0; i < used_; ++i) {
      M[i][i] = M[i][i] + (i < forces_ ? at.slip : at.turning);
      at.x[i] = -b[i];
    }
    solvable_ = factors_.factor(M, used_) && solvable_;
    factors_.solve(at.x);
  }

  /// x̂_iᵀ M⁻¹ x̂_j of the parts of x that are friction and resistance, each over its size: λ_j takes |x_i| down by as much of
  /// it.
  struct Slopes {
    T slip_size = T(0), turning_size = T(0);
    T slip = T(0), both = T(0), turning = T(0);
  };
  [[nodiscard]] Slopes slopes(const Shares& at) const {
    const Part slip = part_of(at.x, 0, forces_), turning = part_of(at.x, forces_, used_);
    Vector by_slip = slip.x, by_turning = turning.x;
    factors_.solve(by_slip);
    factors_.solve(by_turning);
    Slopes result{.slip_size = slip.size, .turning_size = turning.size};
    for (std::size_t i = 0; i < used_; ++i) {
      result.slip = result.slip + slip.x[i] * by_slip[i];
      result.both = result.both + turning.x[i] * by_slip[i];
      result.turning = result.turning + turning.x[i] * by_turning[i];
    }
    return result;
  }

  /// λ >= 0 at which a size that falls with it is 1, or 0 where it is less there: Newton's method for its inverse, which is
  /// all but linear, kept between what is too little and too much. `size(λ)` also gives the share of it that λ takes.
  template <class Size>
  void find(T& lambda, Size&& size) {
    constexpr int most_steps = 60;
    const T exact = T(16) * std::numeric_limits<T>::epsilon();
    lambda = T(0);
    T low(0), high = std::numeric_limits<T>::infinity();
    for (int i = 0; i < most_steps; ++i) {
      T slope(0);
      const T over = size(slope) - T(1);
      if ((i == 0 && !(T(0) < over)) || (-exact < over && over < exact)) {
        return;
      }
      if (!scalar::is_finite(over)) {
        solvable_ = false;
        return;
      }
      (T(0) < over ? low : high) = lambda;
      T next = lambda + over / slope;
      if (!(low < next && next < high)) {
        next = high < std::numeric_limits<T>::infinity() ? T((low + high) / T(2)) : T(T(2) * low + T(1));
      }
      if (!(low < next && next < high)) {
        return;
      }
      lambda = next;
    }
  }

  [[nodiscard]] Shares shares(const T& N, const T& size) {
    Vector b = {};
    for (std::size_t i = 0; i < used_; ++i) {
      b[i] = (free_[i] + N * pressed_[i]) / size;
    }
    Shares at;
    const bool limited = 0 < forces_ && !smooth_ && !rough_;
    const auto rub = [&] {
      if (limited) {
        find(at.slip, [&](T& slope) {
          solve(b, at);
          const Slopes by = slopes(at);
          slope = by.slip;
          return by.slip_size;
        });
        return;
      }
      at.slip = smooth_ && 0 < forces_ ? T(T(1) / (size * per_slip_)) : T(0);
      solve(b, at);
    };
    if (forces_ == used_) {
      rub();
      return at;
    }
    find(at.turning, [&](T& slope) {
      rub();
      const Slopes by = slopes(at);
      // Friction that is at its most stays so.
      slope = limited && T(0) < at.slip ? T(by.turning - scalar::sq(by.both) / by.slip) : by.turning;
      return by.turning_size;
    });
    return at;
  }

  /// The velocity at which the contact point leaves after a normal impulse N. Friction that does not end pulls, too.
  [[nodiscard]] T leaving(const T& N, Shares& at) {
    const T size = scalar::abs(N);
    at = shares(N, size);
    T v = c_.z() + N * normal_.point.z();
    for (std::size_t i = 0; i < used_; ++i) {
      v = v + size * at.x[i] * made_[i].point.z();
    }
    return v;
  }

  /// The least N that leaves the contact point on the plane: looked for from far below what it would take without
  /// friction, by factors that grow, and by false position (Illinois) once it is known to within one.
  [[nodiscard]] Onset<T> balanced() {
    Shares at;
    const T epsilon = std::numeric_limits<T>::epsilon();
    const T falls = rough_ ? T(scalar::sqrt(formula::dot(c_, c_)) + h_ * body_.strength) : T(-c_.z());
    const T first = scalar::max(falls, T(epsilon * h_ * body_.strength)) / (T(64) * now_.W.zz);
    solvable_ = true;
    T sign(1), low(0), low_v = c_.z();
    if (rough_) {
      const T hardly = leaving(T(T(1e-6) * first), at);
      sign = hardly < T(0) ? T(1) : T(-1);
      low_v = sign * hardly;
    } else if (!(low_v < T(0))) {
      return {};
    }
    constexpr int most_factors = 10, most_steps = 100;
    T high = first, high_v = sign * leaving(T(sign * high), at);
    T factor(2);
    for (int i = 0; i < most_factors && high_v < T(0); ++i) {
      low = high;
      low_v = high_v;
      high = factor * high;
      high_v = sign * leaving(T(sign * high), at);
      factor = scalar::sq(factor);
    }
    const auto round_off = [&](const T& N) { return T(16) * epsilon * (falls + N * now_.W.zz); };
    int last = 0;
    T left = high_v;
    for (int i = 0; i < most_steps && round_off(high) < left; ++i) {
      T middle = (low + high) / T(2);
      if (T(0) < low && T(8) * low < high) {
        middle = low * scalar::sqrt(T(high / low));
      } else if (low_v < T(0) && i % 4 != 3) {
        middle = low + (high - low) * (low_v / (low_v - high_v));
      }
      if (!(low < middle && middle < high)) {
        break;
      }
      const T v = sign * leaving(T(sign * middle), at);
      if (-round_off(middle) < v) {
        high = middle;
        high_v = left = v;
        low_v = last > 0 ? T(low_v / T(2)) : low_v;  // Illinois
        last = 1;
      } else {
        low = middle;
        low_v = v;
        high_v = last < 0 ? T(high_v / T(2)) : high_v;
        last = -1;
      }
    }
    static_cast<void>(leaving(T(sign * high), at));
    return after(T(sign * high), high, at);
  }

  [[nodiscard]] Onset<T> after(const T& N, const T& size, const Shares& at) const {
    Onset<T> result;
    result.impulse = {T(0), T(0), N};
    Vec3<T> point = formula::plus(c_, N, normal_.point);
    for (std::size_t i = 0; i < used_; ++i) {
      const T share = size * at.x[i];
      result.impulse = formula::plus(result.impulse, share, ways_[i].force);
      result.resistance = formula::plus(result.resistance, share, ways_[i].torque);
      point = formula::plus(point, share, made_[i].point);
    }
    result.closed = solvable_ && scalar::is_finite(T(formula::dot(point, point) + N));
    const bool holds = 0 < forces_ && !(T(0) < at.slip);
    result.slips = !holds;
    result.slip_x = holds ? T(0) : T(point.x());
    result.slip_y = holds ? T(0) : T(point.y());
    result.turns = forces_ == used_ || T(0) < at.turning;
    if (result.turns) {
      result.L = formula::plus(formula::plus(L_, formula::cross(now_.r, result.impulse)), T(1), result.resistance);
    }
    return result;
  }

  const ContactBody<T>& body_;
  const Kinetics<T>& now_;
  T h_;
  bool smooth_, rough_, solvable_ = true;
  int evaluations_ = 0;
  T per_slip_ = T(0);  // [s/m] of the smooth laws
  Vec3<T> c_, L_;      // velocity of the contact point and angular momentum, without any force of contact
  Motion normal_;
  std::array<Way, most> ways_;
  std::array<Motion, most> made_;
  std::size_t forces_ = 0, used_ = 0;
  typename Cholesky<T, most>::Matrix A_ = {};
  Cholesky<T, most> factors_;
  Vector free_ = {}, pressed_ = {};
};

/// So short a time that motion changes by nothing but what begins in it   [s].
template <Ordered T>
[[nodiscard]] T onset_time(const ContactBody<T>& body, const Kinetics<T>& now, const T& s_x, const T& s_y) {
  const T turning = scalar::sqrt(formula::dot(now.w, now.w));
  const T slip = scalar::sqrt(T(scalar::sq(s_x) + scalar::sq(s_y))) / body.stone.width;
  return scalar::max(T(1e-7), T(scalar::sqrt(std::numeric_limits<T>::epsilon()))) / (body.frequency + turning + slip);
}

}  // namespace goishi::detail
