#pragma once
/// \file
/// The one stratified list of shapes that accuracy, laws and quadrature draw from.

#include <array>
#include <cmath>
#include <goishi/rotation.hpp>
#include <goishi/shape/catalogue.hpp>
#include <random>
#include <sstream>
#include <string>

namespace goishi::verify {

/// Inputs in T's own grid, to be taken as exact.
template <class T>
struct ShapeSample {
  T width;
  T height;
  T bevel;  // > 0
};

/// The domain's corners on purpose: h/w thin to 1e-9, ordinary, near the ball (1 − h/w from 1e-9 up, or one ulp of T),
/// the ball itself; b/h from 1e-12, ordinary, near 1 (1 − b/h from 1e-9 up, or one ulp of T). Width in two binades, so
/// that every mantissa occurs. Sample i visits the strata in turn.
template <class T>
[[nodiscard]] ShapeSample<T> draw_shape(std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto decades = [&](double span) { return std::pow(10.0, -span * unit(random)); };
  const T one = 1;
  const T w = static_cast<T>(0.5 + 1.5 * unit(random));
  T h = w;
  switch (i % 5) {
    case 0:
      h = static_cast<T>(static_cast<double>(w) * decades(9.0));
      break;
    case 1:
      h = static_cast<T>(static_cast<double>(w) * (0.05 + 0.95 * unit(random)));
      break;
    case 2:
      h = w * (one - static_cast<T>(decades(9.0)));
      break;
    case 3:
      h = static_cast<T>(static_cast<double>(w) * (0.28 + 0.25 * unit(random)));  // as in the catalogue
      break;
    default:
      break;  // the ball
  }
  h = h < w ? h : w;
  T b = h;
  switch ((i / 5) % 3) {
    case 0:
      b = static_cast<T>(static_cast<double>(h) * decades(12.0));
      break;
    case 1:
      b = static_cast<T>(static_cast<double>(h) * (0.001 + 0.998 * unit(random)));
      break;
    default:
      b = h * (one - static_cast<T>(decades(9.0)));
      break;
  }
  if (!(b < h)) {
    b = std::nextafter(h, T(0));
  }
  return {w, h, b};
}

/// Shapes for oracles in double: h/w from 0.05 to 0.98, b/h from 0.01 to 0.95.
[[nodiscard]] inline ShapeSample<double> draw_ordinary_shape(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double w = 0.5 + 1.5 * unit(random);
  const double h = w * (0.05 + 0.93 * unit(random));
  return {w, h, h * (0.01 + 0.94 * unit(random))};
}

/// Attitudes to the bit: the identity, half turns, thirds of a turn. Their products with a vector are exact.
inline const std::array<Quat<double>, 6> exact_attitudes = {
    Quat<double>(1.0, 0.0, 0.0, 0.0), Quat<double>(0.0, 1.0, 0.0, 0.0),  Quat<double>(0.0, 0.0, -1.0, 0.0),
    Quat<double>(0.5, 0.5, 0.5, 0.5), Quat<double>(0.5, -0.5, 0.5, 0.5), Quat<double>(0.0, 0.0, 0.0, 1.0)};

/// Evenly distributed over all attitudes.
[[nodiscard]] inline Quat<double> draw_attitude(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quat<double>(normal(random), normal(random), normal(random), normal(random)).normalized();
}

template <class T>
[[nodiscard]] std::string describe(const ShapeSample<T>& shape) {
  std::ostringstream text;
  text << std::hexfloat << "w = " << shape.width << ", h = " << shape.height << ", b = " << shape.bevel;
  text << std::defaultfloat << " (h/w = " << shape.height / shape.width << ", b/h = " << shape.bevel / shape.height
       << ')';
  return text.str();
}

/// Calls f(stone, name) for every catalogue stone, by every standard.
template <class F>
void for_each_catalogue_stone(F&& f) {
  for (const Standard standard : standards) {
    for (const catalogue::Size& size : catalogue::sizes) {
      for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
        f(catalogue_stone(size.number, color, standard), std::string("size ") + std::to_string(size.number) + " " +
                                                             std::string(to_string(color)) + ", " +
                                                             std::string(to_string(standard)));
      }
    }
  }
}

}  // namespace goishi::verify
