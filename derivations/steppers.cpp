/// \file
/// One step of each scheme: what it keeps, how fast its energy grows, and its order.

#include <cstddef>
#include <goishi/motion/step_formulas.hpp>
#include <goishi/rotation.hpp>
#include <string>
#include <vector>

#include "euler.hpp"
#include "order.hpp"
#include "proof.hpp"
#include "relations.hpp"
#include "series.hpp"
#include "splitting.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;
using formula::RotorNumbers;

template <class T>
RotorNumbers<T> numbers(const goishi::Quat<T>& q, const goishi::Vec3<T>& l) {
  return {q.w(), q.x(), q.y(), q.z(), l.x(), l.y(), l.z()};
}

template <class T>
goishi::Quat<T> attitude(const RotorNumbers<T>& s) {
  return {s.w, s.x, s.y, s.z};
}

template <class T>
goishi::Vec3<T> momentum(const RotorNumbers<T>& s) {
  return {s.lx, s.ly, s.lz};
}

void problem(Document& document) {
  document.section("What a step has to find");
  document.text(
      R"(Torque-free, $L_W$ is constant, and with $l = \bar q L q$ and the inverse moments $J$ the exact motion is

$$\dot l = l \times J l, \qquad \dot q = \tfrac12\, q\, (0, J l).$$

Its series in $\Delta t$ follows power by power. A scheme of order $p$ has the same coefficients up to $\Delta t^p$:
its error is $O(\Delta t^{p+1})$ in a step and so $O(\Delta t^p)$ in a given time. The shipped step runs on truncated
series as its scalar. What is stated of coefficients holds for all unit $q$, all $l$ and all $J$ unless numbers are
named; that the next coefficient differs is shown at one example.)");
  document.shipped("formula::free_rates", "motion/step_formulas.hpp");
  const Start start;
  const RotorNumbers<ex> rates = formula::free_rates(numbers<ex>(start.q, start.l), start.J);
  const ex rate = components(attitude(rates));
  document.prove(start.relations({.text = R"($\dot q$ is $\frac12 q (0, J l)$)",
                                  .result = rate,
                                  .witness = components(hamilton(start.q, pure(Vector(start.w() / 2)))),
                                  .controls = scaled(rate)}));
  document.prove(start.relations({.text = R"(and `attitude_rate` with $\omega_W = q (J l) \bar q$)",
                                  .result = rate,
                                  .witness = components(formula::attitude_rate(start.w_W(), start.q)),
                                  .controls = scaled(rate)}));
  document.prove({.text = R"($\dot l$ is $l \times J l$)",
                  .result = components(momentum(rates)),
                  .witness = components(Vector(start.l.cross(start.w()))),
                  .controls = scaled(components(momentum(rates)))});
}

void runge_kutta(Document& document) {
  document.section("Runge–Kutta");
  document.text(
      R"(Attitude and momentum in B together; the rates are linear in $q$, which stands on the left throughout, so that
$q_0 = 1$ decides for all.)");
  document.shipped("formula::raw_runge_kutta_4_step", "motion/step_formulas.hpp");
  const Quaternion y = quaternion_letters("y");
  const Start start;
  document.prove(
      {.text = R"($\dot q$ of $q_0 y$ is $q_0$ times that of $y$)",
       .result = components(attitude(formula::free_rates(numbers<ex>(hamilton(start.q, y), start.l), start.J))),
       .witness = components(hamilton(start.q, attitude(formula::free_rates(numbers<ex>(y, start.l), start.J))))});
  Start own = Start::in_own_units();
  own.q = {1, 0, 0, 0};
  own.relations = Relations();
  const auto stepped = [](const Start& s) {
    return formula::raw_runge_kutta_4_step(numbers<Series>(constant_series(s.q), constant_series(s.l)),
                                           constant_series(s.J), Series::step());
  };
  prove_order(
      document, "Runge–Kutta, raw", 4, [&](const Start& s) { return attitude(stepped(s)); }, own);
  const goishi::Vec3<Series> end = momentum(stepped(own));
  const std::vector<Vector> path = exact_momenta(own, 4);
  const symbol power("h");
  ex result = 0;
  ex witness = 0;
  for (int n = 0; n <= 4; ++n) {
    const auto at = [&](int i) { return end[i][static_cast<std::size_t>(n)]; };
    result += components(Vector(at(0), at(1), at(2))) * pow(power, n);
    witness += components(path.at(static_cast<std::size_t>(n))) * pow(power, n);
  }
  document.prove(
      {.text = "and so has the momentum in B", .result = result, .witness = witness, .controls = scaled(result)});
  document.text(
      R"(Normalised, it is as good: if $q' = q + O(\Delta t^5)$ with $|q| = 1$, then $|q'| = 1 + O(\Delta t^5)$.)");
}

