/// \file
/// A stone that spins on its cap: Jellett's integral, and why it rises where it spins fast enough.

#include <goishi/drop/equations/contact_motion.hpp>
#include <goishi/drop/equations/slip.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/shape/lens.hpp>
#include <string>

#include "cap.hpp"
#include "enclosure.hpp"

namespace {

using namespace derivation;

ex derivative(const ex& form, const Vector& by, const Vector& rate) {
  ex sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += form.diff(GiNaC::ex_to<symbol>(by(i))) * rate(i);
  }
  return sum;
}

void jellett(Document& document) {
  document.section("Jellett's integral");
  document.text(
      R"(A force $F$ at the contact gives $\dot L = r \times F$. $L \cdot r$ is differentiated by the chain rule along
this and the shipped $\dot u$, with the support $S = r \mp d u_z$ that `contact_motion.cpp` proves. On a cap $r = \pm
d u - r \hat z$, so that $\dot r$ is along $\dot u$, across $L$.)");
  const Touching stone;
  const Vector F = letters("F"), tau = letters("T");
  const auto rate = [&](const Geometry& geometry, const Vector& torque) {
    const Motion now = formula::contact_motion(stone.mobility, stone.g, geometry, stone.u, stone.L);
    const ex jellett = formula::dot(stone.L, now.r);
    const Vector L_rate = formula::cross(now.r, F) + torque;
    return ex(derivative(jellett, stone.u, now.u_rate) + derivative(jellett, stone.L, L_rate));
  };
  const ex radial_square = pow(stone.u.x(), 2) + pow(stone.u.y(), 2);
  const Geometry rim = formula::rim_contact<ex>(shape.stone, stone.u.z(), sqrt(radial_square));
  for (const int side : {1, -1}) {
    Geometry cap = formula::cap_contact<ex>(shape.stone, side, stone.u.z(), radial_square);
    cap.height = shape.r - side * shape.d * stone.u.z();
    document.prove({.text = std::string(R"($\frac{\mathrm{d}}{\mathrm{d}t}(L \cdot r) = 0$ for every $F$, on the )") +
                            (side == 1 ? "lower" : "upper") + " cap",
                    .result = rate(cap, none),
                    .witness = 0,
                    .controls = {rate(cap, tau)}});
    document.prove({.text = "a torque beside the force changes it by $\\tau \\cdot r$",
                    .result = rate(cap, tau),
                    .witness = tau.dot(side * shape.d * stone.u - shape.r * up),
                    .controls = {rate(cap, none), rate(cap, 2 * tau)}});
  }
  const exmap example = {{stone.u.x(), ex(2) / 7}, {stone.u.y(), ex(3) / 7}, {stone.u.z(), ex(6) / 7}};
  document.refute("on the rim it is not constant", rate(rim, none).subs(example), 0);
}

