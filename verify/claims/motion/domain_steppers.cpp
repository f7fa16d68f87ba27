/// DOMAIN: steps of every scheme, and invariants, of bodies of any size. The witness is the same in 113 bits with 15 bits of
/// exponent: what is judged is range and rounding; ORDER and the derivations judge the formulas.

#include <fmt/format.h>

#include <algorithm>
#include <goishi/motion/steppers.hpp>
#include <string>

#include "verify/claims/claims.hpp"
#include "verify/claims/motion/convergence.hpp"
#include "verify/claims/motion/flight_errors.hpp"
#include "verify/samples/domain.hpp"

namespace goishi::verify {

namespace {

template <class T>
struct StepSample {
  RigidBody<T> body;
  State<T> start;
  Vec3<T> gravity;
  T dt, angle;  // the angle is |L| Δt / I_x
};

template <class T>
RigidBody<T> draw_body(Context& context, int i, bool symmetric) {
  const T size = any_size<T>(context.random(), size_reach<T>);
  const auto unit = [&] { return static_cast<T>(context.uniform(0.2, 1.0)); };
  const T a = unit(), b = unit(), c = unit();
  const std::array<Vec3<T>, 4> kinds = {Vec3<T>(T(1), T(1), T(1)), Vec3<T>(T(1), T(1), T(2)),
                                        Vec3<T>(T(1), T(1), T(0.2) + a), Vec3<T>(a + b, b + c, c + a)};
  const Vec3<T>& shares = kinds[static_cast<std::size_t>(i) % (symmetric ? 3 : 4)];
  return make_rigid_body<T>(any_size<T>(context.random(), size_reach<T>), Vec3<T>(size * shares));
}

/// At rest, about an axis to the bit, or any; inertia and momentum of any size, the step as long as the angle asks.
template <class T>
StepSample<T> draw_step(Context& context, int i, bool symmetric) {
  StepSample<T> s;
  const auto is_normal = [](const T& x) { return std::isnormal(x) && std::isnormal(x * T(16)); };
  T momentum;
  do {
    s.body = draw_body<T>(context, i, symmetric);
    momentum = any_size<T>(context.random(), size_reach<T>);
    s.angle = any_size<T>(context.random(), 3.0) / T(1000);
    s.dt = s.angle * (s.body.moments.x() / momentum);
  } while (!is_normal(s.dt) || !is_normal(momentum / s.body.moments.x()) || !is_normal(s.dt / s.body.moments.x()));
  s.start.q_WB = draw_defective<T>(context, i / 2);
  const std::array<Vec3<T>, 4> along = {
      Vec3<T>(T(0), T(0), T(1)), Vec3<T>(T(1), T(0), T(0)), Vec3<T>(T(0), T(0), T(0)),
      draw_attitude(context.random()).template cast<T>().normalized() * Vec3<T>(T(1), T(0), T(0))};
  s.start.L_W = momentum * Vec3<T>(s.start.q_WB * along[static_cast<std::size_t>(i / 3) % along.size()]);
  const auto length = [&] {
    return T(static_cast<T>(context.uniform(-1.0, 1.0)) * any_size<T>(context.random(), size_reach<T>));
  };
  s.start.p_WB = i % 5 == 0 ? Vec3<T>(T(0), T(0), T(0)) : Vec3<T>(length(), T(0), length());
  const auto held = [](const T& x) { return std::isfinite(x) ? x : T(0); };
  s.start.v_WB = {held(length() / s.dt), held(length() / s.dt), T(0)};
  s.gravity = {T(0), T(0), i % 3 == 0 ? T(0) : held(length() / s.dt / s.dt)};
  if (i % 11 == 10 && s.dt < T(1) / T(128)) {  // numbers of which no two can be added
    const T most = std::numeric_limits<T>::max() / T(4) * T(3);
    s.start.v_WB = {most, most, T(0)};
    s.gravity = {T(0), most, most};
  }
  return s;
}

template <class Real, class T>
State<Real> state_cast(const State<T>& s) {
  return {.p_WB = s.p_WB.template cast<Real>(),
          .q_WB = s.q_WB.template cast<Real>().normalized(),
          .v_WB = s.v_WB.template cast<Real>(),
          .L_W = s.L_W.template cast<Real>()};
}

template <class T>
std::string describe(const StepSample<T>& s, const SchemeInfo& scheme, int mode) {
  return fmt::format(
      "{}: I = ({:a}, {:a}, {:a}), L = ({:a}, {:a}, {:a}), q = ({:a}, {:a}, {:a}, {:a}), p = ({:a}, {:a}, {:a}), v = "
      "({:a}, {:a}, {:a}), g = ({:a}, {:a}, {:a}), dt = {:a}, angle {}, mode {}",
      scheme.name, s.body.moments.x(), s.body.moments.y(), s.body.moments.z(), s.start.L_W.x(), s.start.L_W.y(),
      s.start.L_W.z(), s.start.q_WB.w(), s.start.q_WB.x(), s.start.q_WB.y(), s.start.q_WB.z(), s.start.p_WB.x(),
      s.start.p_WB.y(), s.start.p_WB.z(), s.start.v_WB.x(), s.start.v_WB.y(), s.start.v_WB.z(), s.gravity.x(),
      s.gravity.y(), s.gravity.z(), s.dt, s.angle, mode);
}

template <class T>
void see_step(const Context& context, Checks& checks, const StepSample<T>& s, const SchemeInfo& scheme, int mode) {
  const auto describe_it = [&] { return describe(s, scheme, mode); };
  const auto answer = answer_of(mode, [&] { return Stepper<T>(scheme.scheme, s.body, s.gravity).step(s.start, s.dt); });
  const RigidBody<Quad> body{.mass = Quad(s.body.mass), .moments = s.body.moments.template cast<Quad>()};
  const Vec3<Quad> g = s.gravity.template cast<Quad>();
  const Quad dt(s.dt);
  const Stepped<Quad> exact = Stepper<Quad>(scheme.scheme, body, g).step(state_cast<Quad>(s.start), dt);
  const bool done = answer && answer->status == StepStatus::completed && exact.status == StepStatus::completed;
  see_choice(checks["refusals"], done, [&] { return "refused or failed: " + describe_it(); });
  if (!done) {
    return;
  }
  const State<T>& after = answer->state;
  const double defect =
      std::fabs(static_cast<double>(s.start.q_WB.template cast<Quad>().squaredNorm() - Quad(1))) / epsilon_of<T>;
  const double angle = static_cast<double>(s.angle);
  const Quat<T> q = produced(context, after.q_WB);
  // Three for the product that a turn about an axis is; sixteen for a step that is one, with its rate, sine and cosine.
  const double roundings = std::max(16.0, 3.0 * cosine_products(scheme.scheme));
  checks["attitude"].see(angle_between(Quat<Quad>(q.template cast<Quad>()), exact.state.q_WB),
                         roundings * epsilon_of<T> * (1.0 + angle * (1.0 + defect)), describe_it);
  checks["length"].see(std::fabs(static_cast<double>(q.template cast<Quad>().squaredNorm() - Quad(1))), epsilon_of<T>,
                       describe_it);
  const Quad momentum = exact.state.L_W.norm();
  if (momentum > 0) {
    const Quad off = (Vec3<T>(context.produced(after.L_W)).template cast<Quad>() - exact.state.L_W).norm() / momentum;
    checks["momentum"].see(static_cast<double>(off), 2.0 * epsilon_of<T> * (1.0 + defect), describe_it);
  }
  for (int k = 0; k < 3; ++k) {
    const Quad v = abs(Quad(s.start.v_WB[k])), gain = abs(Quad(g[k] * dt)), least(std::numeric_limits<T>::min());
    const auto off = [&](const T& x, const Quad& right, const Quad& scale) {
      return static_cast<double>(Quad(abs(Quad(Quad(context.produced(x)) - right)) / (scale + least)));
    };
    const Quad way = abs(Quad(s.start.p_WB[k])) + Quad(v + gain) * dt;
    checks["place"].see(off(after.p_WB[k], exact.state.p_WB[k], way), epsilon_of<T>, describe_it);
    checks["velocity"].see(off(after.v_WB[k], exact.state.v_WB[k], Quad(v + gain)), epsilon_of<T>, describe_it);
  }
}

/// A step that is too long: whatever it says, its state is one, and where it failed the one that it started from.
template <class T>
void see_long_step(Context& context, Checks& checks, StepSample<T> s, const SchemeInfo& scheme) {
  const double far = std::log10(static_cast<double>(std::numeric_limits<T>::max()));
  s.dt *= any_size<T>(context.random(), far);
  s.dt = std::isfinite(s.dt) && T(0) < s.dt ? s.dt : std::numeric_limits<T>::max();
  const auto answer =
      answer_of(FE_TONEAREST, [&] { return Stepper<T>(scheme.scheme, s.body, s.gravity).advance(s.start, s.dt, 3); });
  const auto good = [&](const State<T>& state) {
    return state.p_WB.allFinite() && state.v_WB.allFinite() && state.L_W.allFinite() &&
           std::fabs(state.q_WB.squaredNorm() - T(1)) < unit_tolerance<T>();
  };
  const bool right = answer && good(answer->state) &&
                     (answer->status == StepStatus::completed) == (answer->steps == 3) &&
                     (answer->steps > 0 || answer->state.q_WB.coeffs() == s.start.q_WB.coeffs());
  see_choice(checks["long steps"], right, [&] { return describe(s, scheme, FE_TONEAREST); });
}

template <class T>
void see_refusals(Checks& checks, const SchemeInfo& scheme) {
  const T nan = std::numeric_limits<T>::quiet_NaN(), least = std::numeric_limits<T>::denorm_min();
  const Vec3<T> none(T(0), T(0), T(0)), ones(T(1), T(1), T(1));
  const State<T> rest{.p_WB = none, .q_WB = Quat<T>::Identity(), .v_WB = none, .L_W = none};
  const auto refused = [&](const char* name, const Vec3<T>& moments, const State<T>& state, const T& dt, int steps) {
    const auto call = [&] {
      return Stepper<T>(scheme.scheme, make_rigid_body(T(1), moments), none).advance(state, dt, steps);
    };
    see_choice(checks["refusals"], !answer_of(FE_TONEAREST, call),
               [&] { return fmt::format("taken: {}, {}", name, scheme.name); });
  };
  State<T> state = rest;
  refused("1/I", Vec3<T>(least * ones), rest, T(1), 1);
  refused("no time", ones, rest, T(0), 1);
  refused("a time that is no number", ones, rest, nan, 1);
  refused("steps back", ones, rest, T(1), -1);
  state.q_WB.w() = T(1.001);
  refused("no unit attitude", ones, state, T(1), 1);
  state = rest;
  state.L_W.y() = nan;
  refused("no momentum", ones, state, T(1), 1);
}

template <class T>
void see_steps(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const int mode = rounding_modes[static_cast<std::size_t>(i / 7) % rounding_modes.size()];
    for (const SchemeInfo& scheme : schemes) {
      const StepSample<T> sample = draw_step<T>(context, i, scheme.needs_symmetry);
      see_step(context, checks, sample, scheme, mode);
      see_long_step(context, checks, sample, scheme);
    }
  }
  for (const SchemeInfo& scheme : schemes) {
    see_refusals<T>(checks, scheme);
  }
}

// --- invariants

template <class T>
void see_invariants(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const int mode = rounding_modes[static_cast<std::size_t>(i / 7) % rounding_modes.size()];
    const auto size = [&] { return any_size<T>(context.random(), size_reach<T>); };
    const auto vector = [&](int kind) {
      const Vec3<T> any = Vec3<T>(draw_direction<T>(context.random(), kind));
      return Vec3<T>(kind % 7 == 0 ? T(0) * any : size() * any);
    };
    const RigidBody<T> body = draw_body<T>(context, i, false);
    const State<T> state{
        .p_WB = vector(i), .q_WB = draw_defective<T>(context, i), .v_WB = vector(i + 1), .L_W = vector(i + 2)};
    const Vec3<T> g = vector(i + 3), p_WV = vector(i + 4), v_WV = vector(i + 5);
    const Quat<T> q_WV = draw_defective<T>(context, i / 3);
    const RigidBody<Quad> wide{.mass = Quad(body.mass), .moments = body.moments.template cast<Quad>()};
    const State<Quad> right = state_cast<Quad>(state);
    const Vec3<Quad> wide_g = g.template cast<Quad>(), P = p_WV.template cast<Quad>(), V = v_WV.template cast<Quad>();
    const double defect =
        std::fabs(static_cast<double>(state.q_WB.template cast<Quad>().squaredNorm() - Quad(1))) / epsilon_of<T>;
    const auto describe_it = [&](const char* name) {
      return fmt::format("{}: m = {:a}, I_x = {:a}, |p| = {:a}, |v| = {:a}, |L| = {:a}, mode {}", name, body.mass,
                         body.moments.x(), state.p_WB.norm(), state.v_WB.norm(), state.L_W.norm(), mode);
    };
    const auto can = [](const Quad& x) { return x == 0 || (holds<T>(x) && holds<T>(Quad(x * Quad(epsilon_of<T>)))); };
    // Judged where what is stated to be held is; `parts` is the sum of the magnitudes that are added.
    const auto see = [&](const char* check, const char* name, auto&& value, const Quad& exact, const Quad& parts,
                         double more) {
      if (can(Quad(4 * parts))) {
        const T computed = *answer_of(mode, value);
        const double off =
            std::isfinite(computed) ? static_cast<double>(abs(Quad(Quad(context.produced(computed)) - exact))) : NAN;
        const double unit = static_cast<double>(parts);
        checks[check].see(parts == 0 ? off : off / unit, epsilon_of<T> * (1.0 + more),
                          [&] { return describe_it(name); });
      }
    };
    const Quad square = right.v_WB.squaredNorm(), turning = (right.L_W.norm() / wide.moments.minCoeff());
    const Quad work = right.p_WB.cwiseAbs().dot(wide_g.cwiseAbs());
    const Quad kinetic = wide.mass * square / 2, rotating = formula::rotational_energy(right, wide);
    if (can(turning)) {
      see(
          "energy", "rotation", [&] { return formula::rotational_energy(state, body); }, rotating, rotating,
          4.0 * defect);
    }
    if (can(square)) {
      see(
          "energy", "translation", [&] { return formula::translational_energy(state, body); }, kinetic, kinetic, 0.0);
    }
    if (can(work)) {
      see(
          "energy", "position", [&] { return formula::potential_energy(state, body, g); },
          formula::potential_energy(right, wide, wide_g), Quad(wide.mass * work), 0.0);
    }
    if (can(turning) && can(square) && can(work)) {
      see(
          "energy", "energy", [&] { return formula::energy(state, body, g); }, formula::energy(right, wide, wide_g),
          Quad(rotating + kinetic + wide.mass * work), 4.0 * defect);
    }
    const Vec3<Quad> momentum = formula::linear_momentum(right, wide),
                     about = formula::angular_momentum_about(P, right, wide);
    const Quad arm = right.p_WB.norm() + P.norm();
    const State<T> seen = *answer_of(mode, [&] { return formula::seen_from(p_WV, q_WV, v_WV, state); });
    const State<Quad> exact = formula::seen_from(P, Quat<Quad>(q_WV.template cast<Quad>().normalized()), V, right);
    for (int k = 0; k < 3; ++k) {
      see(
          "momentum", "momentum", [&] { return formula::linear_momentum(state, body)[k]; }, momentum[k],
          momentum.norm(), 0.0);
      if (can(momentum.norm())) {
        see(
            "momentum", "angular momentum", [&] { return formula::angular_momentum_about(p_WV, state, body)[k]; },
            about[k], Quad(right.L_W.norm() + arm * momentum.norm()), 0.0);
      }
      see(
          "seen", "place", [&] { return seen.p_WB[k]; }, exact.p_WB[k], arm, 0.0);
      see(
          "seen", "velocity", [&] { return seen.v_WB[k]; }, exact.v_WB[k], Quad(right.v_WB.norm() + V.norm()), 0.0);
      see(
          "seen", "momentum", [&] { return seen.L_W[k]; }, exact.L_W[k], right.L_W.norm(), 0.0);
    }
    const Quat<Quad> q = produced(context, seen.q_WB).template cast<Quad>();
    checks["attitude"].see(angle_between(q, exact.q_WB), epsilon_of<T>, [&] { return describe_it("seen"); });
    const double left = std::fabs(static_cast<double>(q.squaredNorm() - Quad(1))) / epsilon_of<T>;
    checks["length"].see(std::max(0.0, left - defect), [&] { return describe_it("seen"); });
  }
}

}  // namespace

