/// \file
/// Free flight: what a moving body's momenta and energies are, the same from another frame, and the motion in closed
/// form.

#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "moving.hpp"
#include "proof.hpp"
#include "relations.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

void definitions(Document& document, const Moving& b) {
  document.section("Momenta and energies");
  document.text(
      R"(The point $x$ of the body (in B) is at $p + q x \bar q$ in W and has the velocity $\dot x = v + \omega_W
\times q x \bar q$, $\omega_W = q \omega_B \bar q$, $|q| = 1$. B is at the centre of mass along the principal axes, so
over the body $\int x_i\,\mathrm{d}m = 0$ and $\int x_i x_j\,\mathrm{d}m$ is $E_i$ or 0; the moments are $I_1 = E_2 +
E_3$ and so on.)");
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(b.relations.whole(text, result, witness));
  };
  document.shipped("formula::in_body", "motion/state.hpp");
  const Vector in_body = formula::in_body(b.q, b.v);
  document.prove(b.relations(
      {.text = R"($\bar q v q$)", .result = components(in_body), .witness = components(turned(conjugated(b.q), b.v))}));
  document.shipped("formula::angular_momentum_W", "motion/state.hpp");
  const Vector moments = positive_letters("I");
  const exmap sums = {{moments.x(), b.moments.x()}, {moments.y(), b.moments.y()}, {moments.z(), b.moments.z()}};
  document.prove(
      b.relations({.text = R"($L_W = \int q x \bar q \times (\omega_W \times q x \bar q)\,\mathrm{d}m$)",
                   .result = components(formula::angular_momentum_W(b.q, {.mass = b.mass, .moments = moments}, b.w)),
                   .witness = components(b.spin),
                   .view = [&](const ex& e) { return e.subs(sums); }}));
  document.shipped("formula::angular_velocity_B`, `_W", "motion/state.hpp");
  // Quotients by sums such as E_2 + E_3 are the moments again: reduced first, then cancelled.
  const State given = {
      .p_WB = b.p, .q_WB = b.q, .v_WB = b.v, .L_W = b.relations(turned(b.q, moments.cwiseProduct(b.w)))};
  const Body body = {.mass = b.mass, .moments = moments};
  document.text(R"(With $L_W = q (I \omega_B) \bar q$, as just proved:)");
  prove(R"($\omega_B$)", components(formula::angular_velocity_B(given, body)), components(b.w));
  prove(R"($\omega_W$)", components(formula::angular_velocity_W(given, body)), components(b.w_W));

  const Vector velocity = b.v + b.swing;
  const Vector g = letters("g");
  const auto with_sums = [&](const ex& e) { return b.relations(e).subs(sums); };
  const auto prove_energy = [&](const std::string& text, const ex& result, const ex& integrand) {
    document.prove({.text = text,
                    .result = with_sums(result),
                    .witness = b.over(integrand),
                    .controls = scaled(with_sums(result))});
  };
  document.shipped("formula::rotational_energy`, `translational_energy`, `potential_energy`, `energy",
                   "motion/invariants.hpp");
  const ex rotational = formula::rotational_energy(given, body);
  prove_energy(R"(rotation: $\frac12 \int |\omega_W \times q x \bar q|^2\,\mathrm{d}m$)", rotational,
               b.swing.dot(b.swing) / 2);
  prove_energy(R"(translation: $\frac12 \int |v|^2\,\mathrm{d}m$)", formula::translational_energy(given, body),
               b.v.dot(b.v) / 2);
  prove_energy(R"(position: $-\int g \cdot (p + q x \bar q)\,\mathrm{d}m$)", formula::potential_energy(given, body, g),
               -g.dot(Vector(b.p + b.arm)));
  prove_energy(R"(all: $\int (\frac12 |\dot x|^2 - g \cdot (p + q x \bar q))\,\mathrm{d}m$)",
               formula::energy(given, body, g), velocity.dot(velocity) / 2 - g.dot(Vector(b.p + b.arm)));
  document.shipped("formula::linear_momentum`, `angular_momentum_about", "motion/invariants.hpp");
  prove_energy(R"($\int \dot x\,\mathrm{d}m$)", components(formula::linear_momentum(given, body)),
               components(velocity));
  const Vector P = letters("P");
  prove_energy(R"(about a point $P$: $\int (p + q x \bar q - P) \times \dot x\,\mathrm{d}m$)",
               components(formula::angular_momentum_about(P, given, body)),
               components(Vector(Vector(b.p + b.arm - P).cross(velocity))));
}

