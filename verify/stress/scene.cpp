#include "verify/stress/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "verify/stress/dice.hpp"

namespace goishi::verify::stress {

namespace {

Stone<double> draw_stone(Dice& dice, double w) {
  double h = w;
  switch (dice.of(5)) {
    case 0:
      break;
    case 1:
      h = w * dice.decades(-4.0, -1.0);
      break;
    case 2:
      h = w * (1.0 - dice.decades(-8.0, -1.0));
      break;
    default:
      h = w * dice.uniform(0.2, 0.9);
      break;
  }
  switch (dice.of(10)) {
    case 0:
    case 1:
    case 2:
      return make_stone(w, h, 0.0);
    case 3:
      return make_stone(w, h, h * dice.decades(-6.0, -2.0));
    default:
      return make_stone(w, h, h * dice.uniform(0.01, 0.95));
  }
}

void draw_material(Dice& dice, Scene& scene) {
  DropSettings<double>& settings = scene.settings;
  const double restitutions[] = {0.0, 1.0, 1.0 - dice.decades(-4.0, -1.0)};
  const int e = dice.of(12);
  settings.restitution = e < 3 ? restitutions[e] : dice.uniform(0.0, 0.9);
  const double frictions[] = {0.0, std::numeric_limits<double>::infinity(), dice.decades(-5.0, 3.0)};
  const int mu = dice.of(12);
  settings.friction = mu < 3 ? frictions[mu] : dice.uniform(0.05, 1.0);
  const double w = scene.stone.width;
  // Mostly so much that the stone comes to rest.
  const auto length = [&] { return w * dice.decades(dice.of(6) == 0 ? -7.0 : -3.0, std::log10(0.25)); };
  const double first = length(), second = length(), beyond = w * dice.uniform(0.25, 0.5);
  switch (dice.of(8)) {
    case 0:
      settings.rolling_resistance = settings.pivot_radius = 0.0;
      break;
    case 1:
      settings.rolling_resistance = first;
      settings.pivot_radius = 0.0;
      break;
    case 2:
      settings.rolling_resistance = 0.0;
      settings.pivot_radius = second;
      break;
    case 3:
    case 4:
      settings.rolling_resistance = first;
      settings.pivot_radius = second;
      break;
    case 5:
      if (dice.of(4) == 0) {
        (dice.of(2) == 0 ? settings.rolling_resistance : settings.pivot_radius) = beyond;
        scene.physical = false;
      }
      break;
    default:
      break;
  }
  switch (dice.of(16)) {
    case 0:
    case 1:
      settings.friction_model = FrictionModel::slip_proportional;
      settings.slip_coefficient = dice.decades(-2.0, 1.0) / std::sqrt(9.8 * w);
      break;
    case 2:
      settings.friction_model = FrictionModel::coulomb_contensou;
      settings.patch_radius = w * dice.decades(-3.5, -1.5);
      break;
    default:
      break;
  }
  settings.damping = dice.of(10) == 0 ? dice.uniform(0.0, 0.2) * std::sqrt(9.8 / w) : 0.0;
  const ImpactLaw laws[] = {ImpactLaw::published, ImpactLaw::stronge};
  const int law = dice.of(6);
  settings.law = law < 2 ? laws[law] : ImpactLaw::chatterjee_ruina;
  if (dice.of(6) == 0) {
    const Vec3<double> lean = (dice.of(2) == 0 ? 1.0 : dice.decades(-5.0, 1.0)) * dice.normal3();
    settings.gravity = dice.uniform(0.5, 1.5) * Vec3<double>(lean.x(), lean.y(), -9.8);
  } else if (dice.of(100) == 0) {
    settings.gravity = Vec3<double>::Zero();
  }
}

Quat<double> draw_attitude(Dice& dice) {
  const double half = std::sqrt(0.5);
  const double w = dice.normal();
  const Vec3<double> v = dice.normal3();
  switch (dice.of(6)) {
    case 0:
      return Quat<double>::Identity();  // flat
    case 1:
      return {half, half, 0.0, 0.0};  // on the rim
    case 2:
      return {half, 0.0, half, 0.0};
    default:
      return Quat<double>(w, v.x(), v.y(), v.z()).normalized();
  }
}

/// Over the plane, the surface, its edges and corners, or beside the board; for a stone 22 mm wide   [m].
Vec3<double> draw_place(Dice& dice, std::optional<Board<double>>& board) {
  const int place = dice.of(6);
  const double height = dice.uniform(0.012, 0.06);
  if (4 <= place) {
    return {0.0, 0.0, height};
  }
  board = make_board<double>();
  const auto edge = [&](double half) {
    const double off[] = {0.0, dice.decades(-12.0, -4.0), dice.uniform(-0.012, 0.012)};
    const int near = dice.of(12);
    return (dice.of(2) == 0 ? 1.0 : -1.0) * (half + off[near < 2 ? near : 2]);
  };
  const double along_x = dice.uniform(-0.25, 0.25), along_y = dice.uniform(-0.26, 0.26);
  switch (place) {
    case 0:
      return {edge(board->half_width), along_y, height};
    case 1:
      return {edge(board->half_width), edge(board->half_length), height};
    case 2:
      return {along_x, along_y, height};
    default:
      return {board->half_width + 0.012 + dice.decades(-9.0, -1.5), along_y, dice.uniform(-0.13, 0.02)};
  }
}

Board<double> scaled(const Board<double>& board, double by) {
  Board<double> other = board;
  for (double* length :
       {&other.half_width, &other.half_length, &other.thickness, &other.floor, &other.spacing_x, &other.spacing_y}) {
    *length *= by;
  }
  return other;
}

/// Down or sideways to where the stone touches.
void bring_to_touch(Scene& scene) {
  const Pose<double> pose{scene.start.p_WB, scene.start.q_WB};
  Separation<double> nearest = separation(scene.stone, pose, Plane<double>{Vec3<double>::UnitZ(), 0.0});
  if (scene.board) {
    nearest = separation(scene.stone, pose, *scene.board);
    const Separation<double> floor =
        separation(scene.stone, pose, Plane<double>{Vec3<double>::UnitZ(), scene.board->floor});
    nearest = floor.gap < nearest.gap ? floor : nearest;
  }
  scene.start.p_WB -= nearest.gap * nearest.n_W;
}

Vec3<double> draw_spin(Dice& dice) {
  const Vec3<double> direction = dice.normal3().normalized();
  const double fast = dice.decades(0.0, 3.0), usual = dice.uniform(0.0, 100.0);
  switch (dice.of(8)) {
    case 0:
    case 1:
      return Vec3<double>::Zero();
    case 2:
      return fast * direction;
    case 3:
      return fast * Vec3<double>::UnitZ();
    default:
      return usual * direction;
  }
}

}  // namespace

Scene draw_scene(std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, index);
  Scene scene;
  const double size = dice.of(5) == 0 ? dice.decades(-6.0, 4.0) : 1.0;
  const double pace = std::sqrt(size);
  scene.stone = draw_stone(dice, 0.022 * size);
  scene.body = make_rigid_body(mass_properties(scene.stone, Density{2800.0}));
  draw_material(dice, scene);
  scene.settings.tolerance = dice.decades(-9.0, -4.0);
  scene.start.p_WB = size * draw_place(dice, scene.board);
  if (scene.board) {
    *scene.board = scaled(*scene.board, size);
  }
  const Vec3<double> velocity = dice.normal3();
  const double speeds[] = {0.0, 0.05};
  const int speed = dice.of(4);
  scene.start.v_WB = pace * (speed < 2 ? speeds[speed] : dice.uniform(0.0, 1.0)) * velocity;
  scene.start.q_WB = draw_attitude(dice);
  scene.start.L_W = formula::angular_momentum_W(scene.start.q_WB, scene.body, Vec3<double>(draw_spin(dice) / pace));
  if (dice.of(6) == 0) {
    bring_to_touch(scene);
  }
  DropSettings<double>& set = scene.settings;
  const bool free = !(0.0 < set.gravity.norm());
  set = filled(set, scene.stone, free ? 9.8 : set.gravity.norm());
  // What nothing brings to rest is not followed for long: a slope that is too steep for it, next to no resistance, a law
  // without sticking where the stone may lean. Nor does an elastic stone bounce for ever.
  const double pull = std::hypot(set.gravity.x(), set.gravity.y()), weight = -set.gravity.z();
  const double least = std::fmin(*set.rolling_resistance, *set.pivot_radius);
  const bool sticks = set.friction_model == FrictionModel::dry;
  const bool steep = !(pull * scene.stone.width < weight * least) || !(pull < 0.9 * set.friction * weight);
  if (free || (0.0 < pull && (steep || !sticks)) || least < 1e-4 * scene.stone.width || (scene.board && !sticks)) {
    set.horizon = pace * dice.uniform(0.5, 3.0);
  }
  set.maximum_impacts = 20000;
  return scene;
}

