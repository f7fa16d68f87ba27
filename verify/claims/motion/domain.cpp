/// DOMAIN: flights of bodies of any size, of any length, from exact singular starts. Witnesses: the formula in 113 bits,
/// which FLIGHT-3 shows right, and the same flight in other units, by powers of two, which must have the same digits.

#include <fmt/format.h>

#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/steppers.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/claims/motion/flight_errors.hpp"
#include "verify/samples/domain.hpp"
#include "verify/samples/flight.hpp"
#include "verify/samples/motion.hpp"

namespace goishi::verify {

namespace {

/// At the origin or far from it, at rest or turning, about its axis, across it, or any; round, as a lamina, any; at an
/// attitude to the bit or any, as far off the unit sphere as is let through. All of any size.
template <class T>
Top<T> draw_any_top(Context& context, int i) {
  constexpr bool single = std::numeric_limits<T>::digits < 30;
  const double reach = single ? 12.0 : 120.0;
  Top<T> top;
  const T transverse = any_size<T>(context.random(), reach);
  const std::array<T, 4> shares = {T(1), T(2), T(0.5), static_cast<T>(context.uniform(0.25, 2.0))};
  top.moments = {.axial = transverse * shares[static_cast<std::size_t>(i) % shares.size()], .transverse = transverse};
  const std::array<Quat<double>, 4> attitudes = {Quat<double>(1.0, 0.0, 0.0, 0.0), Quat<double>(0.0, 1.0, 0.0, 0.0),
                                                 Quat<double>(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0),
                                                 draw_attitude(context.random())};
  Quat<T> q = attitudes[static_cast<std::size_t>(i / 4) % attitudes.size()].template cast<T>().normalized();
  const int defect = unit_defects[static_cast<std::size_t>(i / 3) % unit_defects.size()];
  q.coeffs() = defective<T, 4>(q.coeffs(), defect);
  const std::array<Vec3<T>, 4> spins = {Vec3<T>(T(0), T(0), T(1)), Vec3<T>(T(0), T(1), T(0)), Vec3<T>(T(0), T(0), T(0)),
                                        draw_attitude(context.random()).template cast<T>() * Vec3<T>(T(1), T(0), T(0))};
  const T time = any_size<T>(context.random(), single ? 8.0 : 60.0);
  const T angle = any_size<T>(context.random(), single ? 5.0 : 9.0);
  top.state =
      spinning<T>(q, top.moments, Vec3<T>((angle / time) * spins[static_cast<std::size_t>(i / 5) % spins.size()]));
  const auto far = [&] {
    return i % 7 == 0 ? T(0) : any_size<T>(context.random(), reach) * static_cast<T>(context.uniform(-1.0, 1.0));
  };
  top.state.p_WB = {far(), far(), far()};
  top.state.v_WB = {far(), T(0), far()};
  top.time = i % 2 == 0 ? time : -time;
  return top;
}

/// How far |q|² is off 1, in ε.
template <class T, class Describe>
void see_length(Worst& worst, const Quat<T>& q, Describe&& describe) {
  worst.see(std::fabs(static_cast<double>(q.template cast<Quad>().squaredNorm() - Quad(1))), epsilon_of<T>, describe);
}

template <class T>
void see_flights(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const Top<T> top = draw_any_top<T>(context, i);
    const Vec3<T> gravity(T(0), T(0), i % 3 == 0 ? T(0) : -any_size<T>(context.random(), 6.0));
    const int mode = rounding_modes[static_cast<std::size_t>(i / 11) % rounding_modes.size()];
    const auto describe_it = [&] { return describe(top) + fmt::format(", mode {}", mode); };
    const auto answer = answer_of(mode, [&] { return free_flight(top.state, top.moments, gravity, top.time); });
    see_choice(checks["refusals"], answer.has_value(), [&] { return "refused: " + describe_it(); });
    if (!answer) {
      continue;
    }
    const Quat<T> q = produced(context, answer->q_WB);
    checks["attitude"].see(attitude_error(q, exact_attitude<Quad>(top), top), describe_it);
    see_length(checks["length"], q, describe_it);
    see_path(context, checks, top.state, gravity, top.time, *answer, describe_it);
  }
}

/// What overflows is refused.
template <class T>
void see_overflows(Checks& checks) {
  const T huge = std::numeric_limits<T>::max() / T(2), root = std::sqrt(huge);
  const Vec3<T> none(T(0), T(0), T(0)), one(T(1), T(0), T(0));
  const State<T> rest{.p_WB = none, .q_WB = Quat<T>::Identity(), .v_WB = none, .L_W = none};
  State<T> fast = rest, spinning = rest;
  fast.v_WB = {huge, T(0), T(0)};
  spinning.L_W = {T(0), T(0), huge};
  const Moments<T> round{.axial = T(1), .transverse = T(1)},
      least{.axial = std::numeric_limits<T>::denorm_min(), .transverse = std::numeric_limits<T>::denorm_min()};
  const Vec3<T> brick(T(2), T(3), T(4));
  const auto refused = [&](const char* name, auto&& call) {
    see_choice(checks["refusals"], !answer_of(FE_TONEAREST, call), [&] { return std::string("taken: ") + name; });
  };
  refused("the way", [&] { return free_flight(fast, round, none, T(8)); });
  refused("the gain", [&] { return free_flight(rest, round, Vec3<T>(huge * one), T(8)); });
  refused("the angle", [&] { return free_flight(spinning, round, none, huge); });
  refused("1/I", [&] { return free_flight(rest, least, none, T(1)); });
  refused("the way", [&] { return elliptic_flight(fast, make_rigid_body(T(1), brick), none, T(8)); });
  StoneBatch<T> batch(3);
  batch.set(1, fast, round);
  refused("the way of a batch", [&] { return batch.fly(none, T(8)), 0; });
  batch.set(2, spinning, round);
  refused("the angle of a batch", [&] { return batch.fly(none, root), 0; });
  see_choice(checks["refusals"], batch.get(1).p_WB == none && batch.get(2).q_WB.w() == T(1),
             [] { return "half a batch flew"; });
}

Measurement measure_flights(Context& context) {
  Checks checks;
  see_flights<double>(context, checks, context.samples(3000, 30'000));
  see_flights<float>(context, checks, context.samples(3000, 30'000));
  see_overflows<double>(checks);
  see_overflows<float>(checks);
  return checks.measurement();
}

/// The same flight with moments times 2^m, times times 2^t: with L times 2^(m − t) the attitude has the same digits.
template <class T>
void see_units(Context& context, Worst& worst, int count) {
  constexpr bool single = std::numeric_limits<T>::digits < 30;
  for (int i = 0; i < count; ++i) {
    const Flight flight = draw_flight(context.random(), body_kinds[static_cast<std::size_t>(i) % body_kinds.size()]);
    const auto power = [&](double reach) { return static_cast<int>(context.uniform(-reach, reach)); };
    const int m = power(single ? 40.0 : 480.0), t = power(single ? 40.0 : 480.0);
    const auto scaled = [](const Vec3<T>& v, int n) {
      return Vec3<T>(std::ldexp(v.x(), n), std::ldexp(v.y(), n), std::ldexp(v.z(), n));
    };
    const Vec3<T> none(T(0), T(0), T(0)), moments = flight.body.moments.cast<T>();
    State<T> start{.p_WB = none,
                   .q_WB = flight.start.q_WB.cast<T>().normalized(),
                   .v_WB = none,
                   .L_W = flight.start.L_W.cast<T>()};
    const T time = static_cast<T>(context.uniform(-20.0, 20.0));
    const auto fly = [&](const State<T>& from, const Vec3<T>& I, const T& span) {
      return answer_of(FE_TONEAREST, [&] { return elliptic_flight(from, make_rigid_body(T(1), I), none, span); });
    };
    const auto plain = fly(start, moments, time);
    start.L_W = scaled(start.L_W, m - t);
    const auto other = fly(start, scaled(moments, m), std::ldexp(time, t));
    const bool same =
        plain && other && plain->q_WB.coeffs() == Eigen::Matrix<T, 4, 1>(context.produced(other->q_WB.coeffs()));
    worst.see(same ? 0.0 : 1.0, [&] { return describe(flight) + fmt::format(", 2^{}, 2^{}, t = {}", m, t, time); });
  }
}

Measurement measure_units(Context& context) {
  Worst worst;
  see_units<double>(context, worst, context.samples(500, 5000));
  see_units<float>(context, worst, context.samples(500, 5000));
  return worst.measurement();
}

/// Beyond what the batch's sine counts.
template <class T>
void see_batches(Context& context, Checks& checks, int count) {
  constexpr bool single = std::numeric_limits<T>::digits < 30;
  for (int i = 0; i < count; ++i) {
    const T time = any_size<T>(context.random(), single ? 12.0 : 16.0) * (i % 2 == 0 ? T(1) : T(-1));
    const Vec3<T> gravity(T(0), T(0), T(-10));
    StoneBatch<T> batch(9);
    std::vector<Top<T>> tops;
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const Moments<T> moments = draw_moments<T>(context.random(), i + static_cast<int>(k), false);
      const T speed = any_size<T>(context.random(), 3.0);
      const Quat<T> q = draw_attitude(context.random()).template cast<T>().normalized();
      tops.push_back({.moments = moments,
                      .state = spinning<T>(q, moments, Vec3<T>(speed * draw_direction<T>(context.random(), i))),
                      .time = time});
      batch.set(k, tops.back().state, moments);
    }
    batch.fly(gravity, time);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const Quat<T> q = produced(context, batch.get(k).q_WB);
      const Quat<T> alone = free_flight(tops[k].state, tops[k].moments, gravity, time).q_WB;
      const auto describe_it = [&] { return describe(tops[k]); };
      checks["attitude"].see(attitude_error(q, exact_attitude<Quad>(tops[k]), tops[k]), describe_it);
      see_length(checks["length"], q, describe_it);
      if (phase(tops[k]) > 1e10) {  // nothing but the same digits tells
        see_choice(checks["as alone"], q.coeffs() == alone.coeffs(), describe_it);
      }
    }
  }
}

}  // namespace

std::vector<Claim> domain_motion_claims() {
  return {
      {.id = "DOMAIN-5",
       .statement = "Free flight of bodies of any size, from any place, at rest, about an axis to the bit, with |q|² "
                    "off by ± 60 ε, "
                    "in each rounding mode: right to round-off; what overflows is refused.",
       .function = "free_flight",
       .family = OracleFamily::rounding,
       .oracle = "the formula, which FLIGHT-3 shows right, in 113 bits; the parabola",
       .checks = {within("attitude", 16.0, "ε (1 + phase)",
                         "twice FLIGHT-1's 8, for rounding that is not to the nearest", 1.0),
                  within("length", 16.0, "ε, of |q|²", "twice FLIGHT-4's 8, for rounding that is not to the nearest",
                         1.0),
                  within("place", 4.0, "ε (|p| + |v t| + |g t²/2|)",
                         "twice FLIGHT-5's 2, for rounding that is not to the nearest", 1.0),
                  within("velocity", 4.0, "ε (|v| + |g t|)",
                         "twice FLIGHT-5's 2, for rounding that is not to the nearest", 1.0),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_flights},
      {.id = "DOMAIN-6",
       .statement = "The flight of a body without a symmetry axis has the same digits in every unit: moments times "
                    "2^±480, times "
                    "times 2^±480 (float: 2^±40).",
       .function = "elliptic_flight",
       .family = OracleFamily::relation,
       .oracle = "the same flight in other units",
       .checks = {within("", 0.0, "flights that differ", "powers of two are exact")},
       .measure = measure_units},
      {.id = "DOMAIN-7",
       .statement = "A batch flies for up to 1e16 s (float: 1e12): each stone as alone, its attitude of length 1.",
       .function = "StoneBatch::fly",
       .family = OracleFamily::relation,
       .oracle = "free_flight of the same stone, to the bit beyond 1e10 rad; the formula in 113 bits",
       .checks = {within("attitude", 8.0, "ε (1 + phase)", "as BATCH-1", 0.5),
                  within("length", 8.0, "ε, of |q|²", "as FLIGHT-4", 0.5),
                  within("as alone", 0.0, "stones that differ",
                         "beyond 1e10 rad the batch leaves them to free_flight")},
       .measure = measure_both(see_batches<double>, see_batches<float>, 200, 2000)},
  };
}

}  // namespace goishi::verify