/// Free flight in W, and what must come of it in a frame V.
void other_frame(Document& document, const Moving& b) {
  document.section("Another inertial frame");
  document.text(
      R"(V has the pose $(P, r)$, $|r| = 1$, and moves with $u$, not turning. A point that is at $X$ in W and moves
with $\dot X$ is at $\bar r (X - P) r$ in V and moves with $\bar r (\dot X - u) r$. Here $L_W$ is any vector.)");
  document.shipped("formula::seen_from", "motion/invariants.hpp");
  const Vector P = letters("P");
  const Quaternion r = quaternion_letters("r");
  const Vector u = letters("u");
  const Vector L = letters("L");
  const Vector g = letters("g");
  const Relations relations = Relations().unit(b.q).unit(r);
  const auto in_V = [&](const Vector& vector) { return relations(turned(conjugated(r), vector)); };
  const auto reduced = [&](const State& s) {
    return State{
        .p_WB = relations(s.p_WB), .q_WB = relations(s.q_WB), .v_WB = relations(s.v_WB), .L_W = relations(s.L_W)};
  };
  const State state = {.p_WB = b.p, .q_WB = b.q, .v_WB = b.v, .L_W = L};
  const State seen = reduced(formula::seen_from(P, r, u, state));
  const Vector moments = positive_letters("I");
  const Body body = {.mass = b.mass, .moments = moments};
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations.whole(text, result, witness));
  };
  prove("each point of the body is where V sees it", components(Vector(seen.p_WB + turned(seen.q_WB, b.x))),
        components(in_V(Vector(b.p + b.arm - P))));
  prove(R"(its attitude is $\bar r q$, not $-\bar r q$)", components(seen.q_WB),
        components(relations(hamilton(conjugated(r), b.q))));
  prove("its centre moves as V sees it", components(seen.v_WB), components(in_V(Vector(b.v - u))));
  prove(R"(it turns as V sees it: $\omega$ is the same vector)", components(formula::angular_velocity_W(seen, body)),
        components(in_V(relations(formula::angular_velocity_W(state, body)))));
  prove("$L$ is the same vector", components(seen.L_W), components(in_V(L)));
  document.text("So the invariants are those of a body that moves by $-u$ more (Galilei):");
  prove("energy of rotation, the same", formula::rotational_energy(seen, body),
        relations(formula::rotational_energy(state, body)));
  prove(R"(energy of translation, less $u \cdot m v - \frac12 m u^2$)", formula::translational_energy(seen, body),
        formula::translational_energy(state, body) - b.mass * (u.dot(b.v) - u.dot(u) / 2));
  prove("energy of position, from $P$", formula::potential_energy(seen, body, in_V(g)),
        formula::potential_energy(state, body, g) + b.mass * g.dot(P));
  prove("momentum, less $mu$", components(formula::linear_momentum(seen, body)),
        components(in_V(Vector(formula::linear_momentum(state, body) - Vector(b.mass * u)))));
  prove(R"(angular momentum about $P$, less $(p - P) \times m u$)",
        components(formula::angular_momentum_about(Vector(0, 0, 0), seen, body)),
        components(
            in_V(Vector(formula::angular_momentum_about(P, state, body) - Vector(b.mass * Vector(b.p - P).cross(u))))));
  document.text("And to fly and to be seen commute (V is at $P + ut$ by then):");
  const possymbol t("t");
  const State first_seen = reduced(formula::ballistic_flight<ex>(seen, in_V(g), t));
  const State first_flown =
      reduced(formula::seen_from(Vector(P + Vector(t * u)), r, u, formula::ballistic_flight<ex>(state, g, t)));
  prove("position", components(first_seen.p_WB), components(first_flown.p_WB));
  prove("velocity", components(first_seen.v_WB), components(first_flown.v_WB));
}