void threshold(Document& document) {
  document.section("The flat spin");
  document.text(
      R"(Lying flat and spinning at $\Omega$, disturbed a little: $L = (\epsilon l_x, \epsilon l_y, I_a\Omega)$, slip
$\epsilon(s_x, s_y)$, and friction $-k N s$. To the first order, in complex numbers, $a = r - d$:)");
  document.shipped("formula::contact_motion, glide_rate", "drop/equations/contact_motion.hpp, drop/equations/slip.hpp");
  const SmallMotion small;
  const realsymbol spin("Omega", R"(\Omega)");
  const possymbol k("k");
  const ex i = GiNaC::I, a = arm, momentum = axial * spin;
  const Motion now = small.at(momentum);
  const goishi::GlideRate<ex> slides =
      formula::glide_rate<ex>(now.W, none, now.need, k, small.epsilon * small.sx, small.epsilon * small.sy);
  const Vector F(-k * slides.N * small.epsilon * small.sx, -k * slides.N * small.epsilon * small.sy, slides.N);
  const ex axis = i * (momentum * small.X - small.l) / transverse;
  const ex moment = -i * g * shape.d * small.X + i * a * k * g * small.slip;
  const ex turning = i * (spin * shape.d + a * (1 / axial - 1 / transverse) * momentum);  // of ω × r by X
  const ex slipping = -k * g * small.slip + turning * axis + i * a / transverse * moment;
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness, .controls = scaled(result)});
  };
  prove(R"($\dot X = i(I_a\Omega X - l)/I_t$)", small.first_order(now.u_rate), axis);
  prove(R"($\dot l = -i g d X + i a k g s$)", small.first_order(Vector(now.r.cross(F))), moment);
  prove(R"($\dot s = -k g s + i(\Omega d + a(1/I_a - 1/I_t) I_a\Omega)\dot X + i (a/I_t)\, \dot l$)",
        small.first_order(Vector(slides.x, slides.y, 0)), slipping);

  document.text(
      R"(With $e^{\lambda t}$ the determinant of this system is $P(\lambda) = P_0(\lambda) + k P_1(\lambda)$.)");
  const realsymbol nu("nu", R"(\nu)");
  const symbol lambda("lambda", R"(\lambda)");
  const auto row = [&](const ex& rate) { return Vector(rate.diff(small.x), rate.diff(small.lx), rate.diff(small.sx)); };
  Matrix system;
  system << row(axis).transpose(), row(moment).transpose(), row(slipping).transpose();
  const ex P = (lambda * Matrix::Identity() - system).determinant().expand();
  const ex p = (P.coeff(k, 0).subs(lambda == i * nu) / i).expand(), q = P.coeff(k, 1).subs(lambda == i * nu).expand();
  document.check("$P$ is linear in $k$", P.degree(k) == 1);
  const ex slipping_free = transverse * pow(nu, 2) - axial * spin * nu - g * shape.d;
  const ex gripping = (transverse + a * a) * pow(nu, 2) - (axial + shape.r * a) * spin * nu - g * shape.d;
  prove(R"($P_0(i\nu) = i p$, $p = -\frac{\nu}{I_t}\,(I_t\nu^2 - I_a\Omega\nu - g d)$)", p,
        -nu / transverse * slipping_free);
  prove(R"($P_1(i\nu) = q = -\frac{g}{I_t}\,((I_t + a^2)\nu^2 - (I_a + r a)\Omega\nu - g d)$)", q,
        -g / transverse * gripping);
  document.text(
      R"($p$ and $q$ are real for real $\nu$, so $i\nu$ is a root for some $k > 0$ only where both vanish, and then
for every $k$. $\nu = 0$ is no root of $q$. And the brackets differ by:)");
  document.prove(
      {.text = R"($a \nu\, (a\nu - r\Omega)$, so that $\nu = r\Omega/a = \Omega/(1 - \alpha)$, $\alpha = d/r$)",
       .result = gripping - slipping_free,
       .witness = a * nu * (a * nu - shape.r * spin),
       .controls = scaled(gripping - slipping_free)});
  document.text(
      R"(From here on the stone is one with $I_t > I_a(1 - \alpha)$. Every sharp lens with $w > h$ is, where $(w^2 +
h^2)(1 - \alpha) = 2h^2$. Of a bevelled stone its numbers decide.)");
  document.shipped("formula::lens_moments_per_mass", "mass/inertia.hpp");
  const possymbol w("w"), h("h");
  const goishi::Moments<ex> lens = formula::lens_moments_per_mass<ex>(w, h);
  const ex alpha = formula::sphere_offset<ex>(w, h) / formula::sphere_radius<ex>(w, h);
  const ex of_lens = (w * w + h * h) * (lens.transverse - (1 - alpha) * lens.axial);
  document.prove(
      {.text = R"($(w^2 + h^2)(I_t - I_a(1 - \alpha)) = \frac{(w^2 - h^2)(10w^4 - 5w^2h^2 - 3h^4)}{80\,(3w^2 + h^2)} >
0$, since $10w^4 > 5w^2h^2 + 3h^4$)",
       .result = of_lens,
       .witness = (w * w - h * h) * (10 * pow(w, 4) - 5 * pow(w * h, 2) - 3 * pow(h, 4)) / (80 * (3 * w * w + h * h)),
       .controls = {-of_lens, of_lens * ex(1001) / 1000,
                    (w * w + h * h) * (lens.transverse - (1 - 2 * alpha) * lens.axial)}});
  const ex part = 1 - shape.d / shape.r, excess = transverse - axial * part;
  document.prove(
      {.text =
           R"(at this $\nu$ the brackets vanish if and only if $\Omega^2 = \omega_c^2 = \frac{g d (1 - \alpha)^2}{I_t -
I_a (1 - \alpha)}$: they are $(\Omega^2 - \omega_c^2)\,\frac{I_t - I_a (1 - \alpha)}{(1 - \alpha)^2}$)",
       .result = slipping_free,
       .witness = pow(spin / part, 2) * excess - g * shape.d,
       .meaning = {{nu, spin / part}}});
  const exmap at_threshold = {{spin, part * nu}, {g, pow(nu, 2) * excess / shape.d}};
  const ex P_there = P.subs(lambda == i * nu);
  document.prove({.text = R"(at $\Omega = \omega_c$, $i\omega_c/(1 - \alpha)$ is a root of $P$ for every $k$)",
                  .result = P_there,
                  .witness = 0,
                  .meaning = at_threshold,
                  .controls = {P.subs(lambda == -i * nu), P.subs(lambda == 2 * i * nu), P.subs(lambda == nu)}});
  document.text(
      R"(Roots move continuously with $\Omega$ and cross the imaginary axis nowhere else. The stone that does not spin
is stable, by Hurwitz, $c_1 c_2 > c_0$:)");
  const auto still = [&](int power) { return P.coeff(lambda, power).subs(spin == 0); };
  document.check("$P$ has the coefficients $c_3 = 1$, and $c_2, c_1, c_0$ positive for $r > d$",
                 vanishes(P.coeff(lambda, 3) - 1) && vanishes(still(2) - k * g * (1 + a * a / transverse)) &&
                     vanishes(still(1) - g * shape.d / transverse) &&
                     vanishes(still(0) - k * g * g * shape.d / transverse));
  document.prove({.text = R"($c_1 c_2 - c_0 = k g^2 d\, a^2/I_t^2 > 0$)",
                  .result = still(1) * still(2) - still(0),
                  .witness = k * pow(g * a / transverse, 2) * shape.d});
  document.text(
      R"(Where it crosses, the root has $\operatorname{Re} \frac{\mathrm{d}\lambda}{\mathrm{d}\Omega} = k\,(p_\Omega
q_\nu - q_\Omega p_\nu)/(p_\nu^2 + k^2 q_\nu^2)$ (from $i p + k q = 0$, $\lambda = i\nu$). It leaves to the right as
$\Omega > 0$ grows:)");
  const ex crossing = p.diff(spin) * q.diff(nu) - q.diff(spin) * p.diff(nu);
  document.prove(
      {.text =
           R"($p_\Omega q_\nu - q_\Omega p_\nu = 2 g\, a r \nu^3 (I_t - I_a(1 - \alpha))/I_t^2 > 0$: the flat spin is
unstable above $\omega_c$, and only there)",
       .result = crossing,
       .witness = (2 * g * a * shape.r * pow(nu, 3) * excess / pow(transverse, 2)).subs(at_threshold),
       .meaning = at_threshold,
       .controls = scaled(crossing)});
}

