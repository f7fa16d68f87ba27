/// What mass properties cost. Run `goishi-bench` on a quiet machine and quote medians: --benchmark_repetitions=9. What
/// motion, contact and drops cost stands beside their errors: `goishi-verify bench`.

#include <benchmark/benchmark.h>

#include <array>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <random>
#include <vector>

namespace {

using namespace goishi;

constexpr std::size_t count = 1024;  // a power of two; more than a branch predictor learns by heart

struct Dimensions {
  double width, height, bevel;
};

const std::vector<Dimensions>& dimensions() {
  static const std::vector<Dimensions> all = [] {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Dimensions> result(count);
    for (Dimensions& one : result) {
      one.width = 0.021 + 0.002 * unit(random);
      one.height = one.width * (0.3 + 0.2 * unit(random));
      one.bevel = one.height * (0.05 + 0.2 * unit(random));
    }
    return result;
  }();
  return all;
}

template <class T, class Make>
std::vector<Stone<T>> stones(Make&& make) {
  std::vector<Stone<T>> result;
  for (const Dimensions& one : dimensions()) {
    result.push_back(make(static_cast<T>(one.width), static_cast<T>(one.height), static_cast<T>(one.bevel)));
  }
  return result;
}

/// Calls f on one item after the other.
template <class Items, class F>
void cycle(benchmark::State& state, const Items& items, F&& f) {
  std::size_t i = 0;
  for (auto _ : state) {
    auto result = f(items[i++ % count]);
    benchmark::DoNotOptimize(result);
  }
}

template <class T>
void sharp_mass_properties(benchmark::State& state) {
  cycle(state, stones<T>([](T w, T h, T) { return make_stone(w, h); }),
        [](const Stone<T>& stone) { return mass_properties(stone, Density<T>{T(2800)}); });
}
BENCHMARK(sharp_mass_properties<double>);
BENCHMARK(sharp_mass_properties<float>);

template <class T>
void bevelled_mass_properties(benchmark::State& state) {
  cycle(state, stones<T>([](T w, T h, T b) { return make_stone(w, h, b); }),
        [](const Stone<T>& stone) { return mass_properties(stone, Density<T>{T(2800)}); });
}
BENCHMARK(bevelled_mass_properties<double>);
BENCHMARK(bevelled_mass_properties<float>);

void make_sharp(benchmark::State& state) {
  cycle(state, dimensions(), [](const Dimensions& one) { return make_stone(one.width, one.height); });
}
BENCHMARK(make_sharp);

void make_bevelled(benchmark::State& state) {
  cycle(state, dimensions(), [](const Dimensions& one) { return make_stone(one.width, one.height, one.bevel); });
}
BENCHMARK(make_bevelled);

void make_measured(benchmark::State& state) {
  cycle(state, dimensions(),
        [](const Dimensions& one) { return make_measured_stone(one.width, one.height, one.bevel); });
}
BENCHMARK(make_measured);

/// What a game would write: everything in double, no wider type. Faster, and less accurate.
void sharp_formulas_in_double(benchmark::State& state) {
  cycle(state, dimensions(), [](const Dimensions& one) {
    const Moments<double> moments = formula::lens_moments(one.width, one.height);
    const Moments<double> per_mass = formula::lens_moments_per_mass(one.width, one.height);
    return std::array{formula::lens_volume(one.width, one.height),
                      formula::lens_surface_area(one.width, one.height),
                      moments.axial,
                      moments.transverse,
                      per_mass.axial,
                      per_mass.transverse};
  });
}
BENCHMARK(sharp_formulas_in_double);

void full_tensor(benchmark::State& state) {
  const MassProperties<double> body = mass_properties(make_stone(0.022, 0.0092, 0.001), Density{2800.0});
  const Quat<double> q_WB = Quat<double>(0.5, 0.5, -0.5, 0.5);
  cycle(state, dimensions(), [&](const Dimensions& one) {
    return inertia_tensor(body, q_WB, Vec3<double>(one.width, one.height, one.bevel));
  });
}
BENCHMARK(full_tensor);

}  // namespace
