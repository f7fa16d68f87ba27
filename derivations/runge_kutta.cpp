/// \file
/// The Runge–Kutta pairs of the contact phase: their orders, from the coefficients that are shipped.

#include <array>
#include <cstddef>
#include <functional>
#include <goishi/drop/schemes/runge_kutta.hpp>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact.hpp"
#include "proof.hpp"
#include "trees.hpp"

namespace {

using namespace derivation;

bool is_positive(const ex& number) {
  return number.info(GiNaC::info_flags::positive);
}

ex power_of_ten(int n) {
  return pow(ex(10), n);
}

/// The coefficients of k₁, k₂ … in y + h Σ a_j k_j.
Row coefficients(const ex& sum, const ex& y, const symbol& h, const Row& k) {
  const ex slope = ((sum - y) / h).expand();
  Row row;
  ex rest = slope;
  for (const ex& rate : k) {
    row.push_back(slope.coeff(rate));
    rest -= row.back() * rate;
  }
  return rest.expand().is_zero() ? row : throw std::logic_error("not of the form y + h Σ a_j k_j");
}

/// The least of what is left of a condition where one coefficient is a thousandth too large.
ex least_of_altered(const std::vector<Tableau>& parts, const Row& weights,
                    const std::function<ex(const std::vector<Tableau>&, const Row&)>& of) {
  ex least = 1;
  const auto note = [&](const std::vector<Tableau>& altered, const Row& with) {
    const ex left = of(altered, with);
    least = is_positive(least - left) ? left : least;
  };
  const ex more = ex(1001) / 1000;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      for (std::size_t j = 0; j < weights.size(); ++j) {
        std::vector<Tableau> altered = parts;
        altered[part][i][j] *= more;
        if (!parts[part][i][j].is_zero()) {
          note(altered, weights);
        }
      }
    }
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    Row altered = weights;
    altered[i] *= more;
    if (!weights[i].is_zero()) {
      note(parts, altered);
    }
  }
  return least;
}

void dormand_prince(Document& document) {
  document.section("Dormand and Prince's 5(4)");
  document.text(
      R"(The shipped step runs on a scalar that is an exact fraction or a symbol, with rates $k_2, k_3, \dots$ that
are symbols too. The points where it asks for them, $y + h \sum a_{ij} k_j$, are its tableau; where it ends, $y + h
\sum b_j k_j$, are its weights; its error, $h \sum (b_j - \hat b_j) k_j$, has those of the embedded method. A method
is of order $p$ for every $f$ if $\sum b_i \phi_i(t) = 1/\gamma(t)$ for all rooted trees $t$ of up to $p$ vertices
(Butcher).)");
  document.shipped("detail::dormand_prince", "drop/schemes/runge_kutta.hpp");
  const symbol y("y"), h("h");
  Row k = {symbol("k1")};
  Row asked;
  const auto rate = [&](const std::array<Exact, 1>& at) {
    asked.push_back(at[0].value());
    k.push_back(symbol("k" + std::to_string(asked.size() + 1)));
    return std::array<Exact, 1>{Exact(k.back())};
  };
  goishi::detail::Trial<Exact, 1> trial;
  const std::array<Exact, 1> first = {Exact(k.front())};
  goishi::detail::dormand_prince(std::array{Exact(y)}, first, Exact(h), trial, rate);
  Tableau A = {Row(k.size(), 0)};
  for (const ex& point : asked) {
    A.push_back(coefficients(point, y, h, k));
  }
  const Row weights = coefficients(trial.y[0].value(), y, h, k);
  const Row error = coefficients(trial.error[0].value(), 0, h, k);
  Row embedded;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    embedded.push_back(weights[i] - error[i]);
  }
  document.check("seven stages; the last is asked for where the step ends, and is the rate there",
                 k.size() == 7 && (asked.back() - trial.y[0].value()).is_zero() && trial.rate[0].value() == k.back());
  document.check("there are 17 trees of up to 5 vertices, 8 of up to 4",
                 trees(5, 1).size() == 17 && trees(4, 1).size() == 8);
  document.check("the weights satisfy all 17 conditions", largest_defect(1, 5, {A}, weights).is_zero());
  document.check("and not those of order 6", is_positive(largest_defect(6, 6, {A}, weights) - power_of_ten(-4)));
  document.check("the embedded weights satisfy all 8", largest_defect(1, 4, {A}, embedded).is_zero());
  document.check("and not those of order 5", is_positive(largest_defect(5, 5, {A}, embedded) - power_of_ten(-4)));
  const auto left = [](const std::vector<Tableau>& parts, const Row& with, const Row& of_embedded) {
    return largest_defect(1, 5, parts, with) + largest_defect(1, 4, parts, of_embedded);
  };
  document.check(
      "with a thousandth more of any coefficient some condition fails by more than $10^{-6}$",
      is_positive(
          least_of_altered({A}, weights, [&](const auto& parts, const Row& of) { return left(parts, of, embedded); }) -
          power_of_ten(-6)) &&
          is_positive(least_of_altered({A}, embedded,
                                       [&](const auto& parts, const Row& of) { return left(parts, weights, of); }) -
                      power_of_ten(-6)));

  document.section("The polynomial along a step of it");
  document.text(
      R"(Through both ends with the rates there, and bent by $\theta^2 (1 - \theta)^2$ times the shipped sum of rates: $y +
h \sum b_j(\theta) k_j$, of degree 4. A method whose step is $\theta h$ long has the tableau $a_{ij}/\theta$ and the
weights $b_j(\theta)/\theta$; both sides of a condition are polynomials of degree 4 that are 0 at $\theta = 0$, so that
five more places prove it.)");
  document.shipped("detail::bend_of", "drop/schemes/runge_kutta.hpp");
  document.shipped("detail::interpolant", "drop/schemes/runge_kutta.hpp");
  const auto along = goishi::detail::interpolant(std::array{Exact(y)}, first, trial.y, trial.rate, Exact(h),
                                                 goishi::detail::bend_of(trial, first, Exact(h)));
  const auto defect = [&](int low, int high, const ex& theta, const ex& altered) {
    Tableau scaled = A;
    for (Row& row : scaled) {
      for (ex& entry : row) {
        entry = entry / theta;
      }
    }
    Row with = coefficients((along(Exact(theta))[0].value() * altered).expand(), y * altered, h, k);
    for (ex& weight : with) {
      weight = weight / theta;
    }
    return largest_defect(low, high, {scaled}, with);
  };
  bool holds = true;
  for (int i = 1; i <= 5; ++i) {
    holds = holds && defect(1, 4, ex(i) / 6, 1).is_zero();
  }
  document.check("it satisfies all 8 conditions up to order 4, for every $\\theta$", holds);
  document.check("and not those of order 5", is_positive(defect(5, 5, ex(1) / 2, 1) - power_of_ten(-4)));
  document.check("with a thousandth more of it they fail",
                 is_positive(defect(1, 4, ex(1) / 2, ex(1001) / 1000) - power_of_ten(-6)));
}

