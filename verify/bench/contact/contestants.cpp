#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/published/separating_axis.hpp>
#include <limits>

#include "verify/bench/contact/contact.hpp"
#include "verify/bench/native.hpp"
#include "verify/report/number.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench::contact {

namespace {

template <class T>
double number_of(const Separation<T>& answer) {
  return answer.status == SeparationStatus::not_converged ? scalar::unset<double>() : static_cast<double>(answer.gap);
}

template <class T>
double number_of(const TimeOfImpact<T>& answer) {
  return answer.status == ImpactStatus::hit ? static_cast<double>(answer.time) : scalar::unset<double>();
}

double number_of(const PublishedSeparation<double>& answer) {
  return -answer.depth;
}

template <std::floating_point T>
double number_of(T gap) {
  return static_cast<double>(gap);
}

/// All of an answer is formed, not only the number that is judged.
template <class Ask>
Entry make_own_query(const Scene& scene, Ask ask) {
  return make_query(scene, [ask = std::move(ask)](std::size_t i) {
    const auto answer = ask(i);
    benchmark::DoNotOptimize(answer);
    return number_of(answer);
  });
}

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
Stone<T> stone_of(const Scene& scene) {
  const auto& [width, height, bevel] = scene.shape;
  return make_stone(static_cast<T>(width), static_cast<T>(height), static_cast<T>(bevel));
}

template <class T>
Entry enter(const Scene& scene, double /*no setting*/) {
  const Stone<T> stone = stone_of<T>(scene);
  const Plane<T> surface;
  switch (scene.query) {
    case Query::plane:
      return make_own_query(
          scene, [=, poses = cast<T>(scene.poses)](std::size_t i) { return separation(stone, poses[i], surface); });
    case Query::impact:
      return make_own_query(scene, [=, paths = cast<T>(scene.paths)](std::size_t i) {
        return time_of_impact(stone, paths[i], surface, T(1));
      });
    case Query::edge:
    case Query::corner:
      return make_own_query(scene, [=, board = make_board<T>(), poses = cast<T>(scene.poses)](std::size_t i) {
        return separation(stone, poses[i], board);
      });
    default:
      return make_own_query(scene, [=, poses = cast<T>(scene.poses), others = cast<T>(scene.others)](std::size_t i) {
        return separation(stone, poses[i], stone, others[i]);
      });
  }
}

/// The talk's test, with its fixed axes.
Entry enter_published(const Scene& scene, double /*no setting*/) {
  return make_own_query(scene, [&scene, stone = stone_of<double>(scene)](std::size_t i) {
    return separating_axis_published(stone, scene.poses[i], scene.board);
  });
}

Entry enter_surface(const Scene& scene, double /*no setting*/) {
  return make_own_query(scene, [&scene, stone = stone_of<double>(scene)](std::size_t i) {
    return surface_separation(stone, scene.poses[i]);
  });
}

template <class T>
Entry enter_gap(const Scene& scene, double /*no setting*/) {
  return make_own_query(scene, [stone = stone_of<T>(scene), poses = cast<T>(scene.poses)](std::size_t i) {
    return surface_gap(stone, poses[i]);
  });
}

/// The scene's stones, in a batch compiled for this machine.
Entry enter_batch(const Scene& scene, double /*no setting*/) {
  const Vec3<double> none = {0, 0, 0};
  std::vector<goishi_native_stone> numbers;
  for (const auto& [p, q] : scene.poses) {
    numbers.push_back(numbers_of(stone_of<double>(scene), {.p_WB = p, .q_WB = q, .v_WB = none, .L_W = none}));
  }
  const std::shared_ptr<goishi_native_stones> stones(goishi_native_make(numbers.size(), numbers.data()),
                                                     goishi_native_free);
  const auto gaps = std::make_shared<std::vector<double>>(numbers.size());
  return {.run = [stones, gaps](std::size_t, std::size_t) { goishi_native_gaps(stones.get(), gaps->data()); },
          .judge = [&scene, gaps] { return judge(*gaps, scene); },
          .at_once = true};
}

std::vector<Contestant<Scene>> contestants() {
  const auto at_board = [](const Scene& scene) { return scene.is_at_board(); };
  const auto at_plane = [](const Scene& scene) { return scene.query == Query::plane; };
  const auto in_batch = [=](const Scene& scene) { return at_plane(scene) && can_run_native(); };
  std::vector<Contestant<Scene>> all = {{{"double", "Goishi, double", "ours"}, enter<double>},
                                        {{"float", "Goishi, float", "ours"}, enter<float>},
                                        {{"surface", "of the surface z = const", "ours"}, enter_surface, at_plane},
                                        {{"published", "published axes", "ours"}, enter_published, at_board},
                                        {{"gap", "gap alone", "ours"}, enter_gap<double>, at_plane},
                                        {{"gap-float", "gap in float", "ours"}, enter_gap<float>, at_plane},
                                        {{"gap-batch", "gaps in a batch", "ours"}, enter_batch, in_batch}};
  for (Contestant<Scene>& other : rival_contestants()) {
    all.push_back(std::move(other));
  }
  return all;
}

std::string note_of(const Scene& scene) {
  const auto& [width, height, bevel] = scene.shape;
  return fmt::format("Over {} random poses; stone of {} × {} mm, bevel {} mm. Right answer: {}.", scene.right.size(),
                     plain_number(1e3 * width), plain_number(1e3 * height), plain_number(1e3 * bevel), scene.witness);
}

bool has_rivals() {
  return !rival_contestants().empty();
}

Race prepare(const Scene& asked, std::size_t poses) {
  const auto scene = std::make_shared<const Scene>(with_poses(asked, poses));
  Race race{.note = note_of(*scene),
            .cost = "run time of a query",
            .quantities = {{"greatest error", "m"}, {"median error", "m"}, {"unanswered", ""}},
            .others = has_rivals() ? "grey are libccd and FCL" : "",
            .cases = poses,
            .block = poses / 8};
  let_enter(race, contestants(), scene);
  return race;
}

/// Which region of the board, over it, beside it, and above.
Race prepare_region(const Effort& effort) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Board<double> board = make_board<double>();
  const double reach = outer_width(make_stone(0.022, 0.0092, 0.001)) / 2;
  std::vector<Vec3<double>> places(effort.poses);
  for (Vec3<double>& p : places) {
    p = {1.1 * board.half_width * unit(random), 1.1 * board.half_length * unit(random),
         reach * (0.75 + 1.25 * unit(random))};
  }
  const Curve curve{.who = {"region", "Goishi", "ours"}, .enter = [=](double /*no setting*/) {
                      return make_entry(
                          places.size(), [=](std::size_t i) { return region_of(board, places[i], reach); },
                          no_quantities);
                    }};
  return {.note = "Over the board, beside it, and above.",
          .cost = "run time of a query",
          .quantities = {},
          .cases = places.size(),
          .curves = {curve}};
}

}  // namespace

