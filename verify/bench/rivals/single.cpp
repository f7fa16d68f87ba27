/// Problems of one stone. What is right is known exactly, but for the place of rest.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/motion/free_flight.hpp>
#include <numbers>
#include <random>

#include "verify/bench/rivals/full_board.hpp"
#include "verify/bench/rivals/rivals.hpp"
#include "verify/samples/stone.hpp"
#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench::rivals {

namespace {

constexpr double frame = 1.0 / 60;

/// States at equal times, the first that of the start.
struct Seen {
  double every = 0;  // [s]
  std::vector<State<double>> states;
  bool rests = false;
};

struct Experiment {
  std::string name;
  Race race;  // without curves
  std::vector<Setup> cases;
  double duration;                                                            // [s]
  bool watched = false;                                                       // seen at every step, not only at the end
  std::vector<double> tolerances = {};                                        // of Goishi; empty: it has no setting
  std::function<std::vector<double>(std::size_t i, const Seen& seen)> worth;  // the errors of a case
};

Seen observe(World& world, double duration, double every) {
  Seen seen{.every = every, .states = {world.state(0)}};
  const long count = std::lround(duration / every);
  for (long k = 1; k <= count; ++k) {
    world.advance_to(static_cast<double>(k) * duration / static_cast<double>(count));
    seen.states.push_back(world.state(0));
  }
  seen.rests = world.rests(0);
  return seen;
}

/// The median over the cases, of each quantity.
std::vector<double> judge(const Experiment& experiment, const std::vector<Seen>& all) {
  std::vector<std::vector<double>> by_quantity(experiment.race.quantities.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<double> values = experiment.worth(i, all[i]);
    for (std::size_t k = 0; k < by_quantity.size(); ++k) {
      by_quantity[k].push_back(values[k]);
    }
  }
  std::vector<double> medians;
  for (const std::vector<double>& values : by_quantity) {
    medians.push_back(quantile(values, 0.5));
  }
  return medians;
}

Race race_of(Experiment made, const Effort& effort) {
  const auto experiment = std::make_shared<const Experiment>(std::move(made));
  Race race = experiment->race;
  race.cases = experiment->cases.size();
  race.by_case = true;
  const auto enter = [experiment](auto make, double every) {
    return make_entry(
        experiment->cases.size(),
        [=](std::size_t i) {
          return observe(*make(experiment->cases[i]), experiment->duration,
                         experiment->watched ? every : experiment->duration);
        },
        [experiment](const std::vector<Seen>& all) { return judge(*experiment, all); });
  };
  const bool direct = experiment->tolerances.empty();
  constexpr double usual_tolerance = 1e-9;
  race.curves.push_back({.who = {"goishi", "Goishi", "ours", direct ? Kind::direct : Kind::tolerance,
                                 direct ? std::vector<double>{0} : experiment->tolerances},
                         .enter = [=](double setting) {
                           const double tolerance = direct ? usual_tolerance : setting;
                           return enter([=](const Setup& setup) { return make_exact_scene(setup, tolerance); },
                                        frame / 16);
                         }});
  let_engines_enter(race, experiment->name, effort.thorough ? steps_of({60, 240, 960, 3840}) : steps_of({60, 240}),
                    [=](const auto& make, double setting, double every) {
                      return enter([=](const Setup& setup) { return make(setup, setting); }, every);
                    });
  return race;
}

Setup bare_setup() {
  const FullBoard board = make_full_board();
  return {.stone = board.stone, .body = board.body, .starts = {}};
}

State<double> start_at(const Setup& setup, double height, const Quat<double>& q, const Vec3<double>& w_B) {
  return {.p_WB = {0, 0, height},
          .q_WB = q,
          .v_WB = {0, 0, 0},
          .L_W = formula::angular_momentum_W<double>(q, setup.body, w_B)};
}

double energy_of(const Setup& setup, const State<double>& state) {
  return formula::energy(state, setup.body, setup.gravity);
}

// --- free spin

Race spin(const Effort& effort) {
  constexpr double duration = 10, spin_rate = 25;
  Setup setup = bare_setup();
  setup.gravity = {0, 0, 0};
  setup.may_sleep = false;
  Experiment experiment{
      .name = "engine-spin",
      .race = {.note = "Size 33, sharp, at 25 rad/s about an axis 60° from its own, in free space. The "
                       "exact answer is two rotations.",
               .cost = "run time of 10 s",
               .quantities = {{"attitude error", "rad"}, {"energy error", "relative"}, {"error of |L|", "relative"}}},
      .cases = {},
      .duration = duration,
      .worth = {}};
  const Vec3<double> axis_B(std::sqrt(3.0) / 2, 0, 0.5);
  setup.starts = {start_at(setup, 1, Quat<double>::Identity(), spin_rate * axis_B)};
  experiment.cases = {setup};
  const Mobility<double> mobility =
      make_mobility(Moments<double>{.axial = setup.body.moments.z(), .transverse = setup.body.moments.x()});
  const State<double> right = free_flight(setup.starts.front(), mobility, setup.gravity, duration);
  experiment.worth = [=](std::size_t, const Seen& seen) -> std::vector<double> {
    const State<double>&first = setup.starts.front(), &last = seen.states.back();
    return {last.q_WB.angularDistance(right.q_WB), std::fabs(energy_of(setup, last) / energy_of(setup, first) - 1),
            std::fabs(last.L_W.norm() / first.L_W.norm() - 1)};
  };
  return race_of(std::move(experiment), effort);
}

// --- elastic bounces

Race bounce(const Effort& effort) {
  Experiment experiment{
      .name = "engine-bounce",
      .race = {.note = "Let go at 5 cm in 8 attitudes, e = 1, no friction, for 2 s. No energy is lost in truth.",
               .cost = "run time of 2 s",
               .quantities = {{"energy error", "relative"}}},
      .cases = {},
      .duration = 2,
      .worth = {}};
  std::mt19937_64 random(1);
  for (int i = 0; i < 8; ++i) {
    Setup setup = bare_setup();
    setup.restitution = 1;
    setup.friction = setup.rolling_resistance = setup.pivot_radius = 0;
    setup.may_sleep = false;
    setup.starts = {start_at(setup, 0.05, draw_attitude(random), {0, 0, 0})};
    experiment.cases.push_back(setup);
  }
  experiment.worth = [cases = experiment.cases](std::size_t i, const Seen& seen) -> std::vector<double> {
    return {std::fabs(energy_of(cases[i], seen.states.back()) / energy_of(cases[i], cases[i].starts.front()) - 1)};
  };
  return race_of(std::move(experiment), effort);
}

// --- rocking

constexpr double rocking_tilt = std::numbers::pi / 90;  // 2°

/// Rolling on the cap without slip from `rocking_tilt`: θ'² = 2 m g d (cos θ − cos θ₀)/(I_t + m (r² − 2 r d cos θ + d²)),
/// with sin(θ/2) = sin(θ₀/2) sin φ; equal weights at equal φ are exact to round-off for what is periodic.
double rocking_period(const Setup& setup) {
  const double m = setup.body.mass, r = setup.stone.sphere_radius, d = setup.stone.sphere_offset;
  const double g = -setup.gravity.z(), k = std::sin(rocking_tilt / 2);
  constexpr int points = 64;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double s = k * std::sin(2 * std::numbers::pi * i / points);
    const double inertia = setup.body.moments.x() + m * (r * r - 2 * r * d * (1 - 2 * s * s) + d * d);
    sum += std::sqrt(inertia / (m * g * d * (1 - s * s)));
  }
  return 2 * std::numbers::pi * sum / points;
}