/// What any interpolant is led through.
void interpolants(Document& document) {
  document.section("Polynomials along a step");
  using Along = goishi::detail::Interpolant<Exact, 1>;
  const symbol h("h"), a("a"), b("b"), u("u"), v("v"), e("e"), t("t"), p("p"), q("q");
  const auto one = [](const ex& value) { return std::array{Exact(value)}; };
  const auto value = [&](const Along& along) { return along(Exact(t))[0].value(); };
  const Along rough = goishi::detail::interpolant(one(a), one(u), one(b), one(v), Exact(h), one(e));
  const auto leads = [&](const ex& form) {
    return (form.subs(t == 0) - a).expand().is_zero() && (form.subs(t == 1) - b).expand().is_zero() &&
           (form.diff(t).subs(t == 0) - h * u).expand().is_zero() &&
           (form.diff(t).subs(t == 1) - h * v).expand().is_zero();
  };
  document.check("it goes through both ends, with the rates there", leads(value(rough)));
  document.check("and not through any others", !leads(value(rough) + t) && !leads(value(rough) + pow(t, 2) * (t - 1)));
  document.shipped("detail::sharpened", "drop/schemes/runge_kutta.hpp");
  int asked = 0;
  ex places = 0;
  const Along sharp = goishi::detail::sharpened(rough, Exact(h), [&](const std::array<Exact, 1>& place) {
    places += (place[0].value() - value(rough).subs(t == ex(++asked) / 3)).expand() * pow(p, asked);
    return one(asked == 1 ? p : q);
  });
  const ex slope = value(sharp).diff(t);
  document.check("the rates at a third and two thirds are asked for where the polynomial is there",
                 asked == 2 && places.expand().is_zero());
  document.check("it then has them as its slopes, and the ends as before",
                 leads(value(sharp)) && (slope.subs(t == ex(1) / 3) - h * p).expand().is_zero() &&
                     (slope.subs(t == ex(2) / 3) - h * q).expand().is_zero());
  document.check("a part of it is the same polynomial",
                 (value(sharp.cut(Exact(e))) - value(sharp).subs(t == e * t)).expand().is_zero());
}

