/// DOMAIN: impacts of bodies of any size and speed, in float as in double. Witnesses: the same impact in other units, which
/// are powers of two; in double what float was given; the same in another rounding mode.

#include <fmt/format.h>

#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/domain.hpp"
#include "verify/samples/impact.hpp"

namespace goishi::verify {

namespace {

template <class T>
struct Met {
  ImpactBody<T> first, second;
  bool two = false;
  Vec3<T> p_WC, n_W;
  Material<T> material;
};

/// In T's own grid, normal and axes of length 1 in it.
template <class T>
Met<T> met_in(const Encounter& from) {
  const auto body = [](const ImpactBody<double>& b) {
    return ImpactBody<T>{.mobility = {static_cast<T>(b.mobility.linear), static_cast<T>(b.mobility.transverse),
                                      static_cast<T>(b.mobility.axial)},
                         .p_WB = b.p_WB.cast<T>(),
                         .u_W = b.u_W.cast<T>().normalized(),
                         .v_WB = b.v_WB.cast<T>(),
                         .L_W = b.L_W.cast<T>()};
  };
  return {.first = body(from.first.state),
          .second = body(from.second.state),
          .two = from.two,
          .p_WC = from.p_WC.cast<T>(),
          .n_W = from.n_W.cast<T>().normalized(),
          .material = {static_cast<T>(from.material.restitution), static_cast<T>(from.material.friction)}};
}

template <class T>
Met<double> in_double(const Met<T>& met) {
  const auto body = [](const ImpactBody<T>& b) {
    return ImpactBody<double>{
        .mobility = {double(b.mobility.linear), double(b.mobility.transverse), double(b.mobility.axial)},
        .p_WB = b.p_WB.template cast<double>(),
        .u_W = b.u_W.template cast<double>().normalized(),
        .v_WB = b.v_WB.template cast<double>(),
        .L_W = b.L_W.template cast<double>()};
  };
  return {.first = body(met.first),
          .second = body(met.second),
          .two = met.two,
          .p_WC = met.p_WC.template cast<double>(),
          .n_W = met.n_W.template cast<double>().normalized(),
          .material = {double(met.material.restitution), double(met.material.friction)}};
}

/// Lengths times 2^l, masses times 2^m, velocities times 2^v.
template <class T>
Met<T> in_units(const Met<T>& met, int l, int m, int v) {
  const auto scaled = [](const Vec3<T>& x, int n) {
    return Vec3<T>(std::ldexp(x.x(), n), std::ldexp(x.y(), n), std::ldexp(x.z(), n));
  };
  const auto body = [&](const ImpactBody<T>& b) {
    return ImpactBody<T>{.mobility = {std::ldexp(b.mobility.linear, -m), std::ldexp(b.mobility.transverse, -m - 2 * l),
                                      std::ldexp(b.mobility.axial, -m - 2 * l)},
                         .p_WB = scaled(b.p_WB, l),
                         .u_W = b.u_W,
                         .v_WB = scaled(b.v_WB, v),
                         .L_W = scaled(b.L_W, m + l + v)};
  };
  Met<T> result = met;
  result.first = body(met.first);
  result.second = body(met.second);
  result.p_WC = scaled(met.p_WC, l);
  return result;
}

template <class T>
Impulse<T> impulse_of(const Met<T>& met, ImpactLaw law) {
  return met.two ? resolve(law, met.material, met.p_WC, met.n_W, met.first, met.second).impulse
                 : resolve(law, met.material, met.p_WC, met.n_W, met.first).impulse;
}

/// Of impulses: how they differ, where a round-off of the velocities at the contact counts as what it makes.
template <class T>
double allowed(const Meeting& meeting) {
  return epsilon_of<T> * meeting.scale * static_cast<double>(meeting.W.trace() * meeting.W.inverse().trace()) *
         static_cast<double>(meeting.W.inverse().trace());
}

/// An impulse on the cone goes with its part along the normal, 1 + e times the plastic one, over all of it.
template <class T>
double condition_of(const Meeting& meeting, const Impulse<T>& impulse) {
  if (impulse.outcome != ImpactOutcome::slid) {
    return 1.0;
  }
  const long double plastic = -meeting.before.dot(meeting.n) / meeting.n.dot(Long3(meeting.W * meeting.n));
  const double normal = static_cast<double>((1 + static_cast<long double>(meeting.met.material.restitution)) * plastic);
  return 1.0 + impulse.impulse_W.template cast<double>().norm() / normal;
}

template <class T>
void see_units(Context& context, Checks& checks, int count) {
  constexpr bool single = std::numeric_limits<T>::digits < 30;
  for (int i = 0; i < count; ++i) {
    const Encounter from = draw_encounter(context, i);
    const Meeting meeting(from);
    if (!meeting.approaches()) {
      continue;
    }
    const Met<T> met = met_in<T>(from);
    const ImpactLaw law = all_laws[static_cast<std::size_t>(i / 2) % all_laws.size()];
    const auto power = [&](double reach) { return static_cast<int>(context.uniform(-reach, reach)); };
    // Very great and small, or very fast and slow: both would leave what energy can be.
    const bool by_mass = i % 4 < 2;
    const int l = power(single ? 15.0 : 160.0), m = power(by_mass ? (single ? 60.0 : 480.0) : (single ? 20.0 : 180.0)),
              v = power(by_mass ? (single ? 10.0 : 50.0) : (single ? 45.0 : 400.0));
    const auto describe_it = [&] {
      return fmt::format("2^{}, 2^{}, 2^{}, {} digits, {}", l, m, v, std::numeric_limits<T>::digits,
                         describe(from, law));
    };
    const auto plain = answer_of(FE_TONEAREST, [&] { return impulse_of(met, law); });
    const auto other = answer_of(FE_TONEAREST, [&] { return impulse_of(in_units(met, l, m, v), law); });
    const int mode = rounding_modes[1 + static_cast<std::size_t>(i / 3) % (rounding_modes.size() - 1)];
    const auto rounded = answer_of(mode, [&] { return impulse_of(met, law); });
    checks["refused"].see(plain && other && rounded ? 0.0 : 1.0, describe_it);
    if (!plain || !other || !rounded) {
      continue;
    }
    if (plain->outcome == ImpactOutcome::not_converged) {
      continue;  // the published law, which says so
    }
    const Vec3<double> p = plain->impulse_W.template cast<double>();
    Vec3<double> q = context.produced(Vec3<double>(other->impulse_W.template cast<double>()));
    q = {std::ldexp(q.x(), -m - v), std::ldexp(q.y(), -m - v), std::ldexp(q.z(), -m - v)};
    // The law that integrates, and the one that goes round until 1e-9, as well as they do.
    const double own = law == ImpactLaw::chatterjee_ruina ? 1.0 : law == ImpactLaw::stronge ? 1e3 : 1e5;
    const double allow = own * allowed<T>(meeting) * condition_of(meeting, *plain);
    checks["units"].see((q - p).norm(), allow, describe_it);
    const double energy = context.produced(std::ldexp(double(other->energy_change), -m - 2 * v));
    checks["energy"].see(std::fabs(energy - double(plain->energy_change)), allow * meeting.scale, describe_it);
    // What float gives of what it was given.
    const Vec3<double> right = impulse_of(in_double(met), law).impulse_W;
    if (single) {
      checks["float"].see((context.produced(p) - right).norm(), allow, describe_it);
    }
    const Vec3<double> otherwise = context.produced(Vec3<double>(rounded->impulse_W.template cast<double>()));
    checks["rounding"].see((otherwise - p).norm(), allow,
                           [&] { return fmt::format("mode {}: {}", mode, describe_it()); });
  }
}

}  // namespace

std::vector<Claim> domain_impact_claims() {
  return {
      {.id = "DOMAIN-8",
       .statement = "Every law gives the same impact in every unit: lengths times 2^±160, masses times 2^±480 or "
                    "velocities times "
                    "2^±400 (float: 2^±15, 2^±60, 2^±45); in float what it gives in double; and in each rounding mode.",
       .function = "resolve (impact)",
       .family = OracleFamily::relation,
       .oracle = "the same impact in other units; in double; rounded otherwise",
       .checks =
           {within("units", 1.0, "ε of the velocity, as an impulse, times the condition of W and of the cone",
                   "some ten roundings, of which the condition counts few; measured 2026-11-30 with 26 seeds: up "
                   "to 0.26"),
            within("energy", 1.0, "ε of the velocity, as an impulse, times the condition of W and of the cone",
                   "some ten roundings, of which the condition counts few; measured 2026-11-30 with 26 seeds: up "
                   "to 0.26"),
            {.name = "float",
             .unit = "ε of the velocity, as an impulse, times the condition of W and of the cone",
             .bound = 1.5,
             .reason =
                 "some ten roundings, of which the condition counts few; measured 2026-11-30 with 26 seeds: up to 0.2"},
            within("rounding", 3.0, "ε of the velocity, as an impulse, times the condition of W and of the cone",
                   "the same, all to one side; measured 2026-11-30 with 26 seeds: up to 0.99"),
            none("refused", "faults")},
       .measure = measure_both(see_units<double>, see_units<float>, 3000, 30'000)},
  };
}

}  // namespace goishi::verify
