#pragma once
/// \file
/// Two embedded Runge–Kutta pairs for small systems y' = f(y): Dormand and Prince's 5(4), and the additive 4(3) of
/// Kennedy and Carpenter (ARK4(3)6L[2]SA) for a system of which some components are stiff; and a polynomial along a step.
/// Their order conditions are proved in derivations/runge_kutta.cpp.

#include <array>
#include <cstddef>
#include <goishi/scalar.hpp>

namespace goishi {

namespace detail {

template <class T, std::size_t N>
using Array = std::array<T, N>;

/// y + h Σ a_j k_j.
template <class T, std::size_t N, std::size_t M>
[[nodiscard]] Array<T, N> advanced(const Array<T, N>& y, const T& h, const std::array<T, M>& a,
                                   const Array<T, N>* const (&k)[M]) {
  Array<T, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    T sum = a[0] * (*k[0])[i];
    for (std::size_t j = 1; j < M; ++j) {
      sum = sum + a[j] * (*k[j])[i];
    }
    result[i] = y[i] + h * sum;
  }
  return result;
}

/// A trial step: where it ends, the rate there, an estimate of the error, and the rates at the inner stages that the
/// polynomial along it needs, if it has such.
template <class T, std::size_t N>
struct Trial {
  Array<T, N> y;
  Array<T, N> rate;
  Array<T, N> error;
  std::array<Array<T, N>, 4> inner;
  bool bends;
};

/// y along a stretch of time, a polynomial in its share θ from 0 to 1.
template <class T, std::size_t N>
struct Interpolant {
  std::array<Array<T, N>, 6> c;  // of 1, θ, θ² …

  [[nodiscard]] Array<T, N> operator()(const T& theta) const {
    Array<T, N> y;
    for (std::size_t i = 0; i < N; ++i) {
      y[i] = c[0][i] + theta * (c[1][i] + theta * (c[2][i] + theta * (c[3][i] + theta * (c[4][i] + theta * c[5][i]))));
    }
    return y;
  }

  /// By how much each power of s changes component i from θ = a on, at a + s (b − a), s from 0 to 1.
  [[nodiscard]] std::array<T, 5> changes(std::size_t i, const T& a, const T& b) const {
    std::array<T, 6> q;
    for (std::size_t k = 0; k < q.size(); ++k) {
      q[k] = c[k][i];
    }
    for (std::size_t k = 0; k < q.size(); ++k) {  // about a, by Horner's scheme again and again
      for (std::size_t j = q.size() - 1; j-- > k;) {
        q[j] = q[j] + a * q[j + 1];
      }
    }
    std::array<T, 5> result;
    T power(1);
    for (std::size_t k = 0; k < result.size(); ++k) {
      power = power * (b - a);
      result[k] = power * q[k + 1];
    }
    return result;
  }

