/// DROP: sliding to a stop, slopes, and waking by a gravity that leans.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

/// The axis' lean forward at which friction does not turn a stone that slides: d sin ψ = μ (r − d cos ψ).
double steady_tilt(const Pebble& pebble, double friction) {
  const Long d = pebble.shape.sphere_offset, r = pebble.shape.sphere_radius, mu = friction;
  return as_double(std::asin(mu * r / (d * std::sqrt(1 + mu * mu))) - std::atan(mu));
}

/// Sliding along x with the axis leaning forward.
State<double> slid(const Pebble& pebble, double tilt, double speed) {
  return set_on_cap(pebble, leaning(tilt), {0.0, 0.0, 0.0}, {speed, 0.0, 0.0});
}

// --- DROP-10

Measurement measure_sliding(Context& context) {
  Checks checks;
  std::vector<Figure> figures;
  const Pebble pebble = size_33();
  for (int i = 0; i < context.samples(10, 60); ++i) {
    const double mu = i == 0 ? 0.3 : context.uniform(0.05, 0.35), v = i == 0 ? 0.3 : context.uniform(0.05, 1.0);
    const DropSettings<double> settings = lossless(mu, tight);
    const Long g = g_earth, stops = v / (mu * g), place = static_cast<Long>(v) * v / (2 * mu * g);
    const auto see = [&](Long error, const char* check, const char* what = "") {
      checks[check].see(as_double(std::fabs(error)), [&] { return fmt::format("{}μ = {:a}, {:a} m/s", what, mu, v); });
    };
    const auto end_of = [&](double tilt, double speed) {
      const DropResult<double> dropped = drop(pebble, slid(pebble, tilt, speed), settings, 2 * stops);
      const Event<double>* const stick = first_event(dropped, EventKind::stick);
      return stick == nullptr ? PlanarMotion{.time = NAN}
                              : PlanarMotion{.time = context.produced(stick->time),
                                             .tilt = std::atan2(context.produced(witnessed(pebble, stick->after).u.x()),
                                                                witnessed(pebble, stick->after).u.z()),
                                             .x = context.produced(stick->after.p_WB.x())};
    };
    const double psi = steady_tilt(pebble, mu);
    const PlanarMotion steady = end_of(psi, v);
    see(steady.time / stops - 1, "steady end", "time: ");
    see(steady.x / place - 1, "steady end", "place: ");
    see(steady.tilt - psi, "steady tilt");
    // Then nothing holds it up: it rests where resistance, if there is any, holds it.
    DropSettings<double> resisted = settings;
    resisted.rolling_resistance = 1e-4;
    const DropResult<double> rests = drop(pebble, slid(pebble, psi, v), resisted, 60);
    const Long lever = pebble.shape.sphere_offset * std::sin(witnessed(pebble, rests.state).tilt);
    see(rests.status == DropStatus::rest && lever <= 1e-4L ? 0 : 1, "faults", "rests where resistance holds it: ");
    // From flat it tilts, and rolls before: an integration in the plane.
    const PlanarMotion flat = end_of(0.0, v);
    const PlanarMotion expected = end_of_slide(pebble.rocker(), {.friction = mu}, {.v = v});
    see((flat.time - expected.time) / stops, "end from flat", "time: ");
    see((flat.x - expected.x) / place, "end from flat", "place: ");
    see(flat.tilt - expected.tilt, "tilt from flat");
    see(std::fabs(flat.time / stops - 1) > 1e-5L ? 0 : 1, "faults", "no difference from flat: ");
    if (i == 0) {
      see(std::fabs(psi / degree - 7.452) < 5e-4 ? 0 : 1, "faults", "7.452°: ");
      figures = {
          {"μ = 0.3, 0.3 m/s, from the steady tilt",
           fmt::format("{:.3f}°: slip ends after {:.9f} s, {:.9f} m, as v²/(2μg)", psi / degree, as_double(steady.time),
                       as_double(steady.x))},
          {"from flat", fmt::format("after {:.9f} s ({:+.2f} %), {:.9f} m ({:+.3f} %), at {:.3f}°: not so",
                                    as_double(flat.time), as_double(100 * (flat.time / stops - 1)), as_double(flat.x),
                                    as_double(100 * (flat.x / place - 1)), as_double(flat.tilt) / degree)}};
    }
  }
  Measurement result = checks.measurement();
  result.figures = figures;
  return result;
}

// --- DROP-11