void parabola(Document& document) {
  document.section("The centre of mass");
  document.text(R"($v(t) = v + \int_0^t g\,\mathrm{d}\tau$ and $p(t) = p + \int_0^t v(\tau)\,\mathrm{d}\tau$.)");
  document.shipped("formula::ballistic_flight`, `falling", "motion/free_flight.hpp");
  const realsymbol t("t");
  const symbol tau("tau");
  const Vector g = letters("g");
  const State start = {
      .p_WB = letters("p"), .q_WB = quaternion_letters("q"), .v_WB = letters("v"), .L_W = letters("L")};
  const State end = formula::ballistic_flight<ex>(start, g, t);
  document.equation("p_1(t)", end.p_WB.x());
  const ex velocity = components(start.v_WB) + integral(components(g), tau, 0, t);
  document.prove({.text = "$v(t)$", .result = components(end.v_WB), .witness = velocity});
  document.prove({.text = "$p(t)$",
                  .result = components(end.p_WB),
                  .witness = components(start.p_WB) + integral(velocity.subs(t == tau), tau, 0, t)});
  document.prove({.text = "the attitude stays", .result = components(end.q_WB), .witness = components(start.q_WB)});
  const Quaternion then = quaternion_letters("r");
  document.prove({.text = "or is what it is said to be by then",
                  .result = components(formula::falling<ex>(start, then, g, t).q_WB),
                  .witness = components(then)});
  document.prove({.text = "$L_W$ stays", .result = components(end.L_W), .witness = components(start.L_W)});
  document.shipped("gravity_W`, `standard_gravity", "motion/invariants.hpp");
  document.prove({.text = "$(0, 0, -g)$ with $g = 9.80665$",
                  .result = components(goishi::gravity_W<ex>()),
                  .witness = components(Vector(0, 0, ex(-980665) / 100000))});
}

