/// \file
/// The equations of the contact phase: the rates of its variables, the ledger of its energy, damping, what a contact's
/// impulses do, and the bounds and slopes of the resistance.

#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/contact_motion.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/equations/resisting.hpp>
#include <goishi/drop/equations/slip.hpp>
#include <goishi/drop/phases/flight_phase.hpp>
#include <goishi/drop/rest/rest.hpp>
#include <goishi/drop/rest/statics.hpp>

#include "contact.hpp"

namespace {

using namespace derivation;
namespace at = goishi::detail::at;

const possymbol c("c"), delta("delta", R"(\delta)"), kappa("kappa", R"(\kappa)");
const realsymbol sx("sx", "s_x"), sy("sy", "s_y");

void axis(Document& document) {
  document.section("The axis keeps its length");
  document.text(
      R"(The integration lets the length of the axis drift, and takes it back before anything is asked of it: $a = (1 +
\epsilon) u$, $|u| = 1$.)");
  document.shipped("formula::reunited_axis", "drop/equations/kinetics.hpp");
  const realsymbol epsilon("epsilon", R"(\epsilon)");
  const Vector u = letters("u");
  const ex result = components(formula::reunited_axis<ex>(Vector((1 + epsilon) * u)));
  document.prove(Relations().unit(u)(
      {.text = R"(it is $(1 + \frac52 \epsilon^3 + \frac{15}{8} \epsilon^4 + \frac38 \epsilon^5)\, u$)",
       .result = result,
       .witness = (1 + 5 * pow(epsilon, 3) / 2 + 15 * pow(epsilon, 4) / 8 + 3 * pow(epsilon, 5) / 8) * components(u)}));
}

/// A stone in contact, a force and a torque of resistance per normal force on it, and the shipped rates.
struct Moved : Touching {
  Vector F = letters("F"), tau = letters("T"), origin = letters("o");
  realsymbol x{"x"}, y{"y"};
  Vector slip = Vector(sx, sy, 0);
  Vector w = J(L), u_rate = w.cross(u);
  Vector centre = slip - w.cross(r());
  goishi::detail::Kinetics<ex> kinetics{now, tau, formula::turned_point(mobility, u, now.r, tau)};
  ex damped = formula::damping_power<ex>(now, c, sx, sy);
  goishi::detail::Variables<ex> rates = formula::contact_rates<ex>(kinetics, tau, c, damped, F, sx, sy, origin);
  Vector L_rate = there(Vector(r().cross(F))) + Vector(F.z() * tau) - Vector(c * L);

  [[nodiscard]] Vector three(std::size_t from) const {
    return there(Vector(rates[from], rates[from + 1], rates[from + 2]));
  }
};

void rates(Document& document, const Moved& stone) {
  document.section("The rates");
  document.text(
      R"(As in the chapter *A stone in contact with a plane*, with a force $F$ at the contact point, which slips with
$s$, and the torque $N\tau$ of the resistance that goes with the normal force $N = F_z$. The two momenta may be damped
at the rate $c$: $\dot v = F + g - c v$, $\dot L = r \times F + N\tau - c L$.)");
  document.shipped("formula::contact_rates", "drop/equations/kinetics.hpp");
  const ex u_rate = components(stone.three(at::u)), L_rate = components(stone.three(at::L));
  document.prove(
      {.text = R"($\dot u = \omega \times u$)", .result = u_rate, .witness = components(stone.there(stone.u_rate))});
  document.prove({.text = R"($\dot L$)", .result = L_rate, .witness = components(stone.L_rate)});
  const ex place = stone.there(stone.rates[at::x] + 2 * stone.rates[at::y]);
  document.prove({.text = R"(the centre moves with the horizontal part of $s - \omega \times r$)",
                  .result = place,
                  .witness = stone.there(stone.centre.x() + 2 * stone.centre.y())});
  const ex spin = stone.rates[at::spin];
  document.prove(Relations().unit(stone.u)(
      {.text = R"($\dot\psi = \omega \cdot u + a \cdot (u \times \dot u)/(1 + a \cdot u)$, carried from the axis $a$)",
       .result = spin,
       .witness =
           stone.w.dot(stone.u) * (1 + stone.origin.dot(stone.u)) + stone.origin.dot(stone.u.cross(stone.u_rate)),
       .view = [&](const ex& e) { return (e * (1 + formula::dot(stone.origin, stone.u))).normal(); },
       .controls = scaled(spin)}));
  document.prove({.text = "no rate of the slip is told here",
                  .result = stone.rates[at::slip] + stone.rates[at::direction],
                  .witness = 0,
                  .controls = {1}});
  document.shipped("formula::centre_velocity", "drop/equations/contact_motion.hpp");
  const Vector centre = formula::centre_velocity<ex>(stone.now, sx, sy);
  const ex moves = components(stone.there(Vector(centre + stone.now.point)));
  document.prove({.text = R"(with this $v$, $v + \omega \times r$ is the slip $(s_x, s_y, 0)$)",
                  .result = moves,
                  .witness = components(stone.slip)});
  document.shipped("formula::carried_attitude", "drop/equations/carried.hpp");
  const Quaternion first = quaternion_letters("q");
  const realsymbol psi("psi", R"(\psi)");
  const Vector a = letters("b");
  const Quaternion shortest = formula::shortest_rotation<ex>(a, stone.u);
  const ex attitude = components(formula::carried_attitude<ex>(a, first, stone.u, psi));
  document.prove(
      {.text = R"(the attitude is $\mathrm{shortest}(a, u)\, q_a\, (\cos\frac\psi2, \hat z \sin\frac\psi2)$)",
       .result = attitude,
       .witness = components(hamilton(hamilton(shortest, first), Quaternion(cos(psi / 2), 0, 0, sin(psi / 2)))),
       .controls = {-attitude, components(formula::carried_attitude<ex>(a, first, stone.u, -psi)),
                    components(formula::carried_attitude<ex>(stone.u, first, a, psi)),
                    components(formula::carried_attitude<ex>(a, conjugated(first), stone.u, psi))}});
}