Scene draw_floor_scene(std::uint64_t seed, std::uint64_t index) {
  Scene scene = draw_scene(seed, index);
  Dice dice(seed ^ 0x5eedULL, index);
  const double size = outer_width(scene.stone) / 0.022, pace = std::sqrt(size);
  scene.board = scaled(make_board<double>(), size);
  const Board<double>& board = *scene.board;
  const auto inside = [&](double half) { return half * dice.uniform(-1.1, 1.1); };
  const Vec3<double> to(inside(board.half_width), inside(board.half_length), board.floor);
  const double angle = dice.uniform(0.0, 6.3), out = std::hypot(board.half_width, board.half_length);
  const double away = out + size * (0.03 + 0.1 * dice.uniform(0.0, 1.0));
  scene.start.p_WB = {away * std::cos(angle), away * std::sin(angle), board.floor + outer_width(scene.stone)};
  scene.start.q_WB = draw_attitude(dice);
  const Pose<double> pose{scene.start.p_WB, scene.start.q_WB};
  scene.start.p_WB.z() -= separation(scene.stone, pose, floor_of(board)).gap;
  const Vec3<double> way(to.x() - scene.start.p_WB.x(), to.y() - scene.start.p_WB.y(), 0.0);
  scene.start.v_WB = pace * dice.uniform(0.5, 4.0) * way.normalized();
  const bool spins = dice.of(3) == 0;
  const Vec3<double> w_B = spins ? Vec3<double>(draw_spin(dice) / pace) : Vec3<double>::Zero();
  scene.start.L_W = formula::angular_momentum_W(scene.start.q_WB, scene.body, w_B);
  scene.settings.friction = dice.of(3) == 0 ? 0.0 : dice.decades(-3.0, -0.5);
  scene.settings.horizon = pace * dice.uniform(0.3, 1.5);
  return scene;
}

