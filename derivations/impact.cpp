/// \file
/// Impacts: how bodies answer to an impulse, the normal impulse, friction, the linear response.

#include <goishi/impact/impulses.hpp>
#include <goishi/published/linear_response.hpp>
#include <string>

#include "impact.hpp"

namespace {

using namespace derivation;

/// Any body at the moment of an impact.
Body body_letters(const std::string& which = "") {
  const std::string index = which.empty() ? "" : "_" + which;
  const auto size = [&](const std::string& name) { return possymbol(name + which, name + index); };
  return {.mobility = {.linear = size("A"), .transverse = size("B"), .axial = realsymbol("C" + which, "C" + index)},
          .p_WB = letters_xyz("x", which),
          .u_W = letters_xyz("u", which),
          .v_WB = letters_xyz("w", which),
          .L_W = letters_xyz("L", which)};
}

/// m v²/2 + L · ω/2.
ex energy(const Body& body) {
  const Vector w = formula::turning(body.mobility, body.u_W, body.L_W);
  return body.v_WB.dot(body.v_WB) / (2 * body.mobility.linear) + body.L_W.dot(w) / 2;
}

Body after(const Body& body, const Vector& r, const Vector& impulse) {
  const goishi::BodyVelocity<ex> velocity = formula::pushed(body, r, impulse);
  Body result = body;
  result.v_WB = velocity.v_WB;
  result.L_W = velocity.L_W;
  return result;
}

void vectors(Document& document) {
  document.section("Vectors");
  document.text("Component by component, against Eigen's own.");
  document.shipped("formula::dot, cross, plus, minus, combination, scaled", "vector.hpp");
  const realsymbol s("s"), t("t");
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness});
  };
  prove(R"($v \cdot p$)", formula::dot(v, p), v.dot(p));
  prove(R"($v \times p$)", components(formula::cross(v, p)), components(v.cross(p)));
  prove("$v + p$", components(formula::plus(v, p)), components(v + p));
  prove("$v + s p$", components(formula::plus(v, ex(s), p)), components(v + Vector(s * p)));
  prove("$v - p$", components(formula::minus(v, p)), components(v - p));
  prove("$s v + t p$", components(formula::combination(ex(s), v, ex(t), p)), components(Vector(s * v) + Vector(t * p)));
  prove("$s v + t p + s t n$", components(formula::combination(ex(s), v, ex(t), p, ex(s * t), n)),
        components(Vector(s * v) + Vector(t * p) + Vector(s * t * n)));
  prove("$s v$", components(formula::scaled(ex(s), v)), components(Vector(s * v)));
}

