#include "drop_motion.hpp"

namespace goishi::cli {

Sample sample_of(const DropScene& scene, double time, const State<double>& state) {
  return sample_of(time, state, scene.solid.body, scene.settings.gravity);
}

Drop<double> drop_of(const DropScene& scene) {
  return scene.board ? Drop<double>(scene.solid.stone, scene.solid.body, scene.start, *scene.board, scene.settings)
                     : Drop<double>(scene.solid.stone, scene.solid.body, scene.start, scene.settings);
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
  return is_on_floor(*scene.board, event.contact_W, event.other_feature) ? Touched::floor : Touched::board;
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

std::vector<Sample> samples_of(const DropScene& scene, const std::vector<double>& times) {
  Drop<double> drop = drop_of(scene);
  std::vector<Sample> samples;
  samples.reserve(times.size());
  for (const double time : times) {
    do {
      drop.advance_to(time);
    } while (drop.time() < time);  // whatever stops it on its way
    samples.push_back(sample_of(scene, time, drop.state()));
  }
  return samples;
}

std::vector<Sample> series_of(const DropScene& scene, double end, int rows) {
  std::vector<double> times(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    times[static_cast<std::size_t>(row)] = row == rows - 1 ? end : end * row / (rows - 1);
  }
  return samples_of(scene, times);
}

}  // namespace goishi::cli
