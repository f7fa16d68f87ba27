#include "verify/stress/heaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <optional>
#include <stdexcept>

#include "verify/stress/dice.hpp"

namespace goishi::verify::stress {

namespace {

using Board_ = goishi::Scene<double>;

Stone<double> draw_shape(Dice& dice, double w, int kind) {
  double h = w * dice.uniform(0.3, 0.6);
  switch (kind) {
    case 0:
      h = w * dice.decades(-1.7, -0.7);
      break;
    case 1:
      h = w * (1.0 - dice.decades(-6.0, -1.0));
      break;
    case 2:
      h = w;
      break;
    default:
      break;
  }
  return make_stone(w, h, dice.of(3) == 0 ? 0.0 : h * dice.uniform(0.02, 0.9));
}

SceneSettings<double> draw_settings(Dice& dice, bool& ends) {
  SceneSettings<double> settings;
  settings.drop.tolerance = dice.decades(-7.0, -4.0);
  const double e = dice.uniform(0.0, 0.8), mu = dice.uniform(0.1, 0.8);
  const int kind_e = dice.of(12), kind_mu = dice.of(12);
  settings.restitution = kind_e == 0 ? 0.0 : kind_e == 1 ? 1.0 : e;
  settings.drop.restitution = dice.of(2) == 0 ? settings.restitution : dice.uniform(0.0, 0.8);
  settings.friction = kind_mu == 0 ? 0.0 : mu;
  settings.drop.friction = kind_mu == 1 ? 0.0 : dice.uniform(0.1, 0.8);
  const int resistance = dice.of(8);
  if (resistance == 0) {
    settings.drop.rolling_resistance = settings.drop.pivot_radius = 0.0;
  } else if (resistance == 1) {
    settings.drop.rolling_resistance = dice.decades(-5.0, -3.0);
    settings.drop.pivot_radius = dice.decades(-5.0, -3.0);
  }
  const double lean = dice.uniform(0.0, 0.5), turn = dice.uniform(0.0, 6.3);
  const bool level = dice.of(6) != 0;
  if (!level) {
    settings.drop.gravity =
        9.8 * Vec3<double>(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), -std::cos(lean));
  }
  ends = level && 1 < resistance && 1 < kind_mu && kind_e != 1;
  return settings;
}

/// Where the heap is: over the middle, an edge, a corner, beside the board.
Vec3<double> draw_middle(Dice& dice, const Board<double>& board) {
  switch (dice.of(6)) {
    case 0:
      return {board.half_width + dice.uniform(-0.02, 0.02), dice.uniform(-0.1, 0.1), 0.0};
    case 1:
      return {board.half_width + dice.uniform(-0.02, 0.02), board.half_length + dice.uniform(-0.02, 0.02), 0.0};
    case 2:
      return {board.half_width + 0.2, 0.0, board.floor};
    default:
      return {dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1), 0.0};
  }
}

State<double> draw_start(Dice& dice, const RigidBody<double>& body, const Vec3<double>& p, double flat) {
  State<double> start{.p_WB = p, .q_WB = {1.0, 0.0, 0.0, 0.0}, .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
  const double speed = dice.uniform(0.0, 0.5),
               spin = dice.of(4) == 0 ? dice.decades(0.0, 2.0) : dice.uniform(0.0, 10.0);
  const Vec3<double> v = speed * dice.normal3(), w = spin * dice.normal3().normalized();
  const Quat<double> q(dice.normal(), dice.normal(), dice.normal(), dice.normal());
  if (dice.uniform(0.0, 1.0) < flat) {
    return start;
  }
  start.q_WB = q.normalized();
  start.v_WB = v;
  start.L_W = formula::angular_momentum_W(start.q_WB, body, w);
  return start;
}

/// The least gap of a stone that is to be added, by the judge's own loop over all.
double gap_to_all(const Board_& scene, const Stone<double>& stone, const Pose<double>& pose) {
  double least = std::fmin(separation(stone, pose, scene.board()).gap,
                           separation(stone, pose, Plane<double>{Vec3<double>::UnitZ(), scene.board().floor}).gap);
  for (const StoneId id : scene.stones()) {
    const State<double> there = scene.state(id);
    const double far = (there.p_WB - pose.p_WB).norm() - (outer_width(stone) + outer_width(scene.stone(id))) / 2.0;
    least = std::fmin(
        least, 0.0 < far ? far : separation(stone, pose, scene.stone(id), Pose<double>{there.p_WB, there.q_WB}).gap);
  }
  return least;
}

void draw_deeds(Dice& dice, Heap& heap) {
  const std::vector<StoneId> stones = heap.scene.stones();
  const int count = dice.of(3) == 0 ? 0 : dice.of(5);
  double last = 0.0;
  for (int i = 0; i < count; ++i) {
    const StoneId stone = stones[static_cast<std::size_t>(dice.of(static_cast<int>(stones.size())))];
    const double time = dice.uniform(0.0, longest_scene);
    const Vec3<double> v = dice.normal3(), w = dice.normal3();
    switch (dice.of(4)) {
      case 0:
        heap.deeds.push_back({Deed::Kind::hold, time, stone, Vec3<double>(0.1 * v.x(), 0.1 * v.y(), 0.2), 2.0 * w,
                              dice.uniform(0.02, 0.5)});
        heap.deeds.push_back({Deed::Kind::release, time + dice.uniform(0.05, 0.7), stone, v, w});
        break;
      case 1:
        heap.deeds.push_back({Deed::Kind::remove, time, stone, v, w});
        break;
      case 2:
        heap.deeds.push_back({Deed::Kind::tilt, time, stone, 9.8 * Vec3<double>(0.2 * v.x(), 0.2 * v.y(), -1.0), w});
        last = std::fmax(last, time);
        heap.ends = false;  // it may roll for long
        break;
      default:
        heap.deeds.push_back({Deed::Kind::push, time, stone, 0.3 * v, w});
        break;
    }
  }
  if (0.0 < last) {
    heap.deeds.push_back(
        {Deed::Kind::tilt, longest_scene, stones[0], heap.scene.settings().drop.gravity, Vec3<double>::Zero()});
  }
  std::stable_sort(heap.deeds.begin(), heap.deeds.end(), [](const Deed& a, const Deed& b) { return a.time < b.time; });
}

}  // namespace

