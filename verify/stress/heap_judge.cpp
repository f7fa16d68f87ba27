#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/stress/heaps.hpp"

namespace goishi::verify::stress {

namespace {

constexpr double frame = 1.0 / 60.0;
// [s] until it has to rest: a ball that has fallen 4 m rolls √(2 g 4 m) / (5/7 g/110) = 139 s.
constexpr double longest_end = 200.0;

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
  goishi::Scene<double> scene_;
  Energy last_;
  HeapVerdict verdict_;
};

}  // namespace

HeapVerdict judge_heap(std::uint64_t seed, std::uint64_t index) {
  return verdict_of<HeapVerdict>([&] { return HeapJudge(draw_heap(seed, index))(); });
}

HeapTally run_heaps(const Order& order, const std::function<void(std::uint64_t)>& progress,
                    const std::function<void(std::uint64_t)>& overdue) {
  return tally_of<HeapTally>(
      order, [&](std::uint64_t index) { return judge_heap(order.seed, index); },
      [](HeapTally& tally, std::uint64_t, const HeapVerdict& verdict, double) {
        tally.stones += verdict.stones;
        tally.refused += static_cast<std::uint64_t>(verdict.refused);
        tally.rest += verdict.rests ? 1 : 0;
        tally.counters.pair_impacts += verdict.counters.pair_impacts;
        tally.counters.steps += verdict.counters.steps;
        tally.counters.unsolved += verdict.counters.unsolved;
        tally.energy_rise = std::max(tally.energy_rise, verdict.energy_rise);
        tally.depth = std::max(tally.depth, verdict.depth);
      },
      progress, overdue);
}

}  // namespace goishi::verify::stress
