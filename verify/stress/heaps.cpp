#include "verify/stress/heaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <goishi/mass/inertia.hpp>
#include <optional>

#include "verify/stress/dice.hpp"

namespace goishi::verify::stress {

namespace {

using Board_ = goishi::Scene<double>;

constexpr double frame = 1.0 / 60.0;
constexpr double longest_scene = 1.0;  // [s] with deeds
constexpr double longest_end = 40.0;   // [s] until it has to rest

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

class HeapJudge {
 public:
  explicit HeapJudge(Heap heap) : heap_(std::move(heap)), scene_(heap_.scene) {}

  HeapVerdict operator()() {
    verdict_.stones = scene_.stones().size();
    verdict_.refused = heap_.refused;
    begin();
    std::size_t deed = 0;
    for (double time = frame; verdict_.faults.empty() && time < longest_scene + 0.8; time += frame) {
      for (; deed < heap_.deeds.size() && heap_.deeds[deed].time <= time; ++deed) {
        go_to(std::fmax(scene_.time(), heap_.deeds[deed].time));
        see();
        carry_out(heap_.deeds[deed]);
        begin();
      }
      go_to(time);
      see();
    }
    end();
    verdict_.counters = scene_.counters();
    return verdict_;
  }

 private:
  void fault(std::string what) { verdict_.faults.push_back(fmt::format("{}, at {:.4f} s", what, scene_.time())); }

  void go_to(double time) {
    if (scene_.time() < time) {
      scene_.advance_to(time);
    }
    const SceneCounters& done = scene_.counters();
    const long long work = done.looks + 20 * done.separations + 50 * done.stretches + 3 * done.updates;
    // Of what a stone costs that does not come to rest, some times.
    const double budget = 1e6 * (0.2 + scene_.time()) * static_cast<double>(heap_.scene.stones().size());
    if (budget < static_cast<double>(work)) {
      fault(fmt::format("works too much: {} looks, {} separations, {} stretches, {} steps, {} updates", done.looks,
                        done.separations, done.stretches, done.steps, done.updates));
    }
  }

  void carry_out(const Deed& deed) {
    const bool here = scene_.has(deed.stone);
    if (!here && deed.kind != Deed::Kind::tilt) {
      return;
    }
    const bool held = here && scene_.mode(deed.stone) == StoneMode::held;
    switch (deed.kind) {
      case Deed::Kind::push:
        if (!held) {
          const Vec3<double> p = scene_.state(deed.stone).p_WB;
          scene_.apply_impulse(deed.stone, Vec3<double>(p + 0.003 * deed.w.normalized()),
                               Vec3<double>(scene_.body(deed.stone).mass * deed.v));
        }
        break;
      case Deed::Kind::hold:
        try {
          scene_.hold(deed.stone, deed.v, deed.w, deed.duration);
        } catch (const InvalidArgument&) {
          // It would be moved into the board.
        }
        break;
      case Deed::Kind::release:
        if (held) {
          scene_.release(deed.stone);
        }
        break;
      case Deed::Kind::remove:
        scene_.remove(deed.stone);
        break;
      case Deed::Kind::tilt: {
        SceneSettings<double> settings = scene_.settings();
        settings.drop.gravity = deed.v;
        scene_.change(settings);
        break;
      }
    }
  }

  /// What hands have put in, and what the others have; how much of it is told at the middles of steps.
  struct Energy {
    double held_out = 0.0, work = 0.0, loose = 0.0, size = 0.0;
  };
  [[nodiscard]] Energy energy() const {
    Energy all;
    const double g = scene_.settings().drop.gravity.norm(), h = *scene_.settings().step;
    for (const StoneId id : scene_.stones()) {
      const RigidBody<double>& body = scene_.body(id);
      all.work += scene_.work(id);
      if (scene_.mode(id) == StoneMode::held) {
        continue;
      }
      const State<double> state = scene_.state(id);
      const double w = scene_.stone(id).width;
      all.held_out += formula::energy(state, body, scene_.settings().drop.gravity);
      const Vec3<double> turn_B = formula::angular_velocity_B(state, body);
      const double speed = state.v_WB.norm() + w / 2.0 * turn_B.norm();
      all.size += body.mass * (g * state.p_WB.norm() + speed * speed);
      // A step of a contact phase may be wrong by its tolerance of m g w, a cluster's velocities are of the middles of steps.
      all.loose += 10.0 * scene_.settings().drop.tolerance * body.mass * g * w;
      if (scene_.mode(id) == StoneMode::cluster) {
        all.loose += body.mass * g * h * (speed + g * h);
      }
    }
    return all;
  }

  void begin() { last_ = energy(); }

