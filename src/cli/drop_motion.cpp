#include "drop_motion.hpp"

#include <cmath>
#include <numbers>

namespace goishi::cli {

DropSample sample_of(const DropScene& scene, double time, const State<double>& state) {
  const Vec3<double> u = formula::symmetry_axis(state.q_WB);
  return {.time = time,
          .state = state,
          .w_WB_B = formula::angular_velocity_B(state, scene.body),
          .tilt = std::atan2(std::hypot(u.x(), u.y()), u.z()) * 180 / std::numbers::pi,
          .energy = formula::energy(state, scene.body, scene.settings.gravity)};
}

Drop<double> drop_of(const DropScene& scene) {
  return scene.board ? Drop<double>(scene.stone, scene.body, scene.start, *scene.board, scene.settings)
                     : Drop<double>(scene.stone, scene.body, scene.start, scene.settings);
}

std::string_view to_string(Touched touched) {
  constexpr std::string_view names[] = {"nothing", "board", "plane", "floor"};
  return names[static_cast<std::size_t>(touched)];
}

Touched touched_at(const DropScene& scene, const Event<double>& event) {
  if (!event.contact_W.allFinite()) {
    return Touched::nothing;
  }
  if (!scene.board) {
    return Touched::plane;
  }
  const bool low = event.contact_W.z() < scene.board->floor / 2;
  return low && event.other_feature == OtherFeature::surface ? Touched::floor : Touched::board;
}

Touched touched_last(const DropScene& scene, const DropResult<double>& drop) {
  switch (drop.ground) {
    case Ground::none:
      return Touched::nothing;
    case Ground::board:
      return scene.board ? Touched::board : Touched::plane;
    case Ground::floor:
      break;
  }
  return Touched::floor;
}

std::vector<DropSample> samples_of(const DropScene& scene, const std::vector<double>& times) {
  Drop<double> drop = drop_of(scene);
  std::vector<DropSample> samples;
  samples.reserve(times.size());
  for (const double time : times) {
    do {
      drop.advance_to(time);
    } while (drop.time() < time);  // whatever stops it on its way
    samples.push_back(sample_of(scene, time, drop.state()));
  }
  return samples;
}

std::vector<DropSample> series_of(const DropScene& scene, double end, int rows) {
  std::vector<double> times(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    times[static_cast<std::size_t>(row)] = row == rows - 1 ? end : end * row / (rows - 1);
  }
  return samples_of(scene, times);
}

}  // namespace goishi::cli