void ledger(Document& document, const Moved& stone) {
  document.section("Damping");
  document.shipped("formula::damping_power", "drop/equations/kinetics.hpp");
  document.prove({.text = R"($c v$ and $c L$ take $c\,(|v|^2 + \omega \cdot L)$)",
                  .result = stone.there(stone.damped),
                  .witness = stone.there(c * (stone.centre.dot(stone.centre) + stone.w.dot(stone.L))),
                  .controls = scaled(stone.there(stone.damped))});
  document.text(
      R"(The contact point's acceleration under all of it, by the chain rule: $\dot v + \frac{\mathrm{d}}{\mathrm{d}t}
(\omega \times r)$ with $\omega = J(u) L$ and $r(u)$.)");
  document.shipped("formula::damped", "drop/equations/slip.hpp");
  const Vector turning = stone.w.cross(stone.r());
  const Vector acceleration =
      stone.F + stone.g - stone.there(Vector(c * stone.centre)) + stone.rate(turning, stone.u_rate, stone.L_rate);
  const Vector undamped = formula::minus(
      formula::plus(formula::product(stone.now.W, stone.F), stone.F.z(), stone.kinetics.brake), stone.now.need);
  const ex damped = stone.there(components(
      Vector(formula::damped<ex>(undamped.x(), c, sx), formula::damped<ex>(undamped.y(), c, sy), undamped.z())));
  document.prove(
      {.text = R"(it is $W F + N J\tau \times r - \mathrm{need} - c s$: the slip is damped as the momenta are)",
       .result = damped,
       .witness = components(acceleration),
       .controls = scaled(damped)});

  document.section("The ledger of the energy");
  document.shipped("formula::contact_energy", "drop/equations/contact_motion.hpp");
  const ex kinetic = formula::contact_kinetic_energy<ex>(stone.now, sx, sy);
  const ex energy = formula::contact_energy<ex>(stone.now, stone.g, stone.x, stone.y, kinetic);
  document.prove({.text = R"($E = \frac12 |v|^2 + \frac12 \omega \cdot L - g \cdot (x, y, S)$)",
                  .result = stone.there(energy),
                  .witness = stone.there((stone.centre.dot(stone.centre) + stone.w.dot(stone.L)) / 2 -
                                         stone.g.dot(Vector(stone.x, stone.y, stone.geometry.height))),
                  .controls = scaled(stone.there(energy))});
  document.shipped("formula::slowing", "drop/equations/contact_motion.hpp");
  const possymbol taken("taken", "t"), whole("whole", "K");
  const ex factor = formula::slowing<ex>(taken, whole);
  const possymbol slower("s");
  document.prove(
      {.text = "of a kinetic energy $K$, what all velocities times $s$ leave, $s^2 K$, is $K$ less what is taken",
       .result = factor,
       .witness = slower,
       .meaning = {{taken, whole * (1 - pow(slower, 2))}},
       .controls = {2 * factor, -factor, formula::slowing<ex>(whole, taken)}});
  const ex power = stone.rate(energy, stone.three(at::u), stone.three(at::L)) +
                   stone.there(energy.diff(stone.x) * stone.rates[at::x] + energy.diff(stone.y) * stone.rates[at::y] +
                               energy.diff(sx) * acceleration.x() + energy.diff(sy) * acceleration.y());
  const ex lost = stone.there(stone.rates[at::loss]), lift = stone.there(turning.z()) * acceleration.z();
  document.prove(
      {.text = R"(along the shipped rates $\dot E$ and that of the loss add up to $(\omega \times r)_z\, a_z$)",
       .result = power + lost,
       .witness = lift,
       .controls = {power - lost, power + lost * ex(1001) / 1000, power}});
  document.text(
      R"(A normal force that keeps the contact point on the plane has $a_z = 0$: then the energy and what the loss has
counted are constant together. Friction against the slip, a torque against $\omega$, and $c \ge 0$ only take.)");
}