void midpoint(Document& document) {
  document.section("The implicit midpoint");
  document.text(
      R"(Euler's equation by the midpoint rule is $l' - l = \Delta t\; m \times J m$ with the momentum $m = \frac12 (l
+ l')$ at the middle; the attitude turns about $J m$.)");
  const Start start;
  const Vector m = letters("m");
  const possymbol dt("dt", R"(\Delta t)");
  document.shipped("formula::midpoint_residual`, `midpoint_jacobian", "motion/step_formulas.hpp");
  const Vector end = Vector(2 * m) - start.l;
  const Vector residual = formula::midpoint_residual<ex>(m, start.l, start.J, dt);
  document.prove({.text = R"(the residual is $\frac12 (l' - l - \Delta t\, m \times J m)$ with $l' = 2m - l$)",
                  .result = components(residual),
                  .witness = components(Vector(end - start.l - dt * m.cross(start.J.cwiseProduct(m)))) / 2});
  const Vector b = letters("b");
  const goishi::Mat3<ex> jacobian = formula::midpoint_jacobian<ex>(m, start.J, dt);
  ex slope = 0;
  for (int i = 0; i < 3; ++i) {
    slope += b(i) * components(residual).diff(GiNaC::ex_to<symbol>(m(i)));
  }
  document.prove({.text = "the matrix is its derivative with respect to $m$",
                  .result = components(Vector(jacobian * b)),
                  .witness = slope});
  document.prove(
      {.text = "it is symmetric in time: the residual of the step back, from $l'$ with $-\\Delta t$, is the negative",
       .result = components(formula::midpoint_residual<ex>(m, end, start.J, -dt)),
       .witness = -components(residual)});
  document.shipped("formula::midpoint_attitude", "motion/step_formulas.hpp");
  document.text(
      R"(The residual vanishes for $l = m - \frac{\Delta t}2 m \times J m$, $l' = m + \frac{\Delta t}2 m \times J m$.
With the half turn $\frac{\Delta t}2 J m = \frac SC n$, $|n| = 1$:)");
  const Turn turn;
  const Relations& relations = turn.relations;
  const Vector half_turn = Vector(turn.S / turn.C * turn.n);
  const Vector middle = Vector(2 / dt * half_turn).cwiseQuotient(start.J);
  const Vector drift = Vector(middle.cross(half_turn));
  const Quaternion raw = formula::midpoint_attitude<ex>(turn.q, middle, start.J, dt);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations.whole(text, result, witness));
  };
  prove(R"($q' = q\,(C, S n)$, a turn by $2\arctan\frac{|\omega|\Delta t}2$)", components(raw), components(turn.end));
  document.prove(
      relations.whole(R"($L_W$ is kept: for every $l$, $\bar q' (q l \bar q) q' = \bar r l r$ with $r = (C, S n)$)",
                      components(formula::in_body(turn.end, relations(turned(turn.q, start.l)))),
                      components(turned(conjugated(turn.turn), start.l))));
  prove(R"(and so $\bar r l r = l'$)", components(turned(conjugated(turn.turn), Vector(middle - drift))),
        components(Vector(middle + drift)));
  const Body body = {.mass = 1, .moments = start.J.cwiseInverse()};
  const State before = {.p_WB = m, .q_WB = {1, 0, 0, 0}, .v_WB = m, .L_W = Vector(middle - drift)};
  State after = before;
  after.q_WB = turn.turn;
  prove("the energy is kept (in a frame W that lies along B at first)", formula::rotational_energy(after, body),
        formula::rotational_energy(before, body));
  prove(R"(the step back, with the same $m$, leads to $q$)",
        components(formula::midpoint_attitude<ex>(turn.end, middle, start.J, -dt)), components(turn.q));
  document.text(R"(For the order $m$ is a series, by iteration from $l$, that makes the shipped residual vanish.)");
  const auto middle_series = [](const Start& s) {
    const SeriesVector l = constant_series(s.l);
    SeriesVector found = l;
    for (std::size_t n = 0; n < Series::last_power; ++n) {
      found -= formula::midpoint_residual<Series>(found, l, constant_series(s.J), Series::step());
    }
    return found;
  };
  prove_order(document, "implicit midpoint", 2, [&](const Start& s) {
    return formula::midpoint_attitude<Series>(constant_series(s.q), middle_series(s), constant_series(s.J),
                                              Series::step());
  });
}

}  // namespace

int main() {
  return derive("Time steppers", [](Document& document) {
    problem(document);
    euler(document);
    energy_growth(document);
    published_loop(document);
    runge_kutta(document);
    midpoint(document);
    splitting(document);
  });
}
