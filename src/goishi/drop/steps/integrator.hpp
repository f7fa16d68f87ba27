#pragma once
/// \file
/// Integrates one set of contact equations, step by step, with error control, up to the event that ends their validity.

#include <array>
#include <goishi/drop/equations/gliding.hpp>
#include <goishi/drop/equations/rolling.hpp>
#include <goishi/drop/equations/sliding.hpp>
#include <goishi/drop/rest/rest.hpp>
#include <goishi/drop/schemes/runge_kutta.hpp>
#include <goishi/drop/state/contact_state.hpp>
#include <goishi/drop/steps/crossing.hpp>
#include <goishi/drop/steps/energy_balance.hpp>
#include <goishi/drop/steps/support_loss.hpp>
#include <optional>
#include <utility>
#include <variant>

namespace goishi::detail {

/// What comes next while a set of equations holds: a step of theirs, their end at a guard, the last stretch to rest or to
/// where a slip has gone, or nothing that could be found.
enum class Course { steps, guard, rests, slip_stops, fails };

template <Ordered T>
class ContactIntegrator {
 public:
  explicit ContactIntegrator(const Run<T>& run) : step_(T(1e-2) / run.scales.frequency) {}

  /// Begins with the equations that `contact.mode` names. What has `begun` just now goes on for a step at least.
  [[nodiscard]] Course begin(Run<T>& run, ContactState<T>& contact, bool begun, Ahead<T>& ahead) {
    switch (contact.mode) {
      case ContactMode::rolling:
        equations_.emplace(std::in_place_type<Rolling<T>>, run.contact_body, contact.feature, contact.origin);
        break;
      case ContactMode::sliding:
        equations_.emplace(std::in_place_type<Sliding<T>>, run.contact_body, contact.feature, contact.origin);
        break;
      case ContactMode::gliding:
        equations_.emplace(std::in_place_type<Gliding<T>>, run.contact_body, contact.feature, contact.origin);
        break;
    }
    return visit(run, [&](auto& equations) { return begin(run, contact, equations, begun, ahead); });
  }

  /// Plans the next step.
  [[nodiscard]] Course plan(Run<T>& run, const ContactState<T>& contact, Ahead<T>& ahead) {
    return visit(run, [&](auto& equations) { return plan(run, contact, equations, ahead); });
  }

  /// What follows a step, once it is over.
  [[nodiscard]] Course after(Run<T>& run, ContactState<T>& contact, Ahead<T>& ahead) {
    return visit(run, [&](auto& equations) { return after(run, contact, equations, ahead); });
  }

  /// The polynomial along the step that is planned from y.
  [[nodiscard]] Interpolant<T, variables> along(const Variables<T>& y, const Ahead<T>& ahead) const {
    return std::visit(
        [&](auto equations) {  // a copy: it evaluates elsewhere
          return interpolated(equations, y, ahead.to, ahead.length);
        },
        *equations_);
  }

  /// The guard that broke.
  [[nodiscard]] Guard guard() const { return guard_; }

  /// What the equations saw last.
  [[nodiscard]] const Kinetics<T>& now() const {
    return std::visit([](const auto& equations) -> const Kinetics<T>& { return equations.now; }, *equations_);
  }
  [[nodiscard]] const Vec3<T>& force() const {
    return std::visit([](const auto& equations) -> const Vec3<T>& { return equations.force; }, *equations_);
  }

 private:
  using GuardValues = std::array<T, guard_count>;

  template <class Function>
  [[nodiscard]] Course visit(Run<T>& run, Function&& function) {
    return std::visit(
        [&](auto& equations) {
          const Course course = function(equations);
          run.counters.contact_evaluations += equations.evaluations;
          equations.evaluations = 0;
          return course;
        },
        *equations_);
  }

