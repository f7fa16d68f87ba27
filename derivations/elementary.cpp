/// \file
/// Sine, cosine and arctangent of our own: the identities behind them, and that their constants are what they stand for.

#include <cmath>
#include <cstddef>
#include <goishi/scalar.hpp>
#include <string>

#include "proof.hpp"

namespace {

using namespace derivation;
using GiNaC::ex_to;
using GiNaC::I;
using GiNaC::numeric;
namespace own = goishi::scalar::detail;

/// A binary number as a fraction, exactly.
numeric fraction(double x) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
  return numeric(static_cast<long>(mantissa)) * pow(numeric(2), numeric(exponent - 53));
}

/// atan(1/n), too small by less than 2^-1250: the alternating series, an even number of terms.
numeric arctangent_of_inverse(int n) {
  const numeric square = numeric(n) * numeric(n);
  numeric power = numeric(1) / numeric(n), sum = 0;
  for (int k = 0; power.compare(pow(numeric(2), numeric(-1250))) > 0 || k % 2 != 0; ++k) {
    sum += (k % 2 == 0 ? numeric(1) : numeric(-1)) * power / numeric(2 * k + 1);
    power /= square;
  }
  return sum;
}

bool is_near(const numeric& x, const numeric& y, int bits) {
  return abs(x - y).compare(pow(numeric(2), numeric(-bits))) < 0;
}

/// Of no more than `size` significant bits.
bool is_short(double x, int size) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), size);
  return mantissa == std::floor(mantissa);
}

void addition(Document& document) {
  document.section("The sum of two angles");
  document.text(
      R"(With $E = \mathrm{e}^{\mathrm{i}r}$ and $F = \mathrm{e}^{\mathrm{i}k\pi/2}$, sines and cosines are rational in them.)");
  document.shipped("scalar::detail::sum_of_angles", "scalar/sincos.hpp");
  const symbol E("E");
  const symbol F("F");
  const auto sine = [](const ex& e) { return ex((e - 1 / e) / (2 * I)); };
  const auto cosine = [](const ex& e) { return ex((e + 1 / e) / 2); };
  const auto sum = own::sum_of_angles<ex>(sine(E), cosine(E), sine(F), cosine(F));
  document.prove({.text = R"($\sin(r + k\frac\pi2)$)", .result = sum.sin, .witness = sine(E * F)});
  document.prove({.text = R"($\cos(r + k\frac\pi2)$)", .result = sum.cos, .witness = cosine(E * F)});
  document.shipped("scalar::detail::quarter_cosine", "scalar/sincos.hpp");
  const auto is = [](double given, const ex& exact) {
    return numeric(static_cast<long>(given)) == ex_to<numeric>(exact);
  };
  bool right = true;
  for (int j = -3; j <= 3; ++j) {
    right = right && is(own::quarter_cosine<double>(j), cos(j * Pi / 2));
  }
  document.check(R"($||j| - 2| - 1 = \cos\frac{j\pi}2$ for $j = -3 \dots 3$)", right);
  bool sines = true;
  for (int j = -2; j <= 3; ++j) {
    sines = sines && is(own::quarter_cosine<double>(j - 1), sin(j * Pi / 2));
  }
  document.check(R"(and of $j - 1$ it is $\sin\frac{j\pi}2$)", sines);
}

void reduction(Document& document, const numeric& pi) {
  document.section("The reduction");
  document.text(
      R"(By $k$ times parts of $\frac\pi2$, of which all but the last have so few bits that the product is exact.
($\pi$ by Machin's formula, $16 \arctan\frac15 - 4 \arctan\frac1{239}$, in fractions.))");
  document.shipped("scalar::detail::SincosNumbers", "scalar/sincos.hpp");
  const auto& wide = own::SincosNumbers<double>::part;
  const auto& narrow = own::SincosNumbers<float>::part;
  document.check("double: 31 and 32 bits, and $|k| < 2^{18}$, are less than 53",
                 is_short(wide[0], 31) && is_short(wide[1], 32));
  document.check(R"(their sum is $\frac\pi2$ to $2^{-121}$)",
                 is_near(fraction(wide[0]) + fraction(wide[1]) + fraction(wide[2]), pi / 2, 121));
  document.check("float: 11 bits, and $|k| < 2^{13}$, are 24",
                 is_short(narrow[0], 11) && is_short(narrow[1], 11) && is_short(narrow[2], 11));
  numeric sum = 0;
  for (const float part : narrow) {
    sum += fraction(part);
  }
  document.check(R"(their sum is $\frac\pi2$ to $2^{-63}$)", is_near(sum, pi / 2, 63));
  numeric words = 0;
  for (std::size_t n = 0; n < own::words_of_two_over_pi.size(); ++n) {
    words += numeric(static_cast<long>(own::words_of_two_over_pi[n])) *
             pow(numeric(2), numeric(32 - 32 * static_cast<long>(n)));
  }
  document.check(R"(beyond: the words of $\frac2\pi$ are its bits to the last, the 1184th)",
                 is_near(words, 2 / pi, 1184) && words.compare(2 / pi) <= 0);
}

void arctangent(Document& document, const numeric& pi) {
  document.section("The arctangent");
  document.text(R"($\tan(\arctan c + \arctan t) = \frac{c + t}{1 - ct}$, which is $\frac ba$:)");
  document.shipped("scalar::detail::tangent_of_rest", "scalar/arctangent.hpp");
  const symbol a("a");
  const symbol b("b");
  const symbol c("c");
  const ex t = own::tangent_of_rest<ex>(b, a, c);
  document.prove({.text = R"($\frac{c + t}{1 - ct} = \frac ba$)", .result = (c + t) / (1 - c * t), .witness = b / a});
  const numeric half = arctangent_of_inverse(2);
  const numeric angles[] = {0, half, pi / 4};
  const numeric axes[] = {0, pi / 2, pi, pi / 2};
  bool right = true;
  for (std::size_t q = 0; q < 4; ++q) {
    for (std::size_t n = 0; n < 3; ++n) {
      const numeric angle = axes[q] + (q == 0 || q == 3 ? angles[n] : -angles[n]);
      const auto& base = own::arctangent_base[q][n];
      right = right && is_near(fraction(base.value) + fraction(base.rest), angle, 104);
    }
  }
  document.check(
      R"(the angles from which it counts, $0$, $\frac\pi2$ or $\pi$ with $\pm\arctan c$, are right to $2^{-104}$)",
      right);
}

}  // namespace

int main() {
  return derive("Sine, cosine and arctangent", [](Document& document) {
    const numeric pi = 16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239);
    addition(document);
    reduction(document, pi);
    arctangent(document, pi);
  });
}
