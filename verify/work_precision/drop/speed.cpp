#include "verify/work_precision/drop/speed.hpp"

#include <algorithm>
#include <cmath>
#include <goishi/impact/laws.hpp>

#include "verify/samples/stone.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench::drops {

namespace {

Drop<double> fall(const Scene& scene, std::size_t i, double tolerance) {
  DropSettings<double> settings;
  settings.tolerance = tolerance;
  return goishi::drop(scene.stone, scene.body, scene.starts[i], settings);
}

std::vector<Vec3<double>> places_of_rest(const Scene& scene) {
  std::vector<Vec3<double>> places;
  for (std::size_t i = 0; i < scene.starts.size(); ++i) {
    places.push_back(fall(scene, i, reference_tolerance).state.p_WB);
  }
  return places;
}

int median_of(const std::vector<DropCounters>& all, int DropCounters::*count) {
  std::vector<double> values;
  for (const DropCounters& one : all) {
    values.push_back(one.*count);
  }
  return static_cast<int>(std::lround(quantile(values, 0.5)));
}

DropCounters medians(const std::vector<DropCounters>& all) {
  DropCounters result;
  for (const auto count : {&DropCounters::impacts, &DropCounters::root_steps, &DropCounters::separations,
                           &DropCounters::contact_evaluations, &DropCounters::steps_accepted,
                           &DropCounters::steps_rejected, &DropCounters::steps_located}) {
    result.*count = median_of(all, count);
  }
  return result;
}

/// All tolerances take turns, drop by drop.
std::vector<Level> measure_levels(const Scene& scene, const std::vector<double>& tolerances, int repeats) {
  const std::vector<Vec3<double>> right = places_of_rest(scene);
  const std::size_t drops = scene.starts.size();
  std::vector<std::vector<double>> times(tolerances.size()), errors(tolerances.size());
  std::vector<std::vector<DropCounters>> counters(tolerances.size());
  std::vector<Level> levels(tolerances.size());
  for (std::size_t i = 0; i < drops; ++i) {
    for (std::size_t k = 0; k < tolerances.size(); ++k) {
      Drop<double> dropped;
      std::vector<double> each;
      for (int repeat = 0; repeat < repeats; ++repeat) {
        each.push_back(time_batch([&](std::size_t) { dropped = fall(scene, i, tolerances[k]); }, {.calls = 1}));
      }
      times[k].push_back(quantile(each, 0.5));
      errors[k].push_back((dropped.state.p_WB - right[i]).norm());
      counters[k].push_back(dropped.counters);
      levels[k].not_at_rest += dropped.status == DropStatus::rest ? 0 : 1;
    }
  }
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    Level& level = levels[k];
    level.tolerance = tolerances[k];
    level.time = summary(times[k]);
    level.late = quantile(times[k], 0.9);
    level.error = quantile(errors[k], 0.5);
    level.late_error = quantile(errors[k], 0.9);
    level.counters = medians(counters[k]);
  }
  return levels;
}

/// Frictionless; by the energy of the events the greatest error.
void measure_elastic(const Scene& scene, int repeats, Speed& speed) {
  DropSettings<double> settings;
  settings.restitution = 1.0;
  settings.friction = 0.0;
  settings.horizon = std::numeric_limits<double>::infinity();
  settings.maximum_impacts = elastic_bounces;
  settings.maximum_events = 2 * elastic_bounces;
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min<std::size_t>(8, scene.starts.size()); ++i) {
    Drop<double> dropped;
    std::vector<double> each;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      each.push_back(
          time_batch([&](std::size_t) { dropped = goishi::drop(scene.stone, scene.body, scene.starts[i], settings); },
                     {.calls = 1}));
    }
    times.push_back(quantile(each, 0.5));
    const double start = dropped.events.front().energy;
    for (const Event<double>& event : dropped.events) {
      speed.energy_error = std::max(speed.energy_error, std::fabs(event.energy / start - 1.0));
    }
  }
  speed.elastic = summary(times);
}

}  // namespace

Contacts make_contacts(const Scene& scene) {
  constexpr std::size_t count = 1024;
  const Mobility<double> mobility = make_mobility(scene.mass);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Contacts contacts;
  while (contacts.bodies.size() < count) {
    const Quat<double> q = draw_attitude(random);
    const Vec3<double> down = q.conjugate() * Vec3<double>(0.0, 0.0, -1.0);
    const Vec3<double> r = q * support(scene.stone, Vec3<double>(down.normalized())).p_B;
    const Vec3<double> w_B = 30.0 * unit(random) * formula::symmetry_axis(draw_attitude(random));
    const ImpactBody<double> body{.mobility = mobility,
                                  .p_WB = {0.0, 0.0, -r.z()},
                                  .u_W = formula::symmetry_axis(q),
                                  .v_WB = {unit(random), unit(random), -1.0},
                                  .L_W = formula::angular_momentum_W(q, scene.body, w_B)};
    if (formula::point_velocity(body, r).z() < 0.0) {
      contacts.bodies.push_back(body);
      contacts.points.push_back(body.p_WB + r);
    }
  }
  return contacts;
}

Loop impacts(const Contacts& contacts, ImpactLaw law, double friction) {
  return [&contacts, law, material = make_material(impact_restitution, friction)](std::size_t calls) {
    const Vec3<double> up(0.0, 0.0, 1.0);
    const std::size_t mask = contacts.bodies.size() - 1;
    for (std::size_t i = 0; i < calls; ++i) {
      keep(resolve(law, material, contacts.points[i & mask], up, contacts.bodies[i & mask]));
    }
  };
}

Speed measure_speed(const Scene& scene, const std::vector<double>& tolerances, int repeats, const Effort& effort) {
  Speed speed;
  speed.drops = scene.starts.size();
  speed.levels = measure_levels(scene, tolerances, repeats);
  measure_elastic(scene, repeats, speed);
  const Contacts contacts = make_contacts(scene);
  for (const ImpactLaw law : {ImpactLaw::chatterjee_ruina, ImpactLaw::published, ImpactLaw::stronge}) {
    speed.laws.push_back(
        {.name = std::string(to_string(law)), .time = time_of(impacts(contacts, law, impact_friction), effort)});
  }
  return speed;
}

}  // namespace goishi::verify::bench::drops