  template <class Equations>
  [[nodiscard]] Course begin(const Run<T>& run, ContactState<T>& contact, Equations& equations, bool begun,
                             Ahead<T>& ahead) {
    contact.y[at::loss] = T(0);
    rate_ = equations(contact.y);
    if (rests(run, contact, equations, ahead)) {
      return Course::rests;
    }
    if (slips(contact) && stops_turning(run.contact_body, equations, run.settings.tolerance)) {
      return broken(Guard::turning);
    }
    if (!begun && turning_is_to_begin(run, equations)) {
      return broken(Guard::onset);
    }
    balance_ = EnergyBalance<T>(run, equations, contact.y);
    old_ = guards_of(run, contact, equations, contact.y);
    return broken(broken_at_once<Equations>(old_));
  }

  template <class Equations>
  [[nodiscard]] Course plan(Run<T>& run, const ContactState<T>& contact, Equations& equations, Ahead<T>& ahead) {
    // Where nothing limits it, a step without end would never come to be looked at again.
    const T longest = T(100) / run.scales.frequency;
    T h = longest < step_ ? longest : step_;
    equations.begin_step();
    const T cut = short_of_standstill<Equations>(run, contact.y, h);
    const bool is_cut = cut < h;
    h = is_cut ? cut : h;
    const T usual = step_;
    if (!accepted_step(run, contact.y, equations, h)) {
      guard_ = Guard::jam;
      return equations.jams() ? Course::guard : Course::fails;
    }
    if (is_cut && !(h < cut) && step_ < usual) {
      step_ = usual;
    } else if (!is_cut) {
      step_ = slip_left<Equations>(contact.y) * step_;
    }
    ++run.counters.steps_accepted;
    ahead.length = h;
    ahead.to = trial_.y;
    ahead.known = false;
    GuardValues now = guards_of(run, contact, equations, trial_.y);
    guard_ = locate(run, contact, equations, now, ahead);
    from_rate_ = rate_;
    rate_ = guard_ == Guard::none ? trial_.rate : equations(ahead.to);
    old_ = now;
    const Variables<T> reached = ahead.to;
    const T total = balance_.total();
    reunite(ahead.to);
    balance_.restore(run, equations, ahead.to);
    ahead.ledger = {total, balance_.total(), run.settings.tolerance * run.scales.speed, run.settings.gravity};
    if (ahead.known) {
      lead(ahead.along, reached, ahead.to);
    }
    return Course::steps;
  }

  template <class Equations>
  [[nodiscard]] Course after(const Run<T>& run, ContactState<T>& contact, Equations& equations, Ahead<T>& ahead) {
    if (guard_ != Guard::none) {
      return Course::guard;
    }
    if (rests(run, contact, equations, ahead)) {
      return Course::rests;
    }
    if (slips(contact) && stops_turning(run.contact_body, equations, run.settings.tolerance)) {
      return broken(Guard::turning);
    }
    const Course slip = slip_after<Equations>(run, contact, ahead);
    if (slip != Course::steps) {
      return slip;
    }
    if (turning_is_to_begin(run, equations)) {
      return broken(Guard::onset);
    }
    if (contact.rebase_if_far()) {
      equations.carry_from(contact.origin);
      rate_ = equations(contact.y);
    }
    return Course::steps;
  }

  [[nodiscard]] Course broken(Guard guard) {
    guard_ = guard;
    return guard == Guard::none ? Course::steps : Course::guard;
  }

  /// Bends a polynomial a little, so that it ends elsewhere.
  static void lead(Interpolant<T, variables>& along, const Variables<T>& from, const Variables<T>& to) {
    for (std::size_t i = 0; i < variables; ++i) {
      const T change = to[i] - from[i];
      along.c[2][i] = along.c[2][i] + T(3) * change;
      along.c[3][i] = along.c[3][i] - T(2) * change;
    }
  }

  /// Of the trial step of length h, from y to `to`.
  template <class Equations>
  [[nodiscard]] Interpolant<T, variables> interpolated(Equations& equations, const Variables<T>& y,
                                                       const Variables<T>& to, const T& h) const {
    const Interpolant<T, variables> rough =
        interpolant(y, from_rate_, to, trial_.rate, h, bend_of(trial_, from_rate_, h));
    // The rates of what is stiff, at a place that is not quite right, are not.
    return equations.order() == 5 ? sharpened(rough, h, equations) : rough;
  }

  // --- standing still

