#include "verify/work_precision/contact/contestant.hpp"

namespace goishi::verify::bench::contact {

namespace {

/// In float its own rounding of the pose counts too.
template <class T>
std::vector<Pose<T>> cast(const std::vector<Pose<double>>& poses) {
  std::vector<Pose<T>> result;
  for (const Pose<double>& pose : poses) {
    result.push_back({.p_WB = pose.p_WB.cast<T>(), .q_WB = pose.q_WB.cast<T>().normalized()});
  }
  return result;
}

template <class T>
std::vector<FlightPath<T>> cast(const std::vector<FlightPath<double>>& paths) {
  std::vector<FlightPath<T>> result;
  for (const FlightPath<double>& path : paths) {
    result.push_back({.p_W = path.p_W.cast<T>(),
                      .v_W = path.v_W.cast<T>(),
                      .a_W = path.a_W.cast<T>(),
                      .u_W = path.u_W.cast<T>().normalized(),
                      .k_W = path.k_W.cast<T>().normalized(),
                      .rate = static_cast<T>(path.rate)});
  }
  return result;
}

template <class T>
std::unique_ptr<Asker> enter(const Scene& scene, double /*no setting*/) {
  const ShapeSample<double>& shape = scene.problem->shape;
  const Stone<T> stone =
      make_stone(static_cast<T>(shape.width), static_cast<T>(shape.height), static_cast<T>(shape.bevel));
  const Plane<T> surface;
  switch (scene.problem->query) {
    case Query::plane:
      return make_asker(scene.size(), [=, poses = cast<T>(scene.poses)](std::size_t i) {
        return separation(stone, poses[i], surface);
      });
    case Query::impact:
      return make_asker(scene.size(), [=, paths = cast<T>(scene.paths)](std::size_t i) {
        return time_of_impact(stone, paths[i], surface, T(1));
      });
    case Query::edge:
    case Query::corner:
      return make_asker(scene.size(), [=, board = make_board<T>(), poses = cast<T>(scene.poses)](std::size_t i) {
        return separation(stone, poses[i], board);
      });
    default:
      return make_asker(scene.size(), [=, poses = cast<T>(scene.poses), others = cast<T>(scene.others)](std::size_t i) {
        return separation(stone, poses[i], stone, others[i]);
      });
  }
}

Contestant ours(const char* name, const char* label,
                std::unique_ptr<Asker> (*enter)(const Scene& scene, double setting)) {
  return {.name = name, .label = label, .ours = true, .kind = Kind::direct, .settings = {0}, .enter = enter};
}

/// The talk's test, with its fixed axes.
std::unique_ptr<Asker> enter_published(const Scene& scene, double /*no setting*/) {
  const auto& [width, height, bevel] = scene.problem->shape;
  return make_asker(scene.size(), [stone = make_stone(width, height, bevel), board = scene.board, poses = scene.poses](
                                      std::size_t i) { return separating_axis_published(stone, poses[i], board); });
}

}  // namespace

std::vector<Contestant> our_contestants() {
  Contestant published = ours("published", "published axes", enter_published);
  published.only_at_board = true;
  return {ours("double", "Goishi, double", enter<double>), ours("float", "Goishi, float", enter<float>), published};
}

}  // namespace goishi::verify::bench::contact
