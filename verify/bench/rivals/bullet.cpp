/// Bullet, in float. Its constants suit bodies of about a metre and a kilogram, so it is told lengths in centimetres. It
/// takes a matrix whose determinant is below 1e-7 as singular: with masses in kilograms a stone would have no gyroscopic
/// torque. With masses in grams stones do not fall asleep.

#include <btBulletDynamicsCommon.h>

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <cmath>
#include <goishi/shape/stone.hpp>

#include "verify/bench/rivals/engine.hpp"

namespace goishi::verify::bench::rivals {

namespace {

constexpr double unit = 100;      // of length in a metre
constexpr double mass_unit = 10;  // of mass in a kilogram
constexpr double margin = 1e-4;   // [m] of the lens, the rest of it is its core

btScalar number(double x) {
  return static_cast<btScalar>(x);
}
btVector3 scaled(const Vec3<double>& v, double factor) {
  return {number(factor * v.x()), number(factor * v.y()), number(factor * v.z())};
}
Vec3<double> unscaled(const btVector3& v, double factor) {
  return Vec3<double>(v.x(), v.y(), v.z()) / factor;
}

/// The exact lens by its support function; within the margin of the rim it is rounded.
class Lens final : public btConvexInternalShape {
 public:
  explicit Lens(const Stone<double>& stone)
      : radius_(number(unit * (stone.sphere_radius - margin))),
        offset_(number(unit * stone.sphere_offset)),
        rim_(std::sqrt(radius_ * radius_ - offset_ * offset_)) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(number(unit * margin));
  }

  [[nodiscard]] btVector3 localGetSupportingVertexWithoutMargin(const btVector3& along) const override {
    const btScalar x = along.x(), y = along.y(), z = along.z();
    const btScalar radial_square = x * x + y * y, length = btSqrt(radial_square + z * z);
    if (radius_ * btFabs(z) > offset_ * length) {
      const btScalar scale = radius_ / length;
      return {scale * x, scale * y, scale * z - (z < 0 ? -offset_ : offset_)};
    }
    const btScalar scale = radial_square > 0 ? rim_ / btSqrt(radial_square) : 0;
    return {scale * x, scale * y, 0};
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* along, btVector3* points,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) {
      points[i] = localGetSupportingVertexWithoutMargin(along[i]);
    }
  }
  /// Along each axis as far as the support point there.
  void getAabb(const btTransform& pose, btVector3& low, btVector3& high) const override {
    const btVector3& middle = pose.getOrigin();
    for (int k = 0; k < 3; ++k) {
      const btVector3& axis = pose.getBasis().getRow(k);
      const btScalar reach = axis.dot(localGetSupportingVertexWithoutMargin(axis)) + getMargin();
      low[k] = middle[k] - reach;
      high[k] = middle[k] + reach;
    }
  }
  /// The body has its own.
  void calculateLocalInertia(btScalar /*mass*/, btVector3& inertia) const override { inertia.setZero(); }
  [[nodiscard]] const char* getName() const override { return "lens"; }

 private:
  btScalar radius_, offset_, rim_;
};

/// A contact has the greater of two bodies' numbers: the ground's are zero, and all stones are alike.
template <btScalar (btCollisionObject::*number)() const>
btScalar greater(const btCollisionObject* first, const btCollisionObject* second) {
  return btMax((first->*number)(), (second->*number)());
}
void set_globals() {
  gDeactivationTime = number(seconds_to_sleep);
  gCalculateCombinedRestitutionCallback = greater<&btCollisionObject::getRestitution>;
  gCalculateCombinedFrictionCallback = greater<&btCollisionObject::getFriction>;
  gCalculateCombinedRollingFrictionCallback = greater<&btCollisionObject::getRollingFriction>;
  gCalculateCombinedSpinningFrictionCallback = greater<&btCollisionObject::getSpinningFriction>;
}

class BulletWorld final : public SteppedWorld {
 public:
  BulletWorld(const Setup& setup, double step)
      : SteppedWorld(step),
        body_(setup.body),
        configuration_(pools(setup.starts.size())),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        lens_(setup.stone),
        plane_({0, 0, 1}, 0),
        ground_(0, nullptr, &plane_) {
    set_globals();
    world_.setGravity(scaled(setup.gravity, unit));
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_restitutionVelocityThreshold = 0;
    info.m_splitImpulsePenetrationThreshold = 0;  // what overlaps is parted without a velocity
    plane_.setMargin(0);
    ground_.setRestitution(0);
    ground_.setFriction(0);
    world_.addRigidBody(&ground_);
    for (const State<double>& start : setup.starts) {
      add(setup, start);
    }
  }
  ~BulletWorld() override {
    for (const auto& stone : stones_) {
      world_.removeRigidBody(stone.get());
    }
    world_.removeRigidBody(&ground_);
  }

  [[nodiscard]] State<double> state(std::size_t i) const override {
    const btRigidBody& stone = *stones_[i];
    const btQuaternion q = stone.getOrientation();
    return state_of(body_, unscaled(stone.getCenterOfMassPosition(), unit), Quat<double>(q.w(), q.x(), q.y(), q.z()),
                    unscaled(stone.getLinearVelocity(), unit), unscaled(stone.getAngularVelocity(), 1));
  }
  [[nodiscard]] bool rests(std::size_t i) const override { return !stones_[i]->isActive(); }

 private:
  void take_step() override { world_.stepSimulation(number(step_size()), 0); }

  void add(const Setup& setup, const State<double>& start) {
    const Quat<double>& q = start.q_WB;
    btRigidBody::btRigidBodyConstructionInfo info(number(mass_unit * setup.body.mass), nullptr, &lens_,
                                                  scaled(setup.body.moments, mass_unit * unit * unit));
    info.m_startWorldTransform =
        btTransform({number(q.x()), number(q.y()), number(q.z()), number(q.w())}, scaled(start.p_WB, unit));
    info.m_restitution = number(setup.restitution);
    info.m_friction = number(setup.friction);
    info.m_rollingFriction = number(unit * setup.rolling_resistance);
    info.m_spinningFriction = number(unit * setup.pivot_radius);
    info.m_linearSleepingThreshold = number(unit * slow);
    info.m_angularSleepingThreshold = number(slow_turn);
    btRigidBody& stone = *stones_.emplace_back(std::make_unique<btRigidBody>(info));
    stone.setLinearVelocity(scaled(start.v_WB, unit));
    stone.setAngularVelocity(scaled(turning_of(setup.body, start), 1));
    if (!setup.may_sleep) {
      stone.setActivationState(DISABLE_DEACTIVATION);
    }
    world_.addRigidBody(&stone);
    stone.setGravity(scaled(setup.gravity, unit));
  }

  /// Its pools, no larger than needed: they cost time when a world is made.
  [[nodiscard]] static btDefaultCollisionConstructionInfo pools(std::size_t stones) {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = info.m_defaultMaxCollisionAlgorithmPoolSize =
        8 + 8 * static_cast<int>(stones);
    return info;
  }

  RigidBody<double> body_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  Lens lens_;
  btStaticPlaneShape plane_;
  btRigidBody ground_;
  std::vector<std::unique_ptr<btRigidBody>> stones_;
};

}  // namespace

Engine bullet() {
  return {.name = "bullet",
          .label = "Bullet, support function",
          .given =
              "Bullet (float, in cm and 0.1 kg): the lens as support function with a margin of 0.1 mm, a static plane, "
              "split impulses, no least speed for restitution, 10 sweeps",
          .make = [](const Setup& setup, double step) { return std::make_unique<BulletWorld>(setup, step); }};
}

}  // namespace goishi::verify::bench::rivals
