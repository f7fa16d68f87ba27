/// FCL: signed distance of hulls, by its own extension of libccd: GJK where they are apart, EPA where they overlap.

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <exception>
#include <memory>

#include "verify/bench/contact/rivals.hpp"

namespace goishi::verify::bench::contact {

namespace {

constexpr double tolerance = 1e-7;  // [m] below the defect of the finest hull

std::shared_ptr<fcl::Convex<double>> convex_of(const Polyhedron& body) {
  auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& face : body.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_shared<fcl::Convex<double>>(std::make_shared<std::vector<fcl::Vector3<double>>>(body.points),
                                               static_cast<int>(body.faces.size()), faces, true);
}

fcl::Transform3<double> transform_of(const Pose<double>& pose) {
  fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();
  transform.linear() = pose.q_WB.toRotationMatrix();
  transform.translation() = pose.p_WB;
  return transform;
}

class Duel {
 public:
  Duel(const Scene& scene, int rings)
      : stone_(convex_of(make_polyhedron(scene.hull, rings))), board_(2 * box_of(scene.board).half) {
    stone_->computeLocalAABB();
    board_.computeLocalAABB();
    board_at_.translation() = box_of(scene.board).centre;
    request_.enable_signed_distance = true;
    request_.distance_tolerance = tolerance;
    request_.gjk_solver_type = fcl::GST_LIBCCD;
  }

  [[nodiscard]] double gap(const Pose<double>& pose) const { return gap(transform_of(pose), board_, board_at_); }
  [[nodiscard]] double gap(const Pose<double>& pose, const Pose<double>& other) const {
    return gap(transform_of(pose), *stone_, transform_of(other));
  }

 private:
  /// NaN where FCL gives up.
  [[nodiscard]] double gap(const fcl::Transform3<double>& at, const fcl::CollisionGeometry<double>& other,
                           const fcl::Transform3<double>& other_at) const {
    try {
      fcl::DistanceResult<double> result;
      fcl::distance<double>(stone_.get(), at, &other, other_at, request_, result);
      return result.min_distance;
    } catch (const std::exception&) {
      return scalar::unset<double>();
    }
  }

  std::shared_ptr<fcl::Convex<double>> stone_;
  fcl::Box<double> board_;
  fcl::Transform3<double> board_at_ = fcl::Transform3<double>::Identity();
  fcl::DistanceRequest<double> request_;
};

}  // namespace

std::vector<Contestant<Scene>> rival_contestants() {
  std::vector<Contestant<Scene>> all = libccd_contestants();
  const auto hull = [](const Scene& scene, double vertices) { return Duel(scene, rings_of(vertices)); };
  all.push_back(make_rival("fcl-hull", "FCL, hull", Kind::vertices, vertex_counts(), hull));
  return all;
}

}  // namespace goishi::verify::bench::contact