DropResult<double> run(const Scene& scene) {
  return scene.board ? drop(scene.stone, scene.body, scene.start, *scene.board, scene.settings)
                     : drop(scene.stone, scene.body, scene.start, scene.settings);
}

std::string describe(const Scene& scene) {
  const Stone<double>& stone = scene.stone;
  const DropSettings<double>& set = scene.settings;
  const State<double>& start = scene.start;
  const Vec3<double> w_B = formula::angular_velocity_B(start, scene.body);
  return fmt::format(
      "w = {:.3g} m, h/w = {:.6g}, b/h = {:.6g}; e = {:.6g}, μ = {:.6g}, δ = {:.3g} m, κ = {:.3g} m; {}, {}; damping "
      "{:.3g}/s; "
      "tolerance {:.2g}; horizon {:.3g} s; on the {}; p = ({:.6g}, {:.6g}, {:.6g}), v = ({:.3g}, {:.3g}, {:.3g}), "
      "q = ({:.6g}, {:.6g}, {:.6g}, {:.6g}), ω_B = ({:.4g}, {:.4g}, {:.4g}), g = ({:.3g}, {:.3g}, {:.3g})",
      stone.width, stone.height / outer_width(stone), stone.bevel / stone.height, set.restitution, set.friction,
      *set.rolling_resistance, *set.pivot_radius, to_string(set.law), to_string(set.friction_model), set.damping,
      set.tolerance, *set.horizon, scene.board ? "board" : "plane", start.p_WB.x(), start.p_WB.y(), start.p_WB.z(),
      start.v_WB.x(), start.v_WB.y(), start.v_WB.z(), start.q_WB.w(), start.q_WB.x(), start.q_WB.y(), start.q_WB.z(),
      w_B.x(), w_B.y(), w_B.z(), set.gravity.x(), set.gravity.y(), set.gravity.z());
}

}  // namespace goishi::verify::stress
