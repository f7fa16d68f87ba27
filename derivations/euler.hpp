#pragma once
/// \file
/// The part of the steppers' derivation that is about Euler's steps: by what they turn, how fast their energy grows, and
/// what the talk's loop keeps.

#include <functional>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/step_formulas.hpp>
#include <goishi/rotation.hpp>
#include <string>

#include "moving.hpp"
#include "order.hpp"
#include "proof.hpp"
#include "relations.hpp"
#include "series.hpp"

namespace derivation {

namespace formula = goishi::formula;

/// Explicit Euler's attitude after a step, normalised.
inline SeriesQuaternion explicit_step(const Start& s) {
  return normalised(
      formula::raw_euler_attitude<Series>(constant_series(s.q), constant_series(s.w_W()), Series::step()));
}

/// Exponential Euler's, (cos |x|, x sin|x|/|x|) with x = ω Δt/2, by the squares of |x|.
inline SeriesQuaternion exponential_step(const Start& s) {
  const SeriesVector x = Series::step() * constant_series(Vector(s.w() / 2));
  const Series square = x.dot(x);
  const Series over = Series(1) - square / Series(6);
  return SeriesQuaternion(constant_series(s.q) *
                          SeriesQuaternion(Series(1) - square / Series(2), over * x.x(), over * x.y(), over * x.z()));
}

inline void euler(Document& document) {
  document.section("Explicit and exponential Euler");
  document.text(
      R"(Both turn about the angular velocity at the start, $\omega_W = q \omega_B \bar q$, $\omega_B = \Omega n$.)");
  document.shipped("formula::raw_euler_attitude", "motion/step_formulas.hpp");
  const Turn turn;
  const Relations& relations = turn.relations;
  const possymbol dt("dt", R"(\Delta t)");
  const Quaternion raw = formula::raw_euler_attitude<ex>(turn.q, turn.w_W, dt);
  document.prove(relations({.text = R"($|q'|^2 = 1 + (\Omega\Delta t/2)^2$)",
                            .result = squared_norm(raw),
                            .witness = 1 + pow(turn.rate * dt / 2, 2),
                            .controls = scaled(squared_norm(raw))}));
  document.text(
      R"(With $\Omega\Delta t/2 = \tan\frac\varphi2 = S/C$ that is $1/C^2$, so $C q'$ is the normalised step:)");
  const exmap by_tangent = {{dt, 2 * turn.S / (turn.C * turn.rate)}};
  const ex step = components(raw);
  document.prove(relations({.text = R"(it is $q\,(C, S n)$, a turn by $\varphi = 2\arctan\frac{\Omega\Delta t}2$)",
                            .result = step,
                            .witness = components(turn.end),
                            .view = [&](const ex& e) { return turn.C * e.subs(by_tangent); },
                            .controls = scaled(step)}));
  prove_order(document, "explicit Euler, normalised", 1, explicit_step);

  document.shipped("formula::exponential_euler_attitude", "motion/step_formulas.hpp");
  const Relations at_once = Relations(relations).angle(turn.rate * dt / 2, turn.C, turn.S);
  const ex exponential = components(formula::exponential_euler_attitude<ex>(turn.q, turn.w_W, dt));
  document.prove(
      at_once({.text = R"(it is $q\,(C, S n)$ with $C$, $S$ of $\frac{\Omega\Delta t}2$: a turn by $\Omega\Delta t$)",
               .result = exponential,
               .witness = components(turn.end),
               .controls = scaled(exponential)}));
  document.text(
      R"(Its angle differs from explicit Euler's, $2\arctan x - 2x = O(\Delta t^3)$ with $x = \Omega\Delta t / 2$, so
its order is 1 too. The coefficients, of the turn as just proved:)");
  prove_order(document, "exponential Euler", 1, exponential_step);
}

/// What a step adds to the energy, as a series in Δt.
inline Series gain_of(const Start& start, const SeriesQuaternion& end) {
  const goishi::RigidBody<Series> body = {.mass = Series(1), .moments = constant_series(start.J.cwiseInverse())};
  const auto energy = [&](const SeriesQuaternion& q) {
    goishi::State<Series> state = {.p_WB = constant_series(Vector::Zero()),
                                   .q_WB = q,
                                   .v_WB = constant_series(Vector::Zero()),
                                   .L_W = constant_series(start.L_W())};
    return formula::rotational_energy(state, body);
  };
  return energy(end) - energy(constant_series(start.q));
}

/// The leading term of the gain, of the turns just proved (exponential Euler's as a series).
inline void energy_of_a_step(Document& document) {
  document.text(
      R"(How fast it grows, step by step: as series in $\Delta t$, for the symmetric top, with $\omega_z$ about its axis
and $\omega_\perp$ across it,)");
  const possymbol axial("Ia", "I_a"), transverse("It", "I_t"), dt("dt", R"(\Delta t)");
  Start top;
  top.J = Vector(1 / transverse, 1 / transverse, 1 / axial);
  const Vector w = top.w();
  const ex across = pow(w.x(), 2) + pow(w.y(), 2);
  const ex leading = across * pow(w.z(), 2) * pow(transverse - axial, 2) / (2 * transverse);
  const auto prove = [&](const std::string& scheme, const std::function<SeriesQuaternion(const Start&)>& step) {
    Series::last_power = 2;
    Series::relations = top.relations;
    const Series gain = gain_of(top, step(top));
    document.prove_limit(scheme + R"(: the coefficients of $\Delta t^0$ and $\Delta t^1$ are both 0)",
                         top.relations(gain[0] + dt * gain[1]), 0);
    document.prove(top.relations(
        {.text =
             R"(and $E' - E = \frac{(I_t - I_a)^2}{2 I_t}\, \omega_\perp^2 \omega_z^2\, \Delta t^2 + O(\Delta t^3)$)",
         .result = gain[2],
         .witness = leading,
         .controls = scaled(gain[2])}));
  };
  prove("explicit Euler, normalised", explicit_step);
  prove("exponential Euler", exponential_step);
  document.text("So the gain is of second order in a step, of first order in a given time, the same for both schemes.");
}

inline void energy_growth(Document& document) {
  document.section("Their energy never falls");
  document.text(
      R"(A symmetric top, $L$ kept, turned by any angle $\varphi$ about its angular velocity. With $l_z = I_a \Omega
n_3$, the momentum about the axis, and)");
  document.display(R"(\kappa = (1 - \cos\varphi)\,(1 - n_3^2)\left(\frac{I_t}{I_a} - 1\right), \qquad
\sigma = \frac1{I_a} - \frac1{I_t} = \frac{I_t - I_a}{I_a I_t})");
  const Turn turn;
  const Top top;
  const Relations& relations = turn.relations;
  const Vector l = turn.w.cwiseProduct(top.body.moments);
  const State start = {.p_WB = letters("p"), .q_WB = turn.q, .v_WB = letters("v"), .L_W = relations(turned(turn.q, l))};
  State end = start;
  end.q_WB = turn.end;
  const ex versine = 2 * pow(turn.S, 2);
  const ex kappa = versine * (1 - pow(turn.n.z(), 2)) * (top.transverse / top.axial - 1);
  const ex sigma = 1 / top.axial - 1 / top.transverse;
  const ex gain = formula::rotational_energy(end, top.body) - formula::rotational_energy(start, top.body);
  document.prove(relations({.text = R"($l_z' = (1 + \kappa)\, l_z$)",
                            .result = formula::in_body(end.q_WB, end.L_W).z(),
                            .witness = (1 + kappa) * l.z(),
                            .controls = {l.z()}}));
  document.prove(relations({.text = R"($E' - E = \frac12 l_z^2\, \sigma\kappa\, (2 + \kappa)$)",
                            .result = gain,
                            .witness = l.z() * l.z() * sigma * kappa * (2 + kappa) / 2,
                            .controls = scaled(gain)}));
  document.prove({.text = R"($\sigma\kappa = (1 - \cos\varphi)(1 - n_3^2)(I_t - I_a)^2 / (I_a^2 I_t)$)",
                  .result = sigma * kappa,
                  .witness = versine * (1 - pow(turn.n.z(), 2)) * pow(top.transverse - top.axial, 2) /
                             (pow(top.axial, 2) * top.transverse)});
  document.text(
      R"(So $\sigma\kappa \ge 0$, and $2 + \kappa > 0$ since $I_a \le 2 I_t$ makes $\kappa \ge -1$: at no step, whatever its
size, does the energy fall, and it grows but for a ball, for $L$ along the axis or across it, and for whole turns.
While $\varphi < 2\pi$ at every step (always with explicit Euler), it goes to where $E$ is greatest for its $|L|$: with
the axis across $L$ if $I_a > I_t$, along $L$ if $I_a < I_t$. From a spin next to the axis, for $I_a > I_t$, that is a
gain of)");
  const auto energy_of = [&](const Vector& momentum) {
    State state = start;
    state.L_W = relations(turned(turn.q, momentum));
    return formula::rotational_energy(state, top.body);
  };
  const ex across = energy_of(Vector(top.length, 0, 0));
  const ex along = energy_of(Vector(0, 0, top.length));
  document.prove({.text = R"($I_a / I_t - 1$, relative)",
                  .result = relations(across) / relations(along) - 1,
                  .witness = top.axial / top.transverse - 1});
  energy_of_a_step(document);
}

inline void published_loop(Document& document) {
  document.section("The talk's loop keeps another thing");
  document.text(
      R"(With $\omega_W$ constant and the quaternion by explicit Euler, $L_W = q (I \bar q \omega_W q) \bar q$ is not
constant: the scheme converges to a turn with constant $\omega_W$, which is not the motion of a free body unless
$\omega$ is along a principal axis.)");
  const Start body;
  Series::last_power = 1;
  Series::relations = body.relations;
  const SeriesQuaternion step = explicit_step(body);
  const goishi::RigidBody<Series> moments = {.mass = Series(1), .moments = constant_series(body.J.cwiseInverse())};
  const SeriesVector w_B = formula::in_body(step, constant_series(body.w_W()));
  const ex change = components(coefficient(formula::angular_momentum_W(step, moments, w_B), 1));
  document.prove(body.relations({.text = R"($\dot L_W = \omega_W \times L_W$)",
                                 .result = change,
                                 .witness = components(body.w_W().cross(body.L_W())),
                                 .controls = scaled(change)}));
}

}  // namespace derivation