/// Where a stone that rocks about Wy is: u_x, and its rate.
struct Lean {
  double value, rate;
};
Lean lean_of(const Setup& setup, const State<double>& state) {
  const Vec3<double> u = formula::symmetry_axis(state.q_WB);
  return {.value = u.x(), .rate = turning_of(setup.body, state).cross(u).x()};
}

/// Between two samples, by the cubic through values and rates; x from 0 to 1.
double between(const Lean& a, const Lean& b, double every, double x) {
  const double y = 1 - x;
  return (1 + 2 * x) * y * y * a.value + x * y * y * every * a.rate + (3 - 2 * x) * x * x * b.value -
         x * x * y * every * b.rate;
}

std::vector<double> rocking_worth(const Setup& setup, const Seen& seen) {
  std::vector<double> falls, tops;  // where the lean falls through 0, and its greatest in each period
  for (std::size_t k = 0; k + 1 < seen.states.size(); ++k) {
    const Lean a = lean_of(setup, seen.states[k]), b = lean_of(setup, seen.states[k + 1]);
    if (a.value > 0 && b.value <= 0) {
      double low = 0, high = 1;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (between(a, b, seen.every, middle) > 0 ? low : high) = middle;
      }
      falls.push_back(seen.every * (static_cast<double>(k) + low));
    }
    if (k > 0 && a.rate > 0 && b.rate <= 0) {
      tops.push_back(between(a, b, seen.every, a.rate / (a.rate - b.rate)));
    }
  }
  if (falls.size() < 3 || tops.empty()) {
    return {scalar::unset<double>(), scalar::unset<double>()};
  }
  const double period = (falls.back() - falls.front()) / static_cast<double>(falls.size() - 1);
  return {std::fabs(period / rocking_period(setup) - 1), std::fabs(tops.back() / std::sin(rocking_tilt) - 1)};
}