void settling(Document& document) {
  document.section("Where it settles");
  document.text(
      R"(Energy falls as long as it slips ($\dot E = F \cdot s = -k N |s|^2$), so a steady state has no slip. In a
steady precession with $\dot u = \nu \hat z \times u$ the centre's velocity $-\omega \times r$ turns with $u$, but
without slip nothing pushes it along the plane: it is 0, and $\omega = c\, r$, $r = d u - r \hat z$. Shipped formulas
at $L = I\omega$, $u = (\sin\theta, 0, \cos\theta)$, $z = \cos\theta$ (the witnesses by the half-angle tangent):)");
  const possymbol t("t"), k("k");
  const realsymbol c("c");
  const ex z = (1 - t * t) / (1 + t * t), across = 2 * t / (1 + t * t);
  const Vector u(across, 0, z);
  const Vector w = c * (shape.d * u - shape.r * up);
  const Vector L = transverse * w + (axial - transverse) * u.dot(w) * u;
  const Motion now = on_cap(u, L, across * across);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness, const exmap& meaning = {}) {
    document.prove(
        {.text = text, .result = result, .witness = witness, .meaning = meaning, .controls = scaled(result)});
  };
  prove(R"($\omega = c\, r$)", components(now.w), components(Vector(c * now.r)));
  document.prove({.text = "the contact point rests while the centre does",
                  .result = components(now.point),
                  .witness = 0,
                  .controls = {components(on_cap(u, w, across * across).point)}});
  prove(R"($\dot u = -c r\, \hat z \times u$: $\nu = -c r$)", components(now.u_rate),
        components(Vector(-c * shape.r * up.cross(u))));
  const ex bracket = transverse * shape.r * z + axial * (shape.d - shape.r * z);
  const exmap steady = {{g, pow(c, 2) * shape.r * bracket / shape.d}};
  const Vector moment = now.r.cross(Vector(0, 0, g));
  prove(
      R"(with $N = g$, $\dot L = r \times g \hat z$ is $\nu \hat z \times L$ if and only if $g d = c^2 r\,[I_t r z +
I_a (d - r z)]$: they differ by $(c^2 r [\dots] - g d)\, \hat z \times u$)",
      components(moment) + c * shape.r * components(up.cross(L)),
      components(Vector((pow(c, 2) * shape.r * bracket - g * shape.d) * up.cross(u))));
  const goishi::GlideRate<ex> glides = formula::glide_rate<ex>(now.W, none, now.need, k, 0, 0);
  prove("and then $N = g$ indeed", glides.N, g.subs(steady), steady);
  document.prove({.text = "and no slip begins",
                  .result = glides.x + realsymbol("b") * glides.y,
                  .witness = 0,
                  .meaning = steady,
                  .controls = {formula::glide_rate<ex>(now.W, none, now.need, 0, 0, 0).x + glides.N}});
  const ex D = transverse * pow(shape.r, 2) * (1 - z * z) + axial * pow(shape.d - shape.r * z, 2);
  const ex J = formula::dot(L, now.r);
  prove(R"($J = L \cdot r = c D$, $D = I_t r^2 (1 - z^2) + I_a (d - r z)^2$)", J, c * D);
  const auto settled = [&](const ex& integral) { return g * shape.d * D * D - pow(integral, 2) * shape.r * bracket; };
  document.prove(
      {.text = R"(so that $g d D^2 = J^2\,[I_t r^2 z + I_a r (d - r z)]$: with Jellett's $J$ the tilt follows)",
       .result = settled(J),
       .witness = 0,
       .meaning = steady,
       .controls = {settled(2 * J), settled(c), g * shape.d * D - pow(J, 2) * shape.r * bracket}});
  const realsymbol spin("Omega", R"(\Omega)");
  const ex part = 1 - shape.d / shape.r;
  const exmap critical = {{g, pow(spin / part, 2) * (transverse - axial * part) / shape.d}};
  const ex flat = formula::dot(Vector(0, 0, axial * spin), on_cap(up, none, 0).r);
  prove(R"(of the flat spin $J = -I_a \Omega (r - d)$)", flat, -axial * spin * (shape.r - shape.d));
  document.prove({.text = R"(and at $\Omega = \omega_c$ the tilt is 0: it begins where the flat spin becomes
unstable)",
                  .result = settled(flat).subs(t == 0),
                  .witness = 0,
                  .meaning = critical,
                  .controls = {settled(2 * flat).subs(t == 0)}});
}

