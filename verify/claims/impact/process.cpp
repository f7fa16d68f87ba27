/// IMPACT: Stronge's law in a plane, and the default law beside it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/impact.hpp"

namespace goishi::verify {

namespace {

// --- IMPACT-6: Routh's construction

/// A planar impact: the slip and the normal velocity are linear in the normal impulse, piece by piece.
struct Planar {
  long double tt, tn, nn;  // of the contact matrix
  long double e, mu;

  struct End {
    long double slip, normal;
  };

  [[nodiscard]] End run(long double slip, long double normal) const {
    long double work = 0, compression = 0;
    bool compressing = true;
    for (int piece = 0; piece < 8; ++piece) {
      // Friction for each unit of normal impulse, < 0 against a slip to the right.
      const long double holding = -tn / tt;
      const long double f = slip > 0                   ? -mu
                            : slip < 0                 ? mu
                            : std::fabs(holding) <= mu ? holding
                            : holding > 0              ? mu
                                                       : -mu;
      const long double slip_rate = tn + f * tt, rate = nn + f * tn;
      long double step = std::numeric_limits<long double>::infinity();
      if (slip * slip_rate < 0) {
        step = -slip / slip_rate;
      }
      const long double ahead = compressing ? -normal : (1 - e * e) * compression - work;
      const long double root = std::sqrt(std::max(0.0L, normal * normal + 2 * rate * ahead));
      const long double end = compressing ? (rate > 0 ? -normal / rate : step * 2) : (root - normal) / rate;
      const bool phase_ends = end < step;
      step = std::min(step, end);
      work += normal * step + rate * step * step / 2;
      normal += rate * step;
      slip = phase_ends ? slip + slip_rate * step : 0;
      if (std::fabs(holding) <= mu && std::fabs(slip_rate) < 1e-15L * tt) {
        slip = 0;
      }
      if (phase_ends) {
        if (!compressing || !(e > 0)) {
          return {slip, normal};
        }
        compressing = false;
        compression = work;
      }
    }
    return {std::numeric_limits<long double>::quiet_NaN(), 0};
  }
};

/// An encounter with the board whose velocity at the contact lies in the plane of normal and axis, where the third
/// direction has no part.
bool make_planar(Encounter& met) {
  met.two = false;
  met.material.friction = std::min(met.material.friction, 1e3);
  ImpactBody<double>& body = met.first.state;
  const Vec3<double> side = body.u_W.cross(met.n_W);
  if (side.norm() < 1e-3) {
    return false;
  }
  const Vec3<double> out = side.normalized();
  body.v_WB -= out.dot(body.v_WB) * out;
  body.L_W = out.dot(body.L_W) * out;
  return true;
}

Measurement measure_routh(Context& context) {
  Worst worst;
  int reversed = 0, held = 0;
  for (int i = 0; i < context.samples(4000, 40000); ++i) {
    Encounter met = draw_encounter(context, i);
    if (!make_planar(met) || !(met.material.friction > 0.0)) {
      continue;
    }
    const Meeting meeting(met);
    if (!(meeting.before.dot(meeting.n) < -1e-3L * static_cast<long double>(meeting.scale))) {
      continue;
    }
    const Long3 out = met.first.state.u_W.cross(met.n_W).cast<long double>().normalized();
    const Long3 t = meeting.n.cross(out);
    const Planar planar{t.dot(Long3(meeting.W * t)), t.dot(Long3(meeting.W * meeting.n)),
                        meeting.n.dot(Long3(meeting.W * meeting.n)), static_cast<long double>(met.material.restitution),
                        static_cast<long double>(met.material.friction)};
    const Planar::End end = planar.run(t.dot(meeting.before), meeting.n.dot(meeting.before));
    const TwoBodyImpact<double> found = strike(met, ImpactLaw::stronge);
    const BodyVelocity<double> body{context.produced(found.first.v_WB), found.first.L_W};
    const Long3 after = meeting.velocity(body, found.second);
    worst.see(as_double((after - end.slip * t - end.normal * meeting.n).norm()), meeting.scale,
              [&] { return describe(met, ImpactLaw::stronge); });
    reversed += end.slip * t.dot(meeting.before) < 0;
    held += std::fabs(end.slip) < 1e-12L;
  }
  return worst.measurement({{"left with the slip reversed", fmt::format("{} of {}", reversed, worst.cases())},
                            {"left without slip", fmt::format("{} of {}", held, worst.cases())}});
}

// --- IMPACT-8: the default law beside it

struct Difference {
  double median, worst;  // of the impulse
  double absolute;       // the worst, of the momentum at 1 m/s, which the centres have
};

Difference difference_of(Context& context, const Stone<double>& stone, double e, double mu, int count) {
  std::vector<double> all;
  double absolute = 0.0;
  const MassProperties<double> body = mass_properties(stone, Mass{0.005});
  while (static_cast<int>(all.size()) < count) {
    const Quat<double> q = draw_attitude(context.random());
    const Vec3<double> n(0.0, 0.0, 1.0);
    const Vec3<double> down = q.conjugate() * Vec3<double>(-n);
    const Vec3<double> r = q * support(stone, Vec3<double>(down.normalized())).p_B;
    const ImpactBody<double> state{make_mobility(body), -r, formula::symmetry_axis(q), draw_unit(context),
                                   body.moments.transverse * 50.0 * context.uniform(0.0, 1.0) * draw_unit(context)};
    const Material<double> material = make_material(e, mu);
    const Vec3<double> p_WC(0.0, 0.0, 0.0);
    const Impulse<double> one = resolve(ImpactLaw::chatterjee_ruina, material, p_WC, n, state).impulse;
    const Impulse<double> other = resolve(ImpactLaw::stronge, material, p_WC, n, state).impulse;
    if (one.outcome != ImpactOutcome::separating) {
      const double off = (context.produced(one.impulse_W) - other.impulse_W).norm();
      all.push_back(off / other.impulse_W.norm());
      absolute = std::max(absolute, off / body.mass);
    }
  }
  std::sort(all.begin(), all.end());
  return {all[all.size() / 2], all.back(), absolute};
}

Measurement measure_default(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const int count = context.samples(300, 3000);
  const auto figure = [&](const std::string& name, const Difference& difference) {
    figures.push_back(
        {name, fmt::format("median {:.1f} %, at most {:.1f} %", 100.0 * difference.median, 100.0 * difference.worst)});
  };
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double mu : {0.1, 0.2, 0.3}) {
      const std::string name = fmt::format("size 33, e = {}, μ = {}", e, mu);
      const Difference stone = difference_of(context, make_stone(0.022, 0.0092, 0.001), e, mu, count);
      figure(name, stone);
      checks["median"].see(stone.median, [&] { return name; });
      checks["faults"].see(stone.worst <= 0.5 ? 0.0 : 1.0, [&] { return name; });
      // A ball, whose W does not couple.
      checks["ball"].see(difference_of(context, make_stone(0.022, 0.022), e, mu, count).absolute, [&] { return name; });
    }
  }
  return checks.measurement(figures);
}

}  // namespace

