/// IMPACT: restitution, momentum, energy and friction of every law.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/impact.hpp"

namespace goishi::verify {

namespace {

/// Calls see(encounter, meeting, law) for `count` encounters that approach, Stronge's law at every eighth.
template <class F>
void for_each_impact(Context& context, int count, F&& see) {
  for (int i = 0; i < count; ++i) {
    const Encounter met = draw_encounter(context, i);
    const Meeting meeting(met);
    if (!meeting.approaches()) {
      continue;
    }
    for (const ImpactLaw law : all_laws) {
      if (law != ImpactLaw::stronge || (i / 16) % 8 == 0) {
        see(met, meeting, law);
      }
    }
  }
}

// --- IMPACT-1

Measurement measure_restitution(Context& context) {
  Worst worst;
  for_each_impact(context, context.samples(20000, 200000), [&](Encounter met, const Meeting& meeting, ImpactLaw law) {
    if (law != ImpactLaw::chatterjee_ruina) {
      met.material.friction = 0.0;
    }
    const TwoBodyImpact<double> end = strike(met, law);
    const BodyVelocity<double> first{context.produced(end.first.v_WB), end.first.L_W};
    const long double after = meeting.velocity(first, end.second).dot(meeting.n);
    const long double expected = -static_cast<long double>(met.material.restitution) * meeting.before.dot(meeting.n);
    worst.see(as_double(std::fabs(after - expected)), meeting.scale, [&] { return describe(met, law); });
  });
  return worst.measurement();
}

// --- IMPACT-2

Measurement measure_momentum(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(20000, 200000); ++i) {
    const Encounter met = draw_encounter(context, 2 * i + 1);
    const auto momenta = [&](const auto& one, const auto& other) {
      const auto of = [&](const Striker& striker, const auto& state) {
        const Long3 p = static_cast<long double>(striker.body.mass) * state.v_WB.template cast<long double>();
        const Long3 arm = (striker.state.p_WB - met.p_WC).cast<long double>();
        return std::pair<Long3, Long3>(p, arm.cross(p) + state.L_W.template cast<long double>());
      };
      const auto [p1, L1] = of(met.first, one);
      const auto [p2, L2] = of(met.second, other);
      return std::pair<Long3, Long3>(p1 + p2, L1 + L2);
    };
    const double width = std::max(outer_width(met.first.specimen.stone), outer_width(met.second.specimen.stone));
    for (const ImpactLaw law : all_laws) {
      if (law == ImpactLaw::stronge && i % 8 != 0) {
        continue;
      }
      const TwoBodyImpact<double> end = strike(met, law);
      const Vec3<double> p = context.produced(end.impulse.impulse_W);
      BodyVelocity<double> first = end.first;
      first.v_WB = context.produced(first.v_WB);
      const auto [p_before, L_before] = momenta(met.first.state, met.second.state);
      const auto [p_after, L_after] = momenta(first, end.second);
      const double size = p.norm() + met.first.body.mass * met.first.state.v_WB.norm() +
                          met.second.body.mass * met.second.state.v_WB.norm();
      const double spin = size * width + met.first.state.L_W.norm() + met.second.state.L_W.norm();
      const auto describe_case = [&] { return describe(met, law); };
      checks["momentum"].see(as_double((p_after - p_before).norm()), size, describe_case);
      checks["angular momentum"].see(as_double((L_after - L_before).norm()), spin, describe_case);
      // The first body got the impulse that is told.
      const Long3 got =
          static_cast<long double>(met.first.body.mass) * (first.v_WB - met.first.state.v_WB).cast<long double>();
      checks["impulse"].see(as_double((got - p.cast<long double>()).norm()), size, describe_case);
      // Exchanged bodies.
      const TwoBodyImpact<double> other =
          resolve(law, met.material, met.p_WC, Vec3<double>(-met.n_W), met.second.state, met.first.state);
      checks["exchanged"].see((other.impulse.impulse_W + p).norm(), size, describe_case);
    }
  }
  return checks.measurement();
}

// --- IMPACT-3

Measurement measure_energy(Context& context) {
  Checks checks;
  for_each_impact(context, context.samples(20000, 200000), [&](Encounter met, const Meeting& meeting, ImpactLaw law) {
    const auto see = [&](double error, const char* name) {
      checks[name].see(error, as_double(meeting.energy), [&] { return describe(met, law); });
    };
    const TwoBodyImpact<double> end = strike(met, law);
    const double told = context.produced(end.impulse.energy_change);
    const long double change = meeting.energy_of(end.first, end.second) - meeting.energy;
    see(std::fabs(told - as_double(change)), "as told");
    met.material.friction = 0.0;
    const TwoBodyImpact<double> smooth = strike(met, law);
    const long double e = static_cast<long double>(met.material.restitution), vn = meeting.before.dot(meeting.n);
    const long double K = meeting.n.dot(Long3(meeting.W * meeting.n));
    const long double lost = -(1 - e * e) * vn * vn / (2 * K);
    see(std::fabs(as_double(lost) - context.produced(smooth.impulse.energy_change)), "without friction");
  });
  return checks.measurement();
}

// --- IMPACT-4

Measurement measure_no_gain(Context& context) {
  Checks checks;
  double least = 0.0;
  int unsettled = 0, rounds = 0, steps = 0;
  for_each_impact(
      context, context.samples(30000, 1000000), [&](const Encounter& met, const Meeting& meeting, ImpactLaw law) {
        const TwoBodyImpact<double> end = strike(met, law);
        BodyVelocity<double> first = end.first;
        first.v_WB = context.produced(first.v_WB);
        const double gain = as_double((meeting.energy_of(first, end.second) - meeting.energy) / meeting.energy);
        least = std::min(least, gain);
        checks["gain"].see(gain, [&] { return describe(met, law); });
        const bool gave_up = end.impulse.outcome == ImpactOutcome::not_converged;
        unsettled += gave_up ? 1 : 0;
        checks["given up"].see(gave_up && law != ImpactLaw::published ? 1.0 : 0.0, [&] { return describe(met, law); });
        (law == ImpactLaw::published ? rounds : steps) =
            std::max(law == ImpactLaw::published ? rounds : steps, end.impulse.rounds);
      });
  return checks.measurement({{"the greatest loss", fmt::format("{:.1f} % of the energy", -100.0 * least)},
                             {"the published law gave up after 1000 rounds", fmt::format("{} times", unsettled)},
                             {"steps of Stronge's law", fmt::format("{} at most", steps)},
                             {"rounds of the published law", fmt::format("{} at most", rounds)}});
}

// --- IMPACT-5

Measurement measure_friction(Context& context) {
  Checks checks;
  for_each_impact(
      context, context.samples(20000, 200000), [&](const Encounter& met, const Meeting& meeting, ImpactLaw law) {
        const TwoBodyImpact<double> end = strike(met, law);
        if (end.impulse.outcome == ImpactOutcome::not_converged) {
          return;
        }
        const double mu = met.material.friction;
        const long double e = static_cast<long double>(met.material.restitution);
        const auto see = [&](double error, double scale, const char* check, const char* what = "") {
          const double share = law == ImpactLaw::stronge ? 10.0 : 1.0;  // the process is integrated
          checks[check].see(error, scale * share, [&] { return what + describe(met, law); });
        };
        const Vec3<double>& told = end.impulse.impulse_W;
        const Long3 p(context.produced(told.x()), told.y(), told.z());  // a length would not be seen
        const double normal = as_double(p.dot(meeting.n));
        // Stronge's impulse is made of the change of velocity.
        const double unit = law == ImpactLaw::stronge ? meeting.scale / as_double(meeting.W.trace()) : 0.0;
        const double size = as_double(p.norm()) + unit;
        const double tangential = as_double(Long3(p - p.dot(meeting.n) * meeting.n).norm());
        // |p_t| <= μ p_n, over 1 + μ; and the board does not pull.
        const double against = 1.0 / (1.0 + 1.0 / mu), along = 1.0 / (1.0 + mu);
        see(std::max(0.0, along * tangential - against * normal), size, "cone", "outside: ");
        see(std::max(0.0, -normal), size, "cone", "pulled: ");
        const Long3 after = meeting.before + meeting.W * p;
        see(std::max(0.0, as_double(-after.dot(meeting.n))), meeting.scale,
            law == ImpactLaw::published ? "approach of the published law" : "approach");
        const Long3 slip = after - after.dot(meeting.n) * meeting.n;
        const long double plastic = -meeting.before.dot(meeting.n) / meeting.n.dot(Long3(meeting.W * meeting.n));
        const Long3 left = meeting.before + plastic * Long3(meeting.W * meeting.n);  // by the plastic normal impulse
        if (law == ImpactLaw::chatterjee_ruina) {
          see(std::max(0.0, as_double(left.dot(p))), meeting.scale * size, "direction",
              "with the slip that it is against: ");
          if (end.impulse.outcome == ImpactOutcome::stuck) {
            see(as_double((after - e * plastic * Long3(meeting.W * meeting.n)).norm()), meeting.scale,
                "slip of what sticks");
          }
        } else if (end.impulse.outcome == ImpactOutcome::stuck && law == ImpactLaw::stronge) {
          see(as_double(slip.norm()), meeting.scale, "slip of what sticks");
        }
        const bool once =
            law == ImpactLaw::chatterjee_ruina || (law == ImpactLaw::published && end.impulse.rounds == 1);
        if (end.impulse.outcome == ImpactOutcome::slid && once) {
          see(std::fabs(along * tangential - against * normal), size, "cone", "slid, but not on it: ");
        }
        if (law == ImpactLaw::published && end.impulse.rounds == 1) {
          const Long3 met_with = meeting.before + (1 + e) * plastic * Long3(meeting.W * meeting.n);
          const Long3 across = met_with - met_with.dot(meeting.n) * meeting.n;
          const Long3 pt = p - p.dot(meeting.n) * meeting.n;
          see(as_double(pt.dot(across) + pt.norm() * across.norm()), meeting.scale * size, "direction",
              "not against the slip: ");
          if (end.impulse.outcome == ImpactOutcome::stuck &&
              across.norm() > 1e-6L * static_cast<long double>(meeting.scale)) {
            see(as_double(std::fabs(after.dot(across)) / across.norm()), meeting.scale, "slip of what sticks",
                "as before: ");
          }
        }
      });
  return checks.measurement();
}

}  // namespace

