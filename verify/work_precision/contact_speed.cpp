/// What contact costs: single queries, one pose after the other.

#include <benchmark/benchmark.h>

#include <cmath>
#include <goishi/contact/batch_plane.hpp>
#include <goishi/contact/separating_axis.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <random>
#include <vector>

#include "verify/samples/stone.hpp"

namespace {

using namespace goishi;

constexpr std::size_t count = 1024;  // a power of two; more than a branch predictor learns by heart

class Random {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Quat<double> attitude() { return verify::draw_attitude(generator_); }
  Vec3<double> unit() { return (attitude() * Vec3<double>::UnitZ()).normalized(); }

 private:
  std::mt19937_64 generator_{1};
};

struct Shape {
  double width, height, bevel;
};
constexpr Shape size_33{0.022, 0.0092, 0.001};
constexpr Shape thin{0.022, 0.0022, 0.0002};

template <class T>
Stone<T> stone_of(const Shape& shape) {
  return make_stone(static_cast<T>(shape.width), static_cast<T>(shape.height), static_cast<T>(shape.bevel));
}

/// A stone that touches x with the normal n, moved out by `gap`.
Pose<double> touching(Random& random, const Stone<double>& stone, const Vec3<double>& x, const Vec3<double>& n,
                      double gap) {
  const Quat<double> q = random.attitude();
  const Vec3<double> below = q.conjugate() * Vec3<double>(-n);
  return {.p_WB = x + gap * n - q * support(stone, Vec3<double>(below.normalized())).p_B, .q_WB = q};
}

struct Poses {
  std::vector<Pose<double>> first, second;
};

/// n_x and n_y may be switched off: 1, 1 at the corner, 1, 0 at the edge, 0, 0 over the surface.
Poses at_board(const Shape& shape, double n_x, double n_y) {
  Random random;
  const Stone<double> stone = stone_of<double>(shape);
  const Board<double> board = make_board<double>();
  Poses poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3<double> n = random.unit().cwiseAbs().cwiseProduct(Vec3<double>(n_x, n_y, 1)).normalized();
    const Vec3<double> x(n_x > 0 ? board.half_width : random.uniform(-0.18, 0.18),
                         n_y > 0 ? board.half_length : random.uniform(-0.18, 0.18), 0);
    const double near = shape.height / 20;
    poses.first.push_back(touching(random, stone, x, n, random.uniform(-near, near)));
  }
  return poses;
}

/// Gaps between, in heights, less the share of the bevels.
Poses pairs(const Shape& shape, double low, double high, double bevels) {
  Random random;
  const Stone<double> stone = stone_of<double>(shape);
  Poses poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose<double> other{.p_WB = 0.01 * random.unit(), .q_WB = random.attitude()};
    const Vec3<double> n = random.unit();
    const Vec3<double> above = other.q_WB.conjugate() * n;
    const Vec3<double> x = other.p_WB + other.q_WB * support(stone, Vec3<double>(above.normalized())).p_B;
    const double gap = random.uniform(low, high) * shape.height - 2 * bevels * stone.bevel_minor_radius;
    poses.first.push_back(touching(random, stone, x, n, gap));
    poses.second.push_back(other);
  }
  return poses;
}

template <class T>
std::vector<Pose<T>> cast(const std::vector<Pose<double>>& poses) {
  std::vector<Pose<T>> result;
  for (const Pose<double>& pose : poses) {
    result.push_back({.p_WB = pose.p_WB.cast<T>(), .q_WB = pose.q_WB.cast<T>().normalized()});
  }
  return result;
}

/// Calls f on one index after the other.
template <class F>
void cycle(benchmark::State& run, F&& f) {
  std::size_t i = 0;
  for (auto _ : run) {
    auto result = f(i++ % count);
    benchmark::DoNotOptimize(result);
  }
}

template <class T>
void contact_plane(benchmark::State& run) {
  const Stone<T> stone = stone_of<T>(size_33);
  const auto poses = cast<T>(at_board(size_33, 0, 0).first);
  cycle(run, [&](std::size_t i) { return separation(stone, poses[i], Plane<T>{}); });
}
BENCHMARK(contact_plane<double>);
BENCHMARK(contact_plane<float>);

template <class T>
void contact_surface_gap(benchmark::State& run) {
  const Stone<T> stone = stone_of<T>(size_33);
  const auto poses = cast<T>(at_board(size_33, 0, 0).first);
  cycle(run, [&](std::size_t i) { return surface_gap(stone, poses[i]); });
}
BENCHMARK(contact_surface_gap<double>);
BENCHMARK(contact_surface_gap<float>);

