/// DOMAIN: principal axes of tensors of any size. The witness is the residual I R − R diag(moments) in 50 digits, which says
/// how far the nearest tensor is that has these axes, and the same tensor in other units.

#include <fmt/format.h>

#include <algorithm>
#include <goishi/mass/tensor.hpp>
#include <string>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/domain.hpp"

namespace goishi::verify {

namespace {

template <class T>
struct TensorSample {
  Mat3<T> tensor;
  Vec3<T> shares;  // of moments that sum up to about 1
  T trace;
};

/// A ball, equal pairs, laminas to the bit, needles, any; along the axes to the bit or turned; symmetric, or so to 8 ε.
template <class T>
TensorSample<T> draw_tensor(Context& context, int i) {
  const auto unit = [&] { return static_cast<T>(context.uniform(0.05, 1.0)); };
  const T a = unit(), b = unit(), c = unit(), thin = any_size<T>(context.random(), 2.0) / T(1000);
  const std::array<Vec3<T>, 6> kinds = {Vec3<T>(T(1), T(1), T(1)), Vec3<T>(T(1), T(1), a),
                                        Vec3<T>(T(1), T(1), T(2)), Vec3<T>(a + b, b + c, a + c),
                                        Vec3<T>(T(1), thin, T(1)), Vec3<T>(a, b, a + b)};
  Vec3<T> shares = kinds[static_cast<std::size_t>(i) % kinds.size()];
  const int first = (i / 6) % 3;
  shares = Vec3<T>(shares[first], shares[(first + 1) % 3], shares[(first + 2) % 3]);
  const T size = i % 31 == 7   ? std::numeric_limits<T>::max() / T(8)
                 : i % 31 == 8 ? std::numeric_limits<T>::min()
                               : any_size<T>(context.random(), size_reach<T>);
  const Mat3<T> R = i % 3 == 0
                        ? Mat3<T>(Mat3<T>::Identity())
                        : Mat3<T>(draw_attitude(context.random()).template cast<T>().normalized().toRotationMatrix());
  Mat3<T> tensor = R * shares.asDiagonal() * R.transpose();
  tensor = T(0.5) * Mat3<T>(tensor + tensor.transpose());
  if (i % 4 == 1) {
    tensor(0, 1) += static_cast<T>(context.uniform(-8.0, 8.0)) * std::numeric_limits<T>::epsilon() * shares.sum();
  }
  return {Mat3<T>(size * tensor), shares, T(size * shares.sum())};
}

template <class T>
void see_tensors(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const TensorSample<T> sample = draw_tensor<T>(context, i);
    const Mat3<T>& tensor = sample.tensor;
    const int mode = rounding_modes[static_cast<std::size_t>(i / 5) % rounding_modes.size()];
    const auto describe_it = [&] {
      std::string text = fmt::format("mode {}, tensor", mode);
      for (const T& entry : tensor.reshaped()) {
        text += fmt::format(" {:a}", entry);
      }
      return text;
    };
    const auto answer = answer_of(mode, [&] { return principal_axes(tensor); });
    see_choice(checks["refusals"], answer.has_value(), [&] { return "refused: " + describe_it(); });
    if (!answer) {
      continue;
    }
    using Wide = Mat3<Digits50>;
    const Digits50 factor(context.produced(1.0));
    const Wide R = factor * answer->R_WP.template cast<Digits50>();
    Wide exact = tensor.template cast<Digits50>();
    exact = Wide((exact + exact.transpose()) / 2);
    const Vec3<Digits50> moments = factor * answer->moments.template cast<Digits50>();
    const Digits50 trace = exact.trace();
    const Digits50 off = Wide(exact * R - R * moments.asDiagonal()).cwiseAbs().maxCoeff() / trace;
    const Digits50 turned = Wide(R.transpose() * R - Wide::Identity()).cwiseAbs().maxCoeff();
    checks["residual"].see(static_cast<double>(off), epsilon_of<T>, describe_it);
    checks["rotation"].see(static_cast<double>(turned), epsilon_of<T>, describe_it);
    Vec3<T> expected = sample.shares * (sample.trace / sample.shares.sum());
    std::sort(expected.data(), expected.data() + 3);
    const Vec3<Digits50> apart = moments - expected.template cast<Digits50>();
    checks["moments"].see(static_cast<double>(Digits50(apart.cwiseAbs().maxCoeff() / Digits50(sample.trace))),
                          epsilon_of<T>, describe_it);
    const bool ascending = answer->moments[0] <= answer->moments[1] && answer->moments[1] <= answer->moments[2];
    see_choice(checks["order"], ascending && R.determinant() > 0, describe_it);
    // In other units, the same digits.
    const int n = static_cast<int>(context.uniform(-1.0, 1.0) * 3.0 * size_reach<T>);
    const T unit = std::ldexp(T(1), n), least = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
    const T scaled_trace = sample.trace * unit;
    if (least < sample.trace && least < scaled_trace && std::isfinite(scaled_trace * T(4)) && i % 3 == 0) {
      const auto other = answer_of(mode, [&] { return principal_axes(Mat3<T>(unit * tensor)); });
      see_choice(checks["units"], other && other->R_WP == answer->R_WP && other->moments == unit * answer->moments,
                 [&] { return fmt::format("times 2^{}: {}", n, describe_it()); });
    }
  }
}

/// What no body has is refused, of any size.
template <class T>
void see_refusals(Context& context, Checks& checks, int count) {
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity();
  for (int i = 0; i < count; ++i) {
    const T size = any_size<T>(context.random(), size_reach<T>);
    const int mode = rounding_modes[static_cast<std::size_t>(i) % rounding_modes.size()];
    const auto refused = [&](const char* name, const Mat3<T>& tensor) {
      see_choice(checks["refusals"], !answer_of(mode, [&] { return principal_axes(tensor); }),
                 [&] { return fmt::format("taken: {}, {:a}, mode {}", name, size, mode); });
    };
    const auto diagonal = [&](double x, double y, double z) {
      return Mat3<T>(size * Vec3<T>(static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)).asDiagonal());
    };
    refused("nothing", Mat3<T>(Mat3<T>::Zero()));
    refused("a rod of no width", diagonal(1.0, 1.0, 0.0));
    refused("a negative moment", diagonal(1.0, 1.0, -0.1));
    refused("one moment too great", diagonal(1.0, 1.0, 2.01));
    for (int k = 0; k < 9; ++k) {
      Mat3<T> tensor = diagonal(1.0, 1.2, 1.4);
      tensor(k / 3, k % 3) = i % 2 == 0 ? nan : infinite;
      refused("no number", tensor);
    }
    Mat3<T> skew = diagonal(1.0, 1.2, 1.4);
    skew(i % 3, (i + 1) % 3) = size * T(100) * std::numeric_limits<T>::epsilon();
    refused("not symmetric", skew);
    Mat3<T> both = skew;
    both(i % 3, (i + 1) % 3) = both((i + 1) % 3, i % 3) = infinite;
    refused("infinite products", both);
  }
}