  /// Whether the stone comes to rest: ahead is the way there. Resistance brakes what is left of the motion as it does now,
  /// so that the kinetic energy E falls as a square of the time left: that is 2E/−Ė.
  template <class Equations>
  [[nodiscard]] bool rests(const Run<T>& run, const ContactState<T>& contact, const Equations& equations,
                           Ahead<T>& ahead) const {
    const Variables<T>& y = contact.y;
    const ContactBody<T>& body = run.contact_body;
    if (!is_at_rest(body, equations, y, run.settings.tolerance)) {
      return false;
    }
    const Kinetics<T>& k = equations.now;
    const Vec3<T>& g = body.gravity;
    const T energy = formula::contact_kinetic_energy(k, equations.slip_x(y), equations.slip_y(y));
    const T taken = rate_[at::loss] - (g.x() * rate_[at::x] + g.y() * rate_[at::y] - g.z() * k.point.z());
    const T stop = no_energy(body) < energy && T(0) < taken ? T(T(2) * energy / taken) : T(0);
    ahead.length = stop;
    ahead.to = y;
    ahead.along = {};
    ahead.along.c[0] = y;
    for (std::size_t i = 0; i < at::loss; ++i) {
      ahead.to[i] = y[i] + stop / T(2) * rate_[i];
      ahead.along.c[1][i] = stop * rate_[i];
      ahead.along.c[2][i] = -(stop / T(2) * rate_[i]);
    }
    if (T(0) < stop && !is_held(body, place_of(body, contact.feature, ahead.to).r)) {
      return false;
    }
    const auto ceases = [&](std::size_t i) {
      ahead.along.c[1][i] = -y[i];
      ahead.to[i] = T(0);
    };
    for (std::size_t i = at::L; i <= at::slip; ++i) {
      ceases(i);
    }
    if (contact.mode == ContactMode::gliding) {
      ceases(at::direction);
    }
    ahead.known = true;
    ahead.ledger.reset();
    reunite(ahead.to);
    return true;
  }

  /// Whether a slip has a direction: a dry one that begins has not yet.
  [[nodiscard]] static bool slips(const ContactState<T>& contact) {
    return contact.mode != ContactMode::sliding || T(0) < contact.y[at::slip];
  }

  /// Whether resistance has stopped the turning, or a stone that does not turn yet will: which way, the equations do not
  /// say there, since resistance is against it.
  template <class Equations>
  [[nodiscard]] bool turning_is_to_begin(const Run<T>& run, const Equations& equations) const {
    const Kinetics<T>& k = equations.now;
    return run.contact_body.resists && T(0) < k.need.z() && !ContactState<T>::turns(run, k.w) &&
           k.w.x() * rate_[at::L] + k.w.y() * rate_[at::L + 1] + k.w.z() * rate_[at::L + 2] <= T(0);
  }

  /// The step cut to just before the turning ceases, if it does within it: as L goes now, J L · L has a least value that is
  /// next to nothing. A dry slip is cut in the same way.
  template <class Equations>
  [[nodiscard]] T short_of_standstill(const Run<T>& run, const Variables<T>& y, T h) const {
    if constexpr (Equations::names[3] == Guard::slip) {
      const T way = T(-0.8) * y[at::slip];
      h = way < T(0) && h * rate_[at::slip] < way ? T(way / rate_[at::slip]) : h;
    }
    const ContactBody<T>& body = run.contact_body;
    if (!body.resists) {
      return h;
    }
    const Vec3<T> u(y[at::u], y[at::u + 1], y[at::u + 2]), L(y[at::L], y[at::L + 1], y[at::L + 2]);
    const Vec3<T> L_rate(rate_[at::L], rate_[at::L + 1], rate_[at::L + 2]);
    const Vec3<T> w_rate = formula::turning(body.mobility, u, L_rate);
    const T falls = -formula::dot(L, w_rate), bends = formula::dot(L_rate, w_rate);
    if (!(falls < h * bends) || !(T(0) < falls)) {
      return h;
    }
    const T now = formula::dot(L, formula::turning(body.mobility, u, L));
    return now - falls * (falls / bends) < T(0.0025) * now ? T(T(0.98) * (falls / bends)) : h;
  }

