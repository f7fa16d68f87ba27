#include "verify/work_precision/drop/race.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/suite/quantile.hpp"
#include "verify/work_precision/drop/speed.hpp"

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
  for (const State<double>& start : scene.starts) {
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

/// `run(question)` says where it ends.
template <class Run>
Point point_of(double setting, const std::vector<Question>& questions, const Effort& effort, Run run) {
  std::vector<double> place, attitude;
  for (const Question& question : questions) {
    const Reached end = run(question);
    place.push_back((end.p - question.right.p_WB).norm());
    attitude.push_back(angle_between(end.q, question.right.q_WB));
  }
  const Loop loop = [&](std::size_t calls) {
    for (std::size_t call = 0; call < calls; ++call) {
      for (const Question& question : questions) {
        keep(run(question));
      }
    }
  };
  const Effort few{.batch = effort.batch, .repeats = 3, .dearest = effort.dearest, .poses = effort.poses};
  return {.setting = setting,
          .time = time_of(loop, few).per(static_cast<double>(questions.size())),
          .place = quantile(place, 0.5),
          .attitude = quantile(attitude, 0.5)};
}

Curve our_curve(const Scene& scene, const std::vector<Question>& questions, const Effort& effort) {
  Curve curve{.name = "drop", .label = "Goishi", .ours = true, .points = {}};
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    curve.points.push_back(point_of(tolerance, questions, effort, [&](const Question& question) {
      const State<double> end =
          goishi::drop(scene.stone, scene.body, question.start, settings_of(question.time, tolerance)).state;
      return Reached{end.p_WB, end.q_WB};
    }));
  }
  return curve;
}

Curve loop_curve(const Scene& scene, const std::vector<Question>& questions, PublishedTurning turning,
                 double finest_rate, const Effort& effort) {
  const bool talk = turning == PublishedTurning::velocity;
  Curve curve{.name = talk ? "published-loop" : "published-loop-momentum",
              .label = talk ? "the talk's loop" : "the loop with L kept",
              .ours = false,
              .points = {}};
  const PublishedStone stone = published_stone(scene);
  PublishedRules rules;
  rules.turning = turning;
  for (double rate = 60.0; rate <= finest_rate; rate *= 4.0) {
    curve.points.push_back(point_of(1.0 / rate, questions, effort, [&](const Question& question) {
      const double steps = std::ceil(question.time * rate);
      const PublishedState end = run_published_loop(stone, rules, published_state(question.start, scene.body),
                                                    question.time / steps, static_cast<std::int64_t>(steps))
                                     .end;
      return Reached{{end.p[0], end.p[1], end.p[2]}, {end.q[0], end.q[1], end.q[2], end.q[3]}};
    }));
  }
  return curve;
}

/// How far a point is from both errors, as a factor; at most 1: reached.
double excess(const Point& point) {
  return std::max(point.place / compared_place, point.attitude / compared_attitude);
}

}  // namespace

std::optional<Cost> cost_of(const Curve& curve) {
  const std::vector<Point>& points = curve.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (excess(points[i]) <= 1.0) {
      if (i == 0) {
        return Cost{.time = points[i].time.median};
      }
      const double part = std::log(excess(points[i - 1])) / std::log(excess(points[i - 1]) / excess(points[i]));
      const double coarse = points[i - 1].time.median;
      return Cost{.time = coarse * std::pow(points[i].time.median / coarse, part)};
    }
  }
  const Point& fine = points.back();
  const Point& coarse = points[points.size() - 2];
  const double order = std::log(excess(coarse) / excess(fine)) / std::log(coarse.setting / fine.setting);
  if (!(order > 0.5)) {
    return std::nullopt;
  }
  return Cost{.time = fine.time.median * std::pow(excess(fine), 1.0 / order), .reached = false};
}

std::vector<Race> run_races(const Scene& scene, double finest_rate, const Effort& effort) {
  struct Kind {
    std::string name, title;
    std::size_t impacts;
    double time;    // [s]
    double finest;  // [1/s]
  };
  Scene part = scene;
  part.starts.resize(part.starts.size() / 2);
  std::vector<Race> races;
  for (const Kind& kind :
       {Kind{"drop-one-impact", "One impact", 1, 1.0, finest_rate},
        Kind{"drop-two-impacts", "Two impacts", 2, 1.0, finest_rate},
        Kind{"drop-half-second", "Half a second, all bounces and contact", 0, 0.5, finest_rate / 4.0}}) {
    const std::vector<Question> questions = questions_of(part, kind.impacts, kind.time);
    if (questions.empty()) {
      continue;
    }
    std::vector<double> times;
    for (const Question& question : questions) {
      times.push_back(question.time);
    }
    races.push_back({.name = kind.name,
                     .title = kind.title,
                     .drops = questions.size(),
                     .time = quantile(times, 0.5),
                     .ours = our_curve(part, questions, effort),
                     .loops = {loop_curve(part, questions, PublishedTurning::velocity, kind.finest, effort),
                               loop_curve(part, questions, PublishedTurning::momentum, kind.finest, effort)}});
  }
  return races;
}

}  // namespace goishi::verify::bench::drops
