/// \file
/// A stone in contact with a plane: where it touches, how that point moves, what a force there does; energy,
/// resistance, rolling; and the attitude that is carried along.

#include <goishi/drop/equations/carried.hpp>
#include <goishi/drop/equations/contact_motion.hpp>
#include <string>

#include "contact.hpp"

namespace {

using namespace derivation;

void geometry(Document& document) {
  document.section("Where the stone touches");
  document.text(
      R"(The plane's normal is $\hat z$, the axis $u$, $\eta = u_z$. A convex body with the support function $h(n)$,
the farthest it reaches in the direction $n$, extended to all $n$ by $h(\lambda n) = \lambda h(n)$, touches a plane of
normal $n$ in the point $\nabla h(n)$. For a body of revolution $h(n) = |n|\, S(-u \cdot n/|n|)$, and under it $n =
-\hat z$. $S$ is any function: $S + S' x + S'' x^2/2$, differentiated where $x = 0$.)");
  document.shipped("formula::contact_motion", "drop/equations/contact_motion.hpp");
  const Touching stone;
  const Vector to = letters("n");
  const ex size = sqrt(to.dot(to));
  const ex reach = size * stone.support(-stone.u.dot(to) / size);
  const auto below = [&](const ex& form) {
    return stone.there(form.subs(exmap{{to.x(), 0}, {to.y(), 0}, {to.z(), -1}}));
  };
  const auto slope = [&](int i) { return below(reach.diff(GiNaC::ex_to<symbol>(to(i)))); };
  const Vector r = stone.there(stone.now.r);
  document.prove({.text = R"($r = \nabla h(-\hat z) = -S' u_h - S \hat z$, $u_h$ the horizontal part of $u$)",
                  .result = components(r),
                  .witness = components(Vector(slope(0), slope(1), slope(2)))});
  document.prove({.text = "the centre of mass is $S$ over the plane",
                  .result = stone.there(stone.now.height),
                  .witness = below(reach)});

  const Shape shape;
  const realsymbol eta("eta", R"(\eta)");
  for (const int side : {1, -1}) {
    document.section(side == 1 ? "The lower cap" : "The upper cap");
    document.text(std::string("It is part of the sphere of radius $r$ about $") + (side == 1 ? "" : "-") +
                  R"(d u$, which touches the plane below its centre.)");
    document.shipped("formula::cap_contact", "drop/equations/contact_motion.hpp");
    const Geometry cap = formula::cap_contact<ex>(shape.stone, side, eta, 1 - pow(eta, 2));
    const Vector u(stone.u.x(), stone.u.y(), eta);
    const Vector touched = side * shape.d * u - shape.r * up;
    document.prove({.text = "$S$", .result = cap.height, .witness = -touched.z()});
    document.prove({.text = "$S'$", .result = cap.slope, .witness = cap.height.diff(eta).normal()});
    document.prove({.text = "$S'' = 0$", .result = cap.curvature, .witness = cap.slope.diff(eta), .controls = {1}});
    document.prove({.text = "the point that `contact_motion` has",
                    .result = components(formula::contact_motion(stone.mobility, stone.g, cap, u, stone.L).r),
                    .witness = components(touched)});
  }

  document.section("The rim");
  document.text(
      R"(A circle of radius $r_1$ across $u$, moved out by a ball of radius $r_2$. Its lowest point lies in the
direction $-\hat z + \eta u$, of length $\rho = \sqrt{1 - \eta^2}$. With $\eta = 2k/(1 + k^2)$, $\rho = (1 - k^2)/(1 +
k^2)$.)");
  document.shipped("formula::rim_contact", "drop/equations/contact_motion.hpp");
  const possymbol k("k");
  const realsymbol c("c"), s("s");
  const ex axial = 2 * k / (1 + k * k), radial = (1 - k * k) / (1 + k * k);
  const auto by_eta = [&](const ex& form) { return (form.diff(k) / axial.diff(k)).normal(); };
  const Geometry rim = formula::rim_contact<ex>(shape.stone, axial, radial);
  const Vector u(radial * c, radial * s, axial);
  const Vector touched = shape.r1 / radial * (axial * u - up) - shape.r2 * up;
  document.prove({.text = "$S$", .result = rim.height, .witness = -touched.z(), .controls = scaled(rim.height)});
  document.prove({.text = "$S'$", .result = rim.slope, .witness = by_eta(rim.height), .controls = scaled(rim.slope)});
  document.prove(
      {.text = "$S''$", .result = rim.curvature, .witness = by_eta(rim.slope), .controls = scaled(rim.curvature)});
  const ex point = components(formula::contact_motion(stone.mobility, stone.g, rim, u, stone.L).r);
  document.prove({.text = "the point that `contact_motion` has",
                  .result = point,
                  .witness = components(touched),
                  .controls = scaled(point)});
}

void motion(Document& document, const Touching& stone) {
  document.section("How it moves");
  document.text(
      R"(Per unit of mass. $J = I^{-1}$ has the inverse moments $1/I_t$ across the axis and $1/I_a$ along it. The axis
is fixed in the body, $\dot u = \omega \times u$.)");
  document.shipped("formula::contact_place", "drop/equations/contact_motion.hpp");
  document.shipped("formula::contact_turn", "drop/equations/contact_motion.hpp");
  document.shipped("formula::contact_motion", "drop/equations/contact_motion.hpp");
  document.prove({.text = "the result holds the $u$ and $L$ that it was given",
                  .result = components(Vector(stone.now.u - 2 * stone.now.L)),
                  .witness = components(Vector(stone.u - 2 * stone.L))});
  const Relations unit = Relations().unit(stone.u);
  const possymbol axial("Ia", "I_a"), transverse("It", "I_t");
  const exmap moments = {{stone.transverse, 1 / transverse}, {stone.axial, 1 / axial - 1 / transverse}};
  const auto I = [&](const Vector& x) -> Vector {
    return Vector(transverse * x) + Vector((axial - transverse) * stone.u.dot(x) * stone.u);
  };
  document.prove(unit({.text = R"($I \omega = L$)",
                       .result = components(I(stone.now.w)),
                       .witness = components(stone.L),
                       .view = [&](const ex& form) { return form.subs(moments); },
                       .controls = scaled(components(I(stone.now.w)))}));
  const Vector w = stone.J(stone.L);
  document.prove(
      {.text = R"($\omega = J L$ as in the witnesses)", .result = components(stone.now.w), .witness = components(w)});
  document.prove(unit({.text = R"($\omega \cdot u$)", .result = stone.now.spin_rate, .witness = w.dot(stone.u)}));
  const Vector u_rate = w.cross(stone.u);
  document.prove({.text = R"($\dot u$)", .result = components(stone.now.u_rate), .witness = components(u_rate)});
  const ex point = components(stone.there(stone.now.point));
  document.prove({.text = R"($\omega \times r$)",
                  .result = point,
                  .witness = components(stone.there(Vector(w.cross(stone.r()))))});
  document.prove(
      {.text = R"(its height: $\hat z \cdot (\omega \times r) = -\frac{\mathrm{d}}{\mathrm{d}t} S$, so the point
rises against the plane as fast as the gap widens)",
       .result = stone.there(stone.now.point.z()),
       .witness = -stone.rate(stone.geometry.height, u_rate, Vector::Zero())});

  document.section("What a force does");
  document.text(
      R"(Newton and Euler, with a force $F$ at the contact and a torque $\tau$ beside it: $\dot v = F + g$, $\dot L =
r \times F + \tau$. The witness differentiates $v + \omega \times r$ by the chain rule, $\omega = J(u) L$ and $r(u)$
along $\dot u$ and $\dot L$. $W$ is the contact matrix of a unit mass (chapter *Impacts*), and $\mathrm{need}$ minus
what the point is accelerated by without force and torque: $\mathrm{need} = -g - \dot J L \times r - \omega \times
\dot r$, with $\dot J$ and $\dot r$ along $\dot u$.)");
  const Vector F = letters("F"), tau = letters("T");
  const Vector L_rate = stone.there(Vector(stone.r().cross(F))) + tau;
  const Vector w_rate = stone.rate(w, u_rate, L_rate), r_rate = stone.rate(stone.r(), u_rate, L_rate);
  const Vector acceleration = F + stone.g + w_rate.cross(stone.there(stone.r())) + w.cross(r_rate);
  const Vector turned = formula::turned_point(stone.mobility, stone.u, stone.now.r, tau);
  const Vector gain = formula::minus(formula::plus(formula::product(stone.now.W, F), turned), stone.now.need);
  document.prove(
      {.text = R"($\frac{\mathrm{d}}{\mathrm{d}t}(v + \omega \times r) = W F + J\tau \times r - \mathrm{need}$)",
       .result = components(stone.there(gain)),
       .witness = components(acceleration)});

  document.section("Energy");
  document.text(
      R"(The contact slips with $s = (s_x, s_y, 0)$, so that $v = s - \omega \times r$. Its acceleration is $a = W F +
J\tau \times r - \mathrm{need}$, as just proved, and the energy $E$ the shipped kinetic one less $g \cdot p$, the
centre at the height $S$.)");
  document.shipped("formula::contact_kinetic_energy", "drop/equations/contact_motion.hpp");
  const realsymbol sx("sx", "s_x"), sy("sy", "s_y");
  const Vector slip(sx, sy, 0);
  const ex kinetic = formula::contact_kinetic_energy<ex>(stone.now, sx, sy);
  const Vector centre = slip - w.cross(stone.r());
  document.prove({.text = R"(it is $\frac12 |v|^2 + \frac12 \omega \cdot L$)",
                  .result = stone.there(kinetic),
                  .witness = stone.there((centre.dot(centre) + w.dot(stone.L)) / 2),
                  .controls = scaled(stone.there(kinetic))});
  const ex power = stone.rate(kinetic, stone.now.u_rate, L_rate) + stone.there(kinetic.diff(sx)) * acceleration.x() +
                   stone.there(kinetic.diff(sy)) * acceleration.y() -
                   stone.there(stone.g.x() * centre.x() + stone.g.y() * centre.y()) -
                   stone.g.z() * stone.rate(stone.geometry.height, u_rate, L_rate);
  const ex lift = stone.there(stone.now.point.z()) * acceleration.z();
  document.prove(
      {.text = R"($\dot E = F \cdot s + \tau \cdot \omega + (\omega \times r)_z\, a_z$ for every $F$ and $\tau$)",
       .result = power,
       .witness = F.dot(slip) + tau.dot(w) + lift,
       .controls = {power * ex(1001) / 1000, power - lift, power - 2 * tau.dot(w)}});
  document.text(
      R"(A normal force that keeps the contact on the plane, $a_z = 0$, does no work: $\dot E = F \cdot s + \tau \cdot
\omega$. Where nothing slips and nothing resists, energy is constant. Friction against the slip and a torque against
$\omega$ only take.)");
}

void resistance(Document& document) {
  document.section("Resistance");
  document.text(
      R"(The torque per normal force for rolling resistance $\delta$ and pivot friction $\kappa$; $f$ is the floor
under its root, $R^2 = \delta^2 |\omega_h|^2 + \kappa^2 \omega_z^2 + f$.)");
  document.shipped("formula::resistance", "drop/equations/contact_motion.hpp");
  const possymbol delta("delta", R"(\delta)"), kappa("kappa", R"(\kappa)"), f("f");
  const Vector w = letters("w");
  const ex roll = pow(delta, 2) * (pow(w.x(), 2) + pow(w.y(), 2)), pivot = pow(kappa, 2) * pow(w.z(), 2);
  const auto torque = [&](const ex& floor) { return formula::resistance<ex>(pow(delta, 2), pow(kappa, 2), w, floor); };
  const Vector tau = torque(f);
  const ex square = roll + pivot + f;
  document.prove({.text = R"($\tau_h \cdot \tau_h = \delta^2 (1 - (\kappa^2\omega_z^2 + f)/R^2) \le \delta^2$)",
                  .result = pow(tau.x(), 2) + pow(tau.y(), 2),
                  .witness = pow(delta, 2) * (1 - (pivot + f) / square)});
  document.prove({.text = R"($\tau_z^2 = \kappa^2 (1 - (\delta^2|\omega_h|^2 + f)/R^2) \le \kappa^2$)",
                  .result = pow(tau.z(), 2),
                  .witness = pow(kappa, 2) * (1 - (roll + f) / square),
                  .controls = {pow(torque(2 * f).z(), 2), 2 * pow(tau.z(), 2), pow(tau.x(), 2)}});
  document.prove(
      {.text = R"(it only brakes: $\tau \cdot \omega = -(\delta^2|\omega_h|^2 + \kappa^2\omega_z^2)/R \le 0$)",
       .result = tau.dot(w),
       .witness = -(roll + pivot) / sqrt(square),
       .controls = scaled(tau.dot(w))});
  document.prove({.text = R"(its direction: $\tau_h = -\delta^2\omega_h/R$, $\tau_z = -\kappa^2\omega_z/R$)",
                  .result = components(tau),
                  .witness = -components(Vector(pow(delta, 2) * w.x(), pow(delta, 2) * w.y(), pow(kappa, 2) * w.z())) /
                             sqrt(square),
                  .controls = scaled(components(tau))});
  document.prove({.text = R"(rolling alone, without a floor: $\delta$ against $\omega$)",
                  .result = tau.y(),
                  .witness = -delta,
                  .meaning = {{w.x(), 0}, {w.y(), 1 / kappa}, {w.z(), 0}, {f, 0}},
                  .controls = {tau.x(), tau.z(), 2 * tau.y()}});
}

void rolling(Document& document) {
  const Vector b = letters("b"), need = letters("k");
  document.section("Rolling");
  document.text(
      R"(The force that leaves the contact point at rest, where the resistance that goes with a normal force of 1
gives it the acceleration $b = J\tau \times r$: $W F + b F_z - \mathrm{need} = 0$.)");
  document.shipped("formula::rolling_force", "drop/equations/contact_motion.hpp");
  const Matrix both = M + b * up.transpose();
  document.prove({.text = R"($F = (W + b \hat z^\mathsf{T})^{-1}\, \mathrm{need}$)",
                  .result = components(formula::rolling_force(W, b, need)),
                  .witness = components(Vector(both.inverse() * need))});
}

void carried(Document& document) {
  document.section("The attitude");
  document.text(
      R"(It is carried with the axis by the shortest rotation from an axis $a$ to $u$, beyond which the body has
turned by an angle $\psi$ about its axis: $q = \mathrm{shortest}(a, u)\, q_a\, (\cos\frac\psi2, \hat z
\sin\frac\psi2)$, $q_a \hat z \bar q_a = a$.)");
  document.shipped("formula::shortest_rotation", "drop/equations/carried.hpp");
  const Vector a = letters("f"), u = letters("u"), w = letters("w");
  const Relations unit = Relations().unit(a).unit(u);
  const possymbol D("D");
  const ex square = pow(1 + formula::dot(a, u), 2) + formula::dot(formula::cross(a, u), formula::cross(a, u));
  const Quaternion shortest = formula::shortest_rotation(a, u);
  document.prove(unit({.text = R"(the square under the formula's root is $2D$, $D = 1 + a \cdot u$)",
                       .result = square,
                       .witness = 2 * (1 + a.dot(u))}));
  document.prove(
      {.text = "of the two quaternions of a rotation it is the one with $q_0 > 0$: times the root, $q_0$ is $D$",
       .result = shortest.w() * sqrt(square),
       .witness = 1 + a.dot(u)});
  // Free of roots and denominators: the square gives way to 2D, D² is multiplied in, and D is what it stands for.
  const auto times_square = [&](const ex& form) {
    return (form.subs(square == 2 * D).subs(1 + formula::dot(a, u) == D) * D * D).expand().subs(D == 1 + a.dot(u));
  };
  const ex over = pow(1 + a.dot(u), 2);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness,
                         const std::vector<ex>& controls) {
    document.prove(unit({.text = text,
                         .result = result,
                         .witness = over * witness,
                         .view = times_square,
                         .controls = controls.empty() ? scaled(result) : controls}));
  };
  prove("it is a unit quaternion", squared_norm(shortest), 1, {});
  prove("it takes $a$ to $u$", components(turned(shortest, a)), components(u),
        {components(turned(conjugated(shortest), a)), components(turned(shortest, u))});
  prove("about an axis across $a$, so that it is the shortest", Vector(shortest.vec()).dot(a), 0,
        {Vector(shortest.vec()).dot(w)});
  document.shipped("formula::carried_spin_rate", "drop/equations/carried.hpp");
  document.text(
      R"(The angular velocity of $q$ is $\omega_q$ with $\dot q \bar q = \frac12 (0, \omega_q)$. With $p$ for the
shortest rotation and $e$ for the turn by $\psi$, $\dot q \bar q = \dot p \bar p + p q_a \dot e \bar e \bar q_a \bar
p$, and $2 \dot e \bar e = (0, \dot\psi \hat z)$:)");
  const Quaternion carry = quaternion_letters("p"), carry_rate = quaternion_letters("r"),
                   first = quaternion_letters("q");
  const realsymbol half_cosine("c"), half_sine("s"), spin("psi'", R"(\dot\psi)");
  const Relations all = Relations().unit(carry).unit(first).square(half_sine, 1 - pow(half_cosine, 2));
  const auto about_axis = [](const ex& cosine, const ex& sine) { return Quaternion(cosine, 0, 0, sine); };
  const Quaternion turn = about_axis(half_cosine, half_sine);
  const Quaternion turn_rate = about_axis(-half_sine * spin / 2, half_cosine * spin / 2);
  const Quaternion start = hamilton(carry, first);
  const Quaternion q = hamilton(start, turn);
  const Quaternion q_rate(hamilton(hamilton(carry_rate, first), turn).coeffs() + hamilton(start, turn_rate).coeffs());
  const Quaternion of_p = hamilton(carry_rate, conjugated(carry));
  const Vector axis = turned(carry, turned(first, up));
  const ex whole = 2 * components(hamilton(q_rate, conjugated(q)));
  document.prove(
      all({.text = R"($2 \dot q \bar q = 2 \dot p \bar p + (0, \dot\psi\, u)$, $u = p (q_a \hat z \bar q_a) \bar p$)",
           .result = whole,
           .witness = 2 * components(of_p) + components(Vector(spin * axis)),
           .controls = scaled(whole)}));
  const Vector u_rate = w.cross(u);
  const auto rate = [&](const ex& form) {
    ex sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += form.diff(GiNaC::ex_to<symbol>(u(i))) * u_rate(i);
    }
    return sum;
  };
  const Quaternion shortest_rate(rate(shortest.w()), rate(shortest.x()), rate(shortest.y()), rate(shortest.z()));
  const ex carrying = 2 * components(hamilton(shortest_rate, conjugated(shortest)));
  const Vector axis_rate = letters("u'");
  document.prove({.text = R"($\dot\psi = \omega \cdot u + a \cdot (u \times \dot u)/(1 + a \cdot u)$)",
                  .result = formula::carried_spin_rate<ex>(a, u, axis_rate, spin),
                  .witness = spin + a.dot(u.cross(axis_rate)) / (1 + a.dot(u))});
  const ex beyond = formula::carried_spin_rate<ex>(a, u, u_rate, w.dot(u));
  prove(R"($2 \dot p \bar p + (0, \dot\psi\, u) = (0, \omega)$ with this $\dot\psi$, along $\dot u = \omega \times
u$)",
        carrying + beyond * components(u), components(w),
        {carrying - beyond * components(u), carrying + w.dot(u) * components(u)});
}

}  // namespace

int main() {
  return derive("A stone in contact with a plane", [](Document& document) {
    const Touching stone;
    geometry(document);
    motion(document, stone);
    resistance(document);
    rolling(document);
    carried(document);
  });
}
