#include <fmt/format.h>

#include <cmath>

#include "verify/bench/drop/drops.hpp"
#include "verify/oracles/published/loop.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bench::drops {

namespace {

PublishedStone published_stone(const Scene& scene) {
  return {.sphere_radius = scene.stone.sphere_radius,
          .sphere_offset = scene.stone.sphere_offset,
          .ring_radius = scene.stone.bevel_major_radius,
          .tube_radius = scene.stone.bevel_minor_radius,
          .axial = scene.mass.moments_per_mass.axial,
          .transverse = scene.mass.moments_per_mass.transverse};
}

PublishedState published_state(const State<double>& state, const RigidBody<double>& body) {
  const Vec3<double> w = formula::angular_velocity_W(state, body);
  const auto& [p, q, v, L] = state;
  return {.p = {p.x(), p.y(), p.z()},
          .v = {v.x(), v.y(), v.z()},
          .q = {q.w(), q.x(), q.y(), q.z()},
          .w = {w.x(), w.y(), w.z()}};
}

DropSettings<double> settings_of(double time, double tolerance) {
  DropSettings<double> settings;
  settings.law = ImpactLaw::published;
  settings.rolling_resistance = settings.pivot_radius = 0.0;
  settings.horizon = time;
  settings.tolerance = tolerance;
  return settings;
}

struct Question {
  State<double> start;
  double time;  // [s]
  State<double> right;
};

constexpr double least_between = 5e-3;  // [s] of flight, in whose middle a drop is asked for

/// Until midway between impacts `impacts` and the next, if they are far enough apart; else until `time`.
std::vector<Question> questions_of(const Scene& scene, std::size_t impacts, double time) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scene.starts.size() / 2; ++i) {
    const State<double>& start = scene.starts[i];
    double until = time;
    if (impacts > 0) {
      DropSettings<double> settings = settings_of(time, reference_tolerance);
      settings.maximum_impacts = static_cast<int>(impacts) + 1;
      const auto events = goishi::drop(scene.stone, scene.body, start, settings).events;
      if (events.size() < impacts + 2 || !(events[impacts + 1].time - events[impacts].time > least_between)) {
        continue;
      }
      until = (events[impacts].time + events[impacts + 1].time) / 2.0;
    }
    const DropSettings<double> settings = settings_of(until, reference_tolerance);
    questions.push_back({start, until, goishi::drop(scene.stone, scene.body, start, settings).state});
  }
  return questions;
}

double angle_between(const Quat<double>& a, const Quat<double>& b) {
  const Quat<double> turn = a.conjugate() * b;
  return 2.0 * std::atan2(turn.vec().norm(), std::fabs(turn.w()));
}

struct Reached {
  Vec3<double> p;
  Quat<double> q;
};

std::vector<double> judge(const std::vector<Reached>& ends, const std::vector<Question>& questions) {
  std::vector<double> place, attitude;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    place.push_back((ends[i].p - questions[i].right.p_WB).norm());
    attitude.push_back(angle_between(ends[i].q, questions[i].right.q_WB));
  }
  return {quantile(place, 0.5), quantile(attitude, 0.5)};
}

/// `run(question, setting)` says where it ends.
template <class Run>
Curve make_curve(Who who, const std::shared_ptr<const std::vector<Question>>& questions, Run run) {
  return {.who = std::move(who), .enter = [=](double setting) {
            return make_entry(
                questions->size(), [=](std::size_t i) { return run((*questions)[i], setting); },
                [questions](const std::vector<Reached>& ends) { return judge(ends, *questions); });
          }};
}

Race make_race(const Effort& effort, std::size_t impacts, double time, double finest_rate) {
  const auto scene = make_scene(effort);
  const auto questions = std::make_shared<const std::vector<Question>>(questions_of(*scene, impacts, time));
  const auto ours = [scene](const Question& question, double tolerance) {
    const State<double> end =
        goishi::drop(scene->stone, scene->body, question.start, settings_of(question.time, tolerance)).state;
    return Reached{end.p_WB, end.q_WB};
  };
  const auto loop = [scene, stone = published_stone(*scene)](PublishedTurning turning) {
    PublishedRules rules;
    rules.turning = turning;
    return [=](const Question& question, double step) {
      const double steps = std::ceil(question.time * std::round(1.0 / step));
      const PublishedState end = run_published_loop(stone, rules, published_state(question.start, scene->body),
                                                    question.time / steps, static_cast<std::int64_t>(steps))
                                     .end;
      return Reached{{end.p[0], end.p[1], end.p[2]}, {end.q[0], end.q[1], end.q[2], end.q[3]}};
    };
  };
  std::vector<double> steps;
  for (double rate = 60.0; rate <= finest_rate; rate *= 4.0) {
    steps.push_back(1.0 / rate);
  }
  return {.note = fmt::format(
              "{} drops, simulated for {:.3f} s in the median, under the same rules for both: the published law, no "
              "resistance, no damping. The talk's loop holds the angular velocity; the original program kept L. Right "
              "answer: the drop at tolerance {}, to which the loop with L kept converges.",
              questions->size(), median_of(*questions, [](const Question& question) { return question.time; }),
              plain_number(reference_tolerance)),
          .cost = "run time of a drop",
          .quantities = {{"median place error", "m"}, {"median attitude error", "rad"}},
          .others = "grey is the loop",
          .cases = questions->size(),
          .curves = {make_curve({"drop", "Goishi", "ours", Kind::tolerance, {1e-3, 1e-5, 1e-7, 1e-9}}, questions, ours),
                     make_curve({"published-loop", "the talk's loop", "published", Kind::step, steps}, questions,
                                loop(PublishedTurning::velocity)),
                     make_curve({"published-loop-momentum", "the loop with L kept", "published", Kind::step, steps},
                                questions, loop(PublishedTurning::momentum))}};
}

}  // namespace

std::vector<Problem> published_loops() {
  const auto until = [](std::size_t impacts, double time, double rate_share) {
    return [=](const Effort& effort) {
      return make_race(effort, impacts, time, rate_share * (effort.thorough ? 245760 : 15360));
    };
  };
  return {{"drop-one-impact", "One impact", until(1, 1.0, 1.0)},
          {"drop-two-impacts", "Two impacts", until(2, 1.0, 1.0)},
          {"drop-half-second", "Half a second, all bounces and contact", until(0, 0.5, 0.25)}};
}

}  // namespace goishi::verify::bench::drops
