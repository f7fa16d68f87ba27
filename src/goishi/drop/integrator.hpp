#pragma once
/// \file
/// Integrates one set of contact equations, with error control, up to the event that ends their validity.

#include <array>
#include <goishi/drop/contact_state.hpp>
#include <goishi/drop/dormand_prince.hpp>
#include <goishi/drop/energy_balance.hpp>
#include <goishi/drop/gliding.hpp>
#include <goishi/drop/rest.hpp>
#include <goishi/drop/rolling.hpp>

namespace goishi::detail {

/// Why the contact phase ended.
enum class ContactEnd { rest, lift_off, board_edge, side, time, too_many_events, too_many_steps, stuck };

template <Ordered T>
class ContactIntegrator {
 public:
  explicit ContactIntegrator(ContactState<T>& contact)
      : contact_(contact), run_(contact.run), step_(T(1e-2) / contact.scales.frequency) {}

  /// Why it ended where `operator()` gives no guard.
  [[nodiscard]] ContactEnd end() const { return end_; }

  /// Integrates until a guard changes its sign, and returns it; `none` where `end` says why it ended.
  template <class Equations>
  [[nodiscard]] Guard operator()(Equations& equations) {
    contact_.y[at::loss] = T(0);
    Variables<T> rate = equations(contact_.y);
    EnergyBalance<T> balance(contact_, equations, run_.settings.tolerance);
    std::array<T, guard_count> old = guards_of(equations, contact_.y);
    const Guard at_once = broken_at_once<Equations>(old);
    Guard result = at_once;
    while (result == Guard::none) {
      if (is_at_rest(contact_, equations, run_.settings.tolerance)) {
        end_ = ContactEnd::rest;
        break;
      }
      const T left = run_.settings.horizon - run_.time;
      if (!(T(0) < left)) {
        end_ = ContactEnd::time;
        break;
      }
      if (run_.settings.maximum_steps <= run_.result.counters.steps_accepted) {
        end_ = ContactEnd::too_many_steps;
        break;
      }
      T h = left < step_ ? left : step_;
      Trial<T, variables> trial;
      if (!accepted_step(equations, rate, balance, h, trial)) {
        result = equations.jams() ? Guard::jam : Guard::none;
        end_ = ContactEnd::stuck;
        break;
      }
      std::array<T, guard_count> now = guards_of(equations, trial.y);
      result = locate(equations, rate, old, now, h, trial);
      ++run_.result.counters.steps_accepted;
      contact_.y = trial.y;
      // Locating tries other steps: what the equations saw last is then not where it ends.
      rate = result == Guard::none ? trial.rate : equations(trial.y);
      contact_.normalize();
      balance.restore(equations);
      old = now;
      run_.time = run_.time + h;
      if (result == Guard::none && stops_turning(contact_, equations, run_.settings.tolerance)) {
        result = Guard::turning;
      }
      if (result == Guard::none && slip_vanishes(equations, rate)) {
        result = Guard::slip;
      }
      if (result == Guard::none && contact_.carried_far()) {
        run_.state.q_WB = contact_.attitude();
        contact_.rebase(run_.state.q_WB);
        contact_.y[at::spin] = T(0);
        equations.carry_from(contact_.origin);
        rate = equations(contact_.y);
      }
    }
    run_.result.counters.contact_evaluations += equations.evaluations;
    return result;
  }

 private:
  using GuardValues = std::array<T, guard_count>;

  /// A step that the error control accepts. False where there is none.
  template <class Equations>
  [[nodiscard]] bool accepted_step(Equations& equations, const Variables<T>& rate, const EnergyBalance<T>& balance,
                                   T& h, Trial<T, variables>& trial) {
    while (true) {
      bool possible = true;
      trial = equations.step(contact_.y, rate, h, possible);
      T error(1e30);
      if (possible) {
        // A step that oversteps a whole feature meets smooth rates on either side of it; the energy shows it.
        const T worst = balance.defect(equations, trial.y);
        const T estimated = error_of(equations, trial, h);
        error = worst <= estimated ? estimated : worst;
      }
      const T factor = step_factor(error, equations.order());
      // The shortest step passes what no error control can: a jump of the equations.
      if (error <= T(1) || (possible && h < shortest_step)) {
        step_ = h * factor;
        return true;
      }
      ++run_.result.counters.steps_rejected;
      h = h * factor;
      if (h < T(1e-16)) {
        return false;
      }
    }
  }

  /// Whether dry slip is about to end: what is left of it is below a hundredth of a step's error, or lasts no longer than
  /// the shortest step.
  template <class Equations>
  [[nodiscard]] bool slip_vanishes(const Equations&, const Variables<T>& rate) const {
    if constexpr (Equations::names[3] == Guard::slip) {
      const T sigma = contact_.y[at::slip], braking = -rate[at::slip];
      return T(0) < braking &&
             (sigma < T(0.01) * run_.settings.tolerance * contact_.scales.speed || sigma < shortest_step * braking);
    }
    return false;
  }

  template <class Equations>
  [[nodiscard]] GuardValues guards_of(const Equations& equations, const Variables<T>& y) const {
    GuardValues value = equations.guards().value;
    if (run_.board != nullptr) {
      value[guard_count - 1] = contact_.support_guard(equations.now, y);
    }
    return value;
  }

