#include "verify/reference/enclosure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace goishi::verify::reference {

namespace {

/// An integer that frees itself.
class Whole {
 public:
  Whole() { fmpz_init(value_); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  ~Whole() { fmpz_clear(value_); }
  [[nodiscard]] fmpz* get() { return value_; }
  [[nodiscard]] std::string digits() const {
    char* text = fmpz_get_str(nullptr, 10, value_);
    std::string result = text;
    flint_free(text);
    return result;
  }

 private:
  fmpz_t value_;
};

/// 10^exponent; exact up to 10^77.
Ball power_of_ten(int exponent) {
  return Ball::from_decimal(fmt::format("1e{}", exponent));
}

/// Of the first digit.
int decimal_exponent(double size) {
  return static_cast<int>(std::floor(std::log10(size)));
}

/// The digits of a whole number of units 10^unit as a decimal.
std::string decimal(std::string digits, int unit, bool exact) {
  const bool negative = digits.starts_with('-');
  digits.erase(0, negative ? 1 : 0);
  if (digits == "0") {
    return "0";
  }
  const int exponent = unit + static_cast<int>(digits.size()) - 1;
  if (exact) {
    digits.erase(digits.find_last_not_of('0') + 1);
  }
  std::string text = (negative ? "-" : "") + digits.substr(0, 1);
  text += digits.size() > 1 ? "." + digits.substr(1) : "";
  return exponent == 0 ? text : fmt::format("{}e{}", text, exponent);
}

struct Rounded {
  std::string mid;
  bool exact;
};

/// The nearest whole number of units 10^unit. Proves that it is within one of them.
Rounded rounded(const Ball& x, int unit, const std::string& quantity) {
  if (!x.is_finite()) {
    throw std::runtime_error(fmt::format("{} is not enclosed", quantity));
  }
  const Ball in_units = x * power_of_ten(-unit);
  Whole whole;
  arf_get_fmpz(whole.get(), arb_midref(in_units.get()), ARF_RND_NEAR);
  Ball off;
  arb_sub_fmpz(off.get(), in_units.get(), whole.get(), Ball::precision);
  if (!(Ball(1) - off).is_positive() || !(Ball(1) + off).is_positive()) {
    throw std::runtime_error(fmt::format("the enclosure of {} is wider than 1e{}", quantity, unit));
  }
  const std::string text = decimal(whole.digits(), unit, true);
  const bool exact = arb_is_exact(x.get()) != 0 && arb_equal(Ball::from_decimal(text).get(), x.get()) != 0;
  return {.mid = exact ? text : decimal(whole.digits(), unit, false), .exact = exact};
}

int unit_of(const Answer<OrderedBall>& answer) {
  if (0.0 < answer.scale) {
    return decimal_exponent(answer.scale) - printed_digits + 1;
  }
  const Ball& x = answer.values.at(0).ball();
  if (answer.values.size() != 1 || !(x.is_positive() || x.is_negative())) {
    throw std::runtime_error(fmt::format("{} has no size: it needs a scale", answer.quantity));
  }
  return decimal_exponent(std::fabs(static_cast<double>(x))) - printed_digits + 1;
}

}  // namespace

Enclosure printed(const Answer<OrderedBall>& answer) {
  Enclosure result{.quantity = answer.quantity, .mid = {}, .rad = "0", .scale = answer.scale, .word = answer.word};
  if (!answer.word.empty()) {
    return result;
  }
  const int unit = unit_of(answer);
  for (const OrderedBall& value : answer.values) {
    const Rounded component = rounded(value.ball(), unit, answer.quantity);
    result.mid.push_back(component.mid);
    result.rad = component.exact ? result.rad : fmt::format("1e{}", unit);
  }
  return result;
}

void require_met(const OrderedBall& one, const OrderedBall& other, const std::string& what) {
  // Lengths that cancel on a thin stone are of its spheres.
  const auto narrow = [](const Ball& x) {
    Ball radius;
    arb_get_rad_arb(radius.get(), x.get());
    return x.is_finite() && static_cast<double>(radius) <= 1e-50 * (1.0 + std::fabs(static_cast<double>(x)));
  };
  if (!narrow(one.ball()) || !narrow(other.ball()) || !one.ball().overlaps(other.ball())) {
    throw std::runtime_error(fmt::format("two ways to {} do not meet", what));
  }
}

double scale_of(double size) {
  if (!(0.0 < size)) {
    return 1.0;
  }
  int exponent = 0;
  const double fraction = std::frexp(size, &exponent);
  return std::ldexp(1.0, fraction > 0.5 ? exponent : exponent - 1);
}

Answers<OrderedBall> common(std::vector<Answers<OrderedBall>> outcomes) {
  Answers<OrderedBall> result;
  for (Answer<OrderedBall>& answer : outcomes.front()) {
    bool in_all = true;
    for (std::size_t i = 1; i < outcomes.size() && in_all; ++i) {
      const auto other = std::ranges::find(outcomes[i], answer.quantity, &Answer<OrderedBall>::quantity);
      in_all = other != outcomes[i].end() && other->word == answer.word && other->values.size() == answer.values.size();
      for (std::size_t k = 0; in_all && k < answer.values.size(); ++k) {
        Ball both;
        arb_union(both.get(), answer.values[k].ball().get(), other->values[k].ball().get(), Ball::precision);
        answer.values[k] = OrderedBall(both);
      }
    }
    if (in_all) {
      result.push_back(std::move(answer));
    }
  }
  return result;
}

}  // namespace goishi::verify::reference
