#include "verify/oracles/motion/free_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/algebra/norm_result_type.hpp>
#include <cstddef>
#include <stdexcept>

/// Odeint looks for the number inside a std::array, and would look inside the number again.
namespace boost::numeric::odeint {
template <class Backend, multiprecision::expression_template_option Option, std::size_t N>
struct norm_result_type<std::array<multiprecision::number<Backend, Option>, N>, void> {
  using type = multiprecision::number<Backend, Option>;
};
}  // namespace boost::numeric::odeint

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace goishi::verify {

namespace {

namespace odeint = boost::numeric::odeint;

using Phase = std::array<Quad, 7>;  // q (w, x, y, z), ω in B

/// q̇ = ½ q (0, ω), and I ω̇ = (I ω) × ω by components, as Euler wrote it.
struct NewtonEuler {
  std::array<Quad, 3> moments;

  void operator()(const Phase& y, Phase& rate, const Quad& /*time*/) const {
    const auto& [w, x, y_, z, p, q, r] = y;
    const auto& [A, B, C] = moments;
    rate = {-(x * p + y_ * q + z * r) / 2,
            (w * p + y_ * r - z * q) / 2,
            (w * q + z * p - x * r) / 2,
            (w * r + x * q - y_ * p) / 2,
            (B - C) * q * r / A,
            (C - A) * r * p / B,
            (A - B) * p * q / C};
  }
};

Phase by_bulirsch_stoer(const NewtonEuler& system, Phase y, const Quad& end, const Quad& tolerance) {
  using Stepper = odeint::bulirsch_stoer<Phase, Quad, Phase, Quad, odeint::array_algebra>;
  odeint::integrate_adaptive(Stepper(tolerance, tolerance), system, y, Quad(0), end, Quad(end / 64));
  return y;
}

Phase by_fehlberg(const NewtonEuler& system, Phase y, const Quad& end, const Quad& tolerance) {
  using Stepper = odeint::runge_kutta_fehlberg78<Phase, Quad, Phase, Quad, odeint::array_algebra>;
  odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, Stepper()), system, y, Quad(0), end,
                             Quad(end / 64));
  return y;
}

Quad length(const Quad* begin, const Quad* end) {
  Quad sum = 0;
  for (; begin != end; ++begin) {
    sum += *begin * *begin;
  }
  return sqrt(sum);
}

/// The angle between the attitudes and the difference of ω over its length, added: NaN if either is.
double disagreement(const Phase& one, const Phase& other) {
  const auto& [w, x, y, z, p, q, r] = one;
  const auto& [w_, x_, y_, z_, p_, q_, r_] = other;
  // The vector part of q* q'.
  const Phase turn = {w * x_ - x * w_ - y * z_ + z * y_, w * y_ - y * w_ - z * x_ + x * z_,
                      w * z_ - z * w_ - x * y_ + y * x_};
  const Phase spins = {p - p_, q - q_, r - r_};
  const Quad size = length(&one[4], &one[4] + 3);
  const Quad attitude = 2 * length(&turn[0], &turn[0] + 3);
  const Quad spin = size == 0 ? length(&spins[0], &spins[0] + 3) : Quad(length(&spins[0], &spins[0] + 3) / size);
  return static_cast<double>(Quad(attitude + spin));
}

}  // namespace

FreeBodyReference integrate_free_body(const FreeBody& body, const Quad& time, const std::array<double, 2>& tolerances) {
  const NewtonEuler system{body.moments};
  // Time in units of 1/|ω|, with its sign, so that tolerances mean the same at any speed.
  const Quad speed = length(body.spin.data(), body.spin.data() + 3);
  const Quad unit = (time < 0 ? -1 : 1) / (speed == 0 ? Quad(1) : speed);
  const Quad end = time / unit;
  const Quad norm = length(body.attitude.data(), body.attitude.data() + 4);
  Phase start;
  std::transform(body.attitude.begin(), body.attitude.end(), &start[0], [&](const Quad& c) { return Quad(c / norm); });
  std::transform(body.spin.begin(), body.spin.end(), &start[4], [&](const Quad& c) { return Quad(c * unit); });

  FreeBodyReference result{};
  Phase found = start;
  for (const double tolerance : tolerances) {
    result.tolerance = tolerance;
    if (end != 0) {
      found = by_bulirsch_stoer(system, start, end, tolerance);
      result.disagreement = disagreement(found, by_fehlberg(system, start, end, tolerance));
    }
    if (result.disagreement <= free_body_agreement) {
      break;
    }
  }
  if (!(result.disagreement <= free_body_agreement)) {
    throw std::runtime_error(fmt::format(
        "free body: Bulirsch-Stoer and Fehlberg 7(8) differ by {:g}, more than {:g}, after {:g} rad of |omega| t",
        result.disagreement, free_body_agreement, static_cast<double>(end)));
  }
  const Quad found_norm = length(&found[0], &found[0] + 4);
  std::transform(&found[0], &found[0] + 4, result.attitude.begin(),
                 [&](const Quad& c) { return Quad(c / found_norm); });
  std::transform(&found[4], &found[4] + 3, result.spin.begin(), [&](const Quad& c) { return Quad(c / unit); });
  return result;
}

}  // namespace goishi::verify
