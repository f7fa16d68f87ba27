#pragma once
/// \file
/// The impulses of all contacts of a cluster together: Gauss and Seidel's sweeps over exact solutions of one, with
/// Anderson's acceleration.

#include <array>
#include <cstddef>
#include <goishi/drop/schemes/cholesky.hpp>
#include <goishi/scene/cluster/row.hpp>
#include <goishi/scene/events.hpp>
#include <vector>

namespace goishi::detail {

/// Plain sweeps creep where stones lean on each other, 1e-3 of the way each. What several sweeps have changed tells where
/// they lead.
template <Ordered T>
class Sweeps {
 public:
  std::vector<Mover<T>> movers;
  std::vector<Row<T>> rows;

  void clear() {
    movers.clear();
    rows.clear();
  }

  /// From the rows' impulses, until a sweep changes no velocity of a contact by more than `tolerance` [m/s]. False if the
  /// sweeps are used up; then the impulses are those of the last, inside their cones, or if those add energy, some that take
  /// it: blow by blow.
  [[nodiscard]] bool solve(const T& tolerance, int most_sweeps, SceneCounters& counters) {
    ++counters.solves;
    moved();
    kept_ = 0;
    T last_size(0);
    for (int sweep = 1; sweep <= most_sweeps; ++sweep) {
      accelerates_ = plain_sweeps <= sweep && sweep < most_sweeps;
      const bool remembers = plain_sweeps - 1 <= sweep && sweep < most_sweeps;
      if (remembers) {
        read(before_);
      }
      const T change = once();
      ++counters.sweeps;
      counters.updates += static_cast<long long>(rows.size());
      if (change <= tolerance) {
        return true;
      }
      if (remembers) {
        accelerate(last_size);
      }
    }
    ++counters.unsolved;
    const auto energy = [&](bool now) {
      T sum(0);
      for (const Mover<T>& body : movers) {
        sum = sum + body.twice_kinetic_energy(now ? body.v : body.free_v, now ? body.w : body.free_w);
      }
      return sum;
    };
    if (energy(false) < energy(true)) {
      blow_by_blow();
      counters.updates += static_cast<long long>(blows * rows.size());
    }
    return false;
  }

  /// Velocities of all bodies from the impulses.
  void moved() {
    for (Mover<T>& body : movers) {
      body.v = body.free_v;
      body.w = body.free_w;
    }
    for (const Row<T>& row : rows) {
      push(row, row.in_world(row.p));
      twist(row, row.torque);
    }
  }

  /// Velocity of the first body's point relative to the second's, in W.
  [[nodiscard]] Vec3<T> velocity(const Row<T>& row) const {
    const Mover<T>& a = movers[row.a];
    Vec3<T> v = formula::plus(a.v, formula::cross(a.w, row.ra));
    if (row.b != no_index) {
      const Mover<T>& b = movers[row.b];
      v = formula::minus(v, formula::plus(b.v, formula::cross(b.w, row.rb)));
    }
    return v;
  }

 private:
  static constexpr int plain_sweeps = 4;
  static constexpr int blows = 16;  // of each contact, where they do not add up to a solution
  static constexpr std::size_t columns = 5;

  void push(const Row<T>& row, const Vec3<T>& P) {
    Mover<T>& a = movers[row.a];
    a.v = formula::plus(a.v, a.mobility.linear, P);
    a.w = formula::plus(a.w, formula::turning(a.mobility, a.u, formula::cross(row.ra, P)));
    if (row.b != no_index) {
      Mover<T>& b = movers[row.b];
      b.v = formula::plus(b.v, T(-b.mobility.linear), P);
      b.w = formula::minus(b.w, formula::turning(b.mobility, b.u, formula::cross(row.rb, P)));
    }
  }

  void twist(const Row<T>& row, const Vec3<T>& torque) {
    Mover<T>& a = movers[row.a];
    a.w = formula::plus(a.w, formula::turning(a.mobility, a.u, torque));
    if (row.b != no_index) {
      Mover<T>& b = movers[row.b];
      b.w = formula::minus(b.w, formula::turning(b.mobility, b.u, torque));
    }
  }

