#include "compiled/scene.hpp"
#include "verify/bench/rivals/engine.hpp"
#include "verify/bench/rivals/full_board.hpp"

namespace goishi::verify::bench::rivals {

namespace {

class GoishiWorld final : public World {
 public:
  GoishiWorld(const Setup& setup, SceneSettings<double> settings) : scene_(wide_board(), filled_from(setup, settings)) {
    for (const State<double>& start : setup.starts) {
      stones_.push_back(scene_.add(setup.stone, setup.body, start));
    }
  }

  void advance_to(double time) override { scene_.advance_to(time); }
  [[nodiscard]] State<double> state(std::size_t i) const override { return scene_.state(stones_[i]); }
  [[nodiscard]] bool rests(std::size_t i) const override { return scene_.mode(stones_[i]) == StoneMode::rest; }

 private:
  [[nodiscard]] static SceneSettings<double> filled_from(const Setup& setup, SceneSettings<double> settings) {
    settings.restitution = settings.drop.restitution = setup.restitution;
    settings.friction = settings.drop.friction = setup.friction;
    settings.drop.rolling_resistance = setup.rolling_resistance;
    settings.drop.pivot_radius = setup.pivot_radius;
    settings.drop.gravity = setup.gravity;
    return settings;
  }

  Scene<double> scene_;
  std::vector<StoneId> stones_;
};

}  // namespace

std::unique_ptr<World> make_stepped_scene(const Setup& setup, double step) {
  return std::make_unique<GoishiWorld>(setup, full_board_settings(step));
}

std::unique_ptr<World> make_exact_scene(const Setup& setup, double tolerance) {
  SceneSettings<double> settings;
  settings.drop.tolerance = tolerance;
  settings.step = 1.0 / 480;  // without gravity there is nothing to take these from
  settings.impact_speed = 5e-3;
  return std::make_unique<GoishiWorld>(setup, settings);
}

}  // namespace goishi::verify::bench::rivals
