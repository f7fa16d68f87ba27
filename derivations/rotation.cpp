/// \file
/// Quaternions: the product, the exponential of a rotation vector, the rate of an attitude, back to the unit sphere.

#include <goishi/rotation.hpp>
#include <string>

#include "proof.hpp"
#include "relations.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

const Quaternion q = quaternion_letters("q");
const Vector v = letters("v");

void product(Document& document) {
  document.section("The product");
  document.text(
      R"(Hamilton's rule is $(s, a)(t, b) = (st - a \cdot b,\; sb + ta + a \times b)$, and a quaternion turns a vector
as $q v \bar q$. No quaternion of this section need be a unit one, but where it is said. (A vector or a
quaternion $x$ is compared in all components at once, as $a \cdot x$ with independent $a$.))");
  document.shipped("formula::product", "rotation.hpp");
  const Quaternion p = quaternion_letters("p");
  const Quaternion r = quaternion_letters("r");
  const Quaternion made = formula::product(p, q);
  document.equation("(pq)_0", made.w());
  document.equation("(pq)_1", made.x());
  document.prove(
      {.text = "$pq$ is Hamilton's product", .result = components(made), .witness = components(hamilton(p, q))});
  document.prove(
      {.text = "$|pq| = |p||q|$", .result = squared_norm(made), .witness = squared_norm(p) * squared_norm(q)});
  const ex left = components(formula::product(made, r));
  document.prove({.text = "$(pq)r = p(qr)$",
                  .result = left,
                  .witness = components(formula::product(p, formula::product(q, r))),
                  .controls = {components(formula::product(formula::product(q, p), r)), -left}});
  const ex composed = components(turned(made, v));
  document.prove({.text = R"($pq$ turns as $q$ and then $p$: $(pq) v \overline{(pq)} = p (q v \bar q) \bar p$)",
                  .result = composed,
                  .witness = components(turned(p, turned(q, v))),
                  .controls = {components(turned(formula::product(q, p), v)), -composed}});
  document.text("*Eigen:* its `p * q` and, for $|q| = 1$, `q * v` stand in some formulas.");
  document.prove({.text = "`p * q` is Hamilton's product",
                  .result = components(Quaternion(p * q)),
                  .witness = components(hamilton(p, q))});
  document.prove(Relations().unit(q)({.text = R"(`q * v` is $q v \bar q$ if $|q| = 1$)",
                                      .result = components(Vector(q * v)),
                                      .witness = components(turned(q, v))}));
}

void exponential(Document& document) {
  document.section("The rotation by a vector");
  document.text(
      R"($\theta = \alpha n$, with the angle $\alpha > 0$ and the axis $n$, $|n| = 1$. The shipped formula takes a
root, a cosine and a sine of $\theta$; below, $C$ and $S$ stand for $\cos\frac\alpha2$ and $\sin\frac\alpha2$, and
$C^2 + S^2 = 1$. (The library adds the least normal number under the root, so that 0/0 becomes the limit; a symbol has
none.))");
  document.shipped("formula::rotation_exp", "rotation.hpp");
  const possymbol alpha("alpha", R"(\alpha)");
  const Vector n = letters("n");
  const realsymbol C("C");
  const realsymbol S("S");
  const Relations relations = Relations().unit(n).angle(alpha / 2, C, S);
  const Quaternion raw = formula::rotation_exp(Vector(alpha * n));
  const Quaternion form = relations(raw);
  document.check("in double, the rotation by 0 is the identity, to the last bit",
                 formula::rotation_exp<double>(goishi::Vec3<double>::Zero()).coeffs() ==
                     goishi::Quat<double>::Identity().coeffs());
  document.equation(R"(\exp(\theta)_0)", form.w());
  document.equation(R"(\exp(\theta)_1)", form.x());
  document.prove(relations({.text = R"($|\exp\theta| = 1$)",
                            .result = squared_norm(raw),
                            .witness = 1,
                            .controls = alterations_within(squared_norm(raw))}));
  const ex cosine = C * C - S * S;
  const ex sine = 2 * S * C;
  const Vector rodrigues = Vector(cosine * v) + Vector(sine * n.cross(v)) + Vector((1 - cosine) * n.dot(v) * n);
  document.prove(relations(
      {.text =
           R"(Rodrigues: $q v \bar q = v\cos\alpha + n \times v \sin\alpha + n (n \cdot v)(1 - \cos\alpha)$ with $q =
\exp\theta$ (double angles))",
       .result = components(turned(raw, v)),
       .witness = components(rodrigues),
       .controls = {components(turned(formula::rotation_exp(Vector(-alpha * n)), v)),
                    components(turned(Quaternion(raw.w(), raw.y(), raw.x(), raw.z()), v)), components(v)}}));
  document.prove(relations({.text = R"($\exp(-\theta) = \overline{\exp\theta}$)",
                            .result = components(formula::rotation_exp(Vector(-alpha * n))),
                            .witness = components(conjugated(form))}));

  document.text(R"(And it is the exponential: $q(s) = \exp(s\theta)$, with $C$, $S$ of $s\alpha/2$, solves)");
  document.display(R"(\frac{\mathrm{d}q}{\mathrm{d}s} = \tfrac12 (0, \theta)\, q, \qquad q(0) = 1)");
  const possymbol s("s");
  const Relations along = Relations().unit(n).angle(s * alpha / 2, C, S);
  const ex path = components(formula::rotation_exp(Vector(s * alpha * n)));
  document.prove(along({.text = "the equation",
                        .result = path,
                        .witness = components(hamilton(pure(Vector(alpha * n / 2)), quaternion(C, Vector(S * n)))),
                        .view = [&](const ex& e) { return along.rate(along(e), s); },
                        .controls = {-path, path * 2, path.subs(alpha == 2 * alpha), path.subs(n.x() == -n.x())}}));
  document.text(R"(Near $\theta = 0$, from the series of cosine and sine, up to the order $\alpha^2$:)");
  const ex near =
      GiNaC::series_to_poly(components(form).subs(exmap{{C, cos(alpha / 2)}, {S, sin(alpha / 2)}}).series(alpha, 3));
  document.equation(R"(a \cdot \exp(\theta))", near.expand());
  document.prove(
      {.text = R"($\exp\theta = 1 + \frac12(0, \theta) - \frac18|\theta|^2 + O(|\theta|^3)$; at 0 the identity)",
       .result = near,
       .witness = components(quaternion(1 - alpha * alpha / 8, Vector(alpha * n / 2)))});
}

