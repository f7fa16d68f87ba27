#include "verify/bench/rivals/simbody_body.hpp"

#include <Simbody.h>

namespace goishi::verify::bench::rivals {

namespace {

constexpr double stiffness = 1e7;          // [Pa] a hundred times stiffer costs eight times as much
constexpr double slip_of_friction = 1e-3;  // [m/s] at which friction is full

SimTK::Vec3 vector_of(const Three& v) {
  return {v[0], v[1], v[2]};
}
Three numbers_of(const SimTK::Vec3& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

using namespace SimTK;  // NOLINT(google-build-using-namespace)

struct SimbodyBody::Parts {
  explicit Parts(const SimbodySetup& setup)
      : matter(system), forces(system), contacts(system), gravity(forces, matter, vector_of(setup.gravity)) {
    const ContactSetIndex touching = contacts.createContactSet();
    contacts.addBody(touching, matter.updGround(), ContactGeometry::HalfSpace(),
                     Transform(Rotation(Pi / 2, YAxis)));  // what is at its x > 0 is solid
    const auto& [x, y, z] = setup.moments;
    const Body::Rigid rigid(MassProperties(setup.mass, Vec3(0), Inertia(x, y, z)));
    stone = MobilizedBody::Free(matter.updGround(), Transform(), rigid, Transform());
    contacts.addBody(touching, stone, ContactGeometry::Sphere(setup.sphere_radius),
                     Transform(Vec3(0, 0, setup.sphere_offset)));
    HuntCrossleyForce force(forces, contacts, touching);
    for (const int surface : {0, 1}) {
      force.setBodyParameters(ContactSurfaceIndex(surface), stiffness, 0, setup.friction, setup.friction, 0);
    }
    force.setTransitionVelocity(slip_of_friction);
    system.realizeTopology();
    State state = system.getDefaultState();
    const auto& [p, q, v, w] = setup.start;
    stone.setQToFitTransform(state, Transform(Rotation(Quaternion(q[0], q[1], q[2], q[3])), vector_of(p)));
    stone.setUToFitVelocity(state, SpatialVec(vector_of(w), vector_of(v)));
    integrator.setAccuracy(setup.accuracy);
    stepper.initialize(state);
  }

  MultibodySystem system;
  SimbodyMatterSubsystem matter;
  GeneralForceSubsystem forces;
  GeneralContactSubsystem contacts;
  Force::UniformGravity gravity;
  MobilizedBody::Free stone;
  RungeKuttaMersonIntegrator integrator{system};
  TimeStepper stepper{system, integrator};
};

SimbodyBody::SimbodyBody(const SimbodySetup& setup) : parts_(std::make_unique<Parts>(setup)) {}
SimbodyBody::~SimbodyBody() = default;

void SimbodyBody::advance_to(double time) {
  parts_->stepper.stepTo(time);
}

SimbodyState SimbodyBody::state() const {
  const State& now = parts_->integrator.getState();
  parts_->system.realize(now, Stage::Velocity);
  const Transform& pose = parts_->stone.getBodyTransform(now);
  const Quaternion q = pose.R().convertRotationToQuaternion();
  return {numbers_of(pose.p()),
          {q[0], q[1], q[2], q[3]},
          numbers_of(parts_->stone.getBodyOriginVelocity(now)),
          numbers_of(parts_->stone.getBodyAngularVelocity(now))};
}

}  // namespace goishi::verify::bench::rivals
