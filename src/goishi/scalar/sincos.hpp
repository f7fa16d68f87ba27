#pragma once
/// \file
/// Sine and cosine of float, double and batches of them by additions and multiplications alone, so that they are the same to
/// the last bit wherever arithmetic is IEEE's and products are not fused into sums. What callers use is in `scalar.hpp`.
///
///     x = k π/2 + r + l,   |r| <= π/4,   l the round-off of r
///     sin x = sin(r + l) cos(k π/2) + cos(r + l) sin(k π/2), and likewise cos x
///
/// The last line is exact: cosine and sine of k π/2 are 0, 1 or −1.
///
/// Error   sine and cosine <= 0.84 ulp in double, 0.86 in float, of every finite number, those beside multiples of π/2 too,
///         rounding to nearest (claims SINE-1, SINE-2); in other modes half an ulp more.
/// Proof   derivations/elementary.cpp.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace goishi::scalar {

/// Of one angle.
template <class T>
struct SineCosine {
  T sin, cos;
};

namespace detail {

template <class T>
concept SimdBatch = requires {
  typename T::abi_type;
  typename T::mask_type;
};

/// The numbers of the reduction and of the two polynomials: π/2 = Σ part[i], each but the last so short that k part[i] is
/// exact for |x| < `range`; (sin r/r − 1)/z and (cos r − 1 + z/2)/z² in z = r², minimax over 0 < r <= π/4 with the weights
/// r/sin r z and z²/cos r, coefficients rounded one by one and the rest fitted again.
template <class T>
struct SincosNumbers;
template <>
struct SincosNumbers<double> {
  static constexpr double range = 0x1p18;
  static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  static constexpr double to_integer = 0x1.8p52;
  static constexpr double most_rest = 0x1.922p-1;  // above π/4 and what 2x/π is off
  static constexpr std::array part = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  static constexpr std::array sine = {-0x1.5555555555548p-3, 0x1.111111110f73p-7,    -0x1.a01a019be9215p-13,
                                      0x1.71de35552b248p-19, -0x1.ae5e4b83b6803p-26, 0x1.5d8b5584bbd9ap-33};
  static constexpr std::array cosine = {0x1.555555555554bp-5,   -0x1.6c16c16c15015p-10, 0x1.a01a019c8f25ap-16,
                                        -0x1.27e4f7f191df1p-22, 0x1.1ee9dbcf97ef5p-29,  -0x1.8fa684f22e5f1p-37};
};
template <>
struct SincosNumbers<float> {
  static constexpr float range = 8192;
  static constexpr float two_over_pi = 0x1.45f306p-1F;
  static constexpr float to_integer = 0x1.8p23F;
  static constexpr float most_rest = 0x1.93p-1F;
  static constexpr std::array part = {0x1.92p0F, 0x1.fb4p-12F, 0x1.444p-24F, 0x1.68c234p-39F};
  static constexpr std::array sine = {-0x1.555546p-3F, 0x1.110778p-7F, -0x1.995406p-13F};
  static constexpr std::array cosine = {0x1.55554ap-5F, -0x1.6c0c28p-10F, 0x1.99e80cp-16F};
};

/// Two numbers in a register.
#if defined(__GNUC__)
#define GOISHI_PAIRS 1
using DoublePair = double __attribute__((vector_size(16)));
using FloatPair = float __attribute__((vector_size(8)));
template <class T>
using Pair = std::conditional_t<std::is_same_v<T, double>, DoublePair, FloatPair>;
using DoublePairBits = std::int64_t __attribute__((vector_size(16)));
using FloatPairBits = std::int32_t __attribute__((vector_size(8)));
[[nodiscard]] inline DoublePair size_of(const DoublePair& x) {  // a cast between vectors keeps the bits
  return DoublePair(DoublePairBits(x) & std::numeric_limits<std::int64_t>::max());
}
[[nodiscard]] inline FloatPair size_of(const FloatPair& x) {
  return FloatPair(FloatPairBits(x) & std::numeric_limits<std::int32_t>::max());
}
#endif

template <class V>
struct LaneOf {
  using type = V;
};
template <SimdBatch V>
struct LaneOf<V> {
  using type = typename V::value_type;
};
#ifdef GOISHI_PAIRS
template <>
struct LaneOf<DoublePair> {
  using type = double;
};
template <>
struct LaneOf<FloatPair> {
  using type = float;
};
#endif
template <class V>
using lane_t = typename LaneOf<V>::type;

template <SimdBatch V>
[[nodiscard]] inline V size_of(const V& x) {
  return abs(x);
}
template <std::floating_point T>
[[nodiscard]] inline T size_of(T x) {
  return std::fabs(x);
}

/// x = k π/2 + r + l.
template <class V>
struct ReducedAngle {
  V k, r, l;
};

/// For a k within 1 of 2x/π, |x| < `range`.
template <class V>
[[nodiscard, gnu::always_inline]] inline ReducedAngle<V> reduced_by(const V& x, const V& k) {
  using Numbers = SincosNumbers<lane_t<V>>;
  constexpr std::size_t last = Numbers::part.size() - 1;
  constexpr auto first = Numbers::part[0], second = Numbers::part[1], before = Numbers::part[last - 1],
                 rest = Numbers::part[last];
  V a = x - k * first;
  if constexpr (last == 3) {
    a = a - k * second;
  }
  const V kb = k * before, kr = k * rest;
  const V b = a - kb, r = b - kr;
  return {.k = k, .r = r, .l = ((a - b) - kb) + ((b - r) - kr)};
}

/// Sine and cosine of a sum, by sine s and cosine c of one angle, S and C of the other.   Proof  derivations/elementary.cpp, as of
/// all below.
template <class V>
[[nodiscard, gnu::always_inline]] inline SineCosine<V> sum_of_angles(const V& s, const V& c, const V& S, const V& C) {
  return {.sin = s * C + c * S, .cos = c * C - s * S};
}

/// Cosine of j quarter turns, and of j − 1 the sine, exactly: j = −3 … 3, more than the −2 … 2 that rounding to nearest leaves
/// of a whole number but for whole turns.
template <class V>
[[nodiscard, gnu::always_inline]] inline V quarter_cosine(const V& j) {
  return size_of(V(size_of(j) - lane_t<V>(2))) - lane_t<V>(1);
}

/// Sine and cosine of r + l, and of the k quarter turns beside it.
template <class V>
[[nodiscard, gnu::always_inline]] inline SineCosine<V> sincos_of(const ReducedAngle<V>& angle) {
  using T = lane_t<V>;
  using Numbers = SincosNumbers<T>;
  // Each by a name of its own, or g++ loads them one by one and makes a register of each.
  constexpr T S0 = Numbers::sine[0], S1 = Numbers::sine[1], S2 = Numbers::sine[2];
  constexpr T C0 = Numbers::cosine[0], C1 = Numbers::cosine[1], C2 = Numbers::cosine[2];
  const V &k = angle.k, &r = angle.r, &l = angle.l;
  const V z = r * r, z2 = z * z, h = z * T(0.5);
  V ps = (S0 + z * S1) + z2 * S2, pc = (C0 + z * C1) + z2 * C2;
  if constexpr (Numbers::sine.size() == 6) {
    constexpr T S3 = Numbers::sine[3], S4 = Numbers::sine[4], S5 = Numbers::sine[5];
    constexpr T C3 = Numbers::cosine[3], C4 = Numbers::cosine[4], C5 = Numbers::cosine[5];
    ps = (S0 + z * S1) + z2 * ((S2 + z * S3) + z2 * (S4 + z * S5));
    pc = (C0 + z * C1) + z2 * ((C2 + z * C3) + z2 * (C4 + z * C5));
  }
  const V s = r + ((r * z) * ps + (l - l * h));
  const V u = T(1) - h;
  const V c = u + (((T(1) - u) - h) + (z2 * pc - r * l));
  const V j = k - ((k + T(4) * Numbers::to_integer) - T(4) * Numbers::to_integer);
  return sum_of_angles(s, c, V(quarter_cosine(V(j - T(1)))), V(quarter_cosine(j)));
}

/// 2^n, −1022 <= n <= 1023.
[[nodiscard]] inline double power_of_two(int n) {
  const std::uint64_t bits = static_cast<std::uint64_t>(n + 1023) << 52;
  double result = 0;
  std::memcpy(&result, &bits, sizeof result);  // libc++ 13 has no bit_cast
  return result;
}

/// x = m 2^n, 1/2 <= m < 1, of a normal number.
[[nodiscard]] inline int exponent_of(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return static_cast<int>(bits >> 52 & 0x7ff) - 1022;
}

/// 2/π = Σ word[n] 2^(32 − 32 n), n = 0, 1, ….
inline constexpr std::array<std::uint64_t, 39> words_of_two_over_pi = {
    0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046};

/// For any finite x of size 2^18 or more, k being −3 … 4, by Payne and Hanek: x = m 2^e, and of the bits of 2/π only 192 count,
/// those before give whole turns; the product with m is one of whole numbers. No double is nearer to a multiple of π/2 than
/// 2^-62 of a quarter turn; here the rest of a quarter turn is right to 2^-128.
[[nodiscard]] inline ReducedAngle<double> reduced_far(double x) {
  constexpr std::uint64_t low_word = 0xffffffff;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  const int e = exponent_of(x) - 53;
  const std::uint64_t m = (bits & 0xfffffffffffff) | 0x10000000000000;

  // The bits e − 1 … e + 190 of 2/π after its point, times m, mod 2^192; the lowest word first.
  std::array<std::uint64_t, 6> product{};
  std::uint64_t carry = 0, before = 0;
  for (std::size_t i = 0; i < product.size(); ++i) {
    const int begin = e + 62 + 32 * (5 - static_cast<int>(i));
    const auto n = static_cast<std::size_t>(begin / 32);
    const std::uint64_t word =
        (words_of_two_over_pi[n] << 32 | words_of_two_over_pi[n + 1]) >> (32 - begin % 32) & low_word;
    const std::uint64_t a = word * (m & low_word), b = before * (m >> 32);
    const std::uint64_t sum = carry + (a & low_word) + (b & low_word);
    product[i] = sum & low_word;
    carry = (sum >> 32) + (a >> 32) + (b >> 32);
    before = word;
  }

  // Two bits of whole quarter turns, then the rest, to the nearer one.
  const std::uint64_t top = product[5] << 32 | product[4], middle = product[3] << 32 | product[2],
                      bottom = product[1] << 32 | product[0];
  double k = static_cast<double>(top >> 62), sign = 1;
  std::uint64_t f1 = top << 2 | middle >> 62, f0 = middle << 2 | bottom >> 62;
  if (f1 >> 63 != 0) {
    k += 1;
    sign = -1;
    f0 = ~f0 + 1;
    f1 = ~f1 + (f0 == 0 ? 1 : 0);
  }
  int shift = 0;
  for (; f1 >> 63 == 0; ++shift) {
    f1 = f1 << 1 | f0 >> 63;
    f0 <<= 1;
  }

  // In radians, by products that are exact: 26 and 27 bits of the rest by 26 and 26 of π/2; what follows is round-off.
  constexpr double p1 = 0x1.921fb5p+0, p2 = 0x1.110b46p-26, p3 = 0x1.1a62633145c07p-54, pi_half = 0x1.921fb54442d18p+0;
  const double unit = sign * power_of_two(-shift - 26);
  const double h1 = unit * static_cast<double>(f1 >> 38);
  const double h2 = unit * power_of_two(-27) * static_cast<double>(f1 >> 11 & 0x7ffffff);
  const double h3 = unit * power_of_two(-80) * static_cast<double>((f1 & 0x7ff) << 42 | f0 >> 22);
  const double most = h1 * p1, next = h1 * p2 + h2 * p1;
  const double sum = most + next, rest = ((most - sum) + next) + (h2 * p2 + ((h1 + h2) * p3 + h3 * pi_half));
  const double r = sum + rest, l = (sum - r) + rest;
  return x < 0 ? ReducedAngle<double>{-k, -r, -l} : ReducedAngle<double>{k, r, l};
}

/// Where the quick reduction does not reach: too far off, k off by one in another rounding mode, no number.
[[nodiscard, gnu::noinline, gnu::cold]] inline SineCosine<double> sincos_seldom(double x) {
  using Numbers = SincosNumbers<double>;
  if (!(size_of(x) <= std::numeric_limits<double>::max())) {
    return {x - x, x - x};
  }
  if (!(size_of(x) < Numbers::range)) {
    return sincos_of(reduced_far(x));
  }
  const double k = (x * Numbers::two_over_pi + Numbers::to_integer) - Numbers::to_integer;
  const double r = reduced_by(x, k).r;
  return sincos_of(reduced_by(x, r < 0 ? k - 1 : k + 1));
}

template <class V>
[[nodiscard]] inline SineCosine<V> sincos(const V& x);

[[nodiscard, gnu::noinline, gnu::cold]] inline SineCosine<float> sincos_seldom(float x) {
  const SineCosine<double> wide = sincos(static_cast<double>(x));
  return {static_cast<float>(wide.sin), static_cast<float>(wide.cos)};
}

/// Whether each lane's `x` and `r` are of a size for the quick reduction.
template <class V>
[[nodiscard, gnu::always_inline]] inline bool reaches(const V& x, const V& r) {
  using Numbers = SincosNumbers<lane_t<V>>;
  const auto near = size_of(x) < Numbers::range, small = size_of(r) < Numbers::most_rest;
  if constexpr (SimdBatch<V>) {
    return all_of(near && small);
  } else if constexpr (std::is_arithmetic_v<V>) {
    return near && small;
  } else {
    const auto both = near & small;
    return (both[0] & both[1]) != 0;
  }
}

/// One by one.
template <class V>
[[nodiscard, gnu::noinline, gnu::cold]] SineCosine<V> sincos_of_lanes(const V& x) {
  using T = lane_t<V>;
  SineCosine<V> result{x, x};
  for (std::size_t i = 0; i < sizeof(V) / sizeof(T); ++i) {
    const SineCosine<T> lane = sincos(static_cast<T>(x[i]));
    result.sin[i] = lane.sin;
    result.cos[i] = lane.cos;
  }
  return result;
}

template <class V>
[[nodiscard, gnu::always_inline]] inline SineCosine<V> sincos(const V& x) {
  using Numbers = SincosNumbers<lane_t<V>>;
  const V k = (x * Numbers::two_over_pi + Numbers::to_integer) - Numbers::to_integer;
  const ReducedAngle<V> angle = reduced_by(x, k);
  if (reaches(x, angle.r)) [[likely]] {
    return sincos_of(angle);
  }
  if constexpr (std::is_arithmetic_v<V>) {
    return sincos_seldom(x);
  } else {
    return sincos_of_lanes(x);
  }
}

/// Of two numbers at once, in one register where the compiler has such.
template <class T>
[[nodiscard]] std::array<SineCosine<T>, 2> sincos(const T& x, const T& y) {
#ifdef GOISHI_PAIRS
  const SineCosine<Pair<T>> both = sincos(Pair<T>{x, y});
  return {{{both.sin[0], both.cos[0]}, {both.sin[1], both.cos[1]}}};
#undef GOISHI_PAIRS
#else
  return {{sincos(x), sincos(y)}};
#endif
}

}  // namespace detail
}  // namespace goishi::scalar