  /// One sweep. The greatest change of a contact's velocity.
  [[nodiscard]] T once() {
    T greatest(0);
    for (Row<T>& row : rows) {
      const Vec3<T> now = formula::plus(row.in_frame(velocity(row)), row.bias);
      const Vec3<T> f = formula::minus(now, formula::product(row.W, row.p));
      const Vec3<T> p = contact_impulse(row.W, row.S, row.friction, f);
      const Vec3<T> more = formula::minus(p, row.p);
      if (T(0) < formula::dot(more, more)) {
        push(row, row.in_world(more));
        const Vec3<T> change = formula::product(row.W, more);
        for (Eigen::Index i = 0; i < 3; ++i) {
          greatest = scalar::max(greatest, scalar::abs(T(change[i])));
        }
        row.p = p;
      }
      if (T(0) < row.rolling) {
        resist(row, greatest);
      }
    }
    return greatest;
  }

  /// Each contact stops what it meets at its turn, as if by an impact without restitution, and takes nothing back: but for what
  /// moves by itself and overlaps, that takes energy, whatever leans on what.
  void blow_by_blow() {
    for (Row<T>& row : rows) {
      row.p = row.torque = Vec3<T>(T(0), T(0), T(0));
    }
    moved();
    for (int sweep = 0; sweep < blows; ++sweep) {
      for (Row<T>& row : rows) {
        const Vec3<T> now = formula::plus(row.in_frame(velocity(row)), row.bias);
        const Vec3<T> more = contact_impulse(row.W, row.S, row.friction, now);
        if (T(0) < formula::dot(more, more)) {
          push(row, row.in_world(more));
          row.p = formula::plus(row.p, more);
        }
      }
    }
  }

  /// Resistance: the torque that would stop all relative turning, or what of it the normal impulse bears.
  void resist(Row<T>& row, T& greatest) {
    const Mover<T>& a = movers[row.a];
    const Vec3<T> turning = formula::minus(a.w, row.b != no_index ? movers[row.b].w : row.other_w);
    Vec3<T> torque = Vec3<T>(T(0), T(0), T(0));
    if (T(0) < row.p.z()) {
      torque = formula::minus(row.torque, formula::product(row.turn, turning));
      if (T(1) < formula::resistance_share(row.n, torque, T(row.p.z()), row.rolling, row.pivot)) {
        torque = borne(row, torque);
      }
    }
    const Vec3<T> more = formula::minus(torque, row.torque);
    if (!(T(0) < formula::dot(more, more))) {
      return;
    }
    twist(row, more);
    row.torque = torque;
    const Vec3<T> w = formula::turning(a.mobility, a.u, more);
    const T change = a.reach * scalar::sqrt(formula::dot(w, w));
    greatest = scalar::max(greatest, change);
  }

  /// Of a torque that would stop all turning, what the normal impulse p_n bears: against the turning that is left, as
  /// resistance is of a stone alone, τ ∝ −D⁻¹ ω.
  ///
  ///     (M + λ D) τ = M τ₀,  τ · D τ = p_n²,  M = I_a⁻¹ + I_b⁻¹,  D = (1 − n nᵀ)/δ² + n nᵀ/κ²,  λ > 0
  [[nodiscard]] static Vec3<T> borne(const Row<T>& row, const Vec3<T>& stopping) {
    const Vec3<T>& n = row.n;
    const ContactMatrix<T> M = inverted(row.turn);
    const Vec3<T> right = formula::product(M, stopping);
    // In units of δ².
    const T more = scalar::sq(T(row.rolling / row.pivot)) - T(1), bound = row.rolling * row.p.z();
    const auto D = [&](const Vec3<T>& x) { return formula::plus(x, T(more * formula::dot(n, x)), n); };
    const auto solved = [&](const T& lambda, const Vec3<T>& b) {
      const T k = lambda * more;
      return formula::solution(ContactMatrix<T>{.xx = T(M.xx + lambda + k * n.x() * n.x()),
                                                .yy = T(M.yy + lambda + k * n.y() * n.y()),
                                                .zz = T(M.zz + lambda + k * n.z() * n.z()),
                                                .xy = T(M.xy + k * n.x() * n.y()),
                                                .xz = T(M.xz + k * n.x() * n.z()),
                                                .yz = T(M.yz + k * n.y() * n.z())},
                               b);
    };
    constexpr int most_steps = 30;
    Vec3<T> torque = stopping;
    T lambda(0), size(0);
    for (int i = 0; i < most_steps; ++i) {
      const Vec3<T> weighed = D(torque);
      size = scalar::sqrt(formula::dot(torque, weighed));
      if (size <= T(T(1) + T(1e-9)) * bound) {
        break;
      }
      // Newton on 1/size, from below.
      lambda = lambda + (size / bound - T(1)) * scalar::sq(size) / formula::dot(weighed, solved(lambda, weighed));
      torque = solved(lambda, right);
    }
    return formula::scaled(size <= bound ? T(1) : T(bound / size), torque);
  }