void size_33(Document& document) {
  document.section("The sharp stone of size 33");
  document.text(
      R"($w = 22$ mm, $h = 9.2$ mm, standard gravity. By the formulas above, $\omega_c$, and the tilts from flat
spins; the numbers are enclosed by fractions, so that each digit is proved. A tilt is where $g d D^2 - J^2 [\dots]$
changes its sign:)");
  const ex width = ex(22) / 1000, height = ex(92) / 10000;
  const goishi::Moments<ex> moments = formula::lens_moments_per_mass<ex>(width, height);
  const ex r = formula::sphere_radius<ex>(width, height), d = formula::sphere_offset<ex>(width, height);
  const ex fall = goishi::standard_gravity<ex>() * d, part = 1 - d / r;
  const auto thousandths = [](int n) { return ex(n) / 1000; };
  const ex square = fall * part * part / (moments.transverse - moments.axial * part);
  document.check(R"($27.9295 < \omega_c < 27.9305$)",
                 positive(square - pow(ex(279295) / 10000, 2)) && positive(pow(ex(279305) / 10000, 2) - square));
  const auto excess = [&](int spin, const ex& degrees) {
    const ex z = cos(degrees * Pi / 180), J = moments.axial * spin * (r - d);
    const ex D = moments.transverse * r * r * (1 - z * z) + moments.axial * pow(d - r * z, 2);
    return ex(fall * D * D - J * J * (moments.transverse * r * r * z + moments.axial * r * (d - r * z)));
  };
  const auto settles = [&](int spin, int tilt) {
    return positive(excess(spin, thousandths(tilt) + thousandths(1) / 2)) &&
           positive(-excess(spin, thousandths(tilt) - thousandths(1) / 2));
  };
  document.check(R"(30 rad/s: 9.116° within 0.0005°)", settles(30, 9116));
  document.check(R"(40 rad/s: 22.035° within 0.0005°)", settles(40, 22035));
  document.check(R"(60 rad/s: 35.970° within 0.0005°)", settles(60, 35970));
  document.check("the same decision refuses 9.117°, 22.036° and 35.971°",
                 !settles(30, 9117) && !settles(40, 22036) && !settles(60, 35971));
}

}  // namespace

int main() {
  return derive("A stone that spins on its cap", [](Document& document) {
    jellett(document);
    threshold(document);
    settling(document);
    size_33(document);
  });
}