void rate(Document& document) {
  document.section("The rate of an attitude");
  document.text(
      R"(A body turns with $\omega$, in W: each of its points, $V = q v \bar q$ from the centre of mass, moves with
$\dot V = \omega \times V$. Here $\dot V = \sum_i \dot q_i\, \partial V / \partial q_i$ with the shipped $\dot q$.)");
  document.shipped("formula::attitude_rate", "rotation.hpp");
  const Vector w = letters("w");
  const Quaternion made = formula::attitude_rate(w, q);
  document.equation(R"(\dot q_0)", made.w());
  document.equation(R"(\dot q_1)", made.x());
  const Quaternion slope = quaternion_letters("b");
  const ex result = slope.coeffs().dot(made.coeffs());
  const auto along = [&](const ex& function) {
    exmap meaning;
    for (int i = 0; i < 4; ++i) {
      meaning[slope.coeffs()(i)] = function.diff(GiNaC::ex_to<symbol>(q.coeffs()(i)));
    }
    return meaning;
  };
  document.prove({.text = R"($\dot V = \omega \times V$)",
                  .result = result,
                  .witness = components(w.cross(turned(q, v))),
                  .meaning = along(components(turned(q, v)))});
  document.prove({.text = "$|q|$ stays",
                  .result = result,
                  .witness = 0,
                  .meaning = along(squared_norm(q)),
                  .controls = alterations_within(result)});
}

void unit_again(Document& document) {
  document.section("Back to the unit sphere");
  document.text(R"($q = (1 + \delta) u$ with $|u| = 1$: round-off took $q$ off the sphere by a relative $\delta$.)");
  document.shipped("formula::reunited", "rotation.hpp");
  const realsymbol delta("delta", R"(\delta)");
  const Quaternion u = quaternion_letters("u");
  const ex result = components(formula::reunited(q));
  exmap meaning;
  for (int i = 0; i < 4; ++i) {
    meaning[q.coeffs()(i)] = (1 + delta) * u.coeffs()(i);
  }
  const Relations relations = Relations().unit(u);
  const auto near = [&](const ex& e) { return e.subs(meaning); };
  document.prove(relations(
      {.text = R"(the result is $(1 - \frac32\delta^2 - \frac12\delta^3)\, u$: $\delta$ becomes $O(\delta^2)$)",
       .result = result,
       .witness = (1 - 3 * pow(delta, 2) / 2 - pow(delta, 3) / 2) * components(u),
       .view = near}));
  document.prove(relations(
      {.text = "a unit quaternion stays", .result = result, .witness = components(u), .view = [&](const ex& e) {
         return near(e).subs(delta == 0);
       }}));
  const Vector n = letters("n");
  const ex vector = components(formula::reunited(Vector((1 + delta) * n)));
  document.prove(Relations().unit(n)({.text = "and so of a vector",
                                      .result = vector,
                                      .witness = (1 - 3 * pow(delta, 2) / 2 - pow(delta, 3) / 2) * components(n)}));
}

void axis(Document& document) {
  document.section("The symmetry axis");
  document.text(R"($B_z = (0, 0, 1)$ in W, for $|q| = 1$.)");
  document.shipped("formula::symmetry_axis", "rotation.hpp");
  document.prove(Relations().unit(q)({.text = R"($q B_z \bar q$)",
                                      .result = components(formula::symmetry_axis(q)),
                                      .witness = components(turned(q, Vector(0, 0, 1)))}));
  document.text(R"(And for $q = (1 + \delta) u$ with $|u| = 1$, off the sphere by round-off:)");
  document.shipped("formula::unit_axis", "rotation.hpp");
  const realsymbol delta("delta", R"(\delta)");
  const Quaternion u = quaternion_letters("u");
  const ex scale = 1 - 3 * pow(delta, 2) / 2 - pow(delta, 3) / 2;
  document.prove(Relations().unit(u)(
      {.text = R"($(1 - \frac32\delta^2 - \frac12\delta^3)^2\, u B_z \bar u$, as of $u$ by the section before)",
       .result = components(formula::unit_axis(
           Quaternion((1 + delta) * u.w(), (1 + delta) * u.x(), (1 + delta) * u.y(), (1 + delta) * u.z()))),
       .witness = pow(scale, 2) * components(turned(u, Vector(0, 0, 1)))}));
}

}  // namespace

int main() {
  return derive("Rotations and quaternions", [](Document& document) {
    product(document);
    exponential(document);
    rate(document);
    unit_again(document);
    axis(document);
  });
}
