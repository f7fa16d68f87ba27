#include "verify/samples/contact.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "verify/samples/attitude.hpp"

namespace goishi::verify {

double draw_small(Context& context, double span) {
  return std::pow(10.0, -span * context.uniform(0.0, 1.0));
}

Vec3<double> draw_unit(Context& context) {
  return draw_attitude(context.random()) * Vec3<double>::UnitZ();
}

Specimen draw_specimen(Context& context, int i, double thinnest) {
  ShapeSample<double> shape = draw_shape<double>(context.random(), i / 3);
  if (shape.height < thinnest * shape.width) {
    const double taller = shape.width * std::pow(thinnest, context.uniform(0.0, 1.0));
    shape.bevel = std::fmin(taller * (shape.bevel / shape.height), std::nextafter(taller, 0.0));
    shape.height = taller;
  }
  if (i % 3 == 0) {
    shape.bevel = 0.0;
  }
  return {shape, make_stone(shape.width, shape.height, shape.bevel)};
}

Specimen draw_stone(Context& context, int i) {
  const double w = 0.022;
  ShapeSample<double> shape{w, 0.0092, 0.001};
  switch (i % 6) {
    case 0:
      break;
    case 1:
      shape.bevel = 0.0;
      break;
    case 2:
      shape.height = w * draw_small(context, 3.0);
      shape.bevel = context.uniform(0.0, 1.0) < 0.5 ? 0.0 : shape.height * context.uniform(0.01, 0.9);
      break;
    case 3:
      shape.height = w;
      shape.bevel = context.uniform(0.0, 1.0) < 0.5 ? 0.0 : w * context.uniform(0.01, 0.9);
      break;
    case 4:
      shape.height = w * (1.0 - draw_small(context, 9.0));
      shape.bevel = 0.1 * shape.height;
      break;
    default:
      shape.width = w * context.uniform(0.5, 2.0);
      shape.height = shape.width * context.uniform(0.05, 0.98);
      shape.bevel = shape.height * context.uniform(0.01, 0.95);
      break;
  }
  return {shape, make_stone(shape.width, shape.height, shape.bevel)};
}

Vec3<double> draw_normal(Context& context, const Stone<double>& stone, int i) {
  const double azimuth = context.uniform(-3.2, 3.2);
  const auto at = [&](double radial, double axial) {
    return Vec3<double>(radial * std::cos(azimuth), radial * std::sin(azimuth), axial).normalized();
  };
  const double side = i % 2 == 0 ? 1.0 : -1.0;
  const double joint = std::atan2(stone.joint_cosine, stone.joint_sine);  // of the cap, from the axis
  switch (i % 7) {
    case 0:
      return at(draw_small(context, 18.0), side);
    case 1:
      return at(1.0, side * draw_small(context, 18.0));
    case 2:
      return (i / 7) % 2 == 0 ? Vec3<double>(0.0, 0.0, side) : Vec3<double>(side, 0.0, 0.0);
    case 3: {
      const double angle = joint * (1.0 + (i % 4 < 2 ? 1.0 : -1.0) * draw_small(context, 17.0));
      return at(std::sin(angle), side * std::cos(angle));
    }
    case 4: {
      const double angle = joint * context.uniform(0.0, 1.0);
      return at(std::sin(angle), side * std::cos(angle));
    }
    default:
      return draw_unit(context);
  }
}

Hull<Digits50> hull_of(const Specimen& specimen) {
  return construct_hull(specimen.shape.width, specimen.shape.height, specimen.shape.bevel);
}

Standing standing(const Hull<long double>& hull, const Pose<double>& pose) {
  const Quat<long double> q = pose.q_WB.cast<long double>().normalized();
  return {hull, triple(pose.p_WB), triple(Vec3<long double>(q * Vec3<long double>::UnitZ()))};
}

Exact3 exact(const Vec3<double>& v) {
  return {Digits50(v.x()), Digits50(v.y()), Digits50(v.z())};
}

PlaneCase draw_plane_case(Context& context, int i) {
  PlaneCase drawn{draw_specimen(context, i, 1e-9), {}, {}, 0.0, {}, {}};
  const double width = outer_width(drawn.specimen.stone);
  drawn.plane = {.n_W = i % 2 == 0 ? Vec3<double>(0.0, 0.0, 1.0) : draw_unit(context),
                 .offset = i % 4 == 0 ? 0.0 : width * context.uniform(-3.0, 3.0)};
  // The attitude turns a normal of every stratum of the stone into the plane's.
  const Vec3<double> n_B = draw_normal(context, drawn.specimen.stone, i / 2);
  const Quat<double> q = turn_between(n_B, drawn.plane.n_W);
  drawn.pose = {.p_WB = width / draw_small(context, i % 3 == 0 ? 3.0 : 0.0) * draw_unit(context), .q_WB = q};
  drawn.scale = std::max({width, drawn.pose.p_WB.norm(), std::fabs(drawn.plane.offset)});

  const Digits50 w(q.w()), x(q.x()), y(q.y()), z(q.z());
  const Digits50 square = w * w + x * x + y * y + z * z;
  const Exact3 u(2 * (x * z + w * y) / square, 2 * (y * z - w * x) / square, 1 - 2 * (x * x + y * y) / square);
  const Exact3 n = exact(drawn.plane.n_W) / Digits50(sqrt(exact(drawn.plane.n_W).squaredNorm()));
  const Digits50 axial = u.dot(n);
  const Exact3 across = n - axial * u;
  const Digits50 radial = sqrt(across.squaredNorm());
  const auto [rho, height] = farthest(hull_of(drawn.specimen), radial, axial);
  const Exact3 direction = radial > 0 ? Exact3(across / radial) : Exact3(Exact3::Zero());
  drawn.gap = n.dot(exact(drawn.pose.p_WB)) - Digits50(drawn.plane.offset) - (rho * radial + height * axial);
  drawn.lowest = exact(drawn.pose.p_WB) - rho * direction - height * u;
  return drawn;
}

std::string describe(const Vec3<double>& v) {
  std::ostringstream text;
  text << std::hexfloat << '(' << v.x() << ", " << v.y() << ", " << v.z() << ')';
  return text.str();
}

std::string describe(const Specimen& specimen) {
  return describe(specimen.shape);
}

std::string describe(const Specimen& specimen, const Pose<double>& pose) {
  std::ostringstream text;
  text << describe(specimen.shape) << ", p = " << describe(pose.p_WB) << std::hexfloat << ", q = (" << pose.q_WB.w()
       << ", " << pose.q_WB.x() << ", " << pose.q_WB.y() << ", " << pose.q_WB.z() << ')';
  return text.str();
}

std::string describe(const PlaneCase& drawn) {
  std::ostringstream text;
  text << describe(drawn.specimen, drawn.pose) << ", n = " << describe(drawn.plane.n_W) << std::hexfloat
       << ", offset = " << drawn.plane.offset;
  return text.str();
}

}  // namespace goishi::verify