/// Items are stones. Compiled as the rest of this program.
template <class T>
void contact_plane_batch(benchmark::State& run) {
  const Stone<T> stone = stone_of<T>(size_33);
  const auto poses = cast<T>(at_board(size_33, 0, 0).first);
  PlaneBatch<T> batch(count);
  for (std::size_t i = 0; i < count; ++i) {
    batch.set(i, stone, poses[i]);
  }
  std::vector<T> gaps(count);
  for (auto _ : run) {
    batch.gaps(Plane<T>{}, gaps);
    benchmark::DoNotOptimize(gaps.data());
    benchmark::ClobberMemory();
  }
  run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(count));
  run.SetLabel(std::to_string(PlaneBatch<T>::lanes) + " lanes");
}
BENCHMARK(contact_plane_batch<double>);
BENCHMARK(contact_plane_batch<float>);

void contact_region(benchmark::State& run) {
  Random random;
  const Board<double> board = make_board<double>();
  const double reach = outer_width(stone_of<double>(size_33)) / 2;
  std::vector<Vec3<double>> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.emplace_back(1.1 * board.half_width * random.uniform(-1, 1), 1.1 * board.half_length * random.uniform(-1, 1),
                        reach * random.uniform(-0.5, 2));
  }
  cycle(run, [&](std::size_t i) { return region_of(board, places[i], reach); });
}
BENCHMARK(contact_region);

template <class T>
void contact_board(benchmark::State& run, const Shape& shape, const Poses& drawn) {
  const Stone<T> stone = stone_of<T>(shape);
  const Board<T> board = make_board<T>();
  const auto poses = cast<T>(drawn.first);
  cycle(run, [&](std::size_t i) { return separation(stone, poses[i], board); });
}

template <class T>
void contact_pair(benchmark::State& run, const Shape& shape, const Poses& drawn) {
  const Stone<T> stone = stone_of<T>(shape);
  const auto poses = cast<T>(drawn.first), others = cast<T>(drawn.second);
  cycle(run, [&](std::size_t i) { return separation(stone, poses[i], stone, others[i]); });
}

/// The talk's test, which answers less.
void contact_published_axes(benchmark::State& run, const Shape& shape, const Poses& drawn) {
  const Stone<double> stone = stone_of<double>(shape);
  const Board<double> board = make_board<double>();
  cycle(run, [&](std::size_t i) { return separating_axis_published(stone, drawn.first[i], board); });
}

template <class T>
void contact_impact(benchmark::State& run) {
  Random random;
  std::vector<FlightPath<T>> paths;
  for (std::size_t i = 0; i < count; ++i) {
    FlightPath<T> path;
    path.p_W = Vec3<double>(0, 0, size_33.width / 2 + random.uniform(0, 0.05)).cast<T>();
    path.v_W = Vec3<double>(0, 0, random.uniform(-1, 1)).cast<T>();
    path.a_W = Vec3<double>(0, 0, -9.80665).cast<T>();
    path.u_W = random.unit().cast<T>().normalized();
    path.k_W = random.unit().cast<T>().normalized();
    path.rate = static_cast<T>(random.uniform(0, 100));
    paths.push_back(path);
  }
  const Stone<T> stone = stone_of<T>(size_33);
  cycle(run, [&](std::size_t i) { return time_of_impact(stone, paths[i], Plane<T>{}, T(1)); });
}
BENCHMARK(contact_impact<double>);
BENCHMARK(contact_impact<float>);

template <class Run>
void add(const std::string& name, Run&& run) {
  benchmark::RegisterBenchmark(("contact_" + name).c_str(), run);
}

const bool registered = [] {
  for (const auto& [shape, suffix] : {std::pair(size_33, ""), std::pair(thin, "_thin")}) {
    for (const auto& [name, poses] :
         {std::pair("edge", at_board(shape, 1, 0)), std::pair("corner", at_board(shape, 1, 1))}) {
      const std::string full = std::string(name) + suffix;
      add(full + "<double>", [=](benchmark::State& run) { contact_board<double>(run, shape, poses); });
      add(full + "<float>", [=](benchmark::State& run) { contact_board<float>(run, shape, poses); });
      add(full + "/published", [=](benchmark::State& run) { contact_published_axes(run, shape, poses); });
    }
    for (const auto& [name, poses] :
         {std::pair("apart", pairs(shape, 0, 0.05, 0)), std::pair("bevels", pairs(shape, 0, 0, 0.5)),
          std::pair("cores", pairs(shape, -0.4, 0, 1))}) {
      const std::string full = std::string(name) + suffix;
      add(full + "<double>", [=](benchmark::State& run) { contact_pair<double>(run, shape, poses); });
      add(full + "<float>", [=](benchmark::State& run) { contact_pair<float>(run, shape, poses); });
    }
  }
  return true;
}();

}  // namespace