  /// The same up to θ = `share`, as a stretch of its own.
  [[nodiscard]] Interpolant cut(const T& share) const {
    Interpolant part = *this;
    T power(1);
    for (Array<T, N>& coefficients : part.c) {
      for (T& coefficient : coefficients) {
        coefficient = power * coefficient;
      }
      power = power * share;
    }
    return part;
  }
};

/// The 5(4) pair of Dormand and Prince (1980). `rate` is f(y); the last stage is the first of the next step. `inner` is f,
/// too, for the stages between.
template <Ordered T, std::size_t N, class Inner, class F>
void dormand_prince(const Array<T, N>& y, const Array<T, N>& rate, const T& h, Trial<T, N>& trial, Inner&& inner,
                    F&& f) {
  constexpr std::array<T, 1> a2 = {T(1) / T(5)};
  constexpr std::array<T, 2> a3 = {T(3) / T(40), T(9) / T(40)};
  constexpr std::array<T, 3> a4 = {T(44) / T(45), -T(56) / T(15), T(32) / T(9)};
  constexpr std::array<T, 4> a5 = {T(19372) / T(6561), -T(25360) / T(2187), T(64448) / T(6561), -T(212) / T(729)};
  constexpr std::array<T, 5> a6 = {T(9017) / T(3168), -T(355) / T(33), T(46732) / T(5247), T(49) / T(176),
                                   -T(5103) / T(18656)};
  constexpr std::array<T, 5> b = {T(35) / T(384), T(500) / T(1113), T(125) / T(192), -T(2187) / T(6784), T(11) / T(84)};
  constexpr std::array<T, 6> e = {T(71) / T(57600),      -T(71) / T(16695), T(71) / T(1920),
                                  -T(17253) / T(339200), T(22) / T(525),    -T(1) / T(40)};
  const Array<T, N>& k1 = rate;
  auto& [k3, k4, k5, k6] = trial.inner;
  const Array<T, N> k2 = inner(advanced<T, N>(y, h, a2, {&k1}));
  k3 = inner(advanced<T, N>(y, h, a3, {&k1, &k2}));
  k4 = inner(advanced<T, N>(y, h, a4, {&k1, &k2, &k3}));
  k5 = inner(advanced<T, N>(y, h, a5, {&k1, &k2, &k3, &k4}));
  k6 = inner(advanced<T, N>(y, h, a6, {&k1, &k2, &k3, &k4, &k5}));
  trial.y = advanced<T, N>(y, h, b, {&k1, &k3, &k4, &k5, &k6});
  trial.rate = f(trial.y);
  trial.error = advanced<T, N>(Array<T, N>{}, h, e, {&k1, &k3, &k4, &k5, &k6, &trial.rate});
  trial.bends = true;
}

template <Ordered T, std::size_t N, class F>
void dormand_prince(const Array<T, N>& y, const Array<T, N>& rate, const T& h, Trial<T, N>& trial, F&& f) {
  dormand_prince(y, rate, h, trial, f, f);
}

/// What bends the polynomial along a step of it from the cubic, so that it is of order 4 all the way.
/// Source  Shampine, Math. Comp. 46 (1986) 135; Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I.
template <Ordered T, std::size_t N>
[[nodiscard]] Array<T, N> bend_of(const Trial<T, N>& trial, const Array<T, N>& rate, const T& h) {
  constexpr std::array<T, 6> d = {-T(12715105075) / T(11282082432), T(87487479700) / T(32700410799),
                                  -T(10690763975) / T(1880347072),  T(701980252875) / T(199316789632),
                                  -T(1453857185) / T(822651844),    T(69997945) / T(29380423)};
  const auto& [k3, k4, k5, k6] = trial.inner;
  return trial.bends ? advanced<T, N>(Array<T, N>{}, h, d, {&rate, &k3, &k4, &k5, &k6, &trial.rate}) : Array<T, N>{};
}

/// Through both ends of a stretch of length h, with the rates there: a cubic, and beside it `bend` θ² (1 − θ)².
template <Ordered T, std::size_t N>
[[nodiscard]] Interpolant<T, N> interpolant(const Array<T, N>& from, const Array<T, N>& from_rate,
                                            const Array<T, N>& to, const Array<T, N>& to_rate, const T& h,
                                            const Array<T, N>& bend) {
  Interpolant<T, N> result = {};
  for (std::size_t i = 0; i < N; ++i) {
    const T change = to[i] - from[i], first = h * from_rate[i], last = h * to_rate[i];
    result.c[0][i] = from[i];
    result.c[1][i] = first;
    result.c[2][i] = T(3) * change - T(2) * first - last + bend[i];
    result.c[3][i] = first + last - T(2) * (change + bend[i]);
    result.c[4][i] = bend[i];
  }
  return result;
}

/// The same with the rates at θ = 1/3 and 2/3 too, as they are at the places of the polynomial without them: one order more.
template <Ordered T, std::size_t N, class F>
[[nodiscard]] Interpolant<T, N> sharpened(const Interpolant<T, N>& rough, const T& h, F&& f) {
  Interpolant<T, N> result = rough;
  const T third = T(1) / T(3);
  const Array<T, N> k1 = f(rough(third)), k2 = f(rough(T(2) * third));
  for (std::size_t i = 0; i < N; ++i) {
    const auto slope = [&](const T& x) {
      return rough.c[1][i] + x * (T(2) * rough.c[2][i] + x * (T(3) * rough.c[3][i] + x * T(4) * rough.c[4][i]));
    };
    const T d1 = h * k1[i] - slope(third), d2 = h * k2[i] - slope(T(2) * third);
    // θ² (1 − θ)² (a + b θ) has the slopes d1 and d2 there.
    const T a = T(-27) / T(4) * (d1 + T(2) * d2), b = T(81) / T(4) * (d1 + d2);
    result.c[2][i] = rough.c[2][i] + a;
    result.c[3][i] = rough.c[3][i] + (b - T(2) * a);
    result.c[4][i] = rough.c[4][i] + (a - T(2) * b);
    result.c[5][i] = b;
  }
  return result;
}

/// Tableaux of ARK4(3)6L[2]SA (Kennedy and Carpenter 2003): explicit, implicit, weights and the difference to the
/// embedded ones.
template <class T>
struct AdditiveTableau {
  static constexpr std::size_t stages = 6;
  static constexpr T diagonal = T(1) / T(4);
  static constexpr T E[6][5] = {
      {},
      {T(1) / T(2)},
      {T(13861) / T(62500), T(6889) / T(62500)},
      {-T(116923316275) / T(2393684061468), -T(2731218467317) / T(15368042101831),
       T(9408046702089) / T(11113171139209)},
      {-T(451086348788) / T(2902428689909), -T(2682348792572) / T(7519795681897), T(12662868775082) / T(11960479115383),
       T(3355817975965) / T(11060851509271)},
      {T(647845179188) / T(3216320057751), T(73281519250) / T(8382639484533), T(552539513391) / T(3454668386233),
       T(3354512671639) / T(8306763924573), T(4040) / T(17871)}};
  static constexpr T I[6][5] = {
      {},
      {T(1) / T(4)},
      {T(8611) / T(62500), -T(1743) / T(31250)},
      {T(5012029) / T(34652500), -T(654441) / T(2922500), T(174375) / T(388108)},
      {T(15267082809) / T(155376265600), -T(71443401) / T(120774400), T(730878875) / T(902184768),
       T(2285395) / T(8070912)},
      {T(82889) / T(524892), T(0), T(15625) / T(83664), T(69875) / T(102672), -T(2260) / T(8211)}};
  static constexpr T b[6] = {T(82889) / T(524892), T(0),       T(15625) / T(83664), T(69875) / T(102672),
                             -T(2260) / T(8211),   T(1) / T(4)};
  static constexpr T embedded[6] = {T(4586570599) / T(29645900160), T(0),
                                    T(178811875) / T(945068544),    T(814220225) / T(1159782912),
                                    -T(3700637) / T(11593932),      T(61727) / T(225920)};
};

/// A set of components, for each a bit.
using Components = unsigned;

/// A step of that pair from y, where the rate is `rate`: the components of `stiff` are taken implicitly. A stage is solved
/// by `solve(Y, reach, k)`: of Y_i = Y_i' + reach k_i for its stiff components, Y' given in Y, it leaves the solution in Y
/// and all rates there in k, which comes with those of the stage before as a first guess. False if there is none, and then
/// there is no step. The trial's rate is the last stage's.
template <Ordered T, std::size_t N, class Solve>
[[nodiscard]] bool additive_runge_kutta(const Array<T, N>& y, const Array<T, N>& rate, const T& h, Components stiff,
                                        Trial<T, N>& trial, Solve&& solve) {
  using A = AdditiveTableau<T>;
  Array<T, N> k[A::stages];
  k[0] = rate;
  for (std::size_t i = 1; i < A::stages; ++i) {
    Array<T, N> stage = y;
    for (std::size_t j = 0; j < i; ++j) {
      const T a = h * A::E[i][j], b = h * A::I[i][j];
      for (std::size_t n = 0; n < N; ++n) {
        stage[n] = stage[n] + ((stiff >> n & 1U) != 0 ? b : a) * k[j][n];
      }
    }
    k[i] = k[i - 1];
    if (!solve(stage, T(h * A::diagonal), k[i])) {
      return false;
    }
  }
  for (std::size_t n = 0; n < N; ++n) {
    T sum(0), difference(0);
    for (std::size_t i = 0; i < A::stages; ++i) {
      sum = sum + A::b[i] * k[i][n];
      difference = difference + (A::b[i] - A::embedded[i]) * k[i][n];
    }
    trial.y[n] = y[n] + h * sum;
    trial.error[n] = h * difference;
  }
  trial.rate = k[A::stages - 1];
  trial.bends = false;
  return true;
}

/// The step that the error of a trial step suggests, as a factor: error = 1 is what is allowed.
template <Ordered T>
[[nodiscard]] T step_factor(const T& error, int order) {
  const T safety = T(9) / T(10), least = T(1) / T(5), most = T(5);
  if (!(error < T(1e10))) {
    return least;
  }
  if (!(T(1e-10) < error)) {
    return most;
  }
  // error^(-1/4), and for order 5 error^(-3/16): roots alone, so that it is the same everywhere.
  const T fourth = scalar::sqrt(T(scalar::sqrt(error)));
  const T eighth = scalar::sqrt(fourth);
  const T factor = safety / (order == 4 ? fourth : T(eighth * scalar::sqrt(eighth)));
  return factor < least ? least : most < factor ? most : factor;
}

}  // namespace detail
}  // namespace goishi
