#pragma once
/// \file
/// One way to tell any engine of stones, and to ask it where they are: Goishi, and those that others use.

#include <algorithm>
#include <cmath>
#include <functional>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/shape/stone.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "verify/bench/race.hpp"

namespace goishi::verify::bench::rivals {

/// What is simulated: equal stones over the surface z = 0.
struct Setup {
  Stone<double> stone;  // sharp
  RigidBody<double> body;
  std::vector<State<double>> starts;
  Vec3<double> gravity = gravity_W<double>();
  double restitution = 0.3;  // of all contacts, as what follows
  double friction = 0.3;
  double rolling_resistance = 1e-4;  // [m]
  double pivot_radius = 5e-5;        // [m]
  bool may_sleep = true;             // what is slow may be taken as at rest
};

/// What engines are told that put stones to sleep which have been slow for a while.
inline constexpr double slow = 5e-3;      // [m/s]
inline constexpr double slow_turn = 0.5;  // [rad/s]
inline constexpr double seconds_to_sleep = 0.3;

/// A setup that moves.
class World {
 public:
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  virtual ~World() = default;

  /// Goes on up to a time [s], which is a multiple of the step where there is one.
  virtual void advance_to(double time) = 0;
  [[nodiscard]] virtual State<double> state(std::size_t i) const = 0;
  /// Whether the engine takes the stone as at rest.
  [[nodiscard]] virtual bool rests(std::size_t i) const = 0;
};

/// Engines have the angular velocity, in W   [rad/s].
[[nodiscard]] inline Vec3<double> turning_of(const RigidBody<double>& body, const State<double>& state) {
  const Quat<double>& q = state.q_WB;
  return q * Vec3<double>((q.conjugate() * state.L_W).cwiseQuotient(body.moments));
}
[[nodiscard]] inline State<double> state_of(const RigidBody<double>& body, const Vec3<double>& p_WB,
                                            const Quat<double>& q_WB, const Vec3<double>& v_WB,
                                            const Vec3<double>& w_WB) {
  const Quat<double> q = q_WB.normalized();
  return {.p_WB = p_WB,
          .q_WB = q,
          .v_WB = v_WB,
          .L_W = formula::angular_momentum_W<double>(q, body, Vec3<double>(q.conjugate() * w_WB))};
}

/// Goes by a fixed step.
class SteppedWorld : public World {
 public:
  explicit SteppedWorld(double step) : step_(step) {}
  void advance_to(double time) final {
    for (const long until = std::lround(time / step_); done_ < until; ++done_) {
      take_step();
    }
  }

 protected:
  [[nodiscard]] double step_size() const { return step_; }

 private:
  virtual void take_step() = 0;

  double step_;
  long done_ = 0;
};

struct Engine {
  std::string name;   // "bullet", as in the CSV file
  std::string label;  // "Bullet, support function"
  std::string given;  // a sentence: which shape, which settings of its own
  std::function<std::unique_ptr<World>(const Setup& setup, double setting)> make;
  Kind kind = Kind::step;
  std::vector<double> settings = {};       // from coarse to fine; empty: the steps that are usual in a problem
  std::vector<std::string> problems = {};  // that it can take part in; empty: all
};

/// The library's own: a scene with this step, or with this tolerance.
[[nodiscard]] std::unique_ptr<World> make_stepped_scene(const Setup& setup, double step);
[[nodiscard]] std::unique_ptr<World> make_exact_scene(const Setup& setup, double tolerance);

/// Those that were found when this was built.
[[nodiscard]] std::vector<Engine> engines();
/// A curve for each that can take part; `enter(make, setting, every)`: how often it can be looked at [s].
template <class Enter>
void let_engines_enter(Race& race, std::string_view problem, const std::vector<double>& steps, Enter enter) {
  for (const Engine& engine : engines()) {
    const std::vector<std::string>& known = engine.problems;
    if (known.empty() || std::find(known.begin(), known.end(), problem) != known.end()) {
      race.curves.push_back(
          {.who = {engine.name, engine.label, "peer", engine.kind, engine.settings.empty() ? steps : engine.settings},
           .enter = [=](double setting) {
             return enter(engine.make, setting, engine.kind == Kind::step ? setting : 1.0 / 960);
           }});
    }
  }
  race.long_runs = true;
  race.others = race.curves.size() > 1 ? "grey are other engines" : "";
}
[[nodiscard]] Engine bullet();
[[nodiscard]] Engine ode();
[[nodiscard]] Engine siconos();
[[nodiscard]] Engine simbody();

}  // namespace goishi::verify::bench::rivals