Race rocking(const Effort& effort) {
  Setup setup = bare_setup();
  setup.restitution = setup.rolling_resistance = setup.pivot_radius = 0;
  setup.friction = 1;
  setup.may_sleep = false;
  const Quat<double> q(std::cos(rocking_tilt / 2), 0, std::sin(rocking_tilt / 2), 0);
  const double height = setup.stone.sphere_radius - setup.stone.sphere_offset * std::cos(rocking_tilt);
  setup.starts = {start_at(setup, height, q, {0, 0, 0})};
  Experiment experiment{
      .name = "engine-rocking",
      .race = {.note =
                   "On its cap, let go at a tilt of 2°, rolling without slip or loss: the mean period in 1.3 s, and "
                   "how high the last swing is; the period is known as an integral. An engine whose stone does not "
                   "swing has no answer.",
               .cost = "run time of 1.3 s",
               .quantities = {{"period error", "relative"}, {"amplitude error", "relative"}}},
      .cases = {setup},
      .duration = 1.3,
      .watched = true,
      .tolerances = effort.thorough ? std::vector{1e-4, 1e-6, 1e-9} : std::vector{1e-6},
      .worth = [=](std::size_t, const Seen& seen) { return rocking_worth(setup, seen); }};
  return race_of(std::move(experiment), effort);
}

// --- one impact

constexpr double impact_end = 2 * frame;

/// A stone that meets the plane while it slides along x, and turns about y alone: then all laws of restitution agree.
struct Slide {
  Setup setup;
  State<double> right;  // at the end
};

/// Nothing where it would stick, or touch a second time before the end.
std::optional<Slide> slide(double tilt, double speed) {
  Setup setup = bare_setup();
  setup.gravity = {0, 0, 0};
  setup.restitution = 0.8;
  setup.rolling_resistance = setup.pivot_radius = 0;
  setup.may_sleep = false;
  const Quat<double> q(std::cos(tilt / 2), 0, std::sin(tilt / 2), 0);
  constexpr double fall = frame / 2;  // [m] at 1 m/s
  const double reach = setup.stone.sphere_radius - setup.stone.sphere_offset * std::cos(tilt);
  State<double> start = start_at(setup, reach + fall, q, {0, 0, 0});
  start.v_WB = {speed, 0, -1};
  setup.starts = {start};
  // The contact, from the centre: under the middle of the cap's sphere.
  const double m = setup.body.mass, I = setup.body.moments.x(), mu = setup.friction;
  const double x = setup.stone.sphere_offset * std::sin(tilt), z = -reach;
  const double response = (1 + m * x * (x + mu * z) / I) / m;
  const double impulse = (1 + setup.restitution) / response;
  const double turn = impulse * (-mu * z - x) / I;
  State<double> after = start;
  after.p_WB += fall * start.v_WB;
  after.v_WB += impulse / m * Vec3<double>(-mu, 0, 1);
  after.L_W = {0, I * turn, 0};
  const bool slides = after.v_WB.x() + turn * z > 0.1 * speed;
  const Mobility<double> mobility = make_mobility(Moments<double>{.axial = setup.body.moments.z(), .transverse = I});
  constexpr int looks = 64;
  bool leaves = true;
  State<double> end = after;
  for (int k = 1; k <= looks; ++k) {
    end = free_flight(after, mobility, setup.gravity, (impact_end - fall) * k / looks);
    leaves = leaves && surface_gap(setup.stone, Pose<double>{end.p_WB, end.q_WB}, Plane<double>{}) > 0;
  }
  return slides && leaves ? std::optional(Slide{setup, end}) : std::nullopt;
}

