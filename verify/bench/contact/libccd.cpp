/// libccd: GJK and the expanding polytope (EPA), on support functions that its user writes. It has no distance of
/// bodies that are apart, so the stone gets a margin, which is taken off the depth again.

#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/bench/contact/rivals.hpp"

namespace goishi::verify::bench::contact {

namespace {

constexpr double margin = 0.003;    // [m] more than the greatest gap and the coarsest hull's defect
constexpr int most_supports = 400;  // EPA does not always end by itself

/// A body as the support functions see it: an exact stone, a hull, or a box.
struct Body {
  const Stone<double>* stone = nullptr;
  const Polyhedron* hull = nullptr;
  Vec3<double> half = {0, 0, 0};
  Mat3<double> R_WB = Mat3<double>::Identity();
  Vec3<double> p_W = {0, 0, 0};
  double margin = 0;
  mutable int last = 0;      // where the walk over the hull ended
  mutable int supports = 0;  // that were asked for
};

Vec3<double> farthest_in(const Body& body, const Vec3<double>& direction_B) {
  if (body.hull != nullptr) {
    body.last = farthest_point(*body.hull, direction_B, body.last);
    return body.hull->points[static_cast<std::size_t>(body.last)];
  }
  if (body.stone != nullptr) {
    return support(*body.stone, Vec3<double>(direction_B.normalized())).p_B;
  }
  return {std::copysign(body.half.x(), direction_B.x()), std::copysign(body.half.y(), direction_B.y()),
          std::copysign(body.half.z(), direction_B.z())};
}

void set(ccd_vec3_t* out, const Vec3<double>& v) {
  ccdVec3Set(out, v.x(), v.y(), v.z());
}

extern "C" void goishi_bench_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  // Where both bodies answer with the origin, EPA finds nothing to expand, and ends.
  if (++body.supports > most_supports) {
    set(out, Vec3<double>::Zero());
    return;
  }
  const Vec3<double> d(direction->v[0], direction->v[1], direction->v[2]);
  const double length = d.norm();
  if (!(length > 0)) {
    set(out, body.p_W);
    return;
  }
  set(out, body.p_W + body.R_WB * farthest_in(body, body.R_WB.transpose() * d) + body.margin / length * d);
}

/// The gap; infinite: farther apart than the margin; NaN: EPA did not end.
double gap_between(const Body& first, const Body& second, double tolerance) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = goishi_bench_support;
  ccd.support2 = goishi_bench_support;
  ccd.max_iterations = most_supports;
  ccd.epa_tolerance = tolerance;
  first.supports = 0;
  second.supports = 0;
  ccd_real_t depth = 0;
  ccd_vec3_t direction, position;
  const int status = ccdGJKPenetration(&first, &second, &ccd, &depth, &direction, &position);
  if (most_supports < first.supports) {
    return scalar::unset<double>();
  }
  return status == 0 ? first.margin - depth : std::numeric_limits<double>::infinity();
}

/// What stands in the scene: a stone, exact or a hull, against the board's box or another such stone.
class Duel {
 public:
  Duel(const Scene& scene, int rings, double tolerance)
      : flies_(scene.query == Query::impact),
        stone_(make_stone(scene.shape.width, scene.shape.height, scene.shape.bevel)),
        tolerance_(tolerance) {
    if (rings > 0) {
      hull_ = make_polyhedron(scene.hull, rings);
    }
    const Box box = box_of(scene.board);
    board_.half = box.half;
    board_.p_W = box.centre;
  }

  /// A flight goes on no farther than the margin.
  [[nodiscard]] double gap(const Pose<double>& pose) const {
    const double gap = gap_between(placed(pose, margin), board_, tolerance_);
    return flies_ ? std::min(gap, margin) : gap;  // NaN stays
  }
  [[nodiscard]] double gap(const Pose<double>& pose, const Pose<double>& other) const {
    return gap_between(placed(pose, margin), placed(other, 0), tolerance_);
  }

 private:
  [[nodiscard]] Body placed(const Pose<double>& pose, double with_margin) const {
    Body body;
    body.stone = &stone_;
    body.hull = hull_.points.empty() ? nullptr : &hull_;
    body.R_WB = pose.q_WB.toRotationMatrix();
    body.p_W = pose.p_WB;
    body.margin = with_margin;
    return body;
  }

  bool flies_;
  Stone<double> stone_;
  Polyhedron hull_;
  Body board_;
  double tolerance_;
};

/// EPA's error grows with the root of its tolerance: to stay below the hull's defect, which falls with its points.
double hull_tolerance(double vertices) {
  return 1e-8 / vertices;
}

}  // namespace

std::vector<Contestant<Scene>> libccd_contestants() {
  const auto hull = [](const Scene& scene, double vertices) {
    return Duel(scene, rings_of(vertices), hull_tolerance(vertices));
  };
  const auto exact = [](const Scene& scene, double tolerance) { return Duel(scene, 0, tolerance); };
  return {
      make_rival("libccd-hull", "libccd, hull", Kind::vertices, vertex_counts(), hull),
      make_rival("libccd-exact", "libccd, exact support", Kind::tolerance, {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}, exact)};
}

}  // namespace goishi::verify::bench::contact
