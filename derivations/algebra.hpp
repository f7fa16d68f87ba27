#pragma once
/// \file
/// Exact algebra for the derivations: is an expression identically zero, which small changes of a result must not be, and the
/// integrals that the witnesses need.
///
/// One rule keeps every decision exact and cheap: state a proof in independent symbols, in which every root is the root of a
/// square and every sine and cosine a rational function. GiNaC's `normal()` then decides.

#include <ginac/ginac.h>

#include <algorithm>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <map>
#include <string>
#include <vector>

namespace Eigen {
template <>
struct NumTraits<GiNaC::ex> {
  using Real = GiNaC::ex;
  using NonInteger = GiNaC::ex;
  using Nested = GiNaC::ex;
  using Literal = GiNaC::ex;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = HugeCost,
    AddCost = HugeCost,
    MulCost = HugeCost
  };
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};
}  // namespace Eigen

namespace derivation {

using GiNaC::ex;
using GiNaC::exmap;
using GiNaC::Pi;
using GiNaC::possymbol;
using GiNaC::realsymbol;
using GiNaC::symbol;

static_assert(goishi::Field<ex> && goishi::Elementary<ex>, "the formulas accept a symbolic scalar");
static_assert(!goishi::Ordered<ex>, "no algorithm does: x < y is a relation, and as a bool it would be silently false");

// --- zero or not

/// The symbols of an expression and π, by name.
inline std::map<std::string, ex> atoms(const ex& e) {
  std::map<std::string, ex> found;
  for (auto node = e.preorder_begin(); node != e.preorder_end(); ++node) {
    if (GiNaC::is_a<symbol>(*node)) {
      found.emplace(GiNaC::ex_to<symbol>(*node).get_name(), *node);
    } else if (GiNaC::is_a<GiNaC::constant>(*node)) {
      found.emplace("", *node);
    }
  }
  return found;
}

/// Whether a polynomial in positive symbols has positive coefficients only, so that it is positive.
inline bool is_plainly_positive(const ex& polynomial) {
  exmap ones;
  for (const auto& [name, atom] : atoms(polynomial)) {
    if (!atom.info(GiNaC::info_flags::positive)) {
      return false;
    }
    ones[atom] = 1;
  }
  const auto positive = [&](const ex& term) { return term.subs(ones).info(GiNaC::info_flags::positive); };
  const ex expanded = polynomial.expand();
  return GiNaC::is_a<GiNaC::add>(expanded) ? std::all_of(expanded.begin(), expanded.end(), positive)
                                           : positive(expanded);
}

/// The positive square root of a polynomial that is a square of plainly positive ones; else 0.
inline ex plain_root(const ex& polynomial) {
  const auto of_factor = [](const ex& factor) -> ex {
    if (GiNaC::is_a<GiNaC::numeric>(factor)) {
      return factor.info(GiNaC::info_flags::positive) ? sqrt(factor) : 0;
    }
    if (!GiNaC::is_a<GiNaC::power>(factor) || !factor.op(1).info(GiNaC::info_flags::even)) {
      return 0;
    }
    const ex& base = factor.op(0);
    const ex size = is_plainly_positive(base) ? base : is_plainly_positive(-base) ? -base : ex(0);
    return pow(size, factor.op(1) / 2);
  };
  const ex factors = GiNaC::sqrfree(polynomial.expand());
  if (!GiNaC::is_a<GiNaC::mul>(factors)) {
    return of_factor(factors);
  }
  ex root = 1;
  for (const ex& factor : factors) {
    root *= of_factor(factor);
  }
  return root;
}

/// √ of a rational function: free of roots if that is a quotient of plainly positive polynomials, else as it stands, which can
/// cost a proof but makes no false one.
inline ex positive_root(const ex& square) {
  const ex fraction = square.numer_denom();
  const ex over = plain_root(fraction.op(0));
  const ex under = plain_root(fraction.op(1));
  return over.is_zero() || under.is_zero() ? sqrt(square) : over / under;
}

/// The expression with `positive_root` for every root in it, innermost first.
inline ex resolve_roots(const ex& e) {
  struct Resolver : GiNaC::map_function {
    ex operator()(const ex& node) override {
      const ex inner = node.map(*this);
      const bool root = GiNaC::is_a<GiNaC::power>(inner) && inner.op(1).info(GiNaC::info_flags::rational) &&
                        !inner.op(1).info(GiNaC::info_flags::integer);
      return root ? pow(positive_root(inner.op(0)), 2 * inner.op(1)) : inner;
    }
  };
  Resolver resolver;
  return resolver(e);
}

/// The value where each symbol and π is a rational number between 1 and 2 of its own: enough to refute an identity, never to
/// prove one.
inline ex sample(const ex& e) {
  exmap point;
  for (const auto& [name, atom] : atoms(e)) {
    int place = 0;
    for (const char letter : name) {
      place = (31 * place + letter) % 9973;
    }
    const int square = place * place % 9973;
    const int mixed = square * square % 9973 * place % 9973;  // or a1, b1 and c1 would be as a2, b2 and c2 are, shifted
    point[atom] = 1 + ex(mixed) / 9973;
  }
  return e.subs(point);
}

/// Whether two samples are of different values. Exact; in double precision where roots remain.
inline bool differ(const ex& sample, const ex& other) {
  const ex difference = sample - other;
  const bool exact = difference.info(GiNaC::info_flags::rational);
  return exact ? !difference.is_zero() : abs(difference.evalf()) > ex(1) / 1000000000;
}

/// Whether an expression is zero for all values of its symbols, π among them. True is a proof.
inline bool vanishes(const ex& e) {
  if (differ(sample(e), 0)) {
    return false;  // and the long way need not be gone
  }
  const ex resolved = resolve_roots(e);
  return resolved.expand().is_zero() ||
         resolved.numer().expand().is_zero();  // cheap where it is enough, or in any case
}

/// The result with the wrong sign, and a thousandth too large: the alterations that show even where most terms vanish.
inline std::vector<ex> scaled(const ex& result) {
  return {-result, result * ex(1001) / 1000};
}

/// All results that differ from `result` in one place: the sign of a term, its size by a thousandth, or an exponent by one.
inline std::vector<ex> alterations(const ex& result) {
  struct ReplaceOperand : GiNaC::map_function {
    ReplaceOperand(size_t which, ex by) : place(which), replacement(std::move(by)) {}
    ex operator()(const ex& operand) override { return at++ == place ? replacement : operand; }
    size_t place;
    ex replacement;
    size_t at = 0;
  };
  struct Walk {
    static std::vector<ex> below(const ex& node) {
      std::vector<ex> altered;
      for (size_t i = 0; i < node.nops(); ++i) {
        const ex& operand = node.op(i);
        std::vector<ex> others = below(operand);
        if (GiNaC::is_a<GiNaC::add>(node)) {
          others.push_back(-operand);
          others.push_back(operand * ex(1001) / 1000);
        } else if (GiNaC::is_a<GiNaC::power>(node) && i == 1) {
          others.push_back(operand + 1);
        }
        for (const ex& other : others) {
          ReplaceOperand replace(i, other);
          altered.push_back(node.map(replace));
        }
      }
      return altered;
    }
  };
  std::vector<ex> altered = Walk::below(result);
  for (const ex& other : scaled(result)) {
    altered.push_back(other);
  }
  return altered;
}

// --- integrals for the witnesses

/// ∫ of a polynomial in x from `lower` to `upper`.
inline ex integral(const ex& polynomial, const symbol& x, const ex& lower, const ex& upper) {
  const ex p = polynomial.expand();
  ex sum = 0;
  for (int n = 0; n <= p.degree(x); ++n) {
    sum += p.coeff(x, n) * (pow(upper, n + 1) - pow(lower, n + 1)) / (n + 1);
  }
  return sum;
}

/// An angle, and its cosine and sine.
struct Angle {
  ex value;
  ex cosine;
  ex sine;
};
inline const Angle full_turn = {2 * Pi, 1, 0};

/// ∫₀^α of a polynomial in cos φ and sin φ (given as two symbols), by exponentials: cos φ = (e^{iφ} + e^{−iφ})/2, and so on;
/// ∫ e^{inφ} dφ = e^{inφ}/(in), except for n = 0.
inline ex arc_integral(const ex& polynomial, const symbol& cosine, const symbol& sine, const Angle& alpha) {
  const symbol e("e");
  const ex series =
      polynomial.expand().subs(exmap{{cosine, (e + 1 / e) / 2}, {sine, (e - 1 / e) / (2 * GiNaC::I)}}).expand();
  ex sum = series.coeff(e, 0) * alpha.value;
  for (int n = series.ldegree(e); n <= series.degree(e); ++n) {
    if (n != 0) {
      const ex at_alpha = pow(alpha.cosine + (n < 0 ? -GiNaC::I : GiNaC::I) * alpha.sine, n < 0 ? -n : n);
      sum += series.coeff(e, n) * (at_alpha - 1) / (n * GiNaC::I);
    }
  }
  return sum.expand();
}

}  // namespace derivation
