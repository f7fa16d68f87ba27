/// TENSOR: any point, any frame, and back to principal axes.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <goishi/mass/tensor.hpp>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

Vec3<double> draw_position(Context& context, double reach) {
  return {context.uniform(-reach, reach), context.uniform(-reach, reach), context.uniform(-reach, reach)};
}

double difference(const Mat3<double>& computed, const Mat3<double>& expected) {
  return (computed - expected).cwiseAbs().maxCoeff() / expected.trace();
}

Measurement over_stones(Context& context, int count,
                        const std::function<double(const MassProperties<double>&, double)>& error) {
  Worst worst;
  for (int i = 0; i < count; ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const MassProperties<double> body =
        mass_properties(make_stone(shape.width, shape.height, shape.bevel), Density{1.0});
    worst.see(error(body, shape.width), [&] { return describe(shape); });
  }
  return worst.measurement();
}

Measurement measure_equivariance(Context& context) {
  return over_stones(context, context.samples(2000, 20000), [&](const MassProperties<double>& body, double width) {
    const Quat<double> q_WB = draw_attitude(context.random());
    const Quat<double> q_VW = draw_attitude(context.random());
    const Vec3<double> p_WB = draw_position(context, width);
    const Mat3<double> in_W = context.produced(inertia_tensor(body, q_WB, p_WB).eval());
    const Mat3<double> in_V = inertia_tensor(body, (q_VW * q_WB).normalized(), Vec3<double>(q_VW * p_WB));
    const Mat3<double> R = q_VW.toRotationMatrix();
    return difference(R * in_W * R.transpose(), in_V);
  });
}

/// Six point masses of m/6, two on each axis where they have the stone's second moments, moved one by one.
Measurement measure_parallel_axes(Context& context) {
  return over_stones(context, context.samples(2000, 5000), [&](const MassProperties<double>& body, double width) {
    using Real = Digits50;
    const Quat<double> q_WB = draw_attitude(context.random());
    const Vec3<double> p_WB = draw_position(context, 2.0 * width);
    // Second moments along the axes, from ∫x² + ∫y² = I_a and ∫y² + ∫z² = I_t.
    const Real m(body.mass);
    const Real across = Real(body.moments.axial) / 2;
    const Real along = Real(body.moments.transverse) - across;
    const std::array<Real, 3> reach = {sqrt(across * 3 / m), sqrt(across * 3 / m), sqrt(along * 3 / m)};
    Quat<Real> q(Real(q_WB.w()), Real(q_WB.x()), Real(q_WB.y()), Real(q_WB.z()));
    q.normalize();
    Mat3<Real> sum = Mat3<Real>::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int sign : {-1, 1}) {
        Vec3<Real> x_B = Vec3<Real>::Zero();
        x_B[axis] = Real(sign) * reach[static_cast<std::size_t>(axis)];
        const Vec3<Real> x_W = Vec3<Real>(q * x_B) + p_WB.cast<Real>();
        sum += (m / 6) * (x_W.dot(x_W) * Mat3<Real>::Identity() - x_W * x_W.transpose());
      }
    }
    return difference(context.produced(inertia_tensor(body, q_WB, p_WB).eval()), sum.cast<double>());
  });
}

Measurement measure_physical(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(20000, 200000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    for (const double bevel : {0.0, shape.bevel}) {
      const Stone<double> stone = make_stone(shape.width, shape.height, bevel);
      const Moments<double> moments = mass_properties(stone, Density{1.0}).moments;
      // Positive, and I_a <= I_t + I_t: the thin stone is a lamina, where they are equal.
      const bool positive = moments.axial > 0.0 && moments.transverse > 0.0;
      const double excess = context.produced(moments.axial) / (2.0 * moments.transverse) - 1.0;
      const bool lamina = bevel == 0.0 && shape.height < 1e-8 * shape.width;
      checks["ratio"].see(lamina ? std::fabs(excess) : std::max(excess, 0.0), [&] { return describe(shape); });
      const char* broken = broken_inertia_rule<double>({moments.transverse, moments.transverse, moments.axial});
      see_choice(checks["bodies"], positive && broken == nullptr, [&] { return describe(shape); });
    }
  }
  return checks.measurement();
}