Measurement measure_slope(Context& context) {
  Checks checks;
  const Pebble pebble = size_33();
  for (int i = 0; i < context.samples(400, 1000); ++i) {
    const double mu = context.uniform(0.05, 0.35), limit = std::atan(mu);
    const double slope = i % 4 == 0   ? limit * (1.0 - 1e-6)
                         : i % 4 == 1 ? limit * (1.0 + 1e-6)
                                      : limit * context.uniform(0.1, 1.9);
    const Long g = g_earth, sine = std::sin(static_cast<Long>(slope)), cosine = std::cos(static_cast<Long>(slope));
    DropSettings<double> settings = lossless(mu, tight);
    settings.gravity = {as_double(g * sine), 0.0, as_double(-g * cosine)};
    const bool slides = slope > limit;
    // Let go where neither gravity nor friction turns it.
    const DropResult<double> dropped =
        drop(pebble, slid(pebble, steady_tilt(pebble, slides ? mu : std::tan(slope)), 0.0), settings, 0.2L);
    const auto see = [&](Long error, const char* check, const char* what = "") {
      checks[check].see(as_double(std::fabs(error)),
                        [&] { return fmt::format("{}μ = {:a}, {:a} rad", what, mu, slope); });
    };
    see(dropped.status == (slides ? DropStatus::moving : DropStatus::rest) ? 0 : 1, "faults", "sticks or slides: ");
    if (slides) {
      const Long along = g * (sine - mu * cosine), time = dropped.time;
      const Long scale = g * sine * time;
      see((context.produced(dropped.state.v_WB.x()) - along * time) / scale, "speed");
      see((context.produced(dropped.state.p_WB.x()) - along * time * time / 2) / (scale * time / 2), "place");
    } else {
      see(dropped.time < 1e-8 ? 0 : 1, "faults", "rests at once: ");
      see(dropped.state.p_WB.x() == 0.0 ? 0 : 1, "faults", "stays: ");
    }
  }
  return checks.measurement();
}

// --- DROP-22

/// Towards +x by the angle β.
Vec3<double> leaning_gravity(double slope) {
  return {g_earth * std::sin(slope), 0.0, -g_earth * std::cos(slope)};
}

/// A flat stone under a gravity that leans, as far as friction and resistance hold it, and further.
void see_woken(Context& context, Checks& checks, const Pebble& pebble, double mu, double delta) {
  DropSettings<double> settings;
  settings.friction = mu;
  settings.rolling_resistance = delta;
  settings.tolerance = tight;
  const double h = pebble.shape.height;
  const auto see = [&](Long error, const char* check) {
    checks[check].see(as_double(std::fabs(error)), [&] { return fmt::format("μ = {:a}, δ = {:a} m", mu, delta); });
  };
  const auto see_that = [&](bool right, const char* what) {
    checks["faults"].see(right ? 0.0 : 1.0, [&] { return fmt::format("{}: μ = {:a}, δ = {:a} m", what, mu, delta); });
  };
  State<double> start = slid(pebble, 0.0, 0.0);
  start.p_WB.z() += 0.001;
  Drop<double> rested(pebble.stone, pebble.body, start, settings);
  const DropResult<double> first = followed(rested);
  const auto wake = [&](double slope, double duration) {
    settings.gravity = leaning_gravity(slope);
    settings.horizon = duration;
    Drop<double> again = rested;
    std::vector<Event<double>> told;
    again.change(settings, told);
    see_that(told.size() == 1 && told[0].kind == EventKind::woken, "is told");
    return followed(again);
  };
  // Weight slips it from tan β = μ, and turns it about the contact from h/2 tan β = δ.
  const double limit = std::atan(std::min(mu, 2.0 * delta / h));
  const DropResult<double> stays = wake(limit * (1.0 - 1e-6), 60.0);
  see_that(stays.status == DropStatus::rest && stays.time == first.time, "stays");
  see_that(stays.state.p_WB == first.state.p_WB, "does not move");
  const DropResult<double> barely = wake(limit * (1.0 + 1e-6), 0.5);
  see_that(barely.time > first.time + 0.01, "moves");
  const double slope = 1.3 * limit;
  if (mu < 2.0 * delta / h) {  // slides as it is, resistance keeps it from turning
    const DropResult<double> slides = wake(slope, 0.1);
    const Long along = static_cast<Long>(g_earth) * (std::sin(slope) - mu * std::cos(slope));
    const Long time = static_cast<Long>(slides.time) - static_cast<Long>(first.time);
    see(context.produced(slides.state.p_WB.x()) / (along * time * time / 2) - 1, "slide");
    see(context.produced(slides.state.v_WB.x()) / (along * time) - 1, "slide");
  } else {  // rolls to where resistance holds it
    const DropResult<double> rolls = wake(slope, 60.0);
    const Long tilt = witnessed(pebble, rolls.state).tilt, d = pebble.shape.sphere_offset;
    const Long lever = (pebble.shape.sphere_radius - d * std::cos(tilt)) * std::tan(slope) - d * std::sin(tilt);
    see_that(rolls.status == DropStatus::rest && std::fabs(lever) <= delta && lever < delta / 1.01 && tilt > 1e-6L,
             "rests again, further on");
  }
}