void impulses(Document& document, const Moved& stone) {
  document.section("Impulses at a contact");
  document.text(
      R"(An impulse $F$ on the contact point and one of torque $\tau$ beside it, per unit of mass: $v$ becomes $v + F$,
$L$ becomes $L + r \times F + \tau$. Any motion before: $v$ and $\omega = J L$.)");
  document.shipped("formula::contact_gain", "drop/equations/contact_motion.hpp");
  const Vector &F = stone.F, &tau = stone.tau, v = letters("v");
  const auto at_once = [&](const Vector& force, const Vector& torque) {
    return formula::contact_gain<ex>(stone.mobility, stone.now, force, torque);
  };
  const goishi::ContactGain<ex> gain = at_once(F, tau);
  const Vector r = stone.now.r, change = r.cross(F) + tau;
  const ex turns = components(gain.w), point = components(gain.point);
  document.prove(
      {.text = R"($\Delta\omega = J (r \times F + \tau)$)", .result = turns, .witness = components(stone.J(change))});
  document.prove({.text = R"($\Delta(v + \omega \times r) = F + \Delta\omega \times r$)",
                  .result = point,
                  .witness = components(Vector(F + stone.J(change).cross(r))),
                  .controls = scaled(point)});
  document.shipped("formula::contact_work", "drop/equations/contact_motion.hpp");
  const goishi::ContactGain<ex> before{Vector(v + stone.w.cross(r)), stone.w};
  const auto energy = [&](const Vector& velocity, const Vector& momentum) {
    return (velocity.dot(velocity) + momentum.dot(stone.J(momentum))) / 2;
  };
  const ex on_before = formula::contact_work<ex>(F, tau, before), on_gain = formula::contact_work<ex>(F, tau, gain);
  document.prove(
      {.text = R"(the work on the motion before and half of that on the gain are the change of $\frac12 |v|^2 +
\frac12 \omega \cdot L$)",
       .result = on_before + on_gain / 2,
       .witness = energy(Vector(v + F), Vector(stone.L + change)) - energy(v, stone.L),
       .controls = {on_before + on_gain, on_before - on_gain / 2, on_before, on_gain / 2,
                    on_before * ex(1001) / 1000 + on_gain / 2}});
  const Vector G = letters("G"), sigma = letters("S");
  const ex mutual = formula::contact_work<ex>(G, sigma, gain);
  document.prove({.text = "what one does on the gain of another, that does on its: the energy is one quadratic form",
                  .result = mutual,
                  .witness = formula::contact_work<ex>(F, tau, at_once(G, sigma)),
                  .controls = scaled(mutual)});
}