void rotation(Document& document, const Top& top) {
  document.section("The rotation of a torque-free top");
  document.text(
      R"(Without a torque $L_W$ is constant, and the body's angular velocity is what this momentum asks for: $\omega_B
= I^{-1} (\bar q L q)$. So its attitude solves

$$\dot q = \tfrac12\, q\, (0, \omega_B), \qquad \omega_B = I^{-1} (\bar q L q), \qquad q(0) \text{ given},$$

which has one solution. $L = \Lambda n$ with $|n| = 1$; $C$, $S$ are cosine and sine of $\Lambda t / 2I_t$; $c$, $s$
those of $L_z t (1/I_a - 1/I_t)/2$. The attitude at first, $q(0) = (q_0, q_1, q_2, q_3)$, is any, $|q(0)| = 1$.)");
  const Relations& relations = top.relations;
  document.shipped("formula::axial_momentum", "motion/free_flight.hpp");
  const Vector L_B = relations(turned(conjugated(top.q), top.L));
  document.prove(relations({.text = R"($L_z = L \cdot q B_z \bar q$ is the last component of $L_B = \bar q L q$)",
                            .result = top.axial_momentum,
                            .witness = L_B.z()}));
  const Vector l = letters("l");
  document.prove(
      {.text = R"(by `mobility`, $I^{-1} L_B = L_B/I_t + (1/I_a - 1/I_t)\, L_z B_z$)",
       .result = components(Vector(top.mobility.transverse * l)) + components(Vector(0, 0, top.mobility.axial * l.z())),
       .witness = components(Vector(l.cwiseQuotient(top.body.moments)))});

  document.shipped("formula::turned_top", "motion/free_flight.hpp");
  const realsymbol alpha("alpha", R"(\alpha)"), beta("beta", R"(\beta)");
  const Relations half_angles = Relations().unit(top.q).angle(alpha, top.C, top.S).angle(beta, top.c, top.s);
  const ex both = half_angles(components(formula::turned_top<ex>(top.q, top.n, alpha, beta)));
  const Quaternion about_k = quaternion(top.C, Vector(top.S * top.n)),
                   about_axis = quaternion(top.c, Vector(0, 0, top.s));
  document.prove({.text = R"(it is $(\cos\alpha, k \sin\alpha)\, q\, (\cos\beta, B_z \sin\beta)$)",
                  .result = both,
                  .witness = half_angles(components(hamilton(hamilton(about_k, top.q), about_axis))),
                  .controls = {-both, both * ex(1001) / 1000, both.subs(top.S == -top.S), both.subs(top.s == -top.s)}});
  document.shipped("formula::free_rotation", "motion/free_flight.hpp");
  document.equation("q_0(t)", top.path.w());
  const ex path = components(top.path);
  const auto rate = [&](const ex& e) { return relations.rate(e, top.t); };
  const std::vector<ex> wrong = {-path, path.subs(top.S == -top.S), path.subs(top.s == -top.s),
                                 path.subs(top.c == top.C)};
  document.prove({.text = "$|q(t)| = 1$",
                  .result = relations(squared_norm(top.path)),
                  .witness = 1,
                  .controls = {relations(squared_norm(Quaternion(top.path.coeffs() * 2)))}});
  if (!(relations(squared_norm(top.path)) - 1).is_zero()) {
    throw std::logic_error("the attitude leaves the unit sphere; what follows would hardly end");
  }
  const Vector L_B_now = relations(turned(conjugated(top.path), top.L));
  const Vector w_B = L_B_now.cwiseQuotient(top.body.moments);
  const Quaternion flow = relations(hamilton(top.path, pure(Vector(w_B / 2))));
  document.prove(
      {.text = "the equation", .result = path, .witness = components(flow), .view = rate, .controls = wrong});
  document.prove({.text = "and it begins there: $q(0)$",
                  .result = relations.at_zero_angles(path),
                  .witness = components(top.q),
                  .controls = {relations.at_zero_angles(path) * ex(1001) / 1000}});
  document.text(
      R"(Thereby the rest. Euler's equations are $\dot L_B = L_B \times \omega_B$, here with $\omega_B$ out of the motion
itself, $(0, \omega_B) = 2 \bar q \dot q$.)");
  const Quaternion moved = relations.rate(top.path, top.t);
  const Vector w_of_motion = relations(Vector(2 * hamilton(conjugated(top.path), moved).vec()));
  const Vector L_of_motion = w_of_motion.cwiseProduct(top.body.moments);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations.whole(text, result, witness));
  };
  prove(R"($\dot L_B = L_B \times \omega_B$)", rate(components(relations(L_of_motion))),
        components(Vector(relations(L_of_motion).cross(w_of_motion))));
  prove(R"(the angular momentum $q (I \omega_B) \bar q$ of this motion is $L$ at every time)",
        components(turned(top.path, relations(L_of_motion))), components(top.L));
  const State start = {.p_WB = letters("p"), .q_WB = top.q, .v_WB = letters("v"), .L_W = top.L};
  State end = start;
  end.q_WB = top.path;
  prove("its energy of rotation is constant", formula::rotational_energy(end, top.body),
        relations(formula::rotational_energy(start, top.body)));
  prove("and so is $L_z$", formula::axial_momentum(top.path, top.L), top.axial_momentum);
}

