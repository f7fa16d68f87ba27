/// DROP: on a board as on the plane; over its edge, where a scheme of lower order stands for a contact that lasts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/drop.hpp"

namespace goishi::verify {

namespace {

bool is_same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

Measurement measure_middle(Context& context) {
  Worst worst;
  const Board<double> board = make_board<double>({.border_x = 10.0, .border_y = 10.0});  // no stone comes to its edge
  for (int i = 0; i < context.samples(20, 200); ++i) {
    const Pebble pebble = size_33(i % 2 == 0 ? 0.001 : 0.0);
    const State<double> start = draw_fall(context, pebble.body);
    DropSettings<double> settings;
    settings.tolerance = 1e-7;
    const DropResult<double> plane = goishi::drop(pebble.stone, pebble.body, start, settings);
    const DropResult<double> on_board = goishi::drop(pebble.stone, pebble.body, start, board, settings);
    const bool same = is_same(plane.state, on_board.state) && plane.time == on_board.time &&
                      plane.status == on_board.status && plane.events.size() == on_board.events.size();
    worst.see(same ? 0.0 : 1.0, [&] {
      return fmt::format("drop {}: ended at {:.17g} s, on the board at {:.17g} s", i, plane.time, on_board.time);
    });
  }
  return worst.measurement();
}

// --- over the edge

/// A stone at rest, lying flat on the edge with its centre beyond it, turns about the edge as a pendulum, as long as the
/// edge presses: (k² + ρ²) φ̈ = g ρ sin φ, ρ from the edge to the centre, φ from the vertical.
struct Tipping {
  State<double> start;
  Long distance, angle, lever;  // ρ, φ at the start; from the edge to the centre of the cap's sphere, level
  Long rate;                    // g ρ/(k² + ρ²)
};

Tipping tip(const Pebble& pebble, const Board<double>& board, double beyond) {
  const Long r = pebble.shape.sphere_radius, d = pebble.shape.sphere_offset, a = beyond;
  const Long height = std::sqrt(r * r - a * a) - d, distance = std::hypot(a, height);
  State<double> start;
  start.p_WB = {board.half_width + beyond, 0.01, as_double(height)};
  start.q_WB = Quat<double>::Identity();
  start.v_WB = start.L_W = Vec3<double>::Zero();
  return {start, distance, std::atan2(a, height), a,
          static_cast<Long>(g_earth) * distance / (pebble.transverse + distance * distance)};
}

/// How far the pendulum has turned after t, by the classical Runge–Kutta method; and the edge's normal force then, of m g.
std::pair<Long, Long> swung(const Pebble& pebble, const Tipping& tipping, Long t) {
  constexpr int steps = 4000;
  const Long h = t / steps;
  Long phi = tipping.angle, w = 0;
  for (int i = 0; i < steps; ++i) {
    const auto bend = [&](Long at) { return tipping.rate * std::sin(at); };
    const Long k1 = w, l1 = bend(phi), k2 = w + h / 2 * l1, l2 = bend(phi + h / 2 * k1);
    const Long k3 = w + h / 2 * l2, l3 = bend(phi + h / 2 * k2), k4 = w + h * l3, l4 = bend(phi + h * k3);
    phi += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    w += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  const Long turned = phi - tipping.angle, bend = tipping.rate * std::sin(phi), g = g_earth;
  // Of the centre, and along the cap's normal at the edge, which has turned with the stone.
  const Long a_x = tipping.distance * (bend * std::cos(phi) - w * w * std::sin(phi));
  const Long a_z = tipping.distance * (-bend * std::sin(phi) - w * w * std::cos(phi));
  const Long normal = std::asin(tipping.lever / pebble.shape.sphere_radius) + turned;
  return {turned, (a_x * std::sin(normal) + (a_z + g) * std::cos(normal)) / g};
}

Measurement measure_edge(Context& context) {
  Checks checks;
  const Board<double> board = make_board<double>();
  Plot plot{.title = "A stone that tips over the edge",
            .x_label = "edge_speed/√(w g)",
            .y_label = "error of the angle [rad]",
            .log_x = true,
            .log_y = true,
            .series = {}};
  for (int i = 0; i < context.samples(6, 30); ++i) {
    const double w = 0.022 * context.uniform(0.8, 1.5);
    const Pebble pebble = make_pebble(w, w * context.uniform(0.3, 0.6), i % 2 == 0 ? 0.04 * w : 0.0);
    const Tipping tipping = tip(pebble, board, w * context.uniform(0.03, 0.06));
    Long t = std::sqrt(static_cast<Long>(w) / g_earth);
    while (swung(pebble, tipping, t).first < 0.35L) {
      t *= 1.05L;
    }
    const auto [turned, force] = swung(pebble, tipping, t);
    if (!(0.2L < force)) {
      checks["pressing"].see(
          1.0, [&] { return fmt::format("stone {}: the edge presses with {:.3g} m g", i, as_double(force)); });
      continue;
    }
    checks["pressing"].see(0.0, [] { return ""; });
    const double scale = std::sqrt(w * g_earth);
    std::array<double, 4> errors{};
    Series series{.name = fmt::format("stone {}", i), .points = {}, .line = true, .look = Look::usual};
    for (std::size_t k = 0; k < errors.size(); ++k) {
      DropSettings<double> settings = lossless(no_slip, 1e-9);
      settings.edge_speed = scale * 4e-3 / std::pow(2.0, static_cast<double>(k));
      settings.horizon = as_double(t);
      const DropResult<double> drop = goishi::drop(pebble.stone, pebble.body, tipping.start, board, settings);
      const Vec3<double> u = drop.state.q_WB * Vec3<double>::UnitZ();
      const Long angle = std::atan2(static_cast<Long>(context.produced(u.x())), static_cast<Long>(u.z()));
      errors[k] = as_double(std::fabs(angle - turned));
      const double speed = *settings.edge_speed / scale;
      checks["angle"].see(errors[k] / speed, [&] {
        return fmt::format("w = {:a}, h = {:a}, edge_speed {:.3g} √(w g)", pebble.stone.width, pebble.stone.height,
                           speed);
      });
      series.points.emplace_back(speed, errors[k]);
    }
    const double order = std::log2(errors.front() / errors.back()) / 3.0;
    checks["order"].see(std::fabs(order - 1.0), [&] { return fmt::format("stone {}: order {:.3f}", i, order); });
    if (i < 4) {
      plot.series.push_back(series);
    }
  }
  Measurement result = checks.measurement();
  result.plots = {plot};
  return result;
}

}  // namespace

std::vector<Claim> drop_board_claims() {
  return {
      {.id = "DROP-27",
       .statement = "Over a board whose edges are out of reach a stone drops as on the plane, to the last bit.",
       .function = "drop (board)",
       .family = OracleFamily::relation,
       .oracle = "the same drop on the plane",
       .checks =
           {{.unit = "drops that differ", .bound = 0.0, .reason = "nothing of the board is near", .counts = true}},
       .measure = measure_middle},
      {.id = "DROP-28",
       .statement =
           "A stone that tips over the board's edge turns about it as a pendulum does: the scheme of micro-impacts "
           "that stands for such a contact is of first order in its speed.",
       .function = "drop (board)",
       .family = OracleFamily::exact,
       .oracle = "the equation of the pendulum, Runge–Kutta in long double, 4000 steps",
       .checks = {within("angle", 0.4, "rad, of edge_speed/√(w g)", "measured 2026-11-30 with 40 seeds: up to 0.113"),
                  within("order", 0.02, "off 1",
                         "first order, and what is of second; measured 2026-11-30 with 40 seeds: up to 0.006"),
                  {.name = "pressing",
                   .unit = "samples of which the edge lets go",
                   .bound = 0.0,
                   .reason = "as drawn, none",
                   .counts = true}},
       .measure = measure_edge},
  };
}

}  // namespace goishi::verify
