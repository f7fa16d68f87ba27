/// 361 stones, let go at once. What is right is the library's own, by its finest steps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>

#include "verify/bench/rivals/full_board.hpp"
#include "verify/bench/rivals/rivals.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench::rivals {

namespace {

constexpr int frames_a_second = 60, seconds = 5;

Setup setup_of(const FullBoard& full) {
  return {.stone = full.stone, .body = full.body, .starts = full.starts};
}

using States = std::vector<State<double>>;
States states_of(const World& world) {
  States states;
  for (std::size_t i = 0; i < FullBoard::lines * FullBoard::lines; ++i) {
    states.push_back(world.state(i));
  }
  return states;
}

/// What is compared, at three times.
struct Course {
  States soon, later, last;                   // at 0.1 s, at 0.2 s, after 5 s
  double all_rest = scalar::unset<double>();  // [s] from when on, to a frame
};
constexpr int soon_frame = 6, later_frame = 12;

void advance_by_frames(World& world, int frames, Course& course) {
  for (int frame = 1; frame <= frames; ++frame) {
    world.advance_to(static_cast<double>(frame) / frames_a_second);
    if (frame == soon_frame) {
      course.soon = states_of(world);
    } else if (frame == later_frame) {
      course.later = states_of(world);
    }
    bool rest = true;
    for (std::size_t i = 0; rest && i < FullBoard::lines * FullBoard::lines; ++i) {
      rest = world.rests(i);
    }
    course.all_rest = !rest                                ? scalar::unset<double>()
                      : course.all_rest == course.all_rest ? course.all_rest
                                                           : frame / 60.0;
  }
  course.last = states_of(world);
}

using Make = std::function<std::unique_ptr<World>(const Setup& setup, double step)>;

/// By the finest steps.
struct Reference {
  double step;
  Course course;
};
const Reference& reference(bool thorough) {
  const auto run = [](double step) {
    Reference made{.step = step, .course = {}};
    advance_by_frames(*make_stepped_scene(setup_of(make_full_board()), step), frames_a_second * seconds, made.course);
    return made;
  };
  if (thorough) {
    static const Reference fine = run(1.0 / 7680);
    return fine;
  }
  static const Reference rough = run(1.0 / 1920);
  return rough;
}

double median_distance(const States& states, const States& right) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < states.size(); ++i) {
    distances.push_back((states[i].p_WB - right[i].p_WB).norm());
  }
  return quantile(distances, 0.5);
}

double energy_of(const FullBoard& full, const States& states) {
  double sum = 0;
  for (const State<double>& state : states) {
    sum += formula::energy(state, full.body, gravity_W<double>());
  }
  return sum;
}

/// The deepest overlaps   [m].
struct Depths {
  double board = 0, stones = 0;
};

void look(const FullBoard& full, const States& states, Depths& deepest) {
  const auto pose = [&](std::size_t i) { return Pose<double>{states[i].p_WB, states[i].q_WB}; };
  for (std::size_t i = 0; i < states.size(); ++i) {
    deepest.board = std::max(deepest.board, -surface_gap(full.stone, pose(i), Plane<double>{}));
    for (std::size_t j = 0; j < i; ++j) {
      if ((states[i].p_WB - states[j].p_WB).norm() < full.stone.width) {
        deepest.stones = std::max(deepest.stones, -separation(full.stone, pose(i), full.stone, pose(j)).gap);
      }
    }
  }
}

/// The same run again, looked at after each of its steps, and of Goishi's also inside them.
Depths depths(const FullBoard& full, World& world, double every) {
  Depths deepest;
  for (long k = 1; static_cast<double>(k) * every < 1 + every / 2; ++k) {
    world.advance_to(static_cast<double>(k) * every);
    look(full, states_of(world), deepest);
  }
  return deepest;
}

/// A curve for everyone. `enter(make, step, every)`: who goes by steps of `step` and is looked at so often.
template <class Enter>
void add_curves(Race& race, const Effort& effort, Enter enter) {
  constexpr double inside = 1.0 / 3840;
  race.curves.push_back(
      {.who = {"goishi", "Goishi", "ours", Kind::step,
               effort.thorough ? steps_of({240, 480, 960, 1920}) : steps_of({480})},
       .enter = [=](double step) { return enter(make_stepped_scene, step, std::min(inside, step)); }});
  let_engines_enter(race, "board", effort.thorough ? steps_of({60, 240}) : steps_of({240}), enter);
}

