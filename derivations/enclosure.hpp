#pragma once
/// \file
/// Proved digits of an exact number: fractions, roots, π, sines and cosines, enclosed by two fractions.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "algebra.hpp"

namespace derivation {

using GiNaC::numeric;

/// All numbers from `low` to `high`, both fractions.
struct Enclosure {
  numeric low;
  numeric high;
};

namespace detail {

inline const numeric resolution =
    GiNaC::pow(numeric(10), numeric(40));  // fractions are rounded outwards to its multiples

inline numeric floor(const numeric& x) {
  const numeric whole = GiNaC::iquo(x.numer(), x.denom());  // towards zero
  return x < whole ? whole - 1 : whole;
}

inline Enclosure rounded(const numeric& low, const numeric& high) {
  return {floor(low * resolution) / resolution, -floor(-high * resolution) / resolution};
}

inline Enclosure product(const Enclosure& a, const Enclosure& b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return rounded(low, high);
}

inline Enclosure inverse(const Enclosure& a) {
  if (!(a.low * a.high).is_positive()) {
    throw std::domain_error("enclosure: division by what may be 0");
  }
  return rounded(1 / a.high, 1 / a.low);
}

inline Enclosure root(const Enclosure& a) {
  if (a.low.is_negative()) {
    throw std::domain_error("enclosure: root of what may be negative");
  }
  const numeric square = resolution * resolution;
  return {GiNaC::isqrt(floor(a.low * square)) / resolution, (GiNaC::isqrt(floor(a.high * square)) + 1) / resolution};
}

/// A sum of terms of alternating signs lies, once their size falls, between any two partial sums in a row.
/// `next` makes the size of term k + 1 from that of term k.
template <class Next>
Enclosure alternating(const numeric& first, const Next& next) {
  numeric sum = 0, term = first;
  for (int k = 0; resolution * term > 1; ++k) {
    sum += k % 2 == 0 ? term : -term;
    term = next(term, k);
  }
  return rounded(sum - term, sum + term);
}

/// π = 16 atan(1/5) − 4 atan(1/239).
inline Enclosure pi() {
  const auto atan_inverse = [](int n) {
    return alternating(numeric(1, n), [n](const numeric& term, int k) {
      return term * numeric(2 * k + 1, 2 * k + 3) / numeric(n * n);
    });
  };
  const Enclosure a = atan_inverse(5), b = atan_inverse(239);
  return rounded(16 * a.low - 4 * b.high, 16 * a.high - 4 * b.low);
}

/// sin x for `odd` 1, cos x for 0, 0 <= x < 1.5.
inline Enclosure series(const numeric& x, int odd) {
  if (x.is_negative() || !(x < numeric(3, 2))) {
    throw std::domain_error("enclosure: sines and cosines are of angles from 0 to 1.5 only");
  }
  return alternating(odd == 1 ? x : numeric(1), [&](const numeric& term, int k) {
    return term * x * x / numeric((2 * k + 1 + odd) * (2 * k + 2 + odd));
  });
}

}  // namespace detail

inline Enclosure enclosure(const ex& e) {
  if (GiNaC::is_a<numeric>(e)) {
    const numeric& n = GiNaC::ex_to<numeric>(e);
    if (!n.is_rational()) {
      throw std::domain_error("enclosure: not a fraction");
    }
    return {n, n};
  }
  if (e.is_equal(Pi)) {
    return detail::pi();
  }
  if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
    const bool sum = GiNaC::is_a<GiNaC::add>(e);
    Enclosure all = {sum ? 0 : 1, sum ? 0 : 1};
    for (const ex& operand : e) {
      const Enclosure one = enclosure(operand);
      all = sum ? Enclosure{all.low + one.low, all.high + one.high} : detail::product(all, one);
    }
    return all;
  }
  if (GiNaC::is_a<GiNaC::power>(e) && (2 * e.op(1)).info(GiNaC::info_flags::integer)) {
    const int twice = GiNaC::ex_to<numeric>(2 * e.op(1)).to_int();
    const Enclosure base = enclosure(e.op(0));
    const Enclosure factor = twice % 2 == 0 ? base : detail::root(base);
    Enclosure power = {1, 1};
    for (int i = 0; i < std::abs(twice % 2 == 0 ? twice / 2 : twice); ++i) {
      power = detail::product(power, factor);
    }
    return twice < 0 ? detail::inverse(power) : power;
  }
  if (GiNaC::is_the_function<GiNaC::sin_SERIAL>(e) || GiNaC::is_the_function<GiNaC::cos_SERIAL>(e)) {
    const bool is_sine = GiNaC::is_the_function<GiNaC::sin_SERIAL>(e);
    const Enclosure angle = enclosure(e.op(0));
    const Enclosure from = detail::series(angle.low, is_sine ? 1 : 0), to = detail::series(angle.high, is_sine ? 1 : 0);
    return is_sine ? Enclosure{from.low, to.high} : Enclosure{to.low, from.high};
  }
  throw std::domain_error("enclosure: no rule for this kind of expression");
}

/// Whether a number is proved to be positive.
inline bool positive(const ex& number) {
  return enclosure(number).low.is_positive();
}

/// A positive number, rounded to a count of decimal places: every digit is proved.
inline std::string decimals(const ex& number, int places) {
  const Enclosure inside = enclosure(number);
  const numeric scale = GiNaC::pow(numeric(10), numeric(places));
  const auto nearest = [&](const numeric& x) { return detail::floor(x * scale + numeric(1, 2)); };
  if (inside.low.is_negative() || nearest(inside.low) != nearest(inside.high)) {
    throw std::domain_error("decimals: the enclosure leaves a digit open");
  }
  std::ostringstream out;
  out << nearest(inside.low);
  std::string digits = out.str();
  digits.insert(0, static_cast<std::size_t>(std::max(0, places + 1 - static_cast<int>(digits.size()))), '0');
  return places == 0 ? digits : digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
}

}  // namespace derivation