Race impact(const Effort& effort) {
  std::vector<Slide> slides;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> tilt(-0.25, 0.25), speed(1.2, 3.0);
  while (slides.size() < 16) {
    const double t = tilt(random);
    if (const auto one = slide(t, speed(random))) {
      slides.push_back(*one);
    }
  }
  Experiment experiment{
      .name = "engine-impact",
      .race =
          {.note =
               "16 stones that come down at 1 m/s without gravity, tilted by up to 14°, and slide in a plane at 1.2 "
               "to 3 m/s all through the impact, e = 0.8, μ = 0.3. There Newton's, Poisson's and Stronge's laws "
               "agree, and the answer is exact.",
           .cost = "run time of 1/30 s",
           .quantities = {{"velocity error", "m/s"}, {"spin error", "rad/s"}, {"place error", "m"}}},
      .cases = {},
      .duration = impact_end,
      .worth = {}};
  for (const Slide& one : slides) {
    experiment.cases.push_back(one.setup);
  }
  experiment.worth = [slides](std::size_t i, const Seen& seen) -> std::vector<double> {
    const State<double>&last = seen.states.back(), &right = slides[i].right;
    return {(last.v_WB - right.v_WB).norm(), (last.L_W - right.L_W).norm() / slides[i].setup.body.moments.x(),
            (last.p_WB - right.p_WB).norm()};
  };
  return race_of(std::move(experiment), effort);
}

// --- a drop to rest

Race drop_to_rest(const Effort& effort) {
  constexpr double duration = 5, finest = 1e-12;
  Experiment experiment{
      .name = "engine-drop",
      .race = {.note = fmt::format(
                   "Let go at 5 cm in 8 attitudes with a spin of up to 5 rad/s, e = μ = 0.3, for 5 s. The error "
                   "is of the place of rest, against Goishi's run at tolerance {}; unanswered is what the "
                   "engine does not take as at rest.",
                   finest),
               .cost = "run time of 5 s",
               .quantities = {{"place error", "m"}, {"energy error", "relative"}, {"unanswered", ""}}},
      .cases = {},
      .duration = duration,
      .tolerances = effort.thorough ? std::vector{1e-4, 1e-6, 1e-9} : std::vector{1e-6},
      .worth = {}};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> spin_rate(0.0, 5.0);
  std::vector<State<double>> right;
  for (int i = 0; i < 8; ++i) {
    Setup setup = bare_setup();
    const Quat<double> q = draw_attitude(random);
    const double rate = spin_rate(random);
    setup.starts = {start_at(setup, 0.05, q, rate * formula::symmetry_axis(draw_attitude(random)))};
    right.push_back(observe(*make_exact_scene(setup, finest), duration, duration).states.back());
    experiment.cases.push_back(setup);
  }
  experiment.worth = [right, cases = experiment.cases](std::size_t i, const Seen& seen) -> std::vector<double> {
    const State<double>& last = seen.states.back();
    return {(last.p_WB - right[i].p_WB).norm(),
            std::fabs(energy_of(cases[i], last) / energy_of(cases[i], right[i]) - 1), seen.rests ? 0.0 : 1.0};
  };
  return race_of(std::move(experiment), effort);
}

}  // namespace

std::vector<Problem> single_problems() {
  return {{"engine-spin", "Free spin", spin},
          {"engine-bounce", "Elastic bounces", bounce},
          {"engine-rocking", "Rocking", rocking},
          {"engine-impact", "One impact with friction", impact},
          {"engine-drop", "A drop to rest", drop_to_rest}};
}

}  // namespace goishi::verify::bench::rivals
