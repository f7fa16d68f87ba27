#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/impact/laws.hpp>

#include "verify/bench/drop/drops.hpp"
#include "verify/report/number.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify::bench::drops {

namespace {

constexpr int elastic_bounces = 10'000;

DropSettings<double> at_tolerance(double tolerance) {
  DropSettings<double> settings;
  settings.tolerance = tolerance;
  return settings;
}

std::vector<double> judge_rest(const std::vector<DropResult<double>>& ends, const std::vector<Vec3<double>>& right) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    errors.push_back((ends[i].state.p_WB - right[i]).norm());
  }
  std::vector<double> values = {quantile(errors, 0.5), quantile(errors, 0.9)};
  for (const auto count : {&DropCounters::contact_evaluations, &DropCounters::steps_accepted,
                           &DropCounters::steps_rejected, &DropCounters::impacts}) {
    values.push_back(median_of(ends, [&](const DropResult<double>& end) { return end.counters.*count; }));
  }
  values.push_back(static_cast<double>(std::count_if(
      ends.begin(), ends.end(), [](const DropResult<double>& end) { return end.status != DropStatus::rest; })));
  return values;
}

Race to_rest(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = scene->starts.size();
  std::vector<Vec3<double>> right;
  for (std::size_t i = 0; i < count; ++i) {
    right.push_back(scene->fall(i, at_tolerance(reference_tolerance)).state.p_WB);
  }
  Race race{
      .note = fmt::format(
          "{} drops. The error of the place of rest is against runs at tolerance {}. Times are over the drops, counts "
          "are medians; unanswered is what does not come to rest.",
          count, plain_number(reference_tolerance)),
      .cost = "run time of a drop",
      .quantities = {{"median error", "m"},
                     {"ninetieth percentile error", "m"},
                     {"evaluations in contact", ""},
                     {"steps", ""},
                     {"steps rejected", ""},
                     {"impacts", ""},
                     {"unanswered", ""}},
      .cases = count,
      .by_case = true};
  const std::vector<double> few = {1e-4, 1e-6, 1e-9}, all = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  race.curves = {
      {.who = {"drop", "Goishi", "ours", Kind::tolerance, effort.thorough ? all : few}, .enter = [=](double tolerance) {
         return make_entry(
             count, [=](std::size_t i) { return scene->fall(i, at_tolerance(tolerance)); },
             [right](const std::vector<DropResult<double>>& ends) { return judge_rest(ends, right); });
       }}};
  return race;
}

Race elastic(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = std::min<std::size_t>(8, scene->starts.size());
  DropSettings<double> settings;
  settings.restitution = 1.0;
  settings.friction = 0.0;
  settings.horizon = std::numeric_limits<double>::infinity();
  settings.maximum_impacts = elastic_bounces;
  settings.maximum_events = 2 * elastic_bounces;
  const auto greatest_gain = [](const std::vector<DropResult<double>>& drops) -> std::vector<double> {
    double greatest = 0;
    for (const DropResult<double>& one : drops) {
      for (const Event<double>& event : one.events) {
        greatest = std::max(greatest, std::fabs(event.energy / one.events.front().energy - 1));
      }
    }
    return {greatest};
  };
  return {.note = fmt::format("{} drops from 5 cm. The error is the greatest of the energy, over all bounces.", count),
          .cost = "run time of all bounces",
          .quantities = {{"energy error", "relative", false}},
          .cases = count,
          .by_case = true,
          .curves = {make_curve(
              count, "drop", "Goishi", [=](std::size_t i) { return scene->fall(i, settings); }, greatest_gain)}};
}

/// Contacts that approach, about which laws are asked.
struct Contacts {
  std::vector<ImpactBody<double>> bodies;
  std::vector<Vec3<double>> points;
};

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

Race impact_laws(const Effort& effort) {
  const auto contacts = std::make_shared<const Contacts>(make_contacts(*make_scene(effort)));
  const std::size_t count = contacts->bodies.size();
  constexpr double restitution = 0.5;
  const auto law_curve = [&](ImpactLaw law, double friction, const char* suffix) {
    const std::string name(to_string(law));
    const auto resolved = [contacts, law, material = make_material(restitution, friction)](std::size_t i) {
      return resolve(law, material, contacts->points[i], Vec3<double>(0.0, 0.0, 1.0), contacts->bodies[i]);
    };
    return make_curve(count, name + suffix, name + suffix, resolved, no_quantities);
  };
  return {.note = fmt::format("{} contacts in random attitude; μ = 0.3. Without friction no contact matrix is formed.",
                              count),
          .cost = "run time of an impact",
          .quantities = {},
          .cases = count,
          .block = count / 16,
          .curves = {law_curve(ImpactLaw::chatterjee_ruina, 0.3, ""),
                     law_curve(ImpactLaw::chatterjee_ruina, 0.0, " at μ = 0"), law_curve(ImpactLaw::published, 0.3, ""),
                     law_curve(ImpactLaw::stronge, 0.3, "")}};
}

}  // namespace

std::vector<Problem> whole_drops() {
  return {{"drop-to-rest", "A stone dropped from 5 cm, to rest", to_rest},
          {"drop-elastic", fmt::format("{} elastic frictionless bounces", elastic_bounces), elastic},
          {"drop-impact-law", "Impact laws", impact_laws}};
}

}  // namespace goishi::verify::bench::drops
