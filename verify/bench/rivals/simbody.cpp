#include "verify/bench/rivals/engine.hpp"
#include "verify/bench/rivals/simbody_body.hpp"

namespace goishi::verify::bench::rivals {

namespace {

Three numbers_of(const Vec3<double>& v) {
  return {v.x(), v.y(), v.z()};
}
Vec3<double> vector_of(const Three& v) {
  return {v[0], v[1], v[2]};
}

SimbodySetup numbers_of(const Setup& setup, double accuracy) {
  const State<double>& start = setup.starts.front();
  const Quat<double>& q = start.q_WB;
  return {.mass = setup.body.mass,
          .moments = numbers_of(setup.body.moments),
          .gravity = numbers_of(setup.gravity),
          .friction = setup.friction,
          .sphere_radius = setup.stone.sphere_radius,
          .sphere_offset = setup.stone.sphere_offset,
          .start = {.p = numbers_of(start.p_WB),
                    .q = {q.w(), q.x(), q.y(), q.z()},
                    .v = numbers_of(start.v_WB),
                    .w = numbers_of(turning_of(setup.body, start))},
          .accuracy = accuracy};
}

class SimbodyWorld final : public World {
 public:
  SimbodyWorld(const Setup& setup, double accuracy) : body_(setup.body), stone_(numbers_of(setup, accuracy)) {}

  void advance_to(double time) override { stone_.advance_to(time); }
  [[nodiscard]] State<double> state(std::size_t /*one*/) const override {
    const auto [p, q, v, w] = stone_.state();
    return state_of(body_, vector_of(p), Quat<double>(q[0], q[1], q[2], q[3]), vector_of(v), vector_of(w));
  }
  [[nodiscard]] bool rests(std::size_t /*one*/) const override { return false; }

 private:
  RigidBody<double> body_;
  SimbodyBody stone_;
};

}  // namespace

Engine simbody() {
  return {.name = "simbody",
          .label = "Simbody, sphere for the cap",
          .given =
              "Simbody, where one cap alone touches: a sphere on a half-space, elastic after Hunt and Crossley with 10 "
              "MPa, friction full from 1 mm/s on, its Runge–Kutta–Merson integrator",
          .make = [](const Setup& setup, double accuracy) { return std::make_unique<SimbodyWorld>(setup, accuracy); },
          .kind = Kind::tolerance,
          .settings = {1e-3, 1e-5, 1e-7},
          .problems = {"engine-spin", "engine-rocking"}};
}

}  // namespace goishi::verify::bench::rivals
