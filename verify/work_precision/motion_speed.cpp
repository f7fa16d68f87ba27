/// What motion costs: the exact flight one by one and in batches, and a step of each scheme.

#include <benchmark/benchmark.h>

#include <goishi/motion/batch.hpp>
#include <goishi/motion/steppers.hpp>
#include <goishi/shape/catalogue.hpp>
#include <random>
#include <string>
#include <vector>

#include "verify/samples/stone.hpp"
#include "verify/work_precision/native.hpp"

namespace {

using namespace goishi;

constexpr std::size_t count = 1024;  // a power of two; more than a branch predictor learns by heart

MassProperties<double> catalogue_stone_properties() {
  return mass_properties(make_stone<double>(catalogue_stone(33, StoneColor::white)), Density{2800.0});
}

/// Thrown at random, about 25 rad/s.
template <class T>
std::vector<State<T>> draw_states(std::size_t how_many) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const double transverse = catalogue_stone_properties().moments.transverse;
  const auto vector = [&](double size) {
    return Vec3<T>(static_cast<T>(size * normal(random)), static_cast<T>(size * normal(random)),
                   static_cast<T>(size * normal(random)));
  };
  std::vector<State<T>> states(how_many);
  for (State<T>& state : states) {
    state = {.p_WB = vector(0.1),
             .q_WB = verify::draw_attitude(random).cast<T>(),
             .v_WB = vector(1),
             .L_W = vector(15 * transverse)};
  }
  return states;
}

template <class T>
Moments<T> moments() {
  const Moments<double> exact = catalogue_stone_properties().moments;
  return {.axial = static_cast<T>(exact.axial), .transverse = static_cast<T>(exact.transverse)};
}

template <class T, class Fly>
void fly_one_by_one(benchmark::State& run, Fly&& fly) {
  const std::vector<State<T>> states = draw_states<T>(count);
  std::size_t i = 0;
  for (auto _ : run) {
    State<T> end = fly(states[i++ % count]);
    benchmark::DoNotOptimize(end);
  }
}

template <class T>
void free_flight_rates_kept(benchmark::State& run) {
  const TopRates<T> rates = make_top_rates(moments<T>());
  const Vec3<T> gravity = gravity_W<T>();
  fly_one_by_one<T>(run, [&](const State<T>& state) { return free_flight(state, rates, gravity, T(1) / T(8)); });
}
BENCHMARK(free_flight_rates_kept<double>);
BENCHMARK(free_flight_rates_kept<float>);

template <class T>
void free_flight_from_moments(benchmark::State& run) {
  const Moments<T> body = moments<T>();
  const Vec3<T> gravity = gravity_W<T>();
  fly_one_by_one<T>(run, [&](const State<T>& state) { return free_flight(state, body, gravity, T(1) / T(8)); });
}
BENCHMARK(free_flight_from_moments<double>);
BENCHMARK(free_flight_from_moments<float>);

/// Items are stones. Compiled as the rest of this program.
template <class T>
void batch(benchmark::State& run) {
  const auto states = draw_states<T>(static_cast<std::size_t>(run.range(0)));
  StoneBatch<T> stones(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    stones.set(i, states[i], moments<T>());
  }
  T time = T(1) / T(8);
  for (auto _ : run) {
    stones.fly(gravity_W<T>(), time);
    time = -time;
  }
  run.SetItemsProcessed(run.iterations() * run.range(0));
  run.SetLabel(std::to_string(StoneBatch<T>::lanes) + " lanes");
}
BENCHMARK(batch<double>)->Arg(1024)->Arg(100'000);
BENCHMARK(batch<float>)->Arg(1024)->Arg(100'000);

/// Items are stones. Compiled for what this machine's processor has.
void batch_native(benchmark::State& run) {
  if (!verify::bench::can_run_native()) {
    run.SkipWithError("this processor lacks what the batch was compiled for");
    return;
  }
  const auto states = draw_states<double>(static_cast<std::size_t>(run.range(0)));
  std::vector<double> numbers;
  std::vector<double> bodies;
  for (const auto& [p, q, v, L] : states) {
    numbers.insert(numbers.end(),
                   {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), L.x(), L.y(), L.z()});
    bodies.insert(bodies.end(), {moments<double>().axial, moments<double>().transverse});
  }
  goishi_native_flock* const flock = goishi_native_make(states.size(), numbers.data(), bodies.data());
  double time = 0.125;
  for (auto _ : run) {
    goishi_native_fly(flock, standard_gravity<double>(), time);
    time = -time;
  }
  goishi_native_free(flock);
  run.SetItemsProcessed(run.iterations() * run.range(0));
  run.SetLabel(std::to_string(goishi_native_lanes()) + " lanes");
}
BENCHMARK(batch_native)->Arg(1024)->Arg(100'000);

/// One step of 1/1024 s, in a row of them as a simulation takes them.
void one_step(benchmark::State& run, Scheme scheme) {
  const RigidBody<double> body = make_rigid_body(catalogue_stone_properties());
  const Stepper<double> stepper(scheme, body);
  const State<double> start = draw_states<double>(1).front();
  for (auto _ : run) {
    Stepped<double> end = stepper.advance(start, 1.0 / 1024, 1024);
    benchmark::DoNotOptimize(end);
  }
  run.SetItemsProcessed(run.iterations() * 1024);
}

const bool registered = [] {
  for (const SchemeInfo& one : schemes) {
    benchmark::RegisterBenchmark(("1024_steps/" + std::string(one.name)).c_str(), one_step, one.scheme);
  }
  return true;
}();

}  // namespace