void resistance(Document& document) {
  document.section("How resistance changes");
  document.text(
      R"($\tau$ is the torque per normal force of the chapter *A stone in contact with a plane*, $R$ the root in it,
$R^2 = \delta^2 |\omega_h|^2 + \kappa^2 \omega_z^2 + f$.)");
  document.shipped("formula::resistance_slope", "drop/equations/resisting.hpp");
  const possymbol f("f"), R("R");
  const Vector w = letters("w"), dw = letters("x");
  const ex square = pow(delta, 2) * (pow(w.x(), 2) + pow(w.y(), 2)) + pow(kappa, 2) * pow(w.z(), 2);
  const auto torque = [&](const ex& floor) { return formula::resistance<ex>(pow(delta, 2), pow(kappa, 2), w, floor); };
  const exmap rooted = {{f, pow(R, 2) - square}};
  const auto with_root = [&](const ex& e) { return resolve_roots(e.subs(rooted).expand()); };
  const ex of_torque = components(torque(f));
  ex moved = 0;
  for (int i = 0; i < 3; ++i) {
    moved += of_torque.diff(GiNaC::ex_to<symbol>(w(i))) * dw(i);
  }
  const Vector with_letters = Vector(with_root(torque(f).x()), with_root(torque(f).y()), with_root(torque(f).z()));
  const ex slope = components(formula::resistance_slope<ex>(pow(delta, 2), pow(kappa, 2), 1 / R, with_letters, dw));
  document.prove({.text = R"(it is $\sum_i \frac{\partial\tau}{\partial\omega_i}\, \mathrm{d}\omega_i$)",
                  .result = slope,
                  .witness = with_root(moved)});
  document.shipped("formula::parts_along", "drop/equations/resisting.hpp");
  const Vector a = letters("f"), b = letters("k"), d = letters("w"), v = letters("v");
  const Vector parts = formula::parts_along<ex>(a, b, d, v);
  const ex sum = components(Vector(parts.x() * a + parts.y() * b + parts.z() * d));
  document.prove(
      {.text = "$x_1 a + x_2 b + x_3 c = v$", .result = sum, .witness = components(v), .controls = scaled(sum)});

  document.section("What resistance can bear");
  document.shipped("formula::resistance_share", "drop/rest/statics.hpp");
  const possymbol N("N");
  const Vector n = letters("n"), t = letters("t");
  const ex share = formula::resistance_share<ex>(n, t, N, delta, kappa);
  document.prove(Relations().unit(n)(
      {.text = R"(its square is $|n \times t|^2/(\delta N)^2 + (n \cdot t)^2/(\kappa N)^2$)",
       .result = pow(share, 2),
       .witness = formula::dot(n.cross(t), n.cross(t)) / pow(delta * N, 2) + pow(n.dot(t), 2) / pow(kappa * N, 2),
       .controls = scaled(pow(share, 2))}));
  const Vector moving = torque(0);
  const auto borne = [&](const ex& force) {
    return pow(formula::resistance_share<ex>(up, Vector(N * moving), force, delta, kappa), 2);
  };
  document.prove(
      {.text = R"(of the resistance itself, $N\tau$ against any turning, it is 1)",
       .result = borne(N),
       .witness = 1,
       .controls = {borne(2 * N), pow(formula::resistance_share<ex>(up, Vector(N * moving), N, kappa, delta), 2)}});
  document.prove({.text = R"(and of $\delta N$ across $n$ alone it is 1, not $-1$)",
                  .result = formula::resistance_share<ex>(up, Vector(N * delta, 0, 0), N, delta, kappa),
                  .witness = 1,
                  .controls = {-1, formula::resistance_share<ex>(up, Vector(N * delta, 0, 0), N, kappa, delta)}});
  document.shipped("formula::resistance_lever", "drop/rest/rest.hpp");
  const ex roll = pow(w.x(), 2) + pow(w.y(), 2), pivot = pow(w.z(), 2);
  const ex lever = pow(formula::resistance_lever<ex>(delta, kappa, roll, pivot), 2);
  document.prove(
      {.text = R"(its square is $(\tau \cdot \omega)^2/|\omega|^2$: the power of resistance per normal force and
$|\omega|$)",
       .result = lever,
       .witness = pow(moving.dot(w), 2) / (roll + pivot)});
  document.prove({.text = R"(and without $\omega_z$ it is $\delta$)",
                  .result = formula::resistance_lever<ex>(delta, kappa, N, 0),
                  .witness = delta,
                  .controls = {-delta, formula::resistance_lever<ex>(kappa, delta, N, 0)}});
}

void bounces(Document& document) {
  document.section("All bounces of a flat drop");
  document.text(
      R"(A stone that leaves the plane with $v$ is back after $2v/g$ and leaves it with $e v$. So the time $T(v)$ of all
its bounces has $T(v) = 2v/g + T(e v)$, and is in proportion to $v$.)");
  document.shipped("formula::bounces_time", "drop/phases/flight_phase.hpp");
  const possymbol v("v"), g("g"), e("e");
  const ex all = formula::bounces_time<ex>(v, g, e);
  document.prove({.text = "$T(v) - T(e v) = 2v/g$", .result = all, .witness = 2 * v / g, .view = [&](const ex& form) {
                    return form - form.subs(v == e * v);
                  }});
}

}  // namespace

int main() {
  return derive("The contact phase", [](Document& document) {
    const Moved stone;
    axis(document);
    rates(document, stone);
    ledger(document, stone);
    impulses(document, stone);
    resistance(document);
    bounces(document);
  });
}