std::vector<double> judge(const std::vector<double>& answers, const Scene& scene) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (std::isfinite(answers[i])) {
      errors.push_back(std::fabs(answers[i] - scene.right[i]) * scene.rate[i]);
    }
  }
  return {quantile(errors, 1), quantile(errors, 0.5), static_cast<double>(answers.size() - errors.size())};
}

Subject subject() {
  constexpr ShapeSample<double> size_33{0.022, 0.0092, 0.001}, thin{0.022, 0.0022, 0.0002};
  const std::vector<Scene> scenes = {
      {"plane", "Stone and plane", Query::plane, size_33},
      {"edge", "Stone at the board's edge", Query::edge, size_33},
      {"edge-thin", "Thin stone at the board's edge", Query::edge, thin},
      {"corner", "Stone at the board's corner", Query::corner, size_33},
      {"corner-thin", "Thin stone at the board's corner", Query::corner, thin},
      {"apart", "Two stones, separated", Query::apart, size_33},
      {"apart-thin", "Two thin stones, separated", Query::apart, thin},
      {"bevels", "Two stones, overlapping by no more than the bevels", Query::bevels, size_33},
      {"cores", "Two stones, their cores overlapping", Query::cores, size_33},
      {"impact", "Time of impact with a plane", Query::impact, size_33}};
  const std::string rivals =
      "libccd and FCL are asked about the convex hull of 64 to 4096 points of the stone's surface, and libccd about "
      "the "
      "exact support function too, with falling tolerances. libccd knows no distance of bodies that are apart, so "
      "there "
      "the stone has a margin of 3 mm, which is taken off its depth. For a time of impact their gaps advance the "
      "flight, "
      "never farther than the stone could have come, to 1 µm of contact. Unanswered are those poses that a library "
      "gave "
      "up, or did not see within the margin, or to which the fixed axes have nothing to say.";
  Subject subject{.name = "contact",
                  .title = "Single queries",
                  .note =
                      "Contact: the error is that of the gap (of a time of impact: times the speed of approach), "
                      "over the same random poses near contact for all. Stars are Goishi's queries, which have no "
                      "setting, and the talk's test with its fixed axes; in float the rounding of the pose counts "
                      "too. " +
                      (has_rivals() ? rivals : "libccd and FCL were not there when this was built."),
                  .problems = {},
                  .contestants = {}};
  for (const Scene& scene : scenes) {
    subject.problems.push_back(
        {scene.name, scene.title, [scene](const Effort& effort) { return prepare(scene, effort.poses); }});
  }
  subject.problems.push_back({"region", "Region of the board", prepare_region});
  for (const Contestant<Scene>& one : contestants()) {
    subject.contestants.push_back(one.who);
  }
  return subject;
}

}  // namespace goishi::verify::bench::contact