void body(Document& document) {
  document.section("A body with a symmetry axis");
  document.text(
      R"(Its tensor is $\operatorname{diag}(I_t, I_t, I_a)$ in B. With the attitude $q$, $|q| = 1$, the axis is $u = q B_z
\bar q$, and the angular velocity comes from the angular momentum by going to B, dividing, and going back.)");
  document.shipped("formula::mobility, turning", "mass/rigid_body.hpp");
  const possymbol m("m");
  const possymbol axial("Ia", "I_a");
  const possymbol transverse("It", "I_t");
  const goishi::Mobility<ex> mobility = formula::mobility<ex>(m, {.axial = axial, .transverse = transverse});
  const auto entries = [](const goishi::Mobility<ex>& of) {
    return components(Vector(of.linear, of.transverse, of.axial));
  };
  document.prove({.text = "$1/m$, $1/I_t$, $1/I_a - 1/I_t$",
                  .result = entries(mobility),
                  .witness = components(Vector(1 / m, 1 / transverse, 1 / axial - 1 / transverse))});
  document.prove({.text = "of a ball the third is 0",
                  .result = mobility.axial,
                  .witness = 0,
                  .meaning = {{axial, transverse}},
                  .controls = {-1 / axial - 1 / transverse, (transverse - 2 * axial) / (axial * transverse)}});
  const Quaternion q = quaternion_letters("q");
  const Vector L = letters_xyz("L");
  const Vector u = turned(q, Vector(0, 0, 1));
  const Vector L_B = turned(conjugated(q), L);
  const Vector w_B(L_B.x() / transverse, L_B.y() / transverse, L_B.z() / axial);
  const Relations relations = Relations().unit(q);
  const goishi::Mobility<ex> one{.linear = possymbol("A"), .transverse = possymbol("B"), .axial = realsymbol("C")};
  const Vector axis = letters_xyz("u");
  exmap meaning = {{one.transverse, mobility.transverse}, {one.axial, mobility.axial}};
  for (int i = 0; i < 3; ++i) {
    meaning[axis(i)] = u(i);
  }
  const ex turning = components(formula::turning(one, axis, L));
  document.equation(R"(a \cdot \omega)", turning);
  document.prove(relations({.text = R"($\omega = I^{-1} L$)",
                            .result = turning,
                            .witness = components(turned(q, w_B)),
                            .view = [&](const ex& x) { return x.subs(meaning); }}));

  document.section("An impulse at a point");
  document.text(
      R"(An impulse $p$ at $r$ from the centre of mass: $\Delta v = p/m$, $\Delta L = r \times p$ (Newton and Euler,
integrated over an instant). The point at $r$ moves with $v + \omega \times r$. From here on the mobility is three letters,
$A = 1/m$, $B = 1/I_t$, $C = 1/I_a - 1/I_t$.)");
  document.shipped("formula::point_velocity, pushed, response", "impact/body.hpp");
  const Body any = body_letters();
  const Vector r = letters_xyz("r");
  const Vector w = formula::turning(any.mobility, any.u_W, any.L_W);
  document.prove({.text = R"(the point's velocity is $v + \omega \times r$)",
                  .result = components(formula::point_velocity(any, r)),
                  .witness = components(any.v_WB + w.cross(r))});
  const Body pushed = after(any, r, p);
  document.prove({.text = R"($v^+ = v + p/m$)",
                  .result = components(pushed.v_WB),
                  .witness = components(any.v_WB + Vector(any.mobility.linear * p))});
  document.prove({.text = R"($L^+ = L + r \times p$)",
                  .result = components(pushed.L_W),
                  .witness = components(any.L_W + r.cross(p))});
  const Vector gain = formula::response(any.mobility, any.u_W, r, p);
  document.prove({.text = R"(the response is what the point's velocity gains)",
                  .result = components(gain),
                  .witness = components(formula::point_velocity(pushed, r) - formula::point_velocity(any, r))});
  document.prove({.text = R"($K$: $n \cdot W n = \frac1m + (I^{-1}(r \times n)) \cdot (r \times n)$, the talk's
$(I^{-1}(r \times n) \times r) \cdot n$)",
                  .result = formula::dot(n, formula::response(any.mobility, any.u_W, r, n)),
                  .witness = any.mobility.linear * n.dot(n) +
                             formula::turning(any.mobility, any.u_W, Vector(r.cross(n))).dot(r.cross(n))});

  document.section("The contact matrix");
  document.shipped("formula::contact_matrix", "impact/contact_matrix.hpp");
  const ContactMatrix<ex> made = formula::contact_matrix(any.mobility, any.u_W, r);
  const goishi::PointMatrix<ex> parts = formula::point_matrix(any.mobility, any.u_W, r);
  document.equation("W_{xx}", made.xx);
  document.equation("W_{xy}", made.xy);
  const ex entry = components(Vector(full(made) * p));
  document.prove({.text = R"($W p$ is the response, for every $p$)", .result = entry, .witness = components(gain)});
  document.shipped("formula::point_matrix, product, solution", "impact/contact_matrix.hpp");
  document.prove({.text = R"(by its parts: $W p$ is the response, for every $p$)",
                  .result = components(formula::product(parts, p)),
                  .witness = components(gain)});
  const ex back = components(formula::solution(parts, formula::product(parts, p)));
  document.prove({.text = "and $W^{-1} W p = p$",
                  .result = back,
                  .witness = components(p),
                  .controls = {-back, back * ex(1001) / 1000, components(formula::solution(parts, p)),
                               components(formula::product(parts, formula::product(parts, p)))}});
  document.prove({.text = R"($W r = r/m$: the least eigenvalue, since by the statement on $K$, for any $n$,
$n \cdot W n - |n|^2/m = (r \times n) \cdot I^{-1} (r \times n) \ge 0$)",
                  .result = components(Vector(full(made) * r)),
                  .witness = components(Vector(any.mobility.linear * r)),
                  .controls = {components(Vector(full(made) * p)), -components(Vector(full(made) * r))}});
}