std::vector<Claim> domain_steppers_claims() {
  const std::string half_as_many = "some four roundings, not to the nearest";
  return {
      {.id = "DOMAIN-14",
       .statement =
           "A step of each scheme for bodies of any size, at rest, about an axis to the bit, far away, with |q|² off "
           "by ± 60 ε, in each rounding mode: right to round-off; a step that is too long leaves a state that is "
           "one, and says so.",
       .function = "Stepper::step",
       .family = OracleFamily::rounding,
       .oracle = "the same step in 113 bits, without a limit of size, at q/|q|",
       .checks = {within("attitude", 1.0,
                         "ε of each rounding of the scheme, times 1 + angle, as much more of the angle as |q|² is off",
                         "splitting-6 turns 37 times, each time rounded three times, not to the nearest all to one "
                         "side: 111; the "
                         "others as often, or 16 times; measured 2026-11-30 with 40 seeds: up to 0.7",
                         0.01),
                  within("length", 16.0, "ε, of |q|²", "as DOMAIN-5", 1.0),
                  within("momentum", 8.0, "2 ε of it, as much more as |q|² is off",
                         "turned into the body and back, nine roundings each, not to the nearest", 0.5),
                  within("place", 6.0, "ε of its parts", "two products and three sums, each off by up to one ulp", 0.5),
                  within("velocity", 2.0, "ε of its parts", "a product and a sum, each off by up to one ulp", 0.5),
                  none("long steps", "steps that are too long and do not say so"),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_both(see_steps<double>, see_steps<float>, 120, 1500)},
      {.id = "DOMAIN-15",
       .statement =
           "Energies, momenta and the state seen from another frame, for bodies of any size anywhere, with |q|² of "
           "both frames off by ± 60 ε, in each rounding mode.",
       .function = "rotational_energy, translational_energy, potential_energy, energy, linear_momentum, "
                   "angular_momentum_about, seen_from",
       .family = OracleFamily::rounding,
       .oracle = "the same in 113 bits, without a limit of size, at q/|q|",
       .checks = {within("energy", 16.0, "ε of the parts, of rotation as much more as |q|² is off",
                         "some eight roundings, twice as large where they are not to the nearest", 1.0),
                  within("momentum", 8.0, "ε of the parts", half_as_many, 1.0),
                  within("seen", 16.0, "ε of the parts",
                         "a difference turned: some eight roundings, not to the nearest", 1.0),
                  within("attitude", 8.0, "ε", half_as_many, 1.0),
                  within("length", 8.0, "ε, beyond the attitude's own defect", half_as_many, 1.0)},
       .measure = measure_both(see_invariants<double>, see_invariants<float>, 1000, 10'000)},
  };
}

}  // namespace goishi::verify
