#include <random>

#include "verify/bench/drop/drops.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify::bench::drops {

std::shared_ptr<const Scene> make_scene(const Effort& effort) {
  const std::size_t count = effort.poses / 16;
  constexpr double from = 0.05;           // [m] height of the centre
  constexpr double greatest_spin = 30.0;  // [rad/s]
  const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  const MassProperties<double> mass = mass_properties(stone, Density{2800.0});
  Scene scene{.stone = stone, .mass = mass, .body = make_rigid_body(mass), .starts = {}};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> spin(0.0, greatest_spin);
  for (std::size_t i = 0; i < count; ++i) {
    const Quat<double> q = draw_attitude(random);
    const Vec3<double> w_B = spin(random) * formula::symmetry_axis(draw_attitude(random));
    scene.starts.push_back({.p_WB = {0.0, 0.0, from},
                            .q_WB = q,
                            .v_WB = {0.0, 0.0, 0.0},
                            .L_W = formula::angular_momentum_W(q, scene.body, w_B)});
  }
  return std::make_shared<const Scene>(scene);
}

Subject subject() {
  Subject subject{
      .name = "drop",
      .title = "A stone from flight to rest, what is skipped, and the talk's loop beside it",
      .note =
          "Drops: size 33, bevel 1 mm, let go 5 cm over the plane, in random attitude with a random spin of "
          "up to 30 rad/s, under the default settings where nothing else is said.",
      .problems = {},
      .contestants = {{"drop", "Goishi", "ours"},
                      {"published-loop", "the talk's loop", "published"},
                      {"published-loop-momentum", "the loop with L kept", "published"}}};
  for (const auto& problems : {whole_drops(), skipped_work(), published_loops()}) {
    subject.problems.insert(subject.problems.end(), problems.begin(), problems.end());
  }
  return subject;
}

}  // namespace goishi::verify::bench::drops