  /// Normal force and grip are to be there from the start.
  template <class Equations>
  [[nodiscard]] static Guard broken_at_once(const GuardValues& guards) {
    for (std::size_t i = 0; i < guard_count; ++i) {
      const Guard name = Equations::names[i];
      const bool strict = name == Guard::lift_off || name == Guard::jam;
      if ((strict && guards[i] <= T(0)) || (name == Guard::grip && guards[i] < T(-1e-8)) ||
          (name == Guard::feature && guards[i] < T(-1e-9)) || (name == Guard::support && guards[i] <= T(0))) {
        return name;
      }
    }
    return Guard::none;
  }

  /// Whether a guard breaks within the step: the first that does, and the step cut to where it does.
  template <class Equations>
  [[nodiscard]] Guard locate(Equations& equations, const Variables<T>& rate, const GuardValues& old, GuardValues& now,
                             T& h, Trial<T, variables>& trial) {
    Guard found = Guard::none;
    for (std::size_t pass = 0; pass < guard_count; ++pass) {
      std::size_t which = guard_count;
      for (std::size_t i = 0; i < guard_count; ++i) {
        const Guard name = Equations::names[i];
        if (name != Guard::none && name != found && now[i] < T(0) && now[i] < old[i]) {
          which = i;
          break;
        }
      }
      if (which == guard_count) {
        break;
      }
      found = Equations::names[which];
      find(equations, rate, old, now, which, h, trial);
    }
    return found;
  }

  /// Illinois on the length of the step.
  template <class Equations>
  void find(Equations& equations, const Variables<T>& rate, const GuardValues& old, GuardValues& now, std::size_t which,
            T& h, Trial<T, variables>& trial) {
    constexpr int most_steps = 60;
    const T small = T(1e-12);
    T low(0), high = h, low_value = old[which], high_value = now[which];
    // From a change of equations the guard starts at zero: some shorter step is to show it positive first. A slip is zero
    // then without round-off, and however short it lives counts: that time has to pass.
    const T shown = Equations::names[which] == Guard::slip ? T(0) : small;
    for (int i = 0; i < most_steps && !(shown < low_value); ++i) {
      const T middle = high / T(2);
      bool possible = true;
      const Trial<T, variables> other = equations.step(contact_.y, rate, middle, possible);
      ++run_.result.counters.steps_located;
      if (!possible) {
        break;
      }
      const GuardValues then = guards_of(equations, other.y);
      if (shown < then[which]) {
        low = middle;
        low_value = then[which];
      } else {
        trial = other;
        h = high = middle;
        now = then;
        high_value = then[which];
      }
    }
    if (!(shown < low_value)) {
      return;
    }
    int last = 0;
    for (int i = 0; i < most_steps; ++i) {
      if (-small < now[which] && now[which] < small) {
        break;
      }
      const T middle = low + (high - low) * (low_value / (low_value - high_value));
      if (!(low < middle && middle < high)) {
        break;
      }
      bool possible = true;
      const Trial<T, variables> other = equations.step(contact_.y, rate, middle, possible);
      ++run_.result.counters.steps_located;
      if (!possible) {
        break;
      }
      trial = other;
      h = middle;
      now = guards_of(equations, trial.y);
      const T value = now[which];
      const int side = value < T(0) ? -1 : 1;
      (side < 0 ? high : low) = middle;
      (side < 0 ? high_value : low_value) = value;
      if (side == last) {
        (side < 0 ? low_value : high_value) = (side < 0 ? low_value : high_value) / T(2);
      }
      last = side;
    }
  }

  /// The greatest error of a variable over what is allowed.
  template <class Equations>
  [[nodiscard]] T error_of(const Equations& equations, const Trial<T, variables>& trial, const T& h) const {
    const T momentum2 = scalar::sq(trial.y[at::L]) + scalar::sq(trial.y[at::L + 1]) + scalar::sq(trial.y[at::L + 2]);
    // Where a stone hardly turns, what matters is in which direction: resistance goes by that. With the coarser scale the
    // integration finds false states of slow creep there.
    const T usual = contact_.scales.frequency / contact_.body.mobility.transverse;
    const T slow = T(1e-3) * usual;
    const T least = contact_.body.resists && momentum2 < scalar::sq(slow) ? slow : usual;
    const T momentum = scalar::sqrt(T(momentum2 + scalar::sq(least)));
    const std::array<T, variables> weight = {T(1),
                                             T(1),
                                             T(1),
                                             T(T(1) / momentum),
                                             T(T(1) / momentum),
                                             T(T(1) / momentum),
                                             T(T(1) / contact_.scales.length),
                                             T(T(1) / contact_.scales.length),
                                             T(1),
                                             T(T(1) / scalar::sq(contact_.scales.speed)),
                                             T(T(1) / contact_.scales.speed),
                                             equations.weight_of_direction(trial.y, contact_.scales.speed, h)};
    T worst(0);
    for (std::size_t i = 0; i < Equations::used; ++i) {
      const T error = weight[i] * (trial.error[i] < T(0) ? T(-trial.error[i]) : trial.error[i]);
      if (!(error <= worst)) {
        worst = error;
      }
    }
    return worst / run_.settings.tolerance;
  }

  static constexpr T shortest_step = T(1e-13);  // [s] round-off of a time of 100 s

  ContactState<T>& contact_;
  Run<T>& run_;
  T step_;  // [s] to try next
  ContactEnd end_ = ContactEnd::time;
};

}  // namespace goishi::detail