/// Two drops, the second from where the first was stopped, against one.
void see_joined(Context& context, Checks& checks, const Pebble& pebble) {
  DropSettings<double> settings = lossless(0.2, 1e-9);
  const State<double> start = set_on_cap(pebble, leaning(context.uniform(0.1, 0.4)), {1.0, 2.0, 20.0}, {0.1, 0.0, 0.0});
  const DropResult<double> whole = drop(pebble, start, settings, 0.3L);
  const double stop = context.uniform(0.05, 0.25);
  Drop<double> part(pebble.stone, pebble.body, start, settings);
  part.advance_to(stop);
  part.change(settings);
  part.advance_to(0.3);
  const State<double> rest = part.state();
  const auto see = [&](Long error, const char* name) {
    checks[name].see(as_double(std::fabs(error)), [&] { return fmt::format("stopped at {:a} s", stop); });
  };
  see(part.time() == 0.3 && whole.time == 0.3 ? 0 : 1, "faults");
  see((context.produced(rest.p_WB) - whole.state.p_WB).norm() / pebble.shape.height, "joined");
  see((context.produced(witnessed(pebble, rest).u) - witnessed(pebble, whole.state).u).norm(), "joined");
}

Measurement measure_waking(Context& context) {
  Checks checks;
  const Pebble pebble = size_33(0.001);
  for (int i = 0; i < context.samples(24, 80); ++i) {
    const double mu = context.uniform(0.1, 0.5);
    see_woken(context, checks, pebble, mu, i % 2 == 0 ? context.uniform(3e-5, 2e-4) : pebble.shape.height * mu);
    see_joined(context, checks, size_33());
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> drop_sliding_claims() {
  return {
      {.id = "DROP-10",
       .statement =
           "A stone that slides stops after v²/(2μg) from the one tilt at which friction does not turn it, 7.452° at "
           "μ = 0.3, and then falls over to where resistance holds it. Not so from flat: it tilts, and stops "
           "when the equation in the plane says, at 0.3 m/s 1 % earlier.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "v/(μg), v²/(2μg); from flat Fehlberg 7(8) in long double with fixed steps",
       .checks = {{.name = "steady end",
                   .unit = "relative, of time and place",
                   .bound = 1e-14,
                   .reason =
                       "uniform deceleration has no error of steps; measured 2026-11-30 with 25 seeds: up to 1.4e-15",
                   .resolution = epsilon},
                  within("steady tilt", 2e-16, "rad",
                         "nothing turns it: some ulps of 2.8e-17; measured 2026-11-30 with 25 seeds: up to 2.0e-17",
                         2.8e-17),
                  within("end from flat", 8e-11, "relative, of time and place",
                         "some hundred steps of tolerance 1e-12; measured 2026-11-30 with 25 seeds: up to 1.5e-11"),
                  within("tilt from flat", 1e-10, "rad", "the same; measured 2026-11-30 with 25 seeds: up to 1.6e-11"),
                  none("faults", "faults")},
       .measure = measure_sliding},
      {.id = "DROP-11",
       .statement = "On a slope a stone let go at that tilt stays below atan μ and slides above it with g (sin β − μ "
                    "cos β), a millionth of the angle off it either way.",
       .function = "drop",
       .family = OracleFamily::exact,
       .oracle = "uniform acceleration, in long double",
       .checks = {within("speed", 5e-11, "of what it would be without friction",
                         "the grip that ends is known to 1e-12 of the weight, and a steady motion has no error of "
                         "steps; measured 2026-11-30 with 25 seeds: up to 1.3e-11"),
                  within("place", 5e-11, "of what it would be without friction",
                         "the same; measured 2026-11-30 with 25 seeds: up to 1.3e-11"),
                  none("faults", "faults")},
       .measure = measure_slope},
      {.id = "DROP-22",
       .statement =
           "A stone at rest stays when gravity leans by less than atan μ and atan 2δ/h, a millionth less, and moves "
           "when it leans a millionth more: it slides with g (sin β − μ cos β) where resistance keeps it from turning, "
           "else rolls to where that holds it. A drop that is stopped and woken ends as one that is not.",
       .function = "Drop::change",
       .family = OracleFamily::exact,
       .oracle = "the balance of the flat stone, uniform acceleration; the one drop",
       .checks = {within("slide", 2e-14, "relative",
                         "a steady motion has no error of steps; measured 2026-11-30 with 25 seeds: up to 2.2e-15",
                         epsilon),
                  within("joined", 5e-10, "of the height, rad",
                         "a hundred steps of tolerance 1e-9, taken otherwise in two drops than in one; measured "
                         "2026-11-30 with 25 seeds: up to 7.5e-11"),
                  none("faults", "faults")},
       .measure = measure_waking},
  };
}

}  // namespace goishi::verify
