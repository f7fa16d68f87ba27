#include "verify/work_precision/bench.hpp"

#include <chrono>
#include <future>

namespace goishi::verify::bench {

namespace {

/// All at once, before anything is timed: those of asymmetric bodies take a second each.
std::vector<Reference> references_of(const std::vector<const Problem*>& problems) {
  std::vector<std::future<Reference>> running;
  for (const Problem* problem : problems) {
    running.push_back(std::async(std::launch::async, [problem] { return reference_of(*problem); }));
  }
  std::vector<Reference> result;
  for (std::future<Reference>& one : running) {
    result.push_back(one.get());
  }
  return result;
}

Race run_race(const Problem& problem, const Reference& reference, const Effort& effort,
              const std::function<void()>& done) {
  std::vector<CurveMeasurement> running;
  for (const Contestant& contestant : contestants()) {
    if (contestant.can_enter(problem)) {
      running.emplace_back(contestant, problem, reference, effort);
    }
  }
  for (int i = 0; i < effort.repeats; ++i) {
    for (CurveMeasurement& one : running) {
      one.time_once();
    }
    done();
  }
  Race race{.problem = &problem, .witness = reference.source, .curves = {}};
  for (const CurveMeasurement& one : running) {
    race.curves.push_back(one.curve());
  }
  return race;
}

/// All at once, before anything is timed.
std::vector<contact::Scene> scenes_of(const std::vector<const contact::Problem*>& problems, std::size_t poses) {
  std::vector<std::future<contact::Scene>> running;
  for (const contact::Problem* problem : problems) {
    running.push_back(std::async(std::launch::async, [=] { return contact::make_scene(*problem, poses); }));
  }
  std::vector<contact::Scene> result;
  for (std::future<contact::Scene>& one : running) {
    result.push_back(one.get());
  }
  return result;
}

}  // namespace

Bench run_bench(const Programme& programme, const Effort& effort, const Stamp& stamp,
                const std::function<void(std::size_t, std::size_t)>& done) {
  const auto start = std::chrono::steady_clock::now();
  Bench bench{.stamp = stamp, .races = {}, .speed = {}, .contact_races = {}, .contact_speed = {}, .drops = {}};
  const auto& [problems, contact_problems, with_drops] = programme;
  const std::size_t total = (problems.size() + contact_problems.size()) * static_cast<std::size_t>(effort.repeats) +
                            (with_drops ? drops::rounds : 0);
  std::size_t finished = 0;
  const auto round_done = [&] { done(++finished, total); };
  done(finished, total);
  const std::vector<Reference> references = references_of(problems);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    bench.races.push_back(run_race(*problems[i], references[i], effort, round_done));
  }
  const std::vector<contact::Scene> scenes = scenes_of(contact_problems, effort.poses);
  for (const contact::Scene& scene : scenes) {
    bench.contact_races.push_back(contact::run_race(scene, effort, round_done));
  }
  bench.speed = measure_flight_speed(full_effort);
  bench.contact_speed = contact::measure_speed(full_effort);
  if (with_drops) {
    bench.drops = drops::measure(effort, round_done);
  }
  bench.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return bench;
}

}  // namespace goishi::verify::bench