void matrices(Document& document) {
  document.section("Symmetric matrices");
  document.text("$M$ is the full matrix with the entries of $W$; its products and inverses by Eigen.");
  document.shipped("formula::sum, product, solution, in_frame, tangential_solution", "impact/contact_matrix.hpp");
  const ContactMatrix<ex> V = matrix_letters("V");
  document.prove({.text = "$W p = M p$", .result = components(formula::product(W, p)), .witness = components(M * p)});
  document.prove({.text = "the sum",
                  .result = components(Vector(full(formula::sum(W, V)) * p)),
                  .witness = components(Vector((M + full(V)) * p))});
  document.prove({.text = "$W^{-1} v = M^{-1} v$",
                  .result = components(formula::solution(W, v)),
                  .witness = components(Vector(M.inverse() * v))});
  const Vector b = letters("b"), c = letters("c");
  Matrix frame;
  frame << b, c, n;
  document.prove({.text = R"(in the frame $F = (b, c, n)$: $F^\mathsf{T} M F$)",
                  .result = components(Vector(full(formula::in_frame(W, b, c, n)) * p)),
                  .witness = components(Vector(frame.transpose() * M * frame * p))});
  const ex determinant = W.xx * W.yy - W.xy * W.xy;
  const Vector across = formula::tangential_solution(W, v.x(), v.y());
  document.prove({.text = R"(across $z$ (Cramer's rule), and nothing along it)",
                  .result = components(across),
                  .witness = components(Vector((v.x() * W.yy - W.xy * v.y()) / determinant,
                                               (W.xx * v.y() - v.x() * W.xy) / determinant, 0))});
}

void two_bodies(Document& document) {
  document.section("Two bodies");
  document.text(
      R"(They meet at one point, $r_1$ and $r_2$ from their centres; $p$ acts on the first, $-p$ on the second. What happens
depends on the relative velocity $v = v_1 - v_2$ of the two points alone. A fixed body is $A = B = C = 0$.)");
  const Body first = body_letters("1"), second = body_letters("2");
  const Vector r1 = letters_xyz("r", "1"), r2 = letters_xyz("r", "2");
  const Body pushed1 = after(first, r1, p), pushed2 = after(second, r2, Vector(-p));
  const Vector before = formula::point_velocity(first, r1) - formula::point_velocity(second, r2);
  const Vector later = formula::point_velocity(pushed1, r1) - formula::point_velocity(pushed2, r2);
  const ContactMatrix<ex> both = formula::sum(formula::contact_matrix(first.mobility, first.u_W, r1),
                                              formula::contact_matrix(second.mobility, second.u_W, r2));
  document.prove({.text = R"($v^+ = v + (W_1 + W_2) p$)",
                  .result = components(formula::plus(before, formula::product(both, p))),
                  .witness = components(later)});
  const auto momentum = [](const Body& body) { return Vector(body.v_WB / body.mobility.linear); };
  document.prove(
      {.text = "momentum is kept",
       .result = components(momentum(pushed1) + momentum(pushed2)),
       .witness = components(momentum(first) + momentum(second)),
       .controls = {components(momentum(pushed1) + momentum(second)), components(momentum(pushed1) - momentum(pushed2)),
                    components(momentum(pushed1) + momentum(after(second, r2, p)))}});
  const auto angular = [&](const Body& body, const Vector& r) {
    return Vector(body.L_W - r.cross(momentum(body)));  // about the contact: the centre is at −r from it
  };
  document.prove({.text = "and so is angular momentum about the contact, and with momentum about any point",
                  .result = components(angular(pushed1, r1) + angular(pushed2, r2)),
                  .witness = components(angular(first, r1) + angular(second, r2)),
                  .controls = {components(angular(pushed1, r2) + angular(pushed2, r2)),
                               components(angular(after(first, r2, p), r1) + angular(pushed2, r2)),
                               components(angular(pushed1, r1) - angular(pushed2, r2))}});
  document.shipped("formula::work", "impact/impulses.hpp");
  const Vector y = letters("y");
  exmap meaning;
  for (int i = 0; i < 3; ++i) {
    meaning[v(i)] = before(i);
    meaning[y(i)] = later(i);
  }
  document.prove({.text = R"(the energy of both changes by $p \cdot (v + v^+)/2$)",
                  .result = formula::work(p, v, y),
                  .witness = energy(pushed1) + energy(pushed2) - energy(first) - energy(second),
                  .meaning = meaning});
}