std::vector<Claim> impact_claims() {
  return {
      {.id = "IMPACT-1",
       .statement = "A contact that approaches leaves with v_n⁺ = −e v_n⁻: under every law without friction, under the "
                    "default law with any friction; stones on the board and in pairs, thin ones and balls.",
       .function = "resolve (impact)",
       .family = OracleFamily::exact,
       .oracle = "velocities of the contact before and after, from full tensors in long double",
       .checks = {within("", 1e-14, "of the contact's velocity, centre and spin added up",
                         "some ten roundings of a product of condition up to 7, the greatest eigenvalue of m W of "
                         "a lens; measured "
                         "2026-11-22",
                         epsilon)},
       .measure = measure_restitution},
      {.id = "IMPACT-2",
       .statement = "Two bodies keep their momentum and their angular momentum about the contact; the first gets the "
                    "impulse that is told; exchanging the bodies exchanges the result.",
       .function = "resolve (two bodies)",
       .family = OracleFamily::invariant,
       .oracle = "momenta of both in long double; the same impact the other way round",
       .checks = {within("momentum", 1e-15, "of the momenta and the impulse together",
                         "each momentum is rounded a few times; measured 2026-11-30 with 26 seeds: up to 3.8e-16",
                         epsilon),
                  within("angular momentum", 1e-15, "of the momenta and the impulse together",
                         "the same; measured 2026-11-30 with 26 seeds: up to 1.1e-16", epsilon),
                  within("impulse", 1e-15, "of the momenta and the impulse together",
                         "the same; measured 2026-11-30 with 26 seeds: up to 3.1e-16", epsilon),
                  within("exchanged", 0.0, "of the momenta and the impulse together",
                         "the same sums, the other way round")},
       .measure = measure_momentum},
      {.id = "IMPACT-3",
       .statement = "The energy changes as told; without friction by −(1 − e²) v_n²/(2K).",
       .function = "resolve (impact)",
       .family = OracleFamily::exact,
       .oracle = "energies of the bodies before and after, and K from full tensors, in long double",
       .checks =
           {{.name = "as told",
             .unit = "of the energy before",
             .bound = 1e-14,
             .reason =
                 "twice IMPACT-1's bound, since energy is a square; measured 2026-11-30 with 26 seeds: up to 2.4e-15",
             .resolution = epsilon},
            within("without friction", 5e-15, "of the energy before",
                   "the same; measured 2026-11-30 with 26 seeds: up to 1.6e-15", epsilon)},
       .measure = measure_energy},
      {.id = "IMPACT-4",
       .statement = "No law gains energy in a million random impacts: any e from 0 to 1, any friction from none to "
                    "infinite, thin stones and balls, on the board and in pairs. Only the published law ever gives up.",
       .function = "resolve (impact)",
       .family = OracleFamily::invariant,
       .oracle = "energies of the bodies before and after, from full tensors in long double",
       .checks = {within("gain", 1e-14, "of the energy before",
                         "round-off, as in IMPACT-3: with e = 1 and no friction the energy stays; measured "
                         "2026-11-30 with 26 seeds: up to 1.1e-15",
                         epsilon),
                  none("given up", "faults")},
       .measure = measure_no_gain},
      {.id = "IMPACT-5",
       .statement =
           "Friction removes the slip or lies on the cone, and is against it: the impulse is never outside the "
           "cone, the board never pulls, no contact leaves approaching. Stronge's law: no slip is left; the "
           "published law: none along the slip that friction met; the default law: only e W p_I, and friction "
           "is against the slip that the plastic normal impulse leaves.",
       .function = "resolve (impact)",
       .family = OracleFamily::invariant,
       .oracle = "Coulomb's law on the impulse and the velocities, the contact matrix from full tensors in long double",
       .checks =
           {within("cone", 6e-15, "of the impulse",
                   "IMPACT-1, and the condition of W once more; Stronge's law, which is integrated, counts a "
                   "tenth; measured 2026-11-30 with 26 seeds: up to 1.1e-15",
                   epsilon),
            within("approach", 4e-15, "of the velocity", "the same; measured 2026-11-30 with 26 seeds: up to 8.0e-16",
                   epsilon),
            {.name = "approach of the published law",
             .unit = "of the velocity",
             .bound = 1e-9,
             .reason =
                 "it goes round until 1e-9 of the approach is left; measured 2026-11-30 with 26 seeds: up to 9.9e-10"},
            within("direction", 1e-15, "of velocity and impulse",
                   "as the cone; measured 2026-11-30 with 26 seeds: up to 2.0e-16", epsilon),
            within("slip of what sticks", 1e-14, "of the velocity",
                   "the same; measured 2026-11-30 with 26 seeds: up to 2.4e-15", epsilon)},
       .measure = measure_friction},
  };
}

}  // namespace goishi::verify
