#pragma once
/// \file
/// The part of the steppers' derivation that is about splitting: one turn, three turns, and compositions of them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <goishi/motion/step_formulas.hpp>
#include <string>
#include <vector>

#include "order.hpp"
#include "proof.hpp"
#include "relations.hpp"
#include "series.hpp"

namespace derivation {

namespace formula = goishi::formula;
using Rotor = formula::Rotor<ex>;
using SeriesRotor = formula::Rotor<Series>;

inline ex components(const Rotor& rotor) {
  static const Vector b = letters("b");
  return components(rotor.q_WB) + b.dot(rotor.L_B);
}

template <int axis>
void one_turn(Document& document) {
  const Start start;
  const possymbol t("t");
  const possymbol u("u");
  const realsymbol C("C");
  const realsymbol S("S");
  const realsymbol D("D");
  const realsymbol T("T");
  const ex rate = start.w()(axis) / 2;
  const Relations relations = Relations().angle(rate * t, C, S).angle(rate * u, D, T);
  const auto turned_by = [&](Rotor rotor, const ex& time) {
    formula::turn_about<axis, ex>(rotor, start.J, time);
    return Rotor{.q_WB = relations(rotor.q_WB), .L_B = relations(rotor.L_B)};
  };
  const Rotor at_first = {.q_WB = start.q, .L_B = start.l};
  const Rotor now = turned_by(at_first, t);
  Vector w = Vector::Zero();
  w(axis) = start.w()(axis);
  const Rotor flow = {.q_WB = hamilton(now.q_WB, pure(Vector(w / 2))), .L_B = now.L_B.cross(w)};
  const ex path = components(now);
  const std::string name = "$i = " + std::to_string(axis + 1) + "$: ";
  document.prove(relations({.text = name + R"($\dot q = \frac12 q (0, \omega)$ and $\dot l = l \times \omega$)",
                            .result = path,
                            .witness = components(flow),
                            .view = [&](const ex& e) { return relations.rate(e, t); },
                            .controls = {-path, path * 2, path.subs(S == -S)}}));
  document.prove({.text = name + "at $t = 0$ as at first",
                  .result = relations.at_zero_angles(path),
                  .witness = components(at_first),
                  .controls = {path}});
  document.prove(relations({.text = name + "$t$ and then $u$ are $t + u$",
                            .result = components(turned_by(now, u)),
                            .witness = path.subs(exmap{{C, C * D - S * T}, {S, S * D + C * T}}),
                            .controls = {path}}));
  document.prove(relations({.text = name + "$t$ and then $-t$: as at first",
                            .result = components(turned_by(now, -t)),
                            .witness = components(at_first),
                            .controls = {path}}));
}

template <std::size_t count>
SeriesRotor composed(const Start& start, const std::array<Series, count>& substeps, const Series& dt) {
  SeriesRotor rotor = {.q_WB = constant_series(start.q), .L_B = constant_series(start.l)};
  formula::splitting_step(rotor, constant_series(start.J), dt, substeps);
  return rotor;
}

/// The splitting of the shipped substeps as a step.
template <std::size_t count>
Step splitting_of(std::array<Series, count> (*substeps)()) {
  return [substeps](const Start& start) { return composed(start, substeps(), Series::step()).q_WB; };
}

/// All coefficients of q and l.
inline ex coefficients(const SeriesRotor& rotor) {
  static const Vector b = letters("b");
  static const symbol power("h");
  ex sum = 0;
  for (std::size_t n = 0; n <= Series::last_power; ++n) {
    sum +=
        (components(coefficient(rotor.q_WB, n)) + b.dot(coefficient(rotor.L_B, n))) * pow(power, static_cast<int>(n));
  }
  return sum;
}

inline void three_turns(Document& document) {
  document.section("Three turns: splitting");
  document.text(
      R"(The energy is the sum of $l_i^2 / 2I_i$. The shipped step is the product of the three exact flows in the
order $x/2, y/2, z, y/2, x/2$: a palindrome, so the step with $-\Delta t$ undoes it, turn by turn.)");
  document.shipped("formula::splitting_step", "motion/step_formulas.hpp");
  const Start start;
  const possymbol dt("dt", R"(\Delta t)");
  Rotor shipped = {.q_WB = start.q, .L_B = start.l};
  Rotor product = shipped;
  formula::splitting_step<ex>(shipped, start.J, dt, formula::composition_2<ex>());
  formula::turn_about<0, ex>(product, start.J, dt / 2);
  formula::turn_about<1, ex>(product, start.J, dt / 2);
  formula::turn_about<2, ex>(product, start.J, dt);
  formula::turn_about<1, ex>(product, start.J, dt / 2);
  formula::turn_about<0, ex>(product, start.J, dt / 2);
  Rotor other = {.q_WB = start.q, .L_B = start.l};
  formula::turn_about<1, ex>(other, start.J, dt);
  formula::turn_about<2, ex>(other, start.J, dt);
  document.prove({.text = "the palindrome",
                  .result = components(shipped),
                  .witness = components(product),
                  .controls = {components(other)}});
  prove_order(document, "splitting", 2, splitting_of(&formula::composition_2<Series>));
}

template <std::size_t count>
std::vector<ex> all_substeps(const std::array<ex, count>& half) {
  std::vector<ex> all(half.begin(), half.end());
  all.insert(all.end(), half.rbegin() + 1, half.rend());
  return all;
}

/// Order of a composition of a symmetric step, from its substeps alone, and of the shipped step at an example.
template <std::size_t count>
void prove_composition(Document& document, int order, const std::array<ex, count>& half,
                       std::array<Series, count> (*substeps)()) {
  const std::string name = "`composition_" + std::to_string(order) + "`: ";
  const std::string next_power = std::to_string(order + 1);
  const auto power_of_ten = [](int n) { return pow(ex(10), n); };
  const auto below = [](const ex& small, const ex& large) { return (large - small).info(GiNaC::info_flags::positive); };
  const std::vector<ex> all = all_substeps(half);
  document.check(name + "up to degree " + std::to_string(order) + R"( all words agree within $10^{-26}$)",
                 below(largest_defect(all, 1, order), power_of_ten(-26)));
  document.check(name + "of degree " + next_power + " one differs by more than $10^{-2}$",
                 below(power_of_ten(-2), largest_defect(all, order + 1, order + 1)));
  std::vector<ex> wrong = all;
  wrong.front() += power_of_ten(-24);
  document.check(name + "with a substep changed by $10^{-24}$ the first of these fails",
                 below(power_of_ten(-26), largest_defect(wrong, 1, order)));

  const Start start = Start::example();
  Series::last_power = static_cast<std::size_t>(order) + 1;
  Series::relations = {};
  const SeriesQuaternion end = splitting_of(substeps)(start);
  const std::vector<Quaternion> path = exact(start, order + 1);
  const auto miss = [&](std::size_t n) -> ex {
    return (coefficient(end, n).coeffs() - path.at(n).coeffs()).squaredNorm();
  };
  ex largest = 0;
  for (std::size_t n = 0; n < Series::last_power; ++n) {
    largest += miss(n);
  }
  document.check(name + R"(the shipped step at the example, up to $\Delta t^)" + std::to_string(order) +
                     R"($: the exact motion's coefficients within $10^{-25}$)",
                 below(largest, power_of_ten(-50)));
  document.check(
      name + R"(of $\Delta t^)" + next_power + "$ it differs by more than $10^{-2}$: order " + std::to_string(order),
      below(power_of_ten(-4), miss(Series::last_power)));
}

/// Of the four numbers of `composition_6` three follow from the first.
inline void last_digits_of_order_6(Document& document) {
  const std::array<ex, 5> shipped = formula::composition_6<ex>();
  const symbol b("b"), c("c"), d("d");
  const std::array<ex, 5> half = {shipped[0], b, c, d, 1 - 2 * (shipped[0] + b + c + d)};
  Words words = {{{}, 1}};
  for (const ex& gamma : all_substeps(half)) {
    words = product(words, exponential(gamma, 5), 5);
  }
  const auto here = [&](const ex& form) { return form.subs(exmap{{b, shipped[1]}, {c, shipped[2]}, {d, shipped[3]}}); };
  const auto slopes = [&](const ex& form) {
    return Vector(here(form.diff(b)), here(form.diff(c)), here(form.diff(d)));
  };
  const ex third = words.at({3}), fifth = words.at({5}), mixed = words.at({1, 1, 3});
  const Vector p = slopes(third), q = slopes(fifth), r = slopes(mixed);
  const Vector newton =
      (here(third) * q.cross(r) + here(fifth) * r.cross(p) + here(mixed) * p.cross(q)) / p.dot(q.cross(r));
  const ex half_of_the_last = 5 / pow(ex(10), 28);
  document.check(
      R"(`composition_6`: its first number given, the others are, in 27 digits, the nearest for which $Y_3$, $Y_5$ and
$Y_1 Y_1 Y_3$ have the coefficient 0 (a step of Newton's method moves none by half of the last digit))",
      std::all_of(newton.begin(), newton.end(), [&](const ex& move) {
        return (half_of_the_last - GiNaC::abs(move)).info(GiNaC::info_flags::positive);
      }));
}

inline void compositions(Document& document) {
  document.section("Compositions");
  document.text(
      R"(`splitting_step` with the substeps $g_1, g_2, g_3$ is the product of the steps $g_1\Delta t$, $g_2\Delta t$,
$g_3\Delta t$, $g_2\Delta t$, $g_1\Delta t$, so again a palindrome. (Here with symbols for the substeps and numbers
for the body, up to $\Delta t^4$.))");
  const Start example = Start::example();
  Series::last_power = 4;
  Series::relations = {};
  const Vector g = letters("g");
  const std::array<Series, 3> substeps = {Series(g.x()), Series(g.y()), Series(g.z())};
  SeriesRotor product = {.q_WB = constant_series(example.q), .L_B = constant_series(example.l)};
  for (const std::size_t i : {0, 1, 2, 1, 0}) {
    formula::splitting_step(product, constant_series(example.J), Series(Series::step() * substeps.at(i)),
                            formula::composition_2<Series>());
  }
  const ex result = coefficients(composed(example, substeps, Series::step()));
  document.prove(
      {.text = "the product",
       .result = result,
       .witness = coefficients(product),
       .controls = {-result, coefficients(composed(example, std::array{substeps[0], substeps[2], substeps[1]},
                                                   Series::step()))}});

  document.text(
      R"(A step $S(\Delta t)$ that is undone by $S(-\Delta t)$ has an odd logarithm, $S(\Delta t) = \exp(\Delta t\,
Y_1 + \Delta t^3\, Y_3 + \Delta t^5\, Y_5 + \dots)$, and if it is of order 2, $\exp(\Delta t\,Y_1)$ is the exact flow.
The $Y$ do not commute. A composition of such steps with substeps $\gamma_j$ is of order $p$, for every body and
motion, if in the product of the exponentials every word $Y_{i_1} Y_{i_2} \cdots$ of a degree $i_1 + i_2 + \dots \le
p$ has the coefficient that it has in $\exp(Y_1)$: $1/k!$ for $Y_1^k$, 0 for others. The product is done exactly, on
the shipped digits. Each constant has 27 of them, so the coefficients can agree to a few $10^{-27}$ and no better.)");
  document.shipped("formula::digits`, `composition_2`, `composition_4`, `composition_6", "motion/step_formulas.hpp");
  document.check("`digits(1, 20, 300)` is $10^{-9} + 20 \\cdot 10^{-18} + 300 \\cdot 10^{-27}$",
                 (formula::digits<ex>(1, 20, 300) - GiNaC::numeric("1000000020000000300") / pow(ex(10), 27)).is_zero());
  document.text(R"(For order 4, $\sum\gamma_j = 1$ and $\sum\gamma_j^3 = 0$ are enough. With $\gamma = 1/(4 - x)$:)");
  const possymbol x("x");
  const ex gamma = 1 / (4 - x);
  document.prove(
      {.text = R"($4\gamma^3 + (1 - 4\gamma)^3 = (4 - x^3)/(4 - x)^3$, which vanishes for $x = \sqrt[3]{4}$)",
       .result = 4 * pow(gamma, 3) + pow(1 - 4 * gamma, 3),
       .witness = (4 - pow(x, 3)) / pow(4 - x, 3)});
  const auto cube_beside = [](const ex& digit) -> ex {
    return pow(4 - 1 / (formula::composition_4<ex>()[0] + digit / pow(ex(10), 27)), 3);
  };
  document.check(
      R"(`composition_4` has the nearest 27 digits of this $\gamma$: $x^3 - 4$ changes sign within half of the last
digit)",
      (cube_beside(ex(1) / 2) - 4).info(GiNaC::info_flags::positive) &&
          (4 - cube_beside(ex(-1) / 2)).info(GiNaC::info_flags::positive));
  prove_composition(document, 2, formula::composition_2<ex>(), &formula::composition_2<Series>);
  prove_composition(document, 4, formula::composition_4<ex>(), &formula::composition_4<Series>);
  prove_composition(document, 6, formula::composition_6<ex>(), &formula::composition_6<Series>);
  last_digits_of_order_6(document);
}

inline void splitting(Document& document) {
  document.section("One turn");
  document.text(R"(With the energy $l_i^2 / 2I_i$ alone the body turns about its axis $i$, $\omega = l_i J_i e_i$.)");
  document.shipped("formula::turn_about", "motion/step_formulas.hpp");
  one_turn<0>(document);
  one_turn<1>(document);
  one_turn<2>(document);
  three_turns(document);
  compositions(document);
}

}  // namespace derivation
