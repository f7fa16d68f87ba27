#pragma once
/// \file
/// The two tiers of templates, and the constants that are exact in every scalar.
///
/// A *formula* is a template on `Field` or `Elementary`: no branch, no decimal literal, constants built from integers
/// (`T(2) / T(5)`). The same source then runs on float and double, on SIMD batches, on 50-digit numbers, on intervals
/// and on symbolic expressions. An *algorithm* is a template on `Ordered`: it may compare, iterate and choose.
///
/// Formulas stand in namespace `goishi::formula`; what stands in `goishi` itself validates, chooses the formula that
/// fits, evaluates it in the next wider type (`scalar::wider_t`) where that is worth its cost, and rounds once.

#include <array>
#include <cfloat>
#include <cmath>
#include <concepts>
#include <goishi/scalar/arctangent.hpp>
#include <goishi/scalar/double_double.hpp>
#include <goishi/scalar/sincos.hpp>
#include <limits>
#include <numbers>
#include <type_traits>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Goishi: -ffast-math and -ffinite-math-only break NaN checks and well-conditioned formulas; build without them"
#endif

// Nothing else tells at compile time whether products are fused into sums: GNU and Clang need -ffp-contract=off, and GNU, where
// the processor can fuse, -fno-tree-slp-vectorize too. The CMake target carries both.
#if (defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0) || defined(_M_FP_FAST) || defined(_M_FP_CONTRACT)
#error "Goishi: float and double must be computed in float and double, not fused, for results to be the same everywhere"
#endif

