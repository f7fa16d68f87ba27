#include "verify/work_precision/drop/skips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/impact/laws.hpp>

#include "verify/report/number.hpp"
#include "verify/suite/quantile.hpp"
#include "verify/work_precision/bar.hpp"
#include "verify/work_precision/drop/speed.hpp"

namespace goishi::verify::bench::drops {

namespace {

using Starts = std::vector<State<double>>;

/// Of what takes milliseconds.
std::size_t few(const Scene& scene) {
  return scene.starts.size() / 4;
}

struct Turns {
  Timing first, second;
};

/// Two loops by turns.
Turns by_turns(const Loop& first, const Loop& second, const Effort& effort) {
  const Batch first_batch = make_batch(first, effort.batch), second_batch = make_batch(second, effort.batch);
  std::vector<double> first_each, second_each;
  for (int i = 0; i < effort.repeats; ++i) {
    first_each.push_back(time_batch(first, first_batch));
    second_each.push_back(time_batch(second, second_batch));
  }
  return {summary(std::move(first_each)), summary(std::move(second_each))};
}

/// Every call does all of so many.
template <class One>
Loop all_of(std::size_t count, One one) {
  return [=](std::size_t calls) {
    for (std::size_t call = 0; call < calls; ++call) {
      for (std::size_t i = 0; i < count; ++i) {
        keep(one(i));
      }
    }
  };
}

Skip skip_of(std::string name, std::string ours, std::string instead, const Turns& times, std::size_t count) {
  const auto each = static_cast<double>(count);
  return {.name = std::move(name),
          .ours = std::move(ours),
          .instead = std::move(instead),
          .time = times.first.per(each),
          .time_instead = times.second.per(each)};
}

std::vector<FlightPath<double>> paths_of(const Scene& scene, const Vec3<double>& moved) {
  std::vector<FlightPath<double>> paths;
  const TopRates<double> rates = make_top_rates(scene.mass.moments);
  for (State<double> start : scene.starts) {
    start.p_WB += moved;
    paths.push_back(path_of(start, rates, gravity_W<double>()));
  }
  return paths;
}

// --- no contact code while a flight's certified root lies ahead

/// The exact flight, looked at every so often until it overlaps.
double polled(const Scene& scene, const TopRates<double>& rates, std::size_t i, double every) {
  for (double k = 0.0; k * every < 1.0; ++k) {
    const State<double> now = formula::free_flight(scene.starts[i], rates, gravity_W<double>(), k * every);
    if (surface_gap(scene.stone, Pose<double>{now.p_WB, now.q_WB}) <= 0.0) {
      return k * every;
    }
  }
  return 1.0;
}

void add_polling(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const std::vector<FlightPath<double>> paths = paths_of(scene, {0.0, 0.0, 0.0});
  const TopRates<double> rates = make_top_rates(scene.mass.moments);
  const std::size_t count = few(scene);
  const auto root = [&](std::size_t i) { return time_of_impact(scene.stone, paths[i], Plane<double>{}, 1.0); };
  std::vector<double> steps;
  for (std::size_t i = 0; i < count; ++i) {
    steps.push_back(root(i).steps);
  }
  for (const auto& [every, name] :
       {std::pair(1.0 / 60.0, "1/60 s"), std::pair(1.0 / 240.0, "1/240 s"), std::pair(1e-5, "10 µs")}) {
    std::vector<double> late;
    for (std::size_t i = 0; i < count; ++i) {
      late.push_back(polled(scene, rates, i, every) - root(i).time);
    }
    skips.push_back(skip_of(
        "first touch from 5 cm", fmt::format("certified root, {:.0f} steps", quantile(steps, 0.5)),
        fmt::format("exact flight asked for contact every {}, late by {}", name, duration(quantile(late, 0.5))),
        by_turns(all_of(count, root),
                 all_of(count, [&, every = every](std::size_t i) { return polled(scene, rates, i, every); }), effort),
        count));
  }
}

// --- one axis in the primary region

void add_board(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const Board<double> board = make_board<double>();
  const std::size_t count = scene.starts.size();
  const auto middle = paths_of(scene, {0.0, 0.0, 0.0});
  const auto edge = paths_of(scene, {board.half_width, 0.0, 0.0});
  const auto on_plane =
      all_of(count, [&](std::size_t i) { return time_of_impact(scene.stone, middle[i], Plane<double>{}, 1.0); });
  const auto on_board = [&](const std::vector<FlightPath<double>>& paths) {
    return all_of(count, [&](std::size_t i) { return time_of_impact(scene.stone, paths[i], board, 1.0); });
  };
  skips.push_back(skip_of("touch over the middle of the board", "the surface's axis alone", "the whole board asked",
                          by_turns(on_plane, on_board(middle), effort), count));
  skips.push_back(skip_of("touch over the middle of the board", "the surface's axis alone", "the board, over its edge",
                          by_turns(on_plane, on_board(edge), effort), count));
  DropSettings<double> settings;
  settings.maximum_impacts = 5;
  struct Counted {
    Loop loop;
    double separations;
  };
  const auto five_impacts = [&](const Vec3<double>& moved, bool with_board) {
    const auto one = [&scene, &board, settings, moved, with_board](std::size_t i) {
      State<double> start = scene.starts[i];
      start.p_WB += moved;
      return with_board ? goishi::drop(scene.stone, scene.body, start, board, settings)
                        : goishi::drop(scene.stone, scene.body, start, settings);
    };
    std::vector<double> separations;
    for (std::size_t i = 0; i < count; ++i) {
      separations.push_back(one(i).counters.separations);
    }
    return Counted{all_of(count, one), quantile(separations, 0.5)};
  };
  const Counted plane = five_impacts({0.0, 0.0, 0.0}, false);
  for (const auto& [where, x] : {std::pair("in its middle", 0.0), std::pair("over its edge", board.half_width)}) {
    const Counted other = five_impacts({x, 0.0, 0.0}, true);
    skips.push_back(skip_of("five impacts", fmt::format("plane: {:.0f} normals", plane.separations),
                            fmt::format("board, {}: {:.0f} normals", where, other.separations),
                            by_turns(plane.loop, other.loop, effort), count));
  }
}

// --- no friction code when μ = 0

void add_friction(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const Contacts contacts = make_contacts(scene);
  skips.push_back(skip_of("an impact at μ = 0", "no contact matrix", fmt::format("μ = {}", impact_friction),
                          by_turns(impacts(contacts, ImpactLaw::chatterjee_ruina, 0.0),
                                   impacts(contacts, ImpactLaw::chatterjee_ruina, impact_friction), effort),
                          1));
}

// --- nothing for a stone at rest

void add_rest(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const std::size_t count = few(scene);
  const DropSettings<double> settings;
  std::vector<Drop<double>> rested;
  int evaluations = 0, steps = 0;
  for (std::size_t i = 0; i < count; ++i) {
    rested.push_back(goishi::drop(scene.stone, scene.body, scene.starts[i], settings));
    const DropCounters again = woken<double>(rested[i], scene.stone, scene.body, nullptr, settings).counters;
    evaluations = std::max(evaluations, again.contact_evaluations);
    steps = std::max(steps, again.steps_accepted + again.steps_rejected);
  }
  const auto wake = [&](std::size_t i) { return woken<double>(rested[i], scene.stone, scene.body, nullptr, settings); };
  const auto fall = [&](std::size_t i) { return goishi::drop(scene.stone, scene.body, scene.starts[i], settings); };
  skips.push_back(skip_of("a stone at rest, woken",
                          fmt::format("at rest again: {} steps, {} evaluations at most", steps, evaluations),
                          "its whole drop", by_turns(all_of(count, wake), all_of(count, fall), effort), count));
}

// --- mass properties once per size

void add_mass(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const std::size_t count = scene.starts.size();
  DropSettings<double> settings;
  settings.maximum_impacts = 1;
  const auto once = [&](std::size_t i) { return goishi::drop(scene.stone, scene.body, scene.starts[i], settings); };
  const auto every = [&](std::size_t i) {
    const Stone<double> stone = make_stone(scene.stone.width, scene.stone.height, scene.stone.bevel);
    const RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
    return goishi::drop(stone, body, scene.starts[i], settings);
  };
  skips.push_back(skip_of("drop to the first impact", "stone and mass made once", "made for every drop",
                          by_turns(all_of(count, once), all_of(count, every), effort), count));
}

// --- infinitely many bounces, summed

void add_closing(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const State<double> flat{
      .p_WB = {0.0, 0.0, 0.05}, .q_WB = Quat<double>::Identity(), .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
  DropSettings<double> followed, summed, at_once;
  followed.closing_speed = 0.0;
  at_once.closing_speed = 10.0;
  const auto loop = [&](const DropSettings<double>& settings) {
    return all_of(1, [&](std::size_t) { return goishi::drop(scene.stone, scene.body, flat, settings); });
  };
  const auto bounces = [&](const DropSettings<double>& settings) {
    return goishi::drop(scene.stone, scene.body, flat, settings).counters.impacts;
  };
  for (const DropSettings<double>* settings : {&summed, &at_once}) {
    skips.push_back(
        skip_of("flat drop to rest",
                fmt::format("summed from {} m/s on: {} impacts",
                            plain_number(*filled(*settings, scene.stone).closing_speed), bounces(*settings)),
                fmt::format("followed to {} m/s: {} impacts",
                            plain_number(*filled(followed, scene.stone).contact_speed), bounces(followed)),
                by_turns(loop(*settings), loop(followed), effort), 1));
  }
}

// --- where the time goes

/// Until the contact lasts, and to rest.
void add_share(const Scene& scene, const Effort& effort, std::vector<Skip>& skips) {
  const std::size_t count = few(scene);
  std::vector<double> lasting, impacts_until;
  for (std::size_t i = 0; i < count; ++i) {
    const Drop<double> whole = goishi::drop(scene.stone, scene.body, scene.starts[i]);
    const auto contact = std::find_if(whole.events.begin(), whole.events.end(),
                                      [](const Event<double>& event) { return event.kind == EventKind::contact; });
    lasting.push_back(contact == whole.events.end() ? whole.time : contact->time);
    impacts_until.push_back(static_cast<double>(std::count_if(
        whole.events.begin(), contact, [](const Event<double>& event) { return event.kind == EventKind::impact; })));
  }
  const auto air = [&](std::size_t i) {
    DropSettings<double> settings;
    settings.horizon = lasting[i] * (1.0 - 1e-12);
    return goishi::drop(scene.stone, scene.body, scene.starts[i], settings);
  };
  const auto whole = [&](std::size_t i) { return goishi::drop(scene.stone, scene.body, scene.starts[i]); };
  skips.push_back(
      skip_of("a drop, until the contact lasts", fmt::format("flight and {:.0f} impacts", quantile(impacts_until, 0.5)),
              "to rest, tolerance 1e-9", by_turns(all_of(count, air), all_of(count, whole), effort), count));
}

}  // namespace

std::vector<Skip> measure_skips(const Scene& scene, const Effort& effort) {
  std::vector<Skip> skips;
  add_polling(scene, effort, skips);
  add_board(scene, effort, skips);
  add_friction(scene, effort, skips);
  add_rest(scene, effort, skips);
  add_mass(scene, effort, skips);
  add_closing(scene, effort, skips);
  add_share(scene, effort, skips);
  return skips;
}

}  // namespace goishi::verify::bench::drops