Heap draw_heap(std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, index);
  bool ends = false;
  const SceneSettings<double> settings = draw_settings(dice, ends);
  Heap heap{Board_(make_board<double>(), settings), {}, 0, ends};
  const Board<double> board = heap.scene.board();
  const int count = 2 + (dice.of(3) == 0 ? dice.of(49) : dice.of(12));
  const Vec3<double> middle = draw_middle(dice, board);
  const bool mixed = dice.of(3) == 0;
  const int kind = dice.of(8);
  const double flat = dice.of(3) == 0 ? 0.8 : 0.1, narrow = dice.of(4) == 0 ? 1.0 : dice.uniform(1.05, 2.0);
  const Stone<double> usual = draw_shape(dice, 0.022, kind);
  const int across = 1 + dice.of(4);
  for (int i = 0; i < count; ++i) {
    const Stone<double> stone = mixed ? draw_shape(dice, 0.022 * dice.uniform(0.5, 2.0), dice.of(8)) : usual;
    const RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
    const double room = (mixed ? 0.046 : 0.0226) * narrow;
    // Some stand on the one below, by its thickness.
    const double layer = flat < 0.5 || mixed ? room : usual.height + 1e-6;
    Vec3<double> p = middle + Vec3<double>(room * (i % across), room * (i / across % across),
                                           layer * (i / (across * across)) + (flat < 0.5 ? 0.03 : stone.height / 2.0));
    if (dice.of(12) == 0) {
      p.z() -= dice.uniform(0.0, 0.01);  // into something, often
    }
    const State<double> start = draw_start(dice, body, p, flat);
    const double gap = gap_to_all(heap.scene, stone, {start.p_WB, start.q_WB});
    const std::size_t before = heap.scene.stones().size();
    try {
      static_cast<void>(heap.scene.add(stone, body, start));
      if (gap < -2e-9 * outer_width(stone)) {
        throw std::runtime_error(fmt::format("a stone is taken that overlaps by {} m", -gap));
      }
    } catch (const InvalidArgument& error) {
      ++heap.refused;
      const bool named = std::string_view(error.what()).find("overlaps") != std::string_view::npos;
      if (!named || 0.0 < gap || heap.scene.stones().size() != before) {
        throw std::runtime_error(fmt::format("a start with a gap of {} m is refused: {}", gap, error.what()));
      }
    }
  }
  if (heap.scene.stones().empty()) {
    const RigidBody<double> body = make_rigid_body(mass_properties(usual, Density{2800.0}));
    static_cast<void>(heap.scene.add(usual, body, draw_start(dice, body, {0.0, 0.0, 0.05}, 0.0)));
  }
  draw_deeds(dice, heap);
  return heap;
}

std::string describe_heap(std::uint64_t seed, std::uint64_t index) {
  const Heap heap = draw_heap(seed, index);
  const SceneSettings<double>& set = heap.scene.settings();
  const Vec3<double>& g = set.drop.gravity;
  std::string text = fmt::format(
      "e = {:.3g} and {:.3g}, μ = {:.3g} and {:.3g} (stones, board), g = ({:.3g}, {:.3g}, {:.3g}), tolerance {:.2g}, "
      "{} "
      "refused{}",
      set.restitution, set.drop.restitution, set.friction, set.drop.friction, g.x(), g.y(), g.z(), set.drop.tolerance,
      heap.refused, heap.ends ? ", is to rest" : "");
  for (const StoneId id : heap.scene.stones()) {
    const Stone<double>& stone = heap.scene.stone(id);
    const Vec3<double> p = heap.scene.state(id).p_WB;
    text += fmt::format("\n  {}: w = {:.4g}, h/w = {:.4g}, b/h = {:.4g}, p = ({:.4g}, {:.4g}, {:.4g})",
                        static_cast<int>(id), stone.width, stone.height / stone.width, stone.bevel / stone.height,
                        p.x(), p.y(), p.z());
  }
  constexpr const char* names[] = {"push", "hold", "release", "remove", "tilt"};
  for (const Deed& deed : heap.deeds) {
    text +=
        fmt::format("\n  {:.4f} s: {} {}", deed.time, names[static_cast<int>(deed.kind)], static_cast<int>(deed.stone));
  }
  return text;
}

}  // namespace goishi::verify::stress
