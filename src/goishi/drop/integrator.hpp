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
      : contact_(contact),
        run_(contact.run),
        step_(T(1e-2) / contact.scales.frequency),
        longest_step_(T(100) / contact.scales.frequency) {}

  /// Why it ended where `operator()` gives no guard.
  [[nodiscard]] ContactEnd end() const { return end_; }

  /// Integrates until a guard changes its sign, and returns it; `none` where `end` says why it ended. What has `begun`
  /// just now goes on for a step at least.
  template <class Equations>
  [[nodiscard]] Guard operator()(Equations& equations, bool begun) {
    contact_.y[at::loss] = T(0);
    Variables<T> rate = equations(contact_.y);
    if (rests(equations, rate)) {
      return over(equations, ContactEnd::rest);
    }
    if (slips() && stops_turning(contact_, equations, run_.settings.tolerance)) {
      return over(equations, ContactEnd::time, Guard::turning);
    }
    if (!begun && turning_is_to_begin(equations, rate)) {
      return over(equations, ContactEnd::time, Guard::onset);
    }
    EnergyBalance<T> balance(contact_, equations, run_.settings.tolerance);
    GuardValues old = guards_of(equations, contact_.y);
    Guard result = broken_at_once<Equations>(old);
    while (result == Guard::none) {
      const T left = run_.left();
      if (!(T(0) < left)) {
        return over(equations, ContactEnd::time);
      }
      T h = left < step_ ? left : step_;
      h = longest_step_ < h ? longest_step_ : h;
      equations.begin_step();
      const T cut = short_of_standstill(equations, rate, h);
      const bool is_cut = cut < h;
      h = is_cut ? cut : h;
      const T usual = step_;
      Trial<T, variables> trial;
      if (!accepted_step(equations, rate, balance, h, trial)) {
        if (!run_.has_budget()) {
          return over(equations, ContactEnd::too_many_steps);
        }
        end_ = ContactEnd::stuck;
        result = equations.jams() ? Guard::jam : Guard::none;
        break;
      }
      if (is_cut && !(h < cut) && step_ < usual) {
        step_ = usual;
      }
      GuardValues now = guards_of(equations, trial.y);
      result = locate(equations, rate, old, now, h, trial);
      ++run_.result.counters.steps_accepted;
      contact_.y = trial.y;
      // Locating tries other steps: what the equations saw last is then not where it ends.
      rate = result == Guard::none ? trial.rate : equations(trial.y);
      contact_.normalize();
      balance.restore(equations);
      old = now;
      run_.time = run_.time + h;
      if (result != Guard::none) {
        break;
      }
      if (rests(equations, rate)) {
        return over(equations, ContactEnd::rest);
      }
      if (slips() && stops_turning(contact_, equations, run_.settings.tolerance)) {
        result = Guard::turning;
      } else if (ends_slip(equations, rate)) {
        result = Guard::slip;
      } else if (turning_is_to_begin(equations, rate)) {
        result = Guard::onset;
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

  template <class Equations>
  [[nodiscard]] Guard over(const Equations& equations, ContactEnd end, Guard guard = Guard::none) {
    run_.result.counters.contact_evaluations += equations.evaluations;
    end_ = end;
    return guard;
  }

  // --- standing still

  /// Whether the stone comes to rest, before the horizon; then it is there. Resistance brakes what is left of the motion
  /// as it does now, so that the kinetic energy E falls as a square of the time left: that is 2E/−Ė.
  template <class Equations>
  [[nodiscard]] bool rests(const Equations& equations, const Variables<T>& rate) {
    Variables<T>& y = contact_.y;
    if (!is_at_rest(contact_, equations, run_.settings.tolerance)) {
      return false;
    }
    const Kinetics<T>& k = equations.now;
    const Vec3<T>& g = contact_.body.gravity;
    const T energy = formula::contact_kinetic_energy(k, equations.slip_x(y), equations.slip_y(y));
    const T taken = rate[at::loss] - (g.x() * rate[at::x] + g.y() * rate[at::y] - g.z() * k.point.z());
    const T stop = no_energy(contact_.body) < energy && T(0) < taken ? T(T(2) * energy / taken) : T(0);
    if (run_.left() < stop) {
      return false;
    }
    Variables<T> there = y;
    for (std::size_t i = 0; i < at::loss; ++i) {
      there[i] = there[i] + stop / T(2) * rate[i];
    }
    if (T(0) < stop && !is_held(contact_.body, kinetics(contact_.body, contact_.feature, there).r)) {
      return false;
    }
    y = there;
    run_.time = run_.time + stop;
    stand_still();
    return true;
  }

  void stand_still() {
    Variables<T>& y = contact_.y;
    y[at::L] = y[at::L + 1] = y[at::L + 2] = y[at::slip] = T(0);
    if (contact_.mode == ContactMode::gliding) {
      y[at::direction] = T(0);
    }
    contact_.normalize();
  }

  /// Whether a slip has a direction: a dry one that begins has not yet.
  [[nodiscard]] bool slips() const { return contact_.mode != ContactMode::sliding || T(0) < contact_.y[at::slip]; }

  /// Whether resistance has stopped the turning, or a stone that does not turn yet will: which way, the equations do not
  /// say there, since resistance is against it.
  template <class Equations>
  [[nodiscard]] bool turning_is_to_begin(const Equations& equations, const Variables<T>& rate) const {
    const Kinetics<T>& k = equations.now;
    return contact_.body.resists && T(0) < k.need.z() && !contact_.turns(k.w) &&
           k.w.x() * rate[at::L] + k.w.y() * rate[at::L + 1] + k.w.z() * rate[at::L + 2] <= T(0);
  }

  /// The step cut to just before the turning ceases, if it does within it: as L goes now, J L · L has a least value that is
  /// next to nothing. A dry slip is cut in the same way.
  template <class Equations>
  [[nodiscard]] T short_of_standstill(const Equations&, const Variables<T>& rate, T h) const {
    if constexpr (Equations::names[3] == Guard::slip) {
      const T way = T(-0.8) * contact_.y[at::slip];
      h = way < T(0) && h * rate[at::slip] < way ? T(way / rate[at::slip]) : h;
    }
    if (!contact_.body.resists) {
      return h;
    }
    const Variables<T>& y = contact_.y;
    const Vec3<T> u(y[at::u], y[at::u + 1], y[at::u + 2]), L(y[at::L], y[at::L + 1], y[at::L + 2]);
    const Vec3<T> L_rate(rate[at::L], rate[at::L + 1], rate[at::L + 2]);
    const Vec3<T> w_rate = formula::turning(contact_.body.mobility, u, L_rate);
    const T falls = -formula::dot(L, w_rate), bends = formula::dot(L_rate, w_rate);
    if (!(falls < h * bends) || !(T(0) < falls)) {
      return h;
    }
    const T now = formula::dot(L, formula::turning(contact_.body.mobility, u, L));
    return now - falls * (falls / bends) < T(0.0025) * now ? T(T(0.98) * (falls / bends)) : h;
  }

  // --- steps

  /// A step that the error control accepts. False where there is none, or no budget for another try.
  template <class Equations>
  [[nodiscard]] bool accepted_step(Equations& equations, const Variables<T>& rate, const EnergyBalance<T>& balance,
                                   T& h, Trial<T, variables>& trial) {
    const T shortest = shortest_step();
    bool tried = false;
    while (run_.has_budget()) {
      bool possible = true;
      trial = equations.step(contact_.y, rate, h, possible);
      T error = T(1e10);  // as far off as `step_factor` counts
      if (possible) {
        // A step that oversteps a whole feature meets smooth rates on either side of it; the energy shows it.
        const T worst = balance.defect(equations, trial.y);
        const T estimated = error_of(equations, trial, h);
        error = worst <= estimated ? estimated : worst;
      }
      const T suggested = step_factor(error, equations.order());
      // What has just been too long is not tried again at once.
      const T factor = tried && T(1) < suggested ? T(1) : suggested;
      tried = true;
      // The shortest step passes what no error control can: a jump of the equations.
      if (error <= T(1) || (possible && h < shortest)) {
        step_ = h * factor;
        return true;
      }
      ++run_.result.counters.steps_rejected;
      h = h * factor;
      if (h < T(1e-3) * shortest) {
        return false;
      }
    }
    return false;
  }

  /// Round-off of the time   [s].
  [[nodiscard]] T shortest_step() const {
    return T(16) * std::numeric_limits<T>::epsilon() * (run_.time + T(1000) / contact_.scales.frequency);
  }

  /// Whether dry slip ends now: what is left of it is below a hundredth of a step's error, or will be gone so soon that its
  /// brake stays the same till then. Then it has gone.
  template <class Equations>
  [[nodiscard]] bool ends_slip(const Equations&, const Variables<T>& rate) {
    if constexpr (Equations::names[3] == Guard::slip) {
      Variables<T>& y = contact_.y;
      const T sigma = y[at::slip], braking = -rate[at::slip], tolerance = run_.settings.tolerance;
      if (!(T(0) < braking)) {
        return false;
      }
      const T rest = sigma / braking, turned = size_of(T(rest * rate[at::direction]));
      const T little = T(0.01) * tolerance * contact_.scales.speed;
      if (scalar::sq(T(rest * contact_.scales.frequency / contact_.scales.thinness)) < T(1e-5) * tolerance &&
          sigma * turned < little && rest < run_.left()) {
        for (std::size_t i = 0; i < at::slip; ++i) {
          y[i] = y[i] + rest * rate[i];
        }
        contact_.normalize();
        run_.time = run_.time + rest;
      } else if (!(sigma < little || rest < shortest_step())) {
        return false;
      }
      y[at::slip] = T(0);
      return true;
    }
    return false;
  }

  template <class Equations>
  [[nodiscard]] GuardValues guards_of(const Equations& equations, const Variables<T>& y) const {
    GuardValues value = equations.guards().value;
    if (run_.board != nullptr) {
      value[guard_count - 1] = contact_.support_guard(equations.now, y) / contact_.scales.length;
    }
    return value;
  }

  /// Normal force and grip are to be there from the start.
  template <class Equations>
  [[nodiscard]] static Guard broken_at_once(const GuardValues& guards) {
    for (std::size_t i = 0; i < guard_count; ++i) {
      const Guard name = Equations::names[i];
      const bool strict = name == Guard::lift_off || name == Guard::jam;
      if ((strict && guards[i] <= T(0)) || (name == Guard::grip && guards[i] < -(T(10) * guard_noise<T>())) ||
          (name == Guard::feature && guards[i] < -guard_noise<T>()) || (name == Guard::support && guards[i] <= T(0))) {
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
    const T small = at_least(T(1e-12), T(32) * std::numeric_limits<T>::epsilon());
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

  [[nodiscard]] static T size_of(const T& x) { return x < T(0) ? T(-x) : x; }

  /// The greatest error of a variable over what is allowed.
  template <class Equations>
  [[nodiscard]] T error_of(const Equations& equations, const Trial<T, variables>& trial, const T& h) const {
    const T momentum2 = scalar::sq(trial.y[at::L]) + scalar::sq(trial.y[at::L + 1]) + scalar::sq(trial.y[at::L + 2]);
    // Where a stone hardly turns, what matters is in which direction: resistance goes by that. With the coarser scale the
    // integration finds false states of slow creep there.
    const T usual = contact_.scales.thinness * contact_.scales.frequency / contact_.body.mobility.transverse;
    const T slow = T(1e-3) * usual;
    const T least = contact_.body.resists && momentum2 < scalar::sq(slow) ? slow : usual;
    const T momentum = scalar::sqrt(T(momentum2 + scalar::sq(least)));
    const auto place = [&](const T& x) {  // no error is below round-off
      return T(1) / (contact_.scales.length +
                     T(64) * std::numeric_limits<T>::epsilon() / run_.settings.tolerance * size_of(x));
    };
    const T& speed = contact_.scales.speed;
    const T& thin = contact_.scales.thinness;
    const std::array<T, variables> weight = {T(T(1) / thin),
                                             T(T(1) / thin),
                                             T(T(1) / thin),
                                             place(trial.y[at::x]),
                                             place(trial.y[at::y]),
                                             T(1),
                                             T(T(1) / (thin * scalar::sq(speed))),
                                             T(T(1) / momentum),
                                             T(T(1) / momentum),
                                             T(T(1) / momentum),
                                             T(T(1) / speed),
                                             equations.weight_of_direction(trial.y, speed, h)};
    T worst(0);
    for (std::size_t i = 0; i < Equations::used; ++i) {
      const T error = weight[i] * size_of(trial.error[i]);
      if (!(error <= worst)) {
        worst = error;
      }
    }
    return worst / run_.settings.tolerance;
  }

  ContactState<T>& contact_;
  Run<T>& run_;
  T step_;          // [s] to try next
  T longest_step_;  // [s] where nothing limits it: a step without end would never come to the horizon
  ContactEnd end_ = ContactEnd::time;
};

}  // namespace goishi::detail