  void see() {
    for (const StoneId id : scene_.stones()) {
      const State<double> state = scene_.state(id);
      if (!state.p_WB.allFinite() || !state.v_WB.allFinite() || !state.L_W.allFinite() ||
          !state.q_WB.coeffs().allFinite()) {
        fault(fmt::format("stone {} is not a number", static_cast<int>(id)));
        return;
      }
      if (state.p_WB.z() < scene_.board().floor) {
        fault(fmt::format("stone {} is below the floor", static_cast<int>(id)));
      }
    }
    see_depth();
    const Energy now = energy();
    const double rise = now.held_out - last_.held_out - (now.work - last_.work);
    const double allowed = now.loose + last_.loose + 0.05 * std::fabs(now.work - last_.work) + 1e-9 * now.size;
    verdict_.energy_rise = std::max(verdict_.energy_rise, rise / allowed);
    if (!(rise <= allowed)) {
      fault(fmt::format("energy rises by {:.3g} J, {:.3g} of what is allowed", rise, rise / allowed));
    }
    last_ = now;
  }

  void see_depth() {
    const std::vector<StoneId> stones = scene_.stones();
    for (std::size_t i = 0; i < stones.size(); ++i) {
      const Stone<double>& stone = scene_.stone(stones[i]);
      const State<double> one = scene_.state(stones[i]);
      const Pose<double> pose{one.p_WB, one.q_WB};
      const auto deep = [&](double gap, const std::string& in) {
        const double depth = -gap / stone.width;
        verdict_.depth = std::max(verdict_.depth, depth);
        if (!(depth <= 0.03)) {
          fault(fmt::format("stone {} is {:.3g} widths deep in {}", static_cast<int>(stones[i]), depth, in));
        }
      };
      deep(separation(stone, pose, scene_.board()).gap, "the board");
      deep(separation(stone, pose, Plane<double>{Vec3<double>::UnitZ(), scene_.board().floor}).gap, "the floor");
      for (std::size_t j = 0; j < i; ++j) {
        const State<double> two = scene_.state(stones[j]);
        const Stone<double>& other = scene_.stone(stones[j]);
        const bool both_held = scene_.mode(stones[i]) == StoneMode::held && scene_.mode(stones[j]) == StoneMode::held;
        if (!both_held && (one.p_WB - two.p_WB).norm() < (outer_width(stone) + outer_width(other)) / 2.0) {
          deep(separation(stone, pose, other, Pose<double>{two.p_WB, two.q_WB}).gap,
               fmt::format("stone {}", static_cast<int>(stones[j])));
        }
      }
    }
  }

  void end() {
    bool held = false;
    for (const StoneId id : scene_.stones()) {
      held = held || scene_.mode(id) == StoneMode::held;
    }
    if (!verdict_.faults.empty() || !heap_.ends || held) {
      return;
    }
    for (int i = 0; i < static_cast<int>(longest_end) && !verdict_.rests && verdict_.faults.empty(); ++i) {
      verdict_.rests = scene_.run_until_rest(1.0);
      go_to(scene_.time());
    }
    see();
    if (!verdict_.rests) {
      std::string moving;
      for (const StoneId id : scene_.stones()) {
        if (scene_.mode(id) != StoneMode::rest) {
          moving += fmt::format(" {} ({}, {:.2g} m/s)", static_cast<int>(id), to_string(scene_.mode(id)),
                                scene_.state(id).v_WB.norm());
        }
      }
      fault("does not come to rest:" + moving);
    }
  }

  Heap heap_;
  Board_ scene_;
  Energy last_;
  HeapVerdict verdict_;
};

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

HeapVerdict judge_heap(std::uint64_t seed, std::uint64_t index) {
  try {
    return HeapJudge(draw_heap(seed, index))();
  } catch (const std::exception& error) {
    HeapVerdict verdict;
    verdict.faults.push_back(fmt::format("throws: {}", error.what()));
    return verdict;
  }
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

HeapTally run_heaps(const Order& order, const std::function<void(std::uint64_t)>& progress,
                    const std::function<void(std::uint64_t)>& overdue) {
  HeapTally tally;
  tally.seconds = work_through(
      order, [&](std::uint64_t index) { return judge_heap(order.seed, index); },
      [&](std::uint64_t index, const HeapVerdict& verdict, double seconds) {
        ++tally.samples;
        tally.stones += verdict.stones;
        tally.refused += static_cast<std::uint64_t>(verdict.refused);
        tally.rest += verdict.rests ? 1 : 0;
        tally.counters.pair_impacts += verdict.counters.pair_impacts;
        tally.counters.steps += verdict.counters.steps;
        tally.counters.unsolved += verdict.counters.unsolved;
        tally.energy_rise = std::max(tally.energy_rise, verdict.energy_rise);
        tally.depth = std::max(tally.depth, verdict.depth);
        if (tally.slowest < seconds) {
          tally.slowest = seconds;
          tally.slowest_index = index;
        }
        if (!verdict.faults.empty()) {
          tally.failures.push_back({index, verdict.faults.front()});
        }
        progress(tally.samples);
      },
      overdue);
  std::sort(tally.failures.begin(), tally.failures.end(),
            [](const Failure& a, const Failure& b) { return a.index < b.index; });
  return tally;
}

}  // namespace goishi::verify::stress
