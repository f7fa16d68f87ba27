#pragma once
/// \file
/// What the claims that walk a domain to its ends share: numbers of any size, rounding modes, refusals.

#include <array>
#include <cfenv>
#include <cmath>
#include <goishi/error.hpp>
#include <limits>
#include <optional>
#include <random>

#include "verify/samples/stone.hpp"
#include "verify/suite/claim.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify {

/// Magnitudes are 10^−reach … 10^reach.
template <class T>
inline constexpr double size_reach = std::numeric_limits<T>::digits < 30 ? 18.0 : 150.0;

inline constexpr std::array rounding_modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// What f gives under a rounding mode, the witness's stays as it is; nothing if it refuses its arguments.
template <class F>
[[nodiscard]] auto answer_of(int mode, F&& f) -> std::optional<decltype(f())> {
  struct Mode {
    explicit Mode(int mode) { std::fesetround(mode); }
    ~Mode() { std::fesetround(FE_TONEAREST); }
  } const held(mode);
  try {
    return f();
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

/// 10^x, x from −reach to reach.
template <class T>
[[nodiscard]] T any_size(std::mt19937_64& random, double reach) {
  return static_cast<T>(std::pow(10.0L, std::uniform_real_distribution<double>(-reach, reach)(random)));
}

/// By how much |q|² or |n|² may be off 1, and nearly is: in ε.
inline constexpr std::array unit_defects = {0, 60, -60};

/// A unit vector, or a quaternion's coefficients, whose square is off 1 by no more than a defect, and by no less than that
/// but for 2 ε: the components are rounded by up to half an ε each, the square by up to one.
template <class T, int rows>
[[nodiscard]] Eigen::Matrix<T, rows, 1> defective(const Eigen::Matrix<T, rows, 1>& unit, int defect) {
  if (defect == 0) {
    return unit;
  }
  using Wide = long double;
  const Wide aim = static_cast<Wide>(defect < 0 ? defect + 1 : defect - 1) * std::numeric_limits<T>::epsilon();
  const auto wide = unit.template cast<Wide>();
  return Eigen::Matrix<T, rows, 1>((std::sqrt((1 + aim) / wide.squaredNorm()) * wide).template cast<T>());
}

/// Widths of any size, denormal ones too; heights down to nothing of it, or in the strata of `draw_shape`, whose ball,
/// near-ball and bevels up to the height are exact.
template <class T>
[[nodiscard]] ShapeSample<T> draw_any_shape(Context& context, int i) {
  ShapeSample<T> shape = draw_shape<T>(context.random(), i);
  const T size =
      i % 50 == 49 ? std::numeric_limits<T>::denorm_min() * T(1000) : any_size<T>(context.random(), size_reach<T>);
  shape.width *= size;
  shape.height *= size;
  shape.bevel = i % 4 == 0 ? T(0) : shape.bevel * size;
  if (i % 6 == 5) {
    shape.height = std::min(shape.width, any_size<T>(context.random(), size_reach<T>));
    shape.bevel = std::min(shape.bevel, shape.height / T(2));
  }
  return shape;
}

/// Attitudes whose zeros are exact, and any, as far off the unit sphere as is let through.
template <class T>
[[nodiscard]] Quat<T> draw_defective(Context& context, int i) {
  Quat<T> q(T(1), T(0), T(0), T(0));
  if (i % 4 == 1) {
    const T root = std::sqrt(T(1) / T(2));
    q = Quat<T>(root, T(0), root, T(0));
  } else if (i % 4 == 2) {
    q = Quat<T>(T(0.5), T(-0.5), T(0.5), T(0.5));
  } else if (i % 4 == 3) {
    q = draw_attitude(context.random()).template cast<T>().normalized();
  }
  const int defect = unit_defects[static_cast<std::size_t>(i / 4) % unit_defects.size()];
  q.coeffs() = defective<T, 4>(q.coeffs(), defect);
  return q;
}

/// Directions along an axis to the bit, across one, with a component that is next to nothing, any; as far off the unit
/// sphere.
template <class T>
[[nodiscard]] Vec3<T> draw_defective_direction(Context& context, int i) {
  const T sign = i % 8 < 4 ? T(1) : T(-1), least = std::numeric_limits<T>::denorm_min();
  const Vec3<T> any = (draw_attitude(context.random()) * Vec3<double>(0.0, 0.0, 1.0)).template cast<T>().normalized();
  const T root = std::sqrt(T(1) / T(2)), small = any_size<T>(context.random(), size_reach<T>);
  const std::array<Vec3<T>, 4> all = {Vec3<T>(sign, T(0), T(-0.0)), Vec3<T>(sign * root, -root, T(0)),
                                      Vec3<T>(sign, i % 3 == 0 ? least : std::fmin(small, T(1e-3)), -least), any};
  const Vec3<T> u = all[static_cast<std::size_t>(i) % all.size()];
  const Vec3<T> turned(u[(i / 4) % 3], u[(i / 4 + 1) % 3], u[(i / 4 + 2) % 3]);
  return defective<T, 3>(turned.normalized(), unit_defects[static_cast<std::size_t>(i / 4) % unit_defects.size()]);
}

/// Whether a type of this range holds an exact value as a normal number.
template <class T, class Exact>
[[nodiscard]] bool holds(const Exact& value) {
  return Exact(std::numeric_limits<T>::min()) <= value && value <= Exact(std::numeric_limits<T>::max());
}

}  // namespace goishi::verify
