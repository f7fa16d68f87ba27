/// Siconos' solver of Coulomb friction inside Moreau's step: for one stone, without resistance to rolling. The step and the
/// contact are made here, so what is judged is the scheme that it serves.

#include <numerics/FrictionContactProblem.h>
#include <numerics/Friction_cst.h>
#include <numerics/NonSmoothDrivers.h>
#include <numerics/NumericsMatrix.h>
#include <numerics/SolverOptions.h>

#include <algorithm>
#include <goishi/contact/stone_plane.hpp>

#include "verify/bench/rivals/engine.hpp"

namespace goishi::verify::bench::rivals {

namespace {

constexpr double solver_tolerance = 1e-12;

Mat3<double> cross_matrix(const Vec3<double>& r) {
  Mat3<double> m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

class SiconosWorld final : public SteppedWorld {
 public:
  SiconosWorld(const Setup& setup, double step)
      : SteppedWorld(step), setup_(setup), state_(setup.starts.front()), mu_(setup.friction) {
    options_ = solver_options_create(SICONOS_FRICTION_3D_NSGS);
    options_->dparam[SICONOS_DPARAM_TOL] = solver_tolerance;
    matrix_ = NM_create(NM_DENSE, 3, 3);
    problem_ = frictionContactProblem_new_with_data(3, 1, matrix_, q_.data(), &mu_);
  }
  ~SiconosWorld() override {
    problem_->M = nullptr;  // what it does not own
    problem_->q = problem_->mu = nullptr;
    frictionContactProblem_free(problem_);
    NM_free(matrix_);
    solver_options_delete(options_);
  }

  [[nodiscard]] State<double> state(std::size_t /*one*/) const override { return state_; }
  [[nodiscard]] bool rests(std::size_t /*one*/) const override { return false; }

 private:
  /// Positions at the middle of the step, velocities at its ends.
  void take_step() override {
    drift(step_size() / 2);
    const Pose<double> pose{state_.p_WB, state_.q_WB};
    const Separation<double> contact = surface_separation(setup_.stone, pose);
    const Vec3<double> gain = step_size() * setup_.gravity;
    if (contact.gap <= 0) {
      const Vec3<double> r = contact.p_stone - state_.p_WB;
      const Mat3<double> R = state_.q_WB.toRotationMatrix(), across = cross_matrix(r);
      const Mat3<double> inverse = R * setup_.body.moments.cwiseInverse().asDiagonal() * R.transpose();
      Mat3<double> frame;  // rows: the normal, and two across it
      frame << 0, 0, 1, 1, 0, 0, 0, 1, 0;
      const Mat3<double> W =
          frame * (Mat3<double>::Identity() / setup_.body.mass - across * inverse * across) * frame.transpose();
      const Vec3<double> before = frame * (state_.v_WB + (inverse * state_.L_W).cross(r));
      q_ = before + frame * gain;
      q_.x() += setup_.restitution * std::min(before.x(), 0.0);
      std::copy(W.data(), W.data() + 9, matrix_->matrix0);
      Vec3<double> push = Vec3<double>::Zero(), after = Vec3<double>::Zero();
      static_cast<void>(fc3d_driver(problem_, push.data(), after.data(), options_));
      const Vec3<double> impulse = frame.transpose() * push;
      state_.v_WB += impulse / setup_.body.mass;
      state_.L_W += r.cross(impulse);
    }
    state_.v_WB += gain;
    drift(step_size() / 2);
  }

  void drift(double time) {
    state_.p_WB += time * state_.v_WB;
    const Vec3<double> w = turning_of(setup_.body, state_);
    State<double> middle = state_;
    middle.q_WB = (formula::rotation_exp(Vec3<double>(time / 2 * w)) * state_.q_WB).normalized();
    const Vec3<double> turn = time * turning_of(setup_.body, middle);
    state_.q_WB = (formula::rotation_exp(turn) * state_.q_WB).normalized();
  }

  Setup setup_;
  State<double> state_;
  double mu_;
  Vec3<double> q_ = Vec3<double>::Zero();
  SolverOptions* options_;
  NumericsMatrix* matrix_;
  FrictionContactProblem* problem_;
};

}  // namespace

Engine siconos() {
  return {.name = "siconos",
          .label = "Siconos' solver in Moreau's step",
          .given =
              "Siconos, for one stone without resistance to rolling: its Gauss–Seidel solver of friction to 1e-12, in "
              "Moreau's step, with the exact contact, both made here",
          .make = [](const Setup& setup, double step) { return std::make_unique<SiconosWorld>(setup, step); },
          .problems = {"engine-spin", "engine-bounce", "engine-rocking", "engine-impact"}};
}

}  // namespace goishi::verify::bench::rivals
