/// ODE, the Open Dynamics Engine, in double.

#include <ode/ode.h>

#include <array>
#include <cmath>
#include <numbers>

#include "verify/bench/rivals/engine.hpp"

namespace goishi::verify::bench::rivals {

namespace {

constexpr int meridians = 16, rings = 2;  // of the hull, and on each of its caps
constexpr int most_contacts = 8;          // of a pair

/// Points on the lens, and the faces between them, as ODE wants them: it keeps no copy.
struct Hull {
  std::vector<dReal> points, planes;
  std::vector<unsigned> polygons;
};

/// `meridians` points on the rim and on each of `rings` circles of either cap, at equal turns of the normal, and both
/// poles: faces between circles are plane.
Hull make_hull(const Stone<double>& stone) {
  Hull hull;
  const double steepest = std::acos(stone.sphere_offset / stone.sphere_radius);
  std::vector<Vec3<double>> points;
  const auto circle = [&](double turn, double side) {
    for (int k = 0; k < meridians; ++k) {
      const double around = 2 * std::numbers::pi * k / meridians, radius = stone.sphere_radius * std::sin(turn);
      points.push_back({radius * std::cos(around), radius * std::sin(around),
                        side * (stone.sphere_radius * std::cos(turn) - stone.sphere_offset)});
    }
  };
  points.push_back({0, 0, stone.height / 2});
  for (int ring = 1; ring <= rings; ++ring) {
    circle(steepest * ring / (rings + 1), 1);
  }
  circle(steepest, 1);
  for (int ring = rings; ring >= 1; --ring) {
    circle(steepest * ring / (rings + 1), -1);
  }
  points.push_back({0, 0, -stone.height / 2});
  const int circles = 2 * rings + 1, last = static_cast<int>(points.size()) - 1;
  const auto at = [&](int ring, int k) { return 1 + ring * meridians + k % meridians; };
  const auto face = [&](const std::vector<int>& corners) {  // counter-clockwise, seen from outside
    const auto corner = [&](std::size_t k) -> const Vec3<double>& {
      return points[static_cast<std::size_t>(corners[k])];
    };
    const Vec3<double> n = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    hull.planes.insert(hull.planes.end(), {n.x(), n.y(), n.z(), n.dot(corner(0))});
    hull.polygons.push_back(static_cast<unsigned>(corners.size()));
    hull.polygons.insert(hull.polygons.end(), corners.begin(), corners.end());
  };
  for (int k = 0; k < meridians; ++k) {
    face({0, at(0, k), at(0, k + 1)});
    for (int ring = 0; ring + 1 < circles; ++ring) {
      face({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
    face({last, at(circles - 1, k + 1), at(circles - 1, k)});
  }
  for (const Vec3<double>& point : points) {
    hull.points.insert(hull.points.end(), {point.x(), point.y(), point.z()});
  }
  return hull;
}

/// ODE counts who uses it.
class Library {
 public:
  Library() { dInitODE2(0); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

class OdeWorld final : public SteppedWorld {
 public:
  OdeWorld(const Setup& setup, double step) : SteppedWorld(step), setup_(setup), hull_(make_hull(setup.stone)) {
    dRandSetSeed(0);  // it solves contacts in random order
    world_ = dWorldCreate();
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    group_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, setup.gravity.x(), setup.gravity.y(), setup.gravity.z());
    dWorldSetERP(world_, 0.8);
    dWorldSetCFM(world_, 0);
    dWorldSetContactSurfaceLayer(world_, 1e-5);
    dWorldSetContactMaxCorrectingVel(world_, 1);
    dWorldSetAutoDisableFlag(world_, setup.may_sleep ? 1 : 0);
    dWorldSetAutoDisableLinearThreshold(world_, slow);
    dWorldSetAutoDisableAngularThreshold(world_, slow_turn);
    dWorldSetAutoDisableSteps(world_, 0);
    dWorldSetAutoDisableTime(world_, seconds_to_sleep);
    dCreatePlane(space_, 0, 0, 1, 0);
    for (const State<double>& start : setup.starts) {
      add(start);
    }
  }
  ~OdeWorld() override {
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  [[nodiscard]] State<double> state(std::size_t i) const override {
    const auto vector = [](const dReal* v) { return Vec3<double>(v[0], v[1], v[2]); };
    const dReal* const q = dBodyGetQuaternion(bodies_[i]);
    return state_of(setup_.body, vector(dBodyGetPosition(bodies_[i])), Quat<double>(q[0], q[1], q[2], q[3]),
                    vector(dBodyGetLinearVel(bodies_[i])), vector(dBodyGetAngularVel(bodies_[i])));
  }
  [[nodiscard]] bool rests(std::size_t i) const override { return dBodyIsEnabled(bodies_[i]) == 0; }

 private:
  void take_step() override {
    dSpaceCollide(space_, this, [](void* self, dGeomID first, dGeomID second) {
      static_cast<OdeWorld*>(self)->touch(first, second);
    });
    dWorldQuickStep(world_, step_size());
    dJointGroupEmpty(group_);
  }

  void touch(dGeomID first, dGeomID second) {
    dBodyID one = dGeomGetBody(first), other = dGeomGetBody(second);
    const auto moves = [](dBodyID body) { return body != nullptr && dBodyIsEnabled(body) != 0; };
    if (!moves(one) && !moves(other)) {
      return;
    }
    std::array<dContact, most_contacts> contacts;
    const int found = dCollide(first, second, most_contacts, &contacts[0].geom, sizeof(dContact));
    for (int k = 0; k < found; ++k) {
      dSurfaceParameters& surface = contacts[static_cast<std::size_t>(k)].surface;
      surface = {};
      surface.mode = dContactBounce | dContactApprox1 | (setup_.rolling_resistance > 0 ? dContactRolling : 0);
      surface.mu = setup_.friction;
      surface.bounce = setup_.restitution;
      surface.bounce_vel = 0;
      surface.rho = surface.rho2 = setup_.rolling_resistance;
      surface.rhoN = setup_.pivot_radius;
      dJointAttach(dJointCreateContact(world_, group_, &contacts[static_cast<std::size_t>(k)]), one, other);
    }
  }

  void add(const State<double>& start) {
    dBodyID body = bodies_.emplace_back(dBodyCreate(world_));
    const Vec3<double>& I = setup_.body.moments;
    dMass mass;
    dMassSetParameters(&mass, setup_.body.mass, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
    dBodySetMass(body, &mass);
    const Quat<double>& q = start.q_WB;
    const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, start.p_WB.x(), start.p_WB.y(), start.p_WB.z());
    dBodySetQuaternion(body, attitude);
    const Vec3<double> w_W = turning_of(setup_.body, start);
    dBodySetLinearVel(body, start.v_WB.x(), start.v_WB.y(), start.v_WB.z());
    dBodySetAngularVel(body, w_W.x(), w_W.y(), w_W.z());
    dBodySetFiniteRotationMode(body, 1);
    dBodySetGyroscopicMode(body, 1);
    const auto faces = static_cast<unsigned>(hull_.planes.size() / 4);
    dGeomID shape = dCreateConvex(space_, hull_.planes.data(), faces, hull_.points.data(),
                                  static_cast<unsigned>(hull_.points.size() / 3), hull_.polygons.data());
    dGeomSetBody(shape, body);
  }

  Library library_;
  Setup setup_;
  Hull hull_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID group_;
  std::vector<dBodyID> bodies_;
};

}  // namespace

Engine ode() {
  return {.name = "ode",
          .label = "ODE, hull of 82 points",
          .given =
              "ODE (double): a convex hull of 82 points, a plane, its quick step with 20 sweeps, ERP 0.8, a layer of "
              "10 µm, at "
              "most 8 contacts of a pair",
          .make = [](const Setup& setup, double step) { return std::make_unique<OdeWorld>(setup, step); }};
}

}  // namespace goishi::verify::bench::rivals
