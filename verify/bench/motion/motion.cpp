#include "verify/bench/motion/motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <goishi/shape/catalogue.hpp>
#include <limits>

#include "verify/oracles/numbers/multiprecision.hpp"

namespace goishi::verify::bench::motion {

namespace {

/// Rounded to 24 bits.
Vec3<double> short_numbers(const Vec3<double>& v) {
  return v.cast<float>().cast<double>();
}

struct Throw {
  Vec3<double> position;
  Vec3<double> velocity;
};

Motion make(std::string name, std::string title, const RigidBody<double>& body, const Vec3<double>& spin_B,
            double duration) {
  Motion motion{.name = std::move(name),
                .title = std::move(title),
                .body = make_rigid_body(body.mass, short_numbers(body.moments)),
                .spin_B = short_numbers(spin_B),
                .start = {.p_WB = Vec3<double>::Zero(),
                          .q_WB = Quat<double>::Identity(),
                          .v_WB = Vec3<double>::Zero(),
                          .L_W = Vec3<double>::Zero()},
                .gravity = Vec3<double>::Zero(),
                .duration = duration,
                .freedom = Freedom::angular};
  motion.start.L_W = motion.body.moments.cwiseProduct(motion.spin_B);
  return motion;
}

Motion thrown(Motion motion, const Throw& how) {
  motion.start.p_WB = short_numbers(how.position);
  motion.start.v_WB = short_numbers(how.velocity);
  motion.gravity = gravity_W<double>();
  motion.freedom = Freedom::both;
  return motion;
}

/// Size 33, white, sharp.
RigidBody<double> catalogue_body() {
  const CatalogueStone entry = catalogue_stone(33, StoneColor::white);
  return make_rigid_body(mass_properties(make_stone<double>(entry), Density{static_cast<double>(entry.density)}));
}

/// 1 cm × 2 cm × 3 cm, the long side along Bz, 15 g.
RigidBody<double> brick() {
  const double mass = 0.015;
  const Vec3<double> squared(1e-4, 4e-4, 9e-4);
  return {.mass = mass, .moments = mass / 12 * (Vec3<double>::Constant(squared.sum()) - squared)};
}

std::array<Quad, 4> exact_attitude(const Motion& motion) {
  using T = Digits50;
  const Mobility<T> mobility =
      formula::mobility(Moments<T>{.axial = T(motion.body.moments.z()), .transverse = T(motion.body.moments.x())});
  const Quat<T> q(T(1), T(0), T(0), T(0));
  const Vec3<T> L = motion.start.L_W.cast<T>();
  const Quat<T> end = formula::free_rotation(q, L, formula::axial_momentum(q, L), mobility, T(motion.duration));
  return {Quad(end.w()), Quad(end.x()), Quad(end.y()), Quad(end.z())};
}

std::array<Quad, 4> integrated_attitude(const Motion& motion) {
  const auto& I = motion.body.moments;
  const auto& w = motion.spin_B;
  return integrate_free_body(
             {.moments = {I.x(), I.y(), I.z()}, .attitude = {1, 0, 0, 0}, .spin = {w.x(), w.y(), w.z()}},
             motion.duration)
      .attitude;
}

std::vector<Motion> make_motions() {
  return {
      make("spin", "Stone of size 33, spinning freely at 25 rad/s for 10 s", catalogue_body(), {12, 9, 20}, 10),
      make("flat-spin", "Stone of size 33, fast flat spin at 200 rad/s for 2 s", catalogue_body(), {3, -2, 200}, 2),
      make("brick", "Brick of 1 × 2 × 3 cm, tumbling at 14 rad/s for 5 s", brick(), {8, -4, 11}, 5),
      make("flip", "The brick at 10 rad/s about its middle axis: 8 s of flips", brick(), {0.001, 10, 0.001}, 8),
      thrown(make("tumble", "Stone of size 33, thrown, tumbling at 50 rad/s for 1 s", catalogue_body(), {30, 0, 40}, 1),
             {.position = {0.25, -0.5, 1}, .velocity = {1.5, 0.75, 3}})};
}

/// By the closed form in 50 digits for a body with a symmetry axis, by high-order integration in 34 digits for others.
Motion with_answer(Motion motion) {
  const State<Quad> start{.p_WB = motion.start.p_WB.cast<Quad>(),
                          .q_WB = motion.start.q_WB.cast<Quad>(),
                          .v_WB = motion.start.v_WB.cast<Quad>(),
                          .L_W = motion.start.L_W.cast<Quad>()};
  const RigidBody<Quad> body{.mass = motion.body.mass, .moments = motion.body.moments.cast<Quad>()};
  motion.energy = formula::energy(start, body, Vec3<Quad>(motion.gravity.cast<Quad>()));
  motion.kinetic = formula::rotational_energy(start, body) + formula::translational_energy(start, body);
  motion.momentum = start.L_W.norm();
  motion.attitude = motion.is_symmetric() ? exact_attitude(motion) : integrated_attitude(motion);
  return motion;
}

/// Steps of a power of two, about two a turn, halved each time; a curve ends by its errors or its run time.
std::vector<double> step_sizes(const Motion& motion) {
  std::vector<double> sizes = {motion.duration /
                               std::exp2(std::ceil(std::log2(motion.spin_B.norm() * motion.duration / 4)))};
  for (int halvings = 0; halvings < 30; ++halvings) {
    sizes.push_back(sizes.back() / 2);
  }
  return sizes;
}

std::vector<Contestant<Motion>> contestants() {
  std::vector<Contestant<Motion>> all = our_contestants();
  for (Contestant<Motion>& other : odeint_contestants()) {
    all.push_back(std::move(other));
  }
  return all;
}

Race prepare(const Motion& asked) {
  const auto motion = std::make_shared<const Motion>(with_answer(asked));
  Race race{
      .note = fmt::format("Right answer: {}.", motion->is_symmetric() ? "closed form, 50 digits"
                                                                      : "Bulirsch–Stoer and Fehlberg 7(8), 34 digits"),
      .cost = "run time per simulated second",
      .quantities = {{"attitude error", "rad"},
                     {"energy error", "relative to the kinetic energy"},
                     {"momentum error", "relative"},
                     {"steps or evaluations", ""}},
      .others = "grey is Odeint",
      .compared = {-2, -4, -6, -8, -10, -12}};
  let_enter(race, contestants(), motion);
  for (Curve& curve : race.curves) {
    if (curve.who.kind == Kind::step) {
      curve.who.settings = step_sizes(*motion);
    }
  }
  return race;
}

Quad angle_between(const std::array<Quad, 4>& right, const Quat<Quad>& found) {
  const Quat<Quad> difference = Quat<Quad>(right[0], right[1], right[2], right[3]).conjugate() * found;
  return 2 * atan2(Quad(difference.vec().norm()), Quad(abs(difference.w())));
}

double relative(const Quad& found, const Quad& right, const Quad& scale) {
  return static_cast<double>(Quad(abs(Quad(found - right)) / scale));
}

}  // namespace

std::vector<double> judge(const Outcome& outcome, const Motion& motion) {
  if (!outcome.completed) {
    return std::vector<double>(4, std::numeric_limits<double>::quiet_NaN());
  }
  const RigidBody<Quad> body{.mass = motion.body.mass, .moments = motion.body.moments.cast<Quad>()};
  State<Quad> end{.p_WB = outcome.p_WB.cast<Quad>(),
                  .q_WB = outcome.q_WB.cast<Quad>().normalized(),
                  .v_WB = outcome.v_WB.cast<Quad>(),
                  .L_W = outcome.rotation.cast<Quad>()};
  if (outcome.holds_spin) {
    end.L_W = formula::angular_momentum_W(end.q_WB, body, end.L_W);
  }
  const Quad energy = formula::energy(end, body, Vec3<Quad>(motion.gravity.cast<Quad>()));
  return {static_cast<double>(angle_between(motion.attitude, end.q_WB)),
          relative(energy, motion.energy, motion.kinetic), relative(end.L_W.norm(), motion.momentum, motion.momentum),
          static_cast<double>(outcome.work)};
}

Subject subject() {
  Subject subject{.name = "motion",
                  .title = "Free flight, from start to end",
                  .note =
                      "Motion: each curve is one way to compute the same motion in double, from coarse to as fine as "
                      "round-off or patience allow. Grey are Odeint's steppers on the raw Newton–Euler equations; a "
                      "star is a closed form, which takes one call and has no step. Odeint's quaternion is "
                      "normalised before its error is taken. Compare at equal error: the tables interpolate each "
                      "curve there, and a dash means that it never comes so far.",
                  .problems = {},
                  .contestants = {}};
  for (const Motion& motion : make_motions()) {
    subject.problems.push_back(
        {motion.name, motion.title, [motion](const Effort& /*any*/) { return prepare(motion); }});
  }
  subject.problems.push_back(flight());
  for (const Contestant<Motion>& one : contestants()) {
    subject.contestants.push_back(one.who);
  }
  return subject;
}

}  // namespace goishi::verify::bench::motion