void more_times(Document& document, const Top& top) {
  document.section("Other times, other tops");
  const Relations& relations = top.relations;
  const auto after = [&](const ex& u) {
    return components(formula::free_rotation<ex>(top.path, top.L, top.axial_momentum, top.mobility, u));
  };
  const ex at_first = components(top.q);
  document.prove(relations({.text = "a time $t$ and then $-t$: as at first, so the formula holds for negative times",
                            .result = after(-top.t),
                            .witness = at_first,
                            .controls = {after(top.t), at_first * 2}}));
  const possymbol u("u");
  const realsymbol D("D");
  const realsymbol T("T");
  const realsymbol d("d");
  const realsymbol e("e");
  const exmap later = {{top.t, u}};
  Relations two_times = relations;
  two_times.angle(top.precession_angle.subs(later), D, T).angle(top.spin_angle.subs(later), d, e);
  const auto& [C, S] = std::pair<ex, ex>(top.C, top.S);
  const auto& [c, s] = std::pair<ex, ex>(top.c, top.s);
  const exmap sum = {{C, C * D - S * T}, {S, S * D + C * T}, {c, c * d - s * e}, {s, s * d + c * e}};
  document.prove(two_times({.text = "a time $t$ and then $u$: as after $t + u$ (cosine and sine of a sum)",
                            .result = after(u),
                            .witness = components(top.path).subs(sum),
                            .controls = {components(top.path), 2 * components(top.path)}}));
  document.text("The limits need no case of their own.");
  document.prove({.text = "$L = 0$, where both angles vanish: at rest",
                  .result = relations.at_zero_angles(components(top.path)),
                  .witness = at_first,
                  .controls = {components(top.path)}});
  const goishi::Mobility<ex> ball = formula::mobility<ex>(1, {.axial = top.transverse, .transverse = top.transverse});
  const ex turning = components(formula::free_rotation<ex>(top.q, top.L, top.axial_momentum, ball, top.t));
  document.prove(relations({.text = "$I_a = I_t$: it turns about $L$ with $L/I_t$",
                            .result = turning,
                            .witness = components(hamilton(quaternion(C, Vector(S * top.n)), top.q)),
                            .controls = {-turning, components(top.path), turning.subs(top.t == 2 * top.t)}}));
}

void flight(Document& document, const Top& top) {
  document.section("Free flight");
  document.shipped("formula::free_flight", "motion/free_flight.hpp");
  const Relations& relations = top.relations;
  const Vector g = letters("g");
  const State start = {.p_WB = letters("p"), .q_WB = top.q, .v_WB = letters("v"), .L_W = top.L};
  const State end = formula::free_flight<ex>(start, top.mobility, g, top.t);
  const State fall = formula::ballistic_flight<ex>(start, g, top.t);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations.whole(text, result, witness));
  };
  prove("position of the parabola", components(end.p_WB), components(fall.p_WB));
  prove("velocity of the parabola", components(end.v_WB), components(fall.v_WB));
  prove("attitude of the top", components(end.q_WB), components(top.path));
  prove("$L_W$ stays", components(end.L_W), components(top.L));
  document.text("What it keeps, and what gravity adds:");
  const State now = {.p_WB = end.p_WB, .q_WB = top.path, .v_WB = end.v_WB, .L_W = end.L_W};
  prove("the energy is constant", formula::energy(now, top.body, g), formula::energy(start, top.body, g));
  const ex mass = top.body.mass;
  prove("the momentum gains $m g t$", components(formula::linear_momentum(now, top.body)),
        mass * components(Vector(start.v_WB + Vector(top.t * g))));
  const Vector P = letters("P");
  const Vector torque = Vector(end.p_WB - P).cross(Vector(mass * g));
  const ex momentum = components(formula::angular_momentum_about(P, now, top.body));
  document.prove(
      {.text = R"(the angular momentum about a point $P$ changes by the torque of gravity, $(p - P) \times m g$)",
       .result = momentum,
       .witness = components(torque),
       .view = [&](const ex& e) { return e.diff(top.t); },
       .controls = scaled(momentum)});
}

}  // namespace

int main() {
  return derive("Free flight", [](Document& document) {
    const Moving moving;
    definitions(document, moving);
    other_frame(document, moving);
    parabola(document);
    const Top top;
    rotation(document, top);
    more_times(document, top);
    flight(document, top);
  });
}