namespace goishi {

namespace scalar {

namespace detail {
using std::atan2;
using std::cos;
using std::sin;
using std::sqrt;

template <class T>
concept HasElementaryFunctions = requires(const T& x) {
  T(sqrt(x));
  T(sin(x));
  T(cos(x));
  T(atan2(x, x));
};

/// Whose sine and cosine are ours: the same bits everywhere. Symbols, balls and 50 digits keep their own.
template <class T>
concept OwnSine = (std::is_same_v<lane_t<T>, float>) ||
                  (std::is_same_v<lane_t<T>, double>) || std::is_same_v<T, DoubleDouble>;
}  // namespace detail

/// False for SIMD batches under clang with AVX-512: there libstdc++'s `where()` silently does nothing and `sin` is
/// wrong in the first digit. Such a batch is no `Field`, so a formula refuses it at compile time. Use g++, or
/// -march=x86-64-v3.
template <class T>
concept WorkingBatch =
#if defined(__clang__) && defined(__AVX512F__)
    !detail::SimdBatch<T>;
#else
    true;
#endif

}  // namespace scalar

/// + − × ÷ and integers: all that a rational formula may ask for. The integers themselves have another ÷.
template <class T>
concept Field = std::copyable<T> && !std::integral<T> && scalar::WorkingBatch<T> && requires(const T& x, const T& y) {
  T(2);
  T(x + y);
  T(x - y);
  T(x * y);
  T(x / y);
  T(-x);
};

/// A field with sqrt, sin, cos and atan2, found by argument-dependent lookup or in `std`.
template <class T>
concept Elementary = Field<T> && scalar::detail::HasElementaryFunctions<T>;

/// An elementary scalar whose `<` gives a `bool`. Batches (a mask), intervals (undecided) and symbols (a relation) are
/// not.
template <class T>
concept Ordered = Elementary<T> && requires(const T& x, const T& y) {
  { x < y } -> std::same_as<bool>;
};

namespace scalar {

template <Elementary T>
[[nodiscard]] T sqrt(const T& x) {
  using std::sqrt;
  return T(sqrt(x));
}

/// Sine and cosine of one angle   [rad]: as quick as one of them.
/// Domain  any number; those that are not finite give NaN.   Error  of float, double and batches <= 0.86 ulp (SINE-1, SINE-2).
template <Elementary T>
[[nodiscard]] SineCosine<T> sincos(const T& x) {
  if constexpr (detail::OwnSine<T>) {
    return detail::sincos(x);
  } else {
    using std::sin, std::cos;
    return {.sin = T(sin(x)), .cos = T(cos(x))};
  }
}

/// Of two angles at once, hardly slower than of one: to the bit what one after the other gives.
template <Elementary T>
[[nodiscard]] std::array<SineCosine<T>, 2> sincos(const T& x, const T& y) {
  if constexpr (std::floating_point<T> && detail::OwnSine<T>) {
    return detail::sincos(x, y);
  } else {
    return {{scalar::sincos(x), scalar::sincos(y)}};
  }
}

template <Elementary T>
[[nodiscard]] T sin(const T& x) {
  if constexpr (detail::OwnSine<T>) {
    return detail::sincos(x).sin;
  } else {
    using std::sin;
    return T(sin(x));
  }
}

template <Elementary T>
[[nodiscard]] T cos(const T& x) {
  if constexpr (detail::OwnSine<T>) {
    return detail::sincos(x).cos;
  } else {
    using std::cos;
    return T(cos(x));
  }
}

/// The angle of (x, y) from the x axis, −π … π   [rad].
/// Domain  as of `std::atan2`, zeros and infinities too.   Error  of float, double and batches <= 2 ulp (ATAN-1).
template <Elementary T>
[[nodiscard]] T atan2(const T& y, const T& x) {
  if constexpr (detail::OwnSine<T>) {
    return detail::own_atan2(y, x);
  } else {
    using std::atan2;
    return T(atan2(y, x));
  }
}

/// π in the arithmetic of T: correctly rounded for built-in types, else atan2(0, −1), which is π itself for a symbolic
/// type and an enclosure of π for intervals.
template <Elementary T>
[[nodiscard]] constexpr T pi() {
  if constexpr (std::floating_point<T>) {
    return std::numbers::pi_v<T>;
  } else if constexpr (detail::SimdBatch<T>) {
    return T(std::numbers::pi_v<typename T::value_type>);
  } else if constexpr (requires { T::pi(); }) {
    return T::pi();
  } else {
    return scalar::atan2(T(0), T(-1));
  }
}

template <Field T>
[[nodiscard]] constexpr T sq(const T& x) {
  return T(x * x);
}

/// |x|, without a branch where T is built in: a sign is as good as random. By T's own `abs` where it has one: of a ball about 0
/// there is no sign to choose by.
template <Ordered T>
[[nodiscard]] constexpr T abs(const T& x) {
  using std::abs;
  if constexpr (requires { T(abs(x)); }) {
    return T(abs(x));
  } else {
    return x < T(0) ? T(-x) : x;
  }
}

/// x >= 0 with the sign of s, of −0 too where T is built in; without a branch there.
template <Ordered T>
[[nodiscard]] constexpr T signed_as(const T& x, const T& s) {
  if constexpr (std::floating_point<T>) {
    return std::copysign(x, s);
  } else {
    return s < T(0) ? T(-x) : x;
  }
}

template <Ordered T>
[[nodiscard]] constexpr T min(const T& x, const T& y) {
  return y < x ? y : x;
}

template <Ordered T>
[[nodiscard]] constexpr T max(const T& x, const T& y) {
  return x < y ? y : x;
}

/// What a physical value holds until it is set: NaN where T has one.
template <class T>
[[nodiscard]] constexpr T unset() {
  if constexpr (std::numeric_limits<T>::has_quiet_NaN) {
    return std::numeric_limits<T>::quiet_NaN();
  } else if constexpr (detail::SimdBatch<T>) {
    return T(std::numeric_limits<typename T::value_type>::quiet_NaN());
  } else {
    return T(0);
  }
}

/// The least normal number of T, added under a root so that 0/0 becomes its limit without a branch. Zero where T has
/// none (symbols, intervals): there the limit has to be taken by who asks for it.
template <class T>
[[nodiscard]] constexpr T tiny() {
  if constexpr (std::numeric_limits<T>::is_specialized) {
    return std::numeric_limits<T>::min();
  } else if constexpr (detail::SimdBatch<T>) {
    return T(std::numeric_limits<typename T::value_type>::min());
  } else {
    return T(0);
  }
}

namespace detail {
template <class T>
struct Wider {
  using type = T;
};
template <>
struct Wider<float> {
  using type = double;
};
template <>
struct Wider<double> {
  using type = DoubleDouble;
};
}  // namespace detail

/// The type in which an algorithm evaluates a short formula before it rounds once to T: float → double → two doubles; every
/// other scalar stays as it is. Never `long double`, which has other digits on every platform.
template <class T>
using wider_t = typename detail::Wider<T>::type;

/// x y in a type that may be wider: exactly, in the next wider one.
template <class Wide, Field T>
[[nodiscard]] constexpr Wide product(const T& x, const T& y) {
  if constexpr (std::same_as<T, double> && std::same_as<Wide, DoubleDouble>) {
    return DoubleDouble::product(x, y);
  } else {
    return Wide(Wide(x) * Wide(y));
  }
}

/// An n with which fifth powers of x 2^-n are far from the ends of the range of double: 0 for 2^-100 <= x < 2^100, else that of
/// x. 0 of a scalar that is not built in, the exponents of which have room enough.
/// Domain  x > 0 and finite.
template <Field T>
[[nodiscard]] int far_exponent(const T& x) {
  if constexpr (std::floating_point<T>) {
    const int n = detail::exponent_of(static_cast<double>(x));
    return -100 < n && n <= 100 ? 0 : n;
  } else {
    return 0;
  }
}

/// x 2^n, rounded once.
template <Field T>
[[nodiscard]] T scaled(const T& x, int n) {
  if constexpr (std::floating_point<T>) {
    if (n != 0) [[unlikely]] {
      return static_cast<T>(std::ldexp(static_cast<double>(x), n));
    }
  }
  return x;
}

namespace detail {
template <class... Ts>
struct Promoted {};
template <Ordered T>
struct Promoted<T> {
  using type = T;
};
template <std::integral T>
struct Promoted<T> {
  using type = double;
};
template <class T, class U, class... Ts>
requires std::integral<T> || std::integral<U> || std::same_as<T, U>
struct Promoted<T, U, Ts...> : Promoted<std::conditional_t<std::integral<T>, U, T>, Ts...> {
};

template <class... Ts>
concept AnyInteger = (std::integral<Ts> || ...);
}  // namespace detail

/// The one scalar of several plain arguments: whole numbers count as what stands beside them, and as double where there is
/// nothing else. Two different scalars have none: which of them was meant is not for a function to say.
template <class... Ts>
using promoted_t = typename detail::Promoted<Ts...>::type;

/// Rounding to nearest is meant where a function says that it refuses what overflows: towards zero, infinity is a number.
template <Ordered T>
[[nodiscard]] constexpr bool is_finite(const T& x) {
  const T zero = T(x - x);  // NOLINT(misc-redundant-expression): NaN for NaN and for ±infinity, and NaN is not below 1
  return zero < T(1);
}

}  // namespace scalar
}  // namespace goishi