/// The course of a whole run; what it is worth, and its deepest overlaps where they are asked for.
Entry entry_of(const std::shared_ptr<const FullBoard>& full, const Make& make, double step, int frames,
               std::function<std::vector<double>(const Course& course)> worth) {
  return make_entry(
      1,
      [=](std::size_t) {
        Course course;
        advance_by_frames(*make(setup_of(*full), step), frames, course);
        return course;
      },
      [=](const std::vector<Course>& courses) { return worth(courses.front()); });
}

Race first_second(const Effort& effort) {
  const auto full = std::make_shared<const FullBoard>(make_full_board());
  const Reference& right = reference(effort.thorough);
  Race race{.note = fmt::format(
                "The first second, where all fall, bounce and push. Errors are medians over the stones, against "
                "Goishi's steps of 1/{:.0f} s. Overlaps are of the exact stones, the deepest at the end of "
                "any step, and of Goishi every 1/3840 s.",
                1 / right.step),
            .cost = "run time of a frame of 1/60 s",
            .quantities = {{"error at 0.2 s", "m"},
                           {"error at 0.1 s", "m"},
                           {"deepest in the board", "m", false},
                           {"deepest in a stone", "m", false}}};
  add_curves(race, effort, [full, &right](const Make& make, double step, double every) {
    Entry entry = entry_of(full, make, step, frames_a_second, [=, &right](const Course& course) -> std::vector<double> {
      const auto again = make(setup_of(*full), step);
      const Depths deepest = depths(*full, *again, every);
      return {median_distance(course.later, right.course.later), median_distance(course.soon, right.course.soon),
              deepest.board, deepest.stones};
    });
    entry.items = frames_a_second;
    return entry;
  });
  return race;
}

Race to_rest(const Effort& effort) {
  const auto full = std::make_shared<const FullBoard>(make_full_board());
  const Reference& right = reference(effort.thorough);
  const double energy = energy_of(*full, right.course.last);
  Race race{
      .note =
          fmt::format("All 5 s. The error is the median over the stones of where they are then, against Goishi's "
                      "steps of 1/{:.0f} s, by which all rest from {:.2f} s on, with {:.5f} J; the energy is off by "
                      "that share of it. All rest when the engine says so; lost is whose centre is under the board's "
                      "surface.",
                      1 / right.step, right.course.all_rest, energy),
      .cost = "run time of 5 s",
      .quantities = {
          {"error at rest", "m"}, {"energy off by", "relative", false}, {"all rest after", "s", false}, {"lost", ""}}};
  add_curves(race, effort, [full, energy, &right](const Make& make, double step, double /*every*/) {
    return entry_of(full, make, step, frames_a_second * seconds,
                    [=, &right](const Course& course) -> std::vector<double> {
                      const auto lost = std::count_if(course.last.begin(), course.last.end(),
                                                      [](const State<double>& state) { return !(state.p_WB.z() > 0); });
                      return {median_distance(course.last, right.course.last),
                              energy_of(*full, course.last) / energy - 1, course.all_rest, static_cast<double>(lost)};
                    });
  });
  return race;
}

}  // namespace

std::vector<Problem> board_problems() {
  return {{"board-first-second", "361 stones on a board, the first second", first_second},
          {"board-to-rest", "361 stones on a board, to rest", to_rest}};
}

Subject subject() {
  Subject subject{
      .name = "engines",
      .title = "Beside the engines that others use",
      .note =
          "Each engine was told the same: stone, mass and moments, gravity, restitution, friction, resistance "
          "to rolling and turning; slower than 5 mm/s and 0.5 rad/s for 0.3 s it may put a stone to sleep. "
          "Times are processor time of one thread, the making of the scene included.",
      .problems = {},
      .contestants = {{"goishi", "Goishi", "ours"}},
      .all_points = true};
  for (const Engine& engine : engines()) {
    subject.note += " " + engine.given + ".";
    subject.contestants.push_back({engine.name, engine.label, "peer"});
  }
  for (const auto& problems : {single_problems(), board_problems()}) {
    subject.problems.insert(subject.problems.end(), problems.begin(), problems.end());
  }
  return subject;
}

}  // namespace goishi::verify::bench::rivals