  // --- steps

  /// The share that a step leaves of a dry slip that decays: how fast its direction turns, and its error grows, goes by 1 over
  /// the slip, so that as much of a step's length is left to the next.
  template <class Equations>
  [[nodiscard]] T slip_left(const Variables<T>& y) const {
    if constexpr (Equations::names[3] == Guard::slip) {
      const T before = y[at::slip], after = trial_.y[at::slip];
      return T(0) < after && after < before ? T(after / before) : T(1);
    }
    return T(1);
  }

  /// A step of at most h that the error control accepts, into `trial_`. False where there is none. (A step that fails is a
  /// tenth shorter at least the next time, so that some 300 tries are the most.)
  template <class Equations>
  [[nodiscard]] bool accepted_step(Run<T>& run, const Variables<T>& y, Equations& equations, T& h) {
    const T shortest = shortest_step(run);
    for (bool tried = false;; tried = true) {
      const bool possible = equations.step(y, rate_, h, trial_);
      // As far off as `step_factor` counts, where there is no such step.
      const T estimated = possible ? error_of(run, equations, h) : T(1e10);
      // A step that oversteps a whole feature meets smooth rates on either side of it; the energy shows it.
      const T seen = possible ? balance_.defect(run, equations, trial_.y) : T(0);
      const T error = seen <= estimated ? estimated : seen;
      const T suggested = step_factor(error, equations.order());
      // What has just been too long is not tried again at once.
      const T factor = tried && T(1) < suggested ? T(1) : suggested;
      // The shortest step passes what no error control can: a jump of the equations.
      if (error <= T(1) || (possible && h < shortest)) {
        step_ = h * factor;
        return true;
      }
      ++run.counters.steps_rejected;
      h = h * factor;
      if (h < T(1e-3) * shortest) {
        return false;
      }
    }
  }

  /// Round-off of the time   [s].
  [[nodiscard]] static T shortest_step(const Run<T>& run) {
    return T(16) * std::numeric_limits<T>::epsilon() * (run.time + T(1000) / run.scales.frequency);
  }

  /// Whether dry slip ends now: what is left of it is below a hundredth of a step's error, or will be gone so soon that its
  /// brake stays the same till then: ahead is the way there.
  template <class Equations>
  [[nodiscard]] Course slip_after(const Run<T>& run, ContactState<T>& contact, Ahead<T>& ahead) {
    if constexpr (Equations::names[3] == Guard::slip) {
      Variables<T>& y = contact.y;
      const T sigma = y[at::slip], braking = -rate_[at::slip], tolerance = run.settings.tolerance;
      if (!(T(0) < braking)) {
        return Course::steps;
      }
      const T rest = sigma / braking, turned = scalar::abs(T(rest * rate_[at::direction]));
      const T little = T(0.01) * tolerance * run.scales.speed;
      if (scalar::sq(T(rest * run.scales.frequency / run.scales.thinness)) < T(1e-5) * tolerance &&
          sigma * turned < little) {
        ahead.length = rest;
        ahead.to = y;
        for (std::size_t i = 0; i < at::slip; ++i) {
          ahead.to[i] = y[i] + rest * rate_[i];
        }
        ahead.to[at::slip] = T(0);
        ahead.straight(y);
        reunite(ahead.to);
        guard_ = Guard::slip;
        return Course::slip_stops;
      }
      if (sigma < little || rest < shortest_step(run)) {
        return broken(Guard::slip);
      }
    }
    return Course::steps;
  }

  // --- guards

