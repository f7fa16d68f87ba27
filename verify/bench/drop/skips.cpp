#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "verify/bench/drop/drops.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench::drops {

namespace {

using Drops = std::vector<DropResult<double>>;

/// Of what takes milliseconds.
std::size_t few(const Scene& scene) {
  return scene.starts.size() / 4;
}

std::shared_ptr<const std::vector<FlightPath<double>>> paths_of(const Scene& scene, double moved) {
  auto paths = std::make_shared<std::vector<FlightPath<double>>>();
  const Mobility<double> mobility = make_mobility(scene.mass.moments);
  for (State<double> start : scene.starts) {
    start.p_WB.x() += moved;
    paths->push_back(path_of(start, mobility, gravity_W<double>()));
  }
  return paths;
}

/// What is done comes first, what is not done after it.
Race make_race(std::string note, std::size_t cases, std::vector<Quantity> quantities, std::vector<Curve> curves) {
  return {.note = std::move(note),
          .cost = "run time",
          .quantities = std::move(quantities),
          .cases = cases,
          .curves = std::move(curves)};
}

/// Looks at the exact flight every so often until it overlaps.
double polled(const Scene& scene, const Mobility<double>& mobility, std::size_t i, double every) {
  for (double k = 0.0; k * every < 1.0; ++k) {
    const State<double> now = formula::free_flight(scene.starts[i], mobility, gravity_W<double>(), k * every);
    if (surface_gap(scene.stone, Pose<double>{now.p_WB, now.q_WB}) <= 0.0) {
      return k * every;
    }
  }
  return 1.0;
}

/// No contact code while a flight's certified root lies ahead.
Race first_touch(const Effort& effort) {
  const auto scene = make_scene(effort);
  const auto paths = paths_of(*scene, 0.0);
  const Mobility<double> mobility = make_mobility(scene->mass.moments);
  const std::size_t count = few(*scene);
  const auto root = [=](std::size_t i) { return time_of_impact(scene->stone, (*paths)[i], Plane<double>{}, 1.0); };
  std::vector<double> times, steps;
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(root(i).time);
    steps.push_back(root(i).steps);
  }
  std::vector<Curve> curves = {make_curve(count, "root", "certified root", root, [=](const auto& /*right*/) {
    return std::vector<double>{0.0, quantile(steps, 0.5)};
  })};
  for (const auto& [every, name] : {std::pair(1.0 / 60.0, "1/60 s"), {1.0 / 240.0, "1/240 s"}, {1e-5, "10 µs"}}) {
    curves.push_back(make_curve(
        count, fmt::format("polled-{:.0f}", 1 / every), fmt::format("exact flight asked for contact every {}", name),
        [=, every = every](std::size_t i) { return polled(*scene, mobility, i, every); },
        [=, every = every](const std::vector<double>& found) {
          std::vector<double> late, looks;
          for (std::size_t i = 0; i < count; ++i) {
            late.push_back(found[i] - times[i]);
            looks.push_back(std::round(found[i] / every));
          }
          return std::vector<double>{quantile(late, 0.5), quantile(looks, 0.5)};
        }));
  }
  return make_race("The median of how late it is found.", count, {{"late by", "s", false}, {"steps", ""}}, curves);
}

/// One axis in the primary region.
Race board_touch(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = scene->starts.size();
  const Board<double> board = make_board<double>();
  const auto middle = paths_of(*scene, 0.0), edge = paths_of(*scene, board.half_width);
  const auto touch = [&](const char* name, const char* label, const auto& paths, const auto& what) {
    return make_curve(
        count, name, label, [=](std::size_t i) { return time_of_impact(scene->stone, (*paths)[i], what, 1.0); },
        no_quantities);
  };
  return make_race(
      "One axis where one is enough.", count, {},
      {touch("surface", "the surface's axis alone", middle, Plane<double>{}),
       touch("board", "the whole board asked", middle, board), touch("edge", "the board, over its edge", edge, board)});
}

Race five_impacts(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = scene->starts.size();
  DropSettings<double> settings;
  settings.maximum_impacts = 5;
  const Board<double> board = make_board<double>();
  const auto normals = [](const Drops& drops) -> std::vector<double> {
    return {median_of(drops, [](const DropResult<double>& one) { return one.counters.separations; })};
  };
  const auto on_board = [&](const char* name, const char* label, double x) {
    return make_curve(
        count, name, label,
        [=](std::size_t i) {
          State<double> start = scene->starts[i];
          start.p_WB.x() += x;
          return goishi::drop(scene->stone, scene->body, start, board, settings);
        },
        normals);
  };
  return make_race(
      "The median of how many normals were asked for.", count, {{"normals", ""}},
      {make_curve(
           count, "plane", "plane", [=](std::size_t i) { return scene->fall(i, settings); }, normals),
       on_board("board", "board, in its middle", 0.0), on_board("edge", "board, over its edge", board.half_width)});
}

/// Nothing for a stone at rest.
Race woken_stone(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = few(*scene);
  std::vector<Drop<double>> rested;
  for (std::size_t i = 0; i < count; ++i) {
    rested.emplace_back(scene->stone, scene->body, scene->starts[i]);
    rested.back().advance_to_rest();
  }
  const auto greatest = [](const Drops& drops) {
    int evaluations = 0, steps = 0;
    for (const DropResult<double>& one : drops) {
      evaluations = std::max(evaluations, one.counters.contact_evaluations);
      steps = std::max(steps, one.counters.steps_accepted + one.counters.steps_rejected);
    }
    return std::vector<double>{1.0 * evaluations, 1.0 * steps};
  };
  return make_race("The greatest counts over all stones.", count, {{"evaluations in contact", ""}, {"steps", ""}},
                   {make_curve(
                        count, "woken", "at rest again",
                        [=](std::size_t i) {
                          Drop<double> again = rested[i];
                          again.change(DropSettings<double>{});
                          return followed(again);
                        },
                        greatest),
                    make_curve(
                        count, "drop", "its whole drop", [=](std::size_t i) { return scene->fall(i); }, greatest)});
}

