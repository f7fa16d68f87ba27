#include "verify/report/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "verify/report/number.hpp"

namespace goishi::verify {

namespace {

/// Between these a number is written without a power of ten.
constexpr int least_plain_exponent = -3;
constexpr int greatest_plain_exponent = 4;

std::string with_minus(std::string text) {
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  if (text.starts_with('-')) {
    text.erase(0, 1);
    return is_zero ? text : "−" + text;
  }
  return text;
}

/// A step of 1, 2 or 5 times a power of ten.
struct Step {
  int factor = 1;
  int exponent = 0;
  [[nodiscard]] double value() const { return factor * std::pow(10.0, exponent); }
};

/// The smallest step that is at least this long.
Step step_above(double length) {
  Step step{1, static_cast<int>(std::floor(std::log10(length)))};
  for (const int factor : {1, 2, 5}) {
    step.factor = factor;
    if (step.value() >= length * (1 - 1e-12)) {
      return step;
    }
  }
  return {1, step.exponent + 1};
}

std::string factor_before_power(const std::string& factor) {
  return factor == "1" ? "" : factor == "−1" ? "−" : factor + "·";
}

/// The multiples of a step between two values, each at its place on the axis.
std::vector<Tick> multiples(const Axis& axis, double low, double high, const Step& step) {
  const int greatest = static_cast<int>(std::floor(std::log10(std::max(std::abs(low), std::abs(high)))));
  const bool scientific = greatest < least_plain_exponent || greatest > greatest_plain_exponent + 1;
  const double unit = scientific ? std::pow(10.0, greatest) : 1.0;
  const int decimals = std::max(0, (scientific ? greatest : 0) - step.exponent);
  std::vector<Tick> result;
  const double first = std::ceil(low / step.value());
  const double last = std::floor(high / step.value());
  for (double i = first; i <= last && result.size() < 100; ++i) {
    const double value = i * step.value();
    if (axis.logarithmic && !(value > 0)) {
      continue;
    }
    std::string label = with_minus(fmt::format("{:.{}f}", value / unit, decimals));
    if (scientific) {
      label = i == 0 ? "0" : factor_before_power(label) + power_of_ten(greatest);
    }
    result.push_back({axis.at(value), std::move(label)});
  }
  return result;
}

std::vector<Tick> linear_ticks(const Axis& axis, double low, double high, int count) {
  const double length = (high - low) / count;
  if (!(length > std::numeric_limits<double>::min()) || std::isinf(length)) {
    return {};  // at the very ends of double there is no step
  }
  return multiples(axis, low, high, step_above(length));
}

std::string decade_label(int factor, int exponent, bool only_powers) {
  if (!only_powers && exponent >= least_plain_exponent && exponent <= greatest_plain_exponent) {
    return plain_number(factor * std::pow(10.0, exponent));
  }
  return (factor == 1 ? "" : std::to_string(factor) + "·") + power_of_ten(exponent);
}

/// A label at each factor of each `stride`-th power of ten, minor ticks between.
std::vector<Tick> decade_ticks(const Axis& axis, const std::vector<int>& factors, int stride) {
  const bool only_powers = axis.high - axis.low > 3;
  std::vector<Tick> result;
  for (int exponent = static_cast<int>(std::floor(axis.low)); exponent <= axis.high; ++exponent) {
    const bool labelled = exponent % stride == 0;
    for (int factor = 1; factor <= 9; ++factor) {
      const double place = exponent + std::log10(factor);
      if (place < axis.low || place > axis.high || (stride > 1 && factor > 1)) {
        continue;
      }
      Tick tick{(place - axis.low) / (axis.high - axis.low), ""};
      if (!labelled && stride > 10) {
        continue;
      }
      if (labelled && std::find(factors.begin(), factors.end(), factor) != factors.end()) {
        tick.label = decade_label(factor, exponent, only_powers);
      }
      result.push_back(std::move(tick));
    }
  }
  return result;
}

std::ptrdiff_t labels(const std::vector<Tick>& some) {
  return std::count_if(some.begin(), some.end(), [](const Tick& tick) { return !tick.label.empty(); });
}

}  // namespace

double Axis::at(double value) const {
  return ((logarithmic ? std::log10(value) : value) - low) / (high - low);
}

Axis axis_around(const std::vector<double>& values, bool logarithmic) {
  Axis axis{logarithmic, 0, logarithmic ? 0.0 : 1.0};
  if (!values.empty()) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    axis.low = logarithmic ? std::log10(*least) : *least;
    axis.high = logarithmic ? std::log10(*greatest) : *greatest;
  }
  const double span = axis.high - axis.low;
  const double size = std::max(std::abs(axis.low), std::abs(axis.high));
  double room = 0.04 * span;
  if (logarithmic ? span < 1e-6 : span <= 1e-9 * size || size < 1e-300) {
    room = logarithmic ? 0.5 : size < 1e-300 ? 1.0 : 0.5 * size;
  }
  axis.low -= room;
  axis.high += room;
  return axis;
}

std::vector<Tick> ticks(const Axis& axis, const std::function<bool(const std::vector<Tick>&)>& fit) {
  const double span = axis.high - axis.low;
  if (axis.logarithmic && span >= 0.8) {
    std::vector<std::vector<Tick>> candidates;
    if (span <= 3) {
      candidates.push_back(decade_ticks(axis, {1, 2, 5}, 1));
    }
    for (const int stride : {1, 2, 3, 5, 10, 20, 50, 100}) {
      candidates.push_back(decade_ticks(axis, {1}, stride));
    }
    for (std::vector<Tick>& candidate : candidates) {
      if (labels(candidate) >= 2 && fit(candidate)) {
        return std::move(candidate);
      }
    }
  }
  const double low = axis.logarithmic ? std::pow(10.0, axis.low) : axis.low;
  const double high = axis.logarithmic ? std::pow(10.0, axis.high) : axis.high;
  std::vector<Tick> result;
  for (const int count : {10, 8, 6, 5, 4, 3, 2, 1}) {
    result = linear_ticks(axis, low, high, count);
    if (fit(result)) {
      break;
    }
  }
  return result;
}

}  // namespace goishi::verify
