/// SINE, ATAN: sine, cosine and arctangent of our own, in float and double, against Arb's, which has its own ways to them.

#include <fmt/format.h>

#include <cmath>
#include <goishi/scalar.hpp>
#include <limits>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/ball.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

template <class T>
void see_angle(const Context& context, Worst& check, T x) {
  const auto [s, c] = scalar::sincos(x);
  const Ball exact(x);
  const auto describe = [&] { return fmt::format("x = {:a}", x); };
  check.see(ulps(context.produced(s), sin(exact)), describe);
  check.see(ulps(context.produced(c), cos(exact)), describe);
}

/// Both signs, exponents from `low` to `high`.
template <class T>
[[nodiscard]] T any_angle(Context& context, double low, double high) {
  const double size = std::exp2(context.uniform(low, high));
  const auto x = static_cast<T>(std::fmin(size, static_cast<double>(std::numeric_limits<T>::max())));
  return context.uniform(-1.0, 1.0) < 0 ? -x : x;
}

/// The number that is nearest to k π/2, and its three neighbours on either side.
template <class T>
void see_multiple(const Context& context, Worst& check, double k) {
  auto x = static_cast<T>(Ball(k) * scalar::pi<Ball>() / Ball(2));
  for (int i = 0; i < 3; ++i) {
    x = std::nextafter(x, T(0));
  }
  for (int i = 0; i < 7; ++i) {
    see_angle(context, check, x);
    x = std::nextafter(x, std::numeric_limits<T>::max());
  }
}

/// `near`: the exponent up to which the argument is reduced in its own type.
template <class T>
Measurement measure_sine(Context& context, double near, double most) {
  Checks checks;
  for (int i = 0; i < context.samples(20'000, 400'000); ++i) {
    see_angle(context, checks["near"], any_angle<T>(context, i % 2 == 0 ? near - 4.0 : -30.0, near));
    if (i % 4 == 0) {
      see_angle(context, checks["far"], any_angle<T>(context, near, most));
    }
  }
  const double last = std::floor(std::exp2(near) * 2.0 / 3.141592653589793);
  const double step = std::fmax(1.0, std::floor(last / context.samples(1000, 200'000)));
  for (double k = 1.0; k <= last; k += step) {
    see_multiple<T>(context, checks["beside multiples of π/2"], k);
  }
  for (int i = 0; i < context.samples(500, 5000); ++i) {
    see_multiple<T>(context, checks["beside multiples of π/2"],
                    std::floor(std::exp2(context.uniform(near, std::fmin(most, 100.0) - 1.0))));
  }
  return checks.measurement();
}

template <class T>
void see_directions(Context& context, Checks& checks, int count) {
  const char* const name = std::is_same_v<T, double> ? "double" : "float";
  constexpr double reach = std::numeric_limits<T>::max_exponent - 1;
  for (int i = 0; i < count; ++i) {
    const double angle = context.uniform(-3.15, 3.15);
    T x = static_cast<T>(std::cos(angle)), y = static_cast<T>(std::sin(angle));
    if (i % 3 == 1) {  // of any size
      x = any_angle<T>(context, -reach, reach);
      y = static_cast<T>(static_cast<double>(x) * context.uniform(-2.0, 2.0));
    } else if (i % 3 == 2) {  // next to the axes
      x = any_angle<T>(context, -0.5 * reach, 0.5 * reach);
      y = any_angle<T>(context, -0.5 * reach, 0.5 * reach);
    }
    if (std::isfinite(x) && std::isfinite(y)) {
      checks[name].see(ulps(context.produced(scalar::atan2(y, x)), atan2(Ball(y), Ball(x))),
                       [&] { return fmt::format("y = {:a}, x = {:a}", y, x); });
    }
  }
}

}  // namespace

std::vector<Claim> elementary_claims() {
  const auto sine_checks = [](double bound, const std::string& reason) {
    return std::vector<Check>{within("near", bound, "ulp", reason, 0.5), within("far", bound, "ulp", reason, 0.5),
                              within("beside multiples of π/2", bound, "ulp", reason, 0.5)};
  };
  return {
      {.id = "SINE-1",
       .statement =
           "Sine and cosine of every finite double are right to 0.84 ulp: up to 2^18, beyond it to 2^1024, and "
           "beside multiples of π/2.",
       .function = "scalar::sincos",
       .family = OracleFamily::other_formula,
       .oracle = "Arb's sine and cosine",
       .checks =
           sine_checks(0.84, "0.832 in 5e8 samples by the same algorithm (2026-11); round-off of the kernel near π/4"),
       .measure = [](Context& context) { return measure_sine<double>(context, 18.0, 1024.0); }},
      {.id = "SINE-2",
       .statement = "Sine and cosine of every finite float are right to 0.86 ulp, likewise.",
       .function = "scalar::sincos",
       .family = OracleFamily::other_formula,
       .oracle = "Arb's sine and cosine",
       .checks = sine_checks(0.86, "0.85 of every seventh float by the same algorithm (2026-11)"),
       .measure = [](Context& context) { return measure_sine<float>(context, 13.0, 128.0); }},
      {.id = "ATAN-1",
       .statement =
           "The angle of a direction is right to two ulps in double, and to the nearest float but for a hundredth, "
           "components of any size.",
       .function = "scalar::atan2",
       .family = OracleFamily::other_formula,
       .oracle = "Arb's arctangent",
       .checks = {within("double", 2.0, "ulp", "quotient, polynomial and two sums, half an ulp each", 0.5),
                  within("float", 0.51, "ulp", "computed in double, then rounded", 0.5)},
       .measure = measure_both(see_directions<double>, see_directions<float>, 20'000, 200'000)},
  };
}

}  // namespace goishi::verify