Measurement measure_principal_axes(Context& context) {
  Checks checks;
  for (int i = 0; i < context.samples(2000, 20000); ++i) {
    const auto shape = draw_shape<double>(context.random(), i);
    const MassProperties<double> body =
        mass_properties(make_stone(shape.width, shape.height, shape.bevel), Density{1.0});
    const Mat3<double> tensor =
        inertia_tensor(body, draw_attitude(context.random()), Vec3<double>(Vec3<double>::Zero()));
    const PrincipalAxes<double> axes = principal_axes(tensor);
    const Mat3<double> R = context.produced(axes.R_WP);
    const Vec3<double> found = context.produced(axes.moments);
    // The moments: the transverse one twice, the axial one, ascending.
    Vec3<double> expected(body.moments.transverse, body.moments.transverse, body.moments.axial);
    std::sort(expected.data(), expected.data() + 3);
    const auto see = [&](const char* check, double error) {
      checks[check].see(error, [&] { return describe(shape); });
    };
    see("tensor", difference(R * found.asDiagonal() * R.transpose(), tensor));
    see("moments", (found - expected).cwiseAbs().maxCoeff() / tensor.trace());
    see("rotation",
        (R.transpose() * R - Mat3<double>::Identity()).cwiseAbs().maxCoeff() + std::fabs(R.determinant() - 1.0));
  }
  return checks.measurement();
}

}  // namespace

std::vector<Claim> tensor_claims() {
  const std::string solver = "Eigen's symmetric solver is backward stable: a small multiple of ε of the norm";
  return {
      {.id = "TENSOR-1",
       .statement = "Turning the world turns the tensor: R I Rᵀ, products of inertia included.",
       .function = "inertia_tensor",
       .family = OracleFamily::relation,
       .oracle = "the stone placed in the turned world",
       .checks = {within("", 16.0 * epsilon, "of the trace", "two rotation matrices (4 ε each) applied on both sides",
                         epsilon)},
       .measure = measure_equivariance},
      {.id = "TENSOR-2",
       .statement = "The tensor about any point is that of an equivalent set of point masses.",
       .function = "inertia_tensor",
       .family = OracleFamily::other_formula,
       .oracle = "six point masses with the stone's second moments, placed one by one and summed in 50 digits",
       .checks = {within("", 8.0 * epsilon, "of the trace", "one rotation matrix (4 ε) applied on both sides",
                         epsilon)},
       .measure = measure_parallel_axes},
      {.id = "TENSOR-3",
       .statement = "Moments are positive and obey the triangle inequality; the thinnest stone is a lamina, I_a = 2 "
                    "I_t, within round-off.",
       .function = "mass_properties, broken_inertia_rule",
       .family = OracleFamily::invariant,
       .oracle = "the inequality",
       .checks = {within("ratio", 8.0 * epsilon, "excess of I_a over 2 I_t",
                         "6 ulp each of two moments that share most of their roundings", epsilon),
                  none("bodies", "moments that are not positive, or refused")},
       .measure = measure_physical},
      {.id = "TENSOR-4",
       .statement = "Principal moments and axes come back from the full tensor, as a rotation.",
       .function = "principal_axes",
       .family = OracleFamily::relation,
       .oracle = "the moments that went in, and the tensor made again from moments and axes",
       .checks = {within("tensor", 12.0 * epsilon, "of the trace",
                         solver + "; measured 2026-11-30 with 40 seeds: up to 2.9 ε", epsilon),
                  within("moments", 12.0 * epsilon, "of the trace",
                         solver + "; measured 2026-11-30 with 40 seeds: up to 3.7 ε", epsilon),
                  within("rotation", 24.0 * epsilon, "absolute",
                         solver + "; measured 2026-11-30 with 40 seeds: up to 9 ε", epsilon)},
       .measure = measure_principal_axes},
  };
}

}  // namespace goishi::verify