Measurement measure_tensors(Context& context) {
  Checks checks;
  see_tensors<double>(context, checks, context.samples(1500, 15'000));
  see_tensors<float>(context, checks, context.samples(1500, 15'000));
  see_refusals<double>(context, checks, context.samples(40, 400));
  see_refusals<float>(context, checks, context.samples(40, 400));
  return checks.measurement();
}

}  // namespace

std::vector<Claim> domain_tensor_claims() {
  return {
      {.id = "DOMAIN-12",
       .statement =
           "Principal axes of tensors of any size, up to the end of the type: balls, equal pairs, laminas to the "
           "bit, needles, along the axes or turned, in each rounding mode; what no body has is refused, and what "
           "is no number.",
       .function = "principal_axes",
       .family = OracleFamily::other_formula,
       .oracle =
           "the residual I R − R diag(moments) and RᵀR − 1 in 50 digits; the same tensor in other units, to the bit",
       .checks = {within("residual", 24.0, "ε of the trace",
                         "twice TENSOR-4's 12, for rounding that is not to the nearest", 1.0),
                  within("rotation", 48.0, "ε", "twice TENSOR-4's 24", 1.0),
                  within("moments", 32.0, "ε of the trace", "twice TENSOR-4's 12, and the sample's own 8 ε", 1.0),
                  none("order", "moments that do not ascend, or axes that are no rotation"),
                  none("units", "tensors that have other digits in other units"),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_tensors},
  };
}

}  // namespace goishi::verify
