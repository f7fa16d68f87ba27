/// DROP: a drop as a value. How its time is cut does not matter, and its state can be told at any time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/drop/equations/stage_rates.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/digest.hpp"
#include "verify/samples/domain.hpp"
#include "verify/samples/drop.hpp"
#include "verify/samples/touching.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify {

namespace {

/// A drop that is to begin, on the plane, on the board or at its edge.
Drop<double> draw_drop(Context& context, int i) {
  Subject subject = draw_subject(context, i);
  subject.settings.tolerance = std::pow(10.0, context.uniform(-9.0, -4.0));
  subject.settings.restitution = i % 7 == 0 ? 0.0 : context.uniform(0.1, 0.8);
  subject.settings.maximum_steps = 200000;
  State<double> start = draw_fall(context, subject.body);
  const Stone<double>& stone = subject.specimen.stone;
  if (i % 3 == 0) {
    return {stone, subject.body, start, subject.settings};
  }
  const Board<double> board = make_board<double>();
  start.p_WB.x() = i % 3 == 1 ? 0.0 : board.half_width - context.uniform(-0.5, 0.5) * stone.width;
  return {stone, subject.body, start, board, subject.settings};
}

// --- DROP-32

Measurement measure_cuts(Context& context) {
  Checks checks;
  int pieces_in_all = 0, copies = 0;
  for (int i = 0; i < context.samples(80, 600); ++i) {
    const Drop<double> fresh = draw_drop(context, i);
    const double end = 0.6;
    Drop<double> whole = fresh;
    Digest told;
    whole.advance_to(end, told);
    for (const int most : {1, 30, 1000}) {
      Drop<double> drop = fresh;
      Digest digest;
      if (most == 30) {
        drop.keep_motion(50);
      }
      const int pieces = 1 + static_cast<int>(context.uniform(0.0, most));
      std::vector<double> times = {end};
      for (int k = 1; k < pieces; ++k) {
        times.push_back(context.uniform(0.0, end));
      }
      std::ranges::sort(times);
      for (const double time : times) {
        while (drop.advance_to(time, digest, most == 1000 ? 2 : 100000) == DropStatus::too_many_steps) {
        }
        if (context.uniform(0.0, 1.0) < 0.05) {
          const Drop<double> stored = drop;  // and the original goes elsewhere
          drop.apply_impulse({0.0, 0.0, 0.0}, {1e-3, 1e-3, 1e-3});
          drop.advance(0.01);
          drop = stored;
          ++copies;
        }
      }
      pieces_in_all += pieces;
      const State<double> there = drop.state();
      const bool same = context.produced(there.p_WB) == whole.state().p_WB &&
                        there.q_WB.coeffs() == whole.state().q_WB.coeffs() && there.v_WB == whole.state().v_WB &&
                        there.L_W == whole.state().L_W && digest == told && drop.status() == whole.status();
      checks["cuts"].see(same ? 0.0 : 1.0, [&] { return fmt::format("drop {} in {} pieces", i, pieces); });
    }
  }
  return checks.measurement(
      {{"pieces", fmt::format("{}", pieces_in_all)}, {"copies that were gone back to", fmt::format("{}", copies)}});
}

// --- DROP-33

/// Axis and place, velocity and angular momentum over the stone's own, energy over that of its speed.
struct Difference {
  double place, momenta, energy;
};

Difference difference(const Drop<double>& drop, const State<double>& a, const State<double>& b) {
  const double w = drop.stone().width, m = drop.body().mass, speed = std::sqrt(g_earth * w / 2.0);
  const Vec3<double> z = Vec3<double>::UnitZ();
  const auto energy = [&](const State<double>& state) {
    return formula::energy(state, drop.body(), drop.settings().gravity);
  };
  return {std::max((a.p_WB - b.p_WB).norm() / (w / 2.0), (a.q_WB * z - b.q_WB * z).norm()),
          std::max((a.v_WB - b.v_WB).norm() / speed, (a.L_W - b.L_W).norm() / (m * speed * w / 4.0)),
          std::fabs(energy(a) - energy(b)) / (m * speed * speed)};
}

Measurement measure_any_time(Context& context) {
  Checks checks;
  std::vector<double> places, momenta, energies, slopes;
  for (int i = 0; i < context.samples(60, 500); ++i) {
    const Drop<double> fresh = draw_drop(context, 3 * i);
    const double tolerance = fresh.settings().tolerance;
    Drop<double> kept = fresh;
    kept.keep_motion();
    std::vector<Event<double>> events;
    kept.advance_to(0.8, events);
    if (is_under_way(kept.status()) && kept.status() != DropStatus::moving) {
      continue;
    }
    const auto told = [&](double time) { return [&, time] { return fmt::format("drop {} at {:a} s", i, time); }; };
    const auto seen_at = [&](double time, Side side = Side::after) {
      State<double> state = kept.state_at(time, side);
      state.p_WB = context.produced(state.p_WB);
      state.L_W = context.produced(state.L_W);
      return state;
    };
    // From where it is, anew at 1e-12, for a part of what a step is long.
    Drop<double> now = fresh;
    DropSettings<double> sharp = fresh.settings();
    sharp.tolerance = tight;
    std::vector<double> times(static_cast<std::size_t>(context.samples(12, 40)));
    std::ranges::generate(times, [&] { return context.uniform(0.0, 0.79); });
    std::ranges::sort(times);
    for (const double time : times) {
      now.advance_to(time);
      Drop<double> other = now;
      other.change(sharp);
      const double later = time + context.uniform(0.0, 2e-3);
      const int impacts = other.counters().impacts;
      other.advance_to(later);
      if (other.counters().impacts == impacts) {  // an impact magnifies
        const Difference off = difference(kept, seen_at(later), other.state());
        places.push_back(off.place / tolerance);
        momenta.push_back(off.momenta / tolerance);
        energies.push_back(off.energy / tolerance);
      }
      // The derivative of the place is the velocity.
      const double h = 1e-5;
      const bool smooth = time > h && std::ranges::none_of(events, [&](const Event<double>& event) {
                            return std::fabs(event.time - time) < 2.0 * h;
                          });
      if (smooth) {
        const Vec3<double> slope = (seen_at(time + h).p_WB - seen_at(time - h).p_WB) / (2.0 * h);
        const Vec3<double> bend = (seen_at(time + h).v_WB - 2.0 * seen_at(time).v_WB + seen_at(time - h).v_WB) / 6.0;
        const double speed = std::sqrt(g_earth * kept.stone().width / 2.0);
        slopes.push_back((slope - bend - seen_at(time).v_WB).norm() / speed / (1e-10 + 30.0 * tolerance));
      }
    }
    for (const Event<double>& event : events) {
      const double size = 1e-15 * (1.0 + event.after.p_WB.norm() / kept.stone().width);
      const Difference before = difference(kept, seen_at(event.time, Side::before), event.before);
      const Difference after = difference(kept, seen_at(event.time), event.after);
      // Several at one time: before the first, after the last.
      const auto at_once = std::ranges::count(events, event.time, &Event<double>::time);
      checks["events"].see(at_once > 1 ? 0.0 : std::max(before.place, after.place), size, told(event.time));
      checks["jumps"].see(at_once > 1 ? 0.0 : std::max(before.momenta, after.momenta) / tolerance, told(event.time));
    }
  }
  for (const auto& [name, errors] :
       {std::pair{"place", &places}, {"momenta", &momenta}, {"energy", &energies}, {"derivative", &slopes}}) {
    checks[name].see(quantile(*errors, 0.99), [] { return "ninety-nine in a hundred"; });
  }
  return checks.measurement({{"times that were asked for", fmt::format("{}", places.size())},
                             {"of the tolerance at worst: place, momenta, energy",
                              fmt::format("{:.2g}, {:.2g}, {:.2g}", quantile(places, 1.0), quantile(momenta, 1.0),
                                          quantile(energies, 1.0))}});
}

// --- DROP-34

Measurement measure_stages(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const Subject subject = draw_subject(context, i % 5 == 0 || i % 5 == 1 ? i : 0);
    const double m = subject.body.mass;
    const Moments<double> per_mass{subject.body.moments.z() / m, subject.body.moments.x() / m};
    const detail::ContactBody<double> body =
        detail::contact_body<double>(subject.specimen.stone, per_mass, subject.settings, g_earth);
    const Vec3<double> u = draw_attitude(context.random()) * Vec3<double>::UnitZ();
    const Feature feature = i % 3 == 0 ? Feature::rim : u.z() > 0.0 ? Feature::lower_cap : Feature::upper_cap;
    const Vec3<double> L = per_mass.transverse * 30.0 * (draw_attitude(context.random()) * Vec3<double>::UnitX());
    const double phi = context.uniform(-3.0, 3.0), c = std::cos(phi), s = std::sin(phi);
    const detail::Variables<double> y = {u.x(), u.y(), u.z(), 0.0, 0.0, 0.0, 0.0, L.x(), L.y(), L.z(), 0.0, 0.0};
    const detail::Kinetics<double> now = detail::kinetics(body, feature, y);
    const StageMotion<double> stage = detail::stage_motion(body, feature, y);
    const auto told = [&] { return fmt::format("axis ({:a}, {:a}, {:a})", u.x(), u.y(), u.z()); };
    if (0.0 < formula::stage_room(stage) && 0.0 < formula::stage_weight(body.mobility, stage)) {
      const Vec3<double> whole = formula::rolling_force(now.W, now.brake, now.need);
      const Vec3<double> lean = context.produced(formula::stage_rolling_force(body.mobility, stage));
      checks["rolling"].see((lean - whole).norm() / (whole.norm() + now.need.norm()), told);
    }
    const double mu = context.uniform(0.05, 0.5);
    const SlipRate<double> lean = formula::stage_slip(body.mobility, stage, mu, c, s);
    const SlipRate<double> whole = formula::slip_rate(now.W, now.brake, now.need, mu, c, s);
    if (0.1 * now.W.zz < whole.denominator) {
      const double size = std::fabs(whole.N) + now.need.norm() + whole.N * now.W.zz;
      for (const double off : {lean.along - whole.along, lean.across - whole.across, lean.N - whole.N,
                               0.1 * (lean.across_slope - whole.across_slope)}) {
        checks["slip"].see(std::fabs(context.produced(off + size) - size) / size, told);
      }
    }
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> drop_value_claims() {
  return {
      {.id = "DROP-32",
       .statement =
           "How the time of a drop is cut does not matter, nor that it is stored, gone back to, kept or held up by a "
           "budget: state and events are the same to the last bit, on plane, board and edge, in 1 to 1000 pieces.",
       .function = "Drop::advance_to",
       .family = OracleFamily::relation,
       .oracle = "the same drop in one piece",
       .checks = {none("cuts", "drops that differ")},
       .measure = measure_cuts},
      {.id = "DROP-33",
       .statement =
           "The state of a drop at any time of its past is that of the drop from a moment before, at tolerance 1e-12, "
           "but for a few tolerances, in 99 of 100 times; the place's derivative is the velocity; at an event it is "
           "the "
           "event's, before and after.",
       .function = "Drop::state_at",
       .family = OracleFamily::relation,
       .oracle = "a fresh drop, at 1e-12, from the state up to 2 ms before",
       .checks = {within("place", 5.0, "of the tolerance, half widths and rad",
                         "ninety-nine times in a hundred, of a bar of 10: a few steps' errors, and the polynomial's; a "
                         "change of the equations between may magnify more. Measured 2026-11-30 with 20 seeds: up to "
                         "1.4",
                         0.1),
                  within("momenta", 10.0, "of the tolerance, of the stone's own speed",
                         "the same; measured 2026-11-30 with 20 seeds: up to 1.6", 0.2),
                  within("energy", 1.0, "of the tolerance, of the stone's own speed squared",
                         "the same, of a bar of 1; measured 2026-11-30 with 20 seeds: up to 0.6", 0.02),
                  within("jumps", 0.1, "of the tolerance, of the stone's own speed",
                         "at an event a turning or slip that is next to nothing is made nothing; measured 2026-11-30 "
                         "with 12 seeds: up to 7e-3",
                         1e-3),
                  within("derivative", 1.0, "of 30 tolerances and 1e-10, of the stone's own speed",
                         "ninety-nine times in a hundred: a polynomial's derivative is off by more than itself, over a "
                         "step; measured 2026-11-30 with 20 seeds: up to 0.4",
                         0.02),
                  within("events", 10.0, "ulp of the width, and of where it is",
                         "the stretch ends where the event is, by some roundings; measured 2026-11-30 with 12 seeds: "
                         "1.2 to 2.8")},
       .measure = measure_any_time},
      {.id = "DROP-34",
       .statement = "At the inner stages of a step the forces of rolling and of dry slip, which are worked out without "
                    "the contact matrix, are those that it gives.",
       .function = "formula::stage_rolling_force, formula::stage_slip",
       .family = OracleFamily::other_formula,
       .oracle = "contact_motion, rolling_force and slip_rate",
       .checks = {within("rolling", 4e-14, "relative",
                         "roundings, more where resistance leaves a normal force little room; measured 2026-11-30 with "
                         "20 seeds: 7.7e-16 to 7.7e-15"),
                  within("slip", 1e-14, "relative", "the same; measured 2026-11-30 with 20 seeds: up to 1.8e-15")},
       .measure = measure_stages},
  };
}

}  // namespace goishi::verify