/// Mass properties once per size.
Race made_once(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = scene->starts.size();
  DropSettings<double> settings;
  settings.maximum_impacts = 1;
  const auto every = [=](std::size_t i) {
    const Stone<double> stone = make_stone(scene->stone.width, scene->stone.height, scene->stone.bevel);
    const RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
    return goishi::drop(stone, body, scene->starts[i], settings);
  };
  return make_race("Stone and mass are made once a size.", count, {},
                   {make_curve(
                        count, "once", "stone and mass made once",
                        [=](std::size_t i) { return scene->fall(i, settings); }, no_quantities),
                    make_curve(count, "every", "made for every drop", every, no_quantities)});
}

/// Infinitely many bounces, summed.
Race flat_drop(const Effort& effort) {
  const auto scene = make_scene(effort);
  const State<double> flat{
      .p_WB = {0.0, 0.0, 0.05}, .q_WB = Quat<double>::Identity(), .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
  const auto closed_from = [&](const char* name, std::optional<double> speed) {
    DropSettings<double> settings;
    settings.closing_speed = speed ? speed : settings.closing_speed;
    const DropSettings<double> all = filled(settings, scene->stone);
    const std::string label = *all.closing_speed > 0
                                  ? fmt::format("summed from {} m/s on", plain_number(*all.closing_speed))
                                  : fmt::format("followed to {} m/s", plain_number(*all.contact_speed));
    return make_curve(
        1, name, label,
        [=](std::size_t /*the only case*/) { return goishi::drop(scene->stone, scene->body, flat, settings); },
        [](const Drops& drops) -> std::vector<double> { return {1.0 * drops.front().counters.impacts}; });
  };
  return make_race("Infinitely many bounces are a geometric series.", 1, {{"impacts", ""}},
                   {closed_from("summed", {}), closed_from("at-once", 10.0), closed_from("followed", 0.0)});
}

/// Where the time goes: until the contact lasts, and to rest.
Race until_contact(const Effort& effort) {
  const auto scene = make_scene(effort);
  const std::size_t count = few(*scene);
  std::vector<double> lasting;
  for (std::size_t i = 0; i < count; ++i) {
    const DropResult<double> whole = scene->fall(i);
    const auto contact = std::find_if(whole.events.begin(), whole.events.end(),
                                      [](const Event<double>& event) { return event.kind == EventKind::contact; });
    lasting.push_back(contact == whole.events.end() ? whole.time : contact->time);
  }
  const auto impacts = [](const Drops& drops) -> std::vector<double> {
    return {median_of(drops, [](const DropResult<double>& one) { return one.counters.impacts; })};
  };
  const auto air = [=](std::size_t i) {
    DropSettings<double> settings;
    settings.horizon = lasting[i] * (1.0 - 1e-12);
    return scene->fall(i, settings);
  };
  return make_race(
      "Medians of the impacts.", count, {{"impacts", ""}},
      {make_curve(count, "flight", "flight and impacts", air, impacts),
       make_curve(
           count, "drop", "to rest, tolerance 1e-9", [=](std::size_t i) { return scene->fall(i); }, impacts)});
}

/// Its state at times of the past, in any order and as they come.
Race any_time(const Effort& effort) {
  const auto scene = make_scene(effort);
  constexpr std::size_t count = 4096;
  DropSettings<double> settings;
  settings.tolerance = 1e-6;
  const auto motion = std::make_shared<Drop<double>>(scene->stone, scene->body, scene->starts.front(), settings);
  motion->keep_motion();
  motion->advance_to_rest();
  std::vector<double> ordered(count);
  for (std::size_t i = 0; i < count; ++i) {
    ordered[i] = motion->time() * static_cast<double>(i) / count;
  }
  std::vector<double> mixed = ordered;
  std::mt19937_64 random(3);
  std::ranges::shuffle(mixed, random);
  const auto curve = [=](const char* name, const char* label, const std::vector<double>& times) {
    return make_curve(
        count, name, label, [=](std::size_t i) { return motion->state_at(times[i]); }, no_quantities);
  };
  Race race =
      make_race(fmt::format("One drop at tolerance 1e-6, {} stretches of motion kept.", motion->kept()), count, {},
                {curve("ordered", "times as they come", ordered), curve("mixed", "times in any order", mixed)});
  race.cost = "run time of a state";
  race.block = count / 16;
  race.by_case = false;
  return race;
}

}  // namespace

std::vector<Problem> skipped_work() {
  return {{"drop-first-touch", "First touch from 5 cm", first_touch},
          {"drop-board-touch", "Touch over the middle of the board", board_touch},
          {"drop-five-impacts", "Five impacts", five_impacts},
          {"drop-woken", "A stone at rest, woken", woken_stone},
          {"drop-first-impact", "Drop to the first impact", made_once},
          {"drop-flat", "Flat drop to rest", flat_drop},
          {"drop-until-contact", "A drop, until the contact lasts", until_contact},
          {"drop-state-at", "The state of a drop at a time of its past", any_time}};
}

}  // namespace goishi::verify::bench::drops