  template <class Equations>
  [[nodiscard]] static GuardValues guards_of(const Run<T>& run, const ContactState<T>& contact,
                                             const Equations& equations, const Variables<T>& y) {
    GuardValues value = equations.guards().value;
    if (run.board) {
      value[guard_count - 1] = contact.support_left(run, equations.now, y[at::x], y[at::y]).gap / run.scales.length;
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

  /// Whether a guard breaks within the step: the first that does; ahead is then the way to where it does.
  template <class Equations>
  [[nodiscard]] Guard locate(Run<T>& run, const ContactState<T>& contact, Equations& equations, GuardValues& now,
                             Ahead<T>& ahead) {
    Guard found = Guard::none;
    T share(1);
    const auto guards_at = [&](const T& theta) {
      ++run.counters.evaluations_located;
      const Variables<T> y = ahead.along(theta);
      static_cast<void>(equations(y));
      return guards_of(run, contact, equations, y);
    };
    const auto know_the_way = [&] {
      from_rate_ = rate_;
      ahead.along = interpolated(equations, contact.y, trial_.y, ahead.length);
    };
    const bool clear = T(0) < old_.back() && T(0) < now.back();  // of losing the support, at both ends
    if (run.board && clear &&
        may_lose_support(run, rate_, trial_.rate, ahead.length, T((old_.back() + now.back()) * run.scales.length))) {
      know_the_way();
      SupportLoss lost(run, contact, ahead.along, at::x, at::u,
                       [&](const Variables<T>& y) { return place_of(run.contact_body, contact.feature, y); });
      if (const std::optional<T> at = lost()) {
        share = *at;
        now = guards_at(share);
        now.back() = scalar::min(now.back(), T(-scalar::tiny<T>()));  // also where it is 0
      } else {
        static_cast<void>(equations(trial_.y));  // they see the end again
      }
      run.counters.evaluations_located += lost.views();
    }
    for (std::size_t pass = 0; pass < guard_count; ++pass) {
      std::size_t which = guard_count;
      for (std::size_t i = 0; i < guard_count; ++i) {
        const Guard name = Equations::names[i];
        if (name != Guard::none && name != found && now[i] < T(0) && now[i] < old_[i]) {
          which = i;
          break;
        }
      }
      if (which == guard_count) {
        break;
      }
      if (found == Guard::none) {
        know_the_way();
      }
      found = Equations::names[which];
      // A slip is zero where it begins without round-off, and however short it lives counts: that time has to pass.
      find_crossing(old_, which, found == Guard::slip ? T(0) : crossing_noise<T>(), now, share, guards_at);
    }
    if (found != Guard::none) {
      ahead.along = ahead.along.cut(share);
      ahead.length = share * ahead.length;
      ahead.to = ahead.along(T(1));
      ahead.known = true;
    }
    return found;
  }

  /// The greatest error of a variable over what is allowed.
  template <class Equations>
  [[nodiscard]] T error_of(const Run<T>& run, const Equations& equations, const T& h) const {
    const Trial<T, variables>& trial = trial_;
    const T momentum2 = scalar::sq(trial.y[at::L]) + scalar::sq(trial.y[at::L + 1]) + scalar::sq(trial.y[at::L + 2]);
    // Where a stone hardly turns, what matters is in which direction: resistance goes by that. With the coarser scale the
    // integration finds false states of slow creep there.
    const T usual = run.scales.thinness * run.scales.frequency / run.contact_body.mobility.transverse;
    const T slow = T(1e-3) * usual;
    const T least = run.contact_body.resists && momentum2 < scalar::sq(slow) ? slow : usual;
    const T momentum = scalar::sqrt(T(momentum2 + scalar::sq(least)));
    const auto place = [&](const T& x) {  // no error is below round-off
      return T(1) /
             (run.scales.length + T(64) * std::numeric_limits<T>::epsilon() / run.settings.tolerance * scalar::abs(x));
    };
    const T& speed = run.scales.speed;
    const T& thin = run.scales.thinness;
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
      const T error = weight[i] * scalar::abs(trial.error[i]);
      if (!(error <= worst)) {
        worst = error;
      }
    }
    return worst / run.settings.tolerance;
  }

  std::optional<std::variant<Rolling<T>, Sliding<T>, Gliding<T>>> equations_;
  EnergyBalance<T> balance_;
  Variables<T> rate_ = {};       // where the equations have got to
  Variables<T> from_rate_ = {};  // where the planned step begins
  Trial<T, variables> trial_ = {};
  GuardValues old_ = {};
  Guard guard_ = Guard::none;
  T step_;  // [s] to try next
};

}  // namespace goishi::detail
