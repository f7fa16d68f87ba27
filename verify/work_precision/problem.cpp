#include "verify/work_precision/problem.hpp"

#include <goishi/shape/catalogue.hpp>

#include "verify/oracles/numbers/multiprecision.hpp"

namespace goishi::verify::bench {

namespace {

/// Rounded to 24 bits.
Vec3<double> short_numbers(const Vec3<double>& v) {
  return v.cast<float>().cast<double>();
}

struct Throw {
  Vec3<double> position;
  Vec3<double> velocity;
};

Problem make(std::string name, std::string title, const RigidBody<double>& body, const Vec3<double>& spin_B,
             double duration) {
  Problem problem{.name = std::move(name),
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
  problem.start.L_W = problem.body.moments.cwiseProduct(problem.spin_B);
  return problem;
}

Problem thrown(Problem problem, const Throw& how) {
  problem.start.p_WB = short_numbers(how.position);
  problem.start.v_WB = short_numbers(how.velocity);
  problem.gravity = gravity_W<double>();
  problem.freedom = Freedom::both;
  return problem;
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

std::array<Quad, 4> exact_attitude(const Problem& problem) {
  using T = Digits50;
  const TopRates<T> rates =
      formula::top_rates<T>({.axial = T(problem.body.moments.z()), .transverse = T(problem.body.moments.x())});
  const Quat<T> q(T(1), T(0), T(0), T(0));
  const Vec3<T> L = problem.start.L_W.cast<T>();
  const Quat<T> end = formula::free_rotation(q, L, formula::axial_momentum(q, L), rates, T(problem.duration));
  return {Quad(end.w()), Quad(end.x()), Quad(end.y()), Quad(end.z())};
}

std::array<Quad, 4> integrated_attitude(const Problem& problem) {
  const auto& I = problem.body.moments;
  const auto& w = problem.spin_B;
  return integrate_free_body(
             {.moments = {I.x(), I.y(), I.z()}, .attitude = {1, 0, 0, 0}, .spin = {w.x(), w.y(), w.z()}},
             problem.duration)
      .attitude;
}

std::vector<Problem> make_problems() {
  return {
      make("spin", "Stone of size 33, spinning freely at 25 rad/s for 10 s", catalogue_body(), {12, 9, 20}, 10),
      make("flat-spin", "Stone of size 33, fast flat spin at 200 rad/s for 2 s", catalogue_body(), {3, -2, 200}, 2),
      make("brick", "Brick of 1 × 2 × 3 cm, tumbling at 14 rad/s for 5 s", brick(), {8, -4, 11}, 5),
      make("flip", "The brick at 10 rad/s about its middle axis: 8 s of flips", brick(), {0.001, 10, 0.001}, 8),
      thrown(make("tumble", "Stone of size 33, thrown, tumbling at 50 rad/s for 1 s", catalogue_body(), {30, 0, 40}, 1),
             {.position = {0.25, -0.5, 1}, .velocity = {1.5, 0.75, 3}})};
}

}  // namespace

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = make_problems();
  return all;
}

Reference reference_of(const Problem& problem) {
  Reference reference;
  const State<Quad> start{.p_WB = problem.start.p_WB.cast<Quad>(),
                          .q_WB = problem.start.q_WB.cast<Quad>(),
                          .v_WB = problem.start.v_WB.cast<Quad>(),
                          .L_W = problem.start.L_W.cast<Quad>()};
  const RigidBody<Quad> body{.mass = problem.body.mass, .moments = problem.body.moments.cast<Quad>()};
  reference.energy = formula::energy(start, body, Vec3<Quad>(problem.gravity.cast<Quad>()));
  reference.kinetic = formula::rotational_energy(start, body) + formula::translational_energy(start, body);
  reference.momentum = start.L_W.norm();
  reference.attitude = problem.is_symmetric() ? exact_attitude(problem) : integrated_attitude(problem);
  reference.source = problem.is_symmetric() ? "closed form, 50 digits" : "Bulirsch–Stoer and Fehlberg 7(8), 34 digits";
  return reference;
}

}  // namespace goishi::verify::bench
