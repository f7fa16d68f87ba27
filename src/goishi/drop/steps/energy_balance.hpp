#pragma once
/// \file
/// Energy as a witness of the contact phase's steps, and as what they are taken back to.

#include <goishi/drop/state/contact_state.hpp>
#include <limits>

namespace goishi::detail {

/// Energy and losses of the contact phase add up to what there was at its beginning. The integration knows both, so a
/// step's defect is an error that is seen; and what the steps leave of it is taken out of the velocities.
template <Ordered T>
class EnergyBalance {
 public:
  EnergyBalance() = default;

  /// From variables that `equations` saw last.
  template <class Equations>
  EnergyBalance(const Run<T>& run, const Equations& equations, const Variables<T>& y)
      : energy_(energy_of(run, equations, y).total) {}

  /// Energy and losses, as the steps have left them   [m²/s²].
  [[nodiscard]] T total() const { return energy_ + excess_; }

  /// What a step to y, which `equations` saw last, adds to the balance: 1 is the tolerance of speed².
  template <class Equations>
  [[nodiscard]] T defect(const Run<T>& run, const Equations& equations, const Variables<T>& y) const {
    const Energy now = energy_of(run, equations, y);
    const T change = now.total + y[at::loss] - energy_ - excess_;
    const T potential = now.kinetic - now.total;
    const T round_off = T(64) * std::numeric_limits<T>::epsilon() * (now.kinetic + scalar::abs(potential));
    return scalar::abs(change) /
           (run.settings.tolerance * run.scales.thinness * scalar::sq(run.scales.speed) + round_off);
  }

  /// Takes the velocities back to what energy and losses allow, all by one factor, and by no more than a step's error.
  /// What is left waits for the next steps: near a turning point, where the stone all but stands still.
  template <class Equations>
  void restore(const Run<T>& run, const Equations& equations, Variables<T>& y) {
    const Energy now = energy_of(run, equations, y);
    const T excess = now.total + y[at::loss] - energy_;
    const T taken = taken_of<T>(now.kinetic, excess, run.settings.tolerance * run.scales.speed);
    excess_ = excess - taken;
    if (!(T(0) < now.kinetic)) {
      return;
    }
    const T factor = formula::slowing(taken, now.kinetic);
    for (std::size_t i = at::L; i < at::L + 3; ++i) {
      y[i] = factor * y[i];
    }
    y[at::slip] = factor * y[at::slip];
    if constexpr (Equations::slip_is_vector) {
      y[at::direction] = factor * y[at::direction];
    }
  }

 private:
  struct Energy {
    T kinetic, total;
  };

  /// Per unit of mass, at variables that `equations` saw last   [m²/s²].
  template <class Equations>
  [[nodiscard]] static Energy energy_of(const Run<T>& run, const Equations& equations, const Variables<T>& y) {
    const T kinetic = formula::contact_kinetic_energy(equations.now, equations.slip_x(y), equations.slip_y(y));
    return {kinetic, formula::contact_energy(equations.now, run.contact_body.gravity, y[at::x], y[at::y], kinetic)};
  }

  T energy_ = T(0);
  T excess_ = T(0);  // [m²/s²] that `restore` left
};

}  // namespace goishi::detail
