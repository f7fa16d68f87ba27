/// DROP: what a drop looks like, and that its energy only falls.

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

/// Height, tilt and energy at a time of a drop: the same drop, stopped there.
struct Look3 {
  double height, tilt, energy;
};

Look3 seen_in(const Pebble& pebble, const State<double>& state) {
  const Witnessed seen = witnessed(pebble, state);
  return {state.p_WB.z(), as_double(seen.tilt) / degree, as_double(seen.energy) * pebble.body.mass};
}

Measurement measure_picture(Context& context) {
  const Pebble pebble = size_33(0.001);
  Worst worst;
  const State<double> start = draw_fall(context, pebble.body);
  Drop<double> motion(pebble.stone, pebble.body, start);
  motion.keep_motion();
  const DropResult<double> drop = followed(motion);
  Series height{"height of the centre", {}}, tilt{"tilt", {}}, energy{"energy", {}};
  const int count = context.samples(120, 400);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= count; ++i) {
    const double time = i == count ? drop.time : drop.time * i / count;
    const Look3 look = seen_in(pebble, motion.state_at(time));
    height.points.emplace_back(time, 1e3 * look.height);
    tilt.points.emplace_back(time, look.tilt);
    energy.points.emplace_back(time, 1e6 * look.energy);
    // The unit is the fall's energy.
    const double rise = (context.produced(look.energy) - last) / (pebble.body.mass * g_earth * 0.05);
    worst.see(std::max(0.0, rise), [&] { return fmt::format("at {} s", time); });
    last = look.energy;
  }
  const auto marks = [&](EventKind kind, auto&& value) {
    Series series{std::string(to_string(kind)), {}, false, Look::star};
    for (const Event<double>& event : drop.events) {
      if (event.kind == kind) {
        series.points.emplace_back(event.time, value(event));
      }
    }
    return series;
  };
  const auto with_marks = [&](Series line, auto&& value) {
    std::vector<Series> all = {std::move(line)};
    for (const EventKind kind : {EventKind::impact, EventKind::contact, EventKind::slip, EventKind::stick,
                                 EventKind::feature, EventKind::lift_off, EventKind::rest}) {
      if (Series series = marks(kind, value); !series.points.empty()) {
        all.push_back(std::move(series));
      }
    }
    return all;
  };
  Measurement result = worst.measurement();
  const auto tilt_of = [&](const Event<double>& event) {
    return as_double(witnessed(pebble, event.after).tilt) / degree;
  };
  result.plots = {{.title = "A drop: height against time",
                   .x_label = "time [s]",
                   .y_label = "height of the centre [mm]",
                   .series = with_marks(height, [](const Event<double>& e) { return 1e3 * e.after.p_WB.z(); })},
                  {.title = "The same drop: tilt of the axis",
                   .x_label = "time [s]",
                   .y_label = "tilt [°]",
                   .series = with_marks(tilt, tilt_of)},
                  {.title = "The same drop: energy",
                   .x_label = "time [s]",
                   .y_label = "energy over the board's surface [µJ]",
                   .series = with_marks(energy, [](const Event<double>& e) { return 1e6 * e.energy; })}};
  std::string kinds;
  for (const Event<double>& event : drop.events) {
    kinds += fmt::format("{}{} {:.4f} s", kinds.empty() ? "" : ", ", to_string(event.kind), event.time);
  }
  result.figures = {{"events", kinds}};
  return result;
}

}  // namespace

std::vector<Claim> drop_picture_claims() {
  return {
      {.id = "DROP-21",
       .statement = "The energy of a drop, seen at any time, only falls (with pictures)",
       .function = "drop",
       .family = OracleFamily::invariant,
       .oracle = "energy of the states, in long double",
       .checks = {within("", 2e-15, "of the fall's energy",
                         "flights and impacts round it; in contact the integration takes what energy is off out of "
                         "the velocities: there this says that it does, and no more; measured 2026-11-30 with 26 "
                         "seeds: up to 3.5e-16",
                         std::numeric_limits<double>::epsilon())},
       .measure = measure_picture},
  };
}

}  // namespace goishi::verify