void normal(Document& document) {
  document.section("The normal impulse");
  document.text(
      R"($p = j n$ changes the approach speed $v_n = v \cdot n$ to $v_n + j K$ with $K = n \cdot W n$, and the energy by $j
(v_n + v_n^+)/2 = j v_n + j^2 K/2$.)");
  document.shipped("formula::normal_impulse", "impact/impulses.hpp");
  const realsymbol approach("vn", "v_n"), speed("vt", "v_t");
  const possymbol K("K"), Kt("Kt", "K_t");
  const ex j = formula::normal_impulse<ex>(approach, K, e);
  document.equation("j", j);
  document.prove({.text = "$v_n^+ = -e v_n$", .result = j, .witness = -e * approach, .view = [&](const ex& x) {
                    return approach + x * K;
                  }});
  const auto change = [](const ex& velocity, const ex& mobility) {
    return [=](const ex& impulse) { return impulse * velocity + impulse * impulse * mobility / 2; };
  };
  document.prove({.text = R"(the energy changes by $-(1 - e^2) v_n^2/(2K)$: never up for $e \le 1$)",
                  .result = j,
                  .witness = -(1 - e * e) * pow(approach, 2) / (2 * K),
                  .view = change(approach, K),
                  .controls = scaled(j)});

  document.section("Friction");
  document.text(R"(Against a slip of speed $v_t$ along the unit vector $t$, $K_t = t \cdot W t$.)");
  document.shipped("formula::stopping_impulse", "impact/impulses.hpp");
  const ex stopping = formula::stopping_impulse<ex>(speed, Kt);
  document.prove({.text = "it stops the slip", .result = stopping, .witness = 0, .view = [&](const ex& x) {
                    return speed + x * Kt;
                  }});
  const realsymbol part("lambda", R"(\lambda)");
  document.prove(
      {.text = R"(a part $\lambda$ of it changes the energy by $-\lambda(2 - \lambda) v_t^2/(2 K_t)$: never up
for $0 \le \lambda \le 1$, so no round of the published law adds energy)",
       .result = stopping,
       .witness = -part * (2 - part) * pow(speed, 2) / (2 * Kt),
       .view = [&](const ex& x) { return change(speed, Kt)(part * x); }});
  document.text(
      R"(But friction couples back into the normal velocity. While it slides, $p = j(n - \mu t)$ and the effective
restitution is not $e$:)");
  const Vector t = letters("t");
  const ex normal_mobility = n.dot(Vector(M * n)), coupling = n.dot(Vector(M * t));
  const Vector slid = Vector(v + M * Vector(j.subs(exmap{{approach, v.dot(n)}, {K, normal_mobility}}) * (n - mu * t)));
  document.prove({.text = R"($-v_n^+/v_n = e - \mu (1 + e)\, \frac{n \cdot W t}{n \cdot W n}$)",
                  .result = -n.dot(slid) / n.dot(v),
                  .witness = e - mu * (1 + e) * coupling / normal_mobility,
                  .controls = scaled(-n.dot(slid) / n.dot(v))});
  document.text(
      R"(For a stone on a plane, with the axis $u = (\sigma, 0, \eta)$ and the contact at $r = (\alpha, 0, \beta)$, all in one
plane with the normal $z$:)");
  const realsymbol alpha("alpha", R"(\alpha)"), beta("beta", R"(\beta)"), sigma("sigma", R"(\sigma)");
  const realsymbol eta("eta", R"(\eta)");
  const Body any = body_letters();
  const ContactMatrix<ex> plane =
      formula::contact_matrix<ex>(any.mobility, Vector(sigma, 0, eta), Vector(alpha, 0, beta));
  document.check("the tangent out of that plane decouples: $W_{xy} = W_{yz} = 0$",
                 vanishes(plane.xy) && vanishes(plane.yz));
  document.refute("$W_{xz}$ is not 0", plane.xz, 0);
  document.prove({.text = R"($\frac{n \cdot W t}{n \cdot W n} = -\frac{\alpha\beta}{I_t/m + \alpha^2}$)",
                  .result = plane.xz / plane.zz,
                  .witness = -alpha * beta / (any.mobility.linear / any.mobility.transverse + alpha * alpha)});
}

void linear(Document& document) {
  document.section("The linear response");
  document.shipped("formula::linear_impulse", "published/linear_response.hpp");
  const possymbol m("m"), K("K");
  const ex j = formula::linear_impulse<ex>(Vector(m * v), n, e);
  document.equation("j", j);
  document.prove({.text = "of a body that does not turn: $W = 1/m$, and $v_n^+ = -e v_n$ (for $|n| = 1$)",
                  .result = j,
                  .witness = -e * v.dot(n),
                  .view = [&](const ex& x) {
                    return v.dot(n) +
                           formula::dot(n, formula::response<ex>({.linear = 1 / m, .transverse = 0, .axial = 0}, v, p,
                                                                 Vector(x * n / n.dot(n))));
                  }});
  document.text(
      R"(Published: the velocity of the contact point, spin included, over the mass alone. The contact answers with $K$, not
with $1/m$:)");
  const ex published = j * v.dot(n) + j * j * K / 2;
  document.prove(
      {.text = R"(then the energy changes by $(1 + e) m v_n^2 \left(\frac{(1 + e) m K}{2} - 1\right)$: up as soon
as $(1 + e) m K > 2$)",
       .result = published,
       .witness = (1 + e) * m * pow(v.dot(n), 2) * ((1 + e) * m * K / 2 - 1)});
}

}  // namespace

int main() {
  return derive("Impacts", [](Document& document) {
    vectors(document);
    body(document);
    matrices(document);
    two_bodies(document);
    normal(document);
    linear(document);
  });
}