std::vector<Claim> impact_process_claims() {
  return {
      {.id = "IMPACT-6",
       .statement = "Stronge's law in a plane is Routh's construction: stick, slip, reversal and both phases, piece by "
                    "piece linear in the normal impulse.",
       .function = "resolve, stronge",
       .family = OracleFamily::exact,
       .oracle = "the pieces in closed form, in long double",
       .checks = {within("", 1.5e-13, "of the contact's velocity, centre and spin added up",
                         "round-off of a grazing impact: approach speeds from 1e-3 of the velocity up; measured "
                         "2026-11-30 with 26 seeds: up to 1.8e-14",
                         epsilon)},
       .measure = measure_routh},
      {.id = "IMPACT-8",
       .statement =
           "The default law stays near Stronge's: on a stone of size 33, with friction up to 0.3, the impulses "
           "differ by some 4 % in the median and by no more than half; on a ball they are the same.",
       .function = "resolve, chatterjee_ruina",
       .family = OracleFamily::integration,
       .oracle = "Stronge's law by integration of the impact",
       .checks = {within("median", 0.08, "of the impulse",
                         "two laws, of nine materials; measured 2026-11-30 with 12 seeds: up to 0.050"),
                  {.name = "ball",
                   .unit = "of the momentum at 1 m/s",
                   .bound = 5e-15,
                   .reason =
                       "W does not couple: one law, and round-off; measured 2026-11-30 with 12 seeds: up to 1.1e-15",
                   .resolution = epsilon},
                  none("faults", "faults")},
       .measure = measure_default},
  };
}

}  // namespace goishi::verify