void additive(Document& document) {
  document.section("The additive pair 4(3)");
  document.text(
      R"(Kennedy and Carpenter's ARK4(3)6L[2]SA: the stiff part of $f$ with the implicit tableau, the rest with the
explicit one, the same weights; the stiff part may be one component. The trees' vertices then have two colours.
Weights, embedded weights and the implicit tableau are exact. Of the explicit one most entries are fractions that its
authors rounded to 25 digits.)");
  document.shipped("detail::AdditiveTableau", "drop/schemes/runge_kutta.hpp");
  using Shipped = goishi::detail::AdditiveTableau<Exact>;
  constexpr std::size_t stages = Shipped::stages;
  Tableau E(stages, Row(stages, 0)), I = E;
  Row weights, embedded;
  for (std::size_t i = 0; i < stages; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      E[i][j] = Shipped::E[i][j].value();
      I[i][j] = Shipped::I[i][j].value();
    }
    I[i][i] = i == 0 ? ex(0) : Shipped::diagonal.value();
    weights.push_back(Shipped::b[i].value());
    embedded.push_back(Shipped::embedded[i].value());
  }
  const auto is_small = [](const ex& number) { return is_positive(power_of_ten(-25) - GiNaC::abs(number)); };
  const auto sum = [](const Row& row) { return std::accumulate(row.begin(), row.end(), ex(0)); };
  document.check("there are 36 trees of up to 4 vertices, 10 of up to 3",
                 trees(4, 2).size() == 36 && trees(3, 2).size() == 10);
  document.check("the implicit method alone: the weights satisfy all conditions of order 4, exactly",
                 largest_defect(1, 4, {I}, weights).is_zero());
  document.check("and the embedded weights those of order 3, exactly", largest_defect(1, 3, {I}, embedded).is_zero());
  document.check("both together: order 4 within $10^{-25}$", is_small(largest_defect(1, 4, {E, I}, weights)));
  document.check("and the embedded weights order 3 within $10^{-25}$",
                 is_small(largest_defect(1, 3, {E, I}, embedded)));
  document.check("and no more: orders 5 and 4 fail by more than $10^{-3}$",
                 is_positive(largest_defect(5, 5, {E, I}, weights) - power_of_ten(-3)) &&
                     is_positive(largest_defect(4, 4, {E, I}, embedded) - power_of_ten(-3)));
  bool at_one_time = true;
  for (std::size_t i = 0; i < stages; ++i) {
    at_one_time = at_one_time && is_small(sum(E[i]) - sum(I[i]));
  }
  document.check("explicit and implicit stages are at the same time, within $10^{-25}$", at_one_time);
  const auto left = [&](int order) {
    return [order](const auto& parts, const Row& of) { return largest_defect(1, order, parts, of); };
  };
  document.check("with a thousandth more of any coefficient some condition fails by more than $10^{-6}$",
                 is_positive(least_of_altered({E, I}, weights, left(4)) - power_of_ten(-6)) &&
                     is_positive(least_of_altered({}, embedded, left(1)) - power_of_ten(-6)));

  document.section("Its implicit part is L-stable");
  document.text(
      R"(For $y' = \lambda y$, $z = h\lambda$, a step multiplies by $R(z) = \det(1 - zA + z \mathbb{1}
b^\mathsf{T})/\det(1 - zA) = P/Q$, $Q(0) = 1$.)");
  document.check("the weights are the last stage's: it is stiffly accurate", weights == I.back());
  const symbol z("z");
  const possymbol w("w");
  GiNaC::matrix under(stages, stages), over(stages, stages);
  for (unsigned i = 0; i < stages; ++i) {
    for (unsigned j = 0; j < stages; ++j) {
      under(i, j) = (i == j ? 1 : 0) - z * I[i][j];
      over(i, j) = under(i, j) + z * weights[j];
    }
  }
  const ex Q = under.determinant().expand(), P = over.determinant().expand();
  document.equation("R", P / Q);
  document.check("$R(\\infty) = 0$, and its only pole is at 4, on the right",
                 P.degree(z) < Q.degree(z) && (Q - pow(1 - z / 4, 5)).expand().is_zero());
  const auto square = [&](const ex& form) {
    return (form.subs(z == GiNaC::I * w) * form.subs(z == -GiNaC::I * w)).expand();
  };
  const ex rest = (square(Q) - square(P)).expand();
  const ex low = rest.coeff(w, 6), middle = rest.coeff(w, 8), high = rest.coeff(w, 10);
  document.equation("|Q(iw)|^2 - |P(iw)|^2", rest);
  document.check("which is $w^6$ times a quadratic in $w^2$ that is positive: $|R(iw)| \\le 1$, so it is L-stable",
                 (rest - pow(w, 6) * (low + middle * pow(w, 2) + high * pow(w, 4))).expand().is_zero() &&
                     is_positive(low) && is_positive(4 * low * high - middle * middle));
}

}  // namespace

int main() {
  return derive("Runge–Kutta pairs", [](Document& document) {
    dormand_prince(document);
    interpolants(document);
    additive(document);
  });
}
