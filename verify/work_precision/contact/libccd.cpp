/// libccd: GJK and the expanding polytope (EPA), on support functions that its user writes. It has no distance of
/// bodies that are apart, so the stone gets a margin, which is taken off the depth again.

#include <ccd/ccd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "verify/work_precision/contact/rivals.hpp"

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
      : scene_(scene),
        stone_(make_stone(scene.problem->shape.width, scene.problem->shape.height, scene.problem->shape.bevel)),
        tolerance_(tolerance) {
    if (rings > 0) {
      hull_ = make_polyhedron(scene.hull, rings);
    }
    const Box box = box_of(scene.board);
    board_.half = box.half;
    board_.p_W = box.centre;
  }

  [[nodiscard]] double gap(const Pose<double>& pose) const {
    return gap_between(placed(pose, margin), board_, tolerance_);
  }
  [[nodiscard]] double gap(const Pose<double>& pose, const Pose<double>& other) const {
    return gap_between(placed(pose, margin), placed(other, 0), tolerance_);
  }
  [[nodiscard]] double answer(std::size_t i) const {
    switch (scene_.problem->query) {
      case Query::impact:
        return advanced_to_contact(scene_.paths[i], scene_.problem->shape.width / 2, [&](const Pose<double>& pose) {
          return std::min(gap(pose), margin);  // NaN stays
        });
      case Query::plane:
      case Query::edge:
      case Query::corner:
        return gap(scene_.poses[i]);
      default:
        return gap(scene_.poses[i], scene_.others[i]);
    }
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

  const Scene& scene_;
  Stone<double> stone_;
  Polyhedron hull_;
  Body board_;
  double tolerance_;
};

/// EPA's error grows with the root of its tolerance: to stay below the hull's defect, which falls with its points.
double hull_tolerance(double vertices) {
  return 1e-8 / vertices;
}

std::unique_ptr<Asker> enter(const Scene& scene, int rings, double tolerance) {
  return make_asker(scene.size(), [duel = std::make_shared<Duel>(scene, rings, tolerance)](std::size_t i) {
    return duel->answer(i);
  });
}

}  // namespace

std::vector<Contestant> libccd_contestants() {
  return {{.name = "libccd-hull",
           .label = "libccd, hull",
           .ours = false,
           .kind = Kind::vertices,
           .settings = vertex_counts(),
           .enter = [](const Scene& scene,
                       double vertices) { return enter(scene, rings_of(vertices), hull_tolerance(vertices)); }},
          {.name = "libccd-exact",
           .label = "libccd, exact support",
           .ours = false,
           .kind = Kind::tolerance,
           .settings = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12},
           .enter = [](const Scene& scene, double tolerance) { return enter(scene, 0, tolerance); }}};
}

}  // namespace goishi::verify::bench::contact
