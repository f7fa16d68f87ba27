#pragma once
/// \file
/// An expression as LaTeX, the same in every run. (GiNaC orders terms, and takes signs out of them, by addresses, which change.)

#include <ginac/ginac.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace derivation {

[[nodiscard]] std::string latex(const GiNaC::ex& e);

namespace detail {

inline std::string integer_latex(const GiNaC::numeric& n) {
  std::ostringstream out;
  out << n;
  return out.str();
}

inline std::string fraction_latex(const std::string& over, const std::string& under) {
  return under == "1" ? over : "\\frac{" + over + "}{" + under + "}";
}

inline std::string numeric_latex(const GiNaC::numeric& n) {
  if (!n.is_rational()) {
    throw std::logic_error("latex: not a rational number");
  }
  const std::string size = fraction_latex(integer_latex(GiNaC::abs(n.numer())), integer_latex(n.denom()));
  return (n.is_negative() ? "-" : "") + size;
}

/// Positive terms first.
inline std::string sum_latex(const GiNaC::ex& sum) {
  std::vector<std::string> plus;
  std::vector<std::string> minus;
  for (const GiNaC::ex& term : sum) {
    const std::string text = latex(term);
    text.front() == '-' ? minus.push_back(text.substr(1)) : plus.push_back(text);
  }
  std::sort(plus.begin(), plus.end());
  std::sort(minus.begin(), minus.end());
  std::string text;
  for (const std::string& term : plus) {
    text += text.empty() ? "" : " + ";
    text += term;
  }
  for (const std::string& term : minus) {
    text += text.empty() ? "-" : " - ";
    text += term;
  }
  return text;
}

/// base^exponent, exponent > 0. `text` is the base's, or, for a sum, that of the base or of its negative.
struct Factor {
  GiNaC::ex base;
  GiNaC::numeric exponent;
  std::string text;

  [[nodiscard]] bool is_sum() const { return GiNaC::is_a<GiNaC::add>(base); }
  [[nodiscard]] bool has_sign() const { return is_sum() && exponent.is_integer(); }
  [[nodiscard]] std::string negative() const { return latex(-base); }

  /// Integers first, then π, letters, and the rest.
  [[nodiscard]] int place() const {
    return GiNaC::is_a<GiNaC::numeric>(base)    ? 0
           : GiNaC::is_a<GiNaC::constant>(base) ? 1
           : GiNaC::is_a<GiNaC::symbol>(base)   ? 2
                                                : 3;
  }

  [[nodiscard]] std::string alone() const { return is_sum() && exponent == 1 ? text : among(); }

  [[nodiscard]] std::string among() const {
    if (exponent.denom() == 2) {
      const std::string root = "\\sqrt{" + text + "}";
      return exponent == GiNaC::numeric(1, 2) ? root : root + "^{" + integer_latex(exponent.numer()) + "}";
    }
    if (exponent == 1) {
      return is_sum() ? "\\left(" + text + "\\right)" : text;
    }
    const bool plain = place() < 3 && text.find('^') == std::string::npos;
    return (plain ? text : "\\left(" + text + "\\right)") + "^{" + integer_latex(exponent) + "}";
  }
};

inline std::string joined(std::vector<Factor> factors) {
  if (factors.empty()) {
    return "1";
  }
  if (factors.size() == 1) {
    return factors.front().alone();
  }
  const auto before = [](const Factor& left, const Factor& right) {
    return std::make_tuple(left.place(), left.among()) < std::make_tuple(right.place(), right.among());
  };
  std::sort(factors.begin(), factors.end(), before);
  std::string text;
  for (const Factor& factor : factors) {
    text += text.empty() ? "" : " ";
    text += factor.among();
  }
  return text;
}

inline std::string product_latex(const GiNaC::ex& product) {
  std::vector<Factor> over;
  std::vector<Factor> under;
  bool negative = false;
  const auto take_number = [&](const GiNaC::numeric& n) {
    negative = n.is_negative();
    if (GiNaC::abs(n.numer()) != 1) {
      over.push_back({GiNaC::abs(n.numer()), 1, integer_latex(GiNaC::abs(n.numer()))});
    }
    if (n.denom() != 1) {
      under.push_back({n.denom(), 1, integer_latex(n.denom())});
    }
  };
  const auto take = [&](const GiNaC::ex& factor) {
    if (GiNaC::is_a<GiNaC::numeric>(factor)) {
      take_number(GiNaC::ex_to<GiNaC::numeric>(factor));
      return;
    }
    const bool is_power = GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<GiNaC::numeric>(factor.op(1));
    const GiNaC::ex base = is_power ? factor.op(0) : factor;
    const auto exponent = is_power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)) : GiNaC::numeric(1);
    (exponent.is_negative() ? under : over).push_back({base, GiNaC::abs(exponent), latex(base)});
  };
  if (GiNaC::is_a<GiNaC::mul>(product)) {
    std::for_each(product.begin(), product.end(), take);
  } else {
    take(product);
  }

  // A sum and its negative are one factor: of both texts take the last (w - h, not h - w), but rather no minus before the whole.
  std::vector<Factor*> mixed;
  for (std::vector<Factor>* part : {&over, &under}) {
    for (Factor& factor : *part) {
      if (factor.has_sign()) {
        const std::string other = factor.negative();
        const bool all_minus = factor.text.front() == '-';
        const bool has_choice = !all_minus && other.front() != '-';
        if (all_minus || (has_choice && factor.text < other)) {
          factor.text = other;
          negative = negative != factor.exponent.is_odd();
        }
        if (has_choice && factor.exponent.is_odd()) {
          mixed.push_back(&factor);
        }
      }
    }
  }
  if (negative && !mixed.empty()) {
    Factor& first = **std::min_element(
        mixed.begin(), mixed.end(), [](const Factor* left, const Factor* right) { return left->text < right->text; });
    const std::string same = latex(first.base);
    first.text = first.text == same ? first.negative() : same;
    negative = false;
  }
  const std::string size = fraction_latex(joined(std::move(over)), joined(std::move(under)));
  return (negative ? "-" : "") + size;
}

}  // namespace detail

[[nodiscard]] inline std::string latex(const GiNaC::ex& e) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    return GiNaC::ex_to<GiNaC::symbol>(e).get_TeX_name();
  }
  if (GiNaC::is_a<GiNaC::numeric>(e)) {
    return detail::numeric_latex(GiNaC::ex_to<GiNaC::numeric>(e));
  }
  if (GiNaC::is_a<GiNaC::constant>(e)) {
    return "\\pi";  // the only one in use
  }
  if (GiNaC::is_a<GiNaC::add>(e)) {
    return detail::sum_latex(e);
  }
  if (GiNaC::is_a<GiNaC::mul>(e) || GiNaC::is_a<GiNaC::power>(e)) {
    return detail::product_latex(e);
  }
  throw std::logic_error("latex: no rule for this kind of expression");
}

}  // namespace derivation