  void read(std::vector<T>& x) const {
    x.clear();
    for (const Row<T>& row : rows) {
      const T over = T(1) / movers[row.a].reach;
      for (Eigen::Index i = 0; i < 3; ++i) {
        x.push_back(row.p[i]);
      }
      for (Eigen::Index i = 0; i < 3; ++i) {
        x.push_back(over * row.torque[i]);
      }
    }
  }

  void write(const std::vector<T>& x) {
    std::size_t k = 0;
    for (Row<T>& row : rows) {
      const T reach = movers[row.a].reach;
      for (Eigen::Index i = 0; i < 3; ++i) {
        row.p[i] = x[k++];
      }
      for (Eigen::Index i = 0; i < 3; ++i) {
        row.torque[i] = reach * x[k++];
      }
    }
    moved();
  }

  [[nodiscard]] static T product(const std::vector<T>& a, const std::vector<T>& b) {
    T sum(0);
    for (std::size_t i = 0; i < a.size(); ++i) {
      sum = sum + a[i] * b[i];
    }
    return sum;
  }

  /// x ← g − Σ γ_k ΔG_k, the γ_k by least squares on f − Σ γ_k ΔF_k: f = g − x what a sweep changes, ΔF and ΔG what its
  /// changes and results have changed by from sweep to sweep.
  void accelerate(T& last_size) {
    read(after_);
    change_.resize(after_.size());
    for (std::size_t i = 0; i < after_.size(); ++i) {
      change_[i] = after_[i] - before_[i];
    }
    const T size = product(change_, change_);
    if (T(4) * last_size < size) {
      kept_ = 0;
    } else if (accelerates_) {
      const std::size_t k = kept_++ % columns;
      changes_[k].resize(change_.size());
      results_[k].resize(change_.size());
      for (std::size_t i = 0; i < change_.size(); ++i) {
        changes_[k][i] = change_[i] - last_change_[i];
        results_[k][i] = after_[i] - last_after_[i];
      }
    }
    last_change_ = change_;
    last_after_ = after_;
    last_size = size;
    const std::size_t used = kept_ < columns ? kept_ : columns;
    if (used == 0) {
      return;
    }
    typename Cholesky<T, columns>::Matrix products = {};
    std::array<T, columns> gamma = {};
    for (std::size_t i = 0; i < used; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        products[i][j] = product(changes_[i], changes_[j]);
      }
      products[i][i] = products[i][i] * (T(1) + T(1e-10));
      gamma[i] = product(changes_[i], change_);
    }
    Cholesky<T, columns> factors;
    if (!factors.factor(products, used)) {
      kept_ = 0;
      return;
    }
    factors.solve(gamma);
    for (std::size_t k = 0; k < used; ++k) {
      for (std::size_t i = 0; i < after_.size(); ++i) {
        after_[i] = after_[i] - gamma[k] * results_[k][i];
      }
    }
    write(after_);
  }

  bool accelerates_ = false;
  std::size_t kept_ = 0;
  std::vector<T> before_, after_, change_, last_change_, last_after_;
  std::array<std::vector<T>, columns> changes_, results_;
};

}  // namespace goishi::detail
