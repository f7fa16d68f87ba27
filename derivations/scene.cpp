/// \file
/// Stones that touch several things: one contact with its normal velocity taken to zero, and how the velocity of a contact
/// changes because the bodies turn.

#include <goishi/scene/cluster/row.hpp>

#include "impact.hpp"

namespace {

using namespace derivation;

const Vector u = letters("u"), L = letters("L"), w = letters("w"), r = letters("r"), r_rate = letters("R");
const realsymbol t("t");

/// The rate of something that depends on u, as u turns with w.
template <class F>
Vector rate_with(F&& f) {
  const Vector now = f(Vector(u + t * w.cross(u)));
  return {now.x().diff(t).subs(t == 0), now.y().diff(t).subs(t == 0), now.z().diff(t).subs(t == 0)};
}

void contact(Document& document) {
  document.section("A contact that closes");
  document.text(
      R"(In its own frame, $z$ along the normal, the contact moves with $W p + f$ after an impulse $p$. What $p$ does along
the normal is chosen so that it does not move there; $w$ is the part of $W$ that couples normal and plane.)");
  document.shipped("formula::tangential, formula::closing_normal", "scene/cluster/cone.hpp");
  const realsymbol x("x"), y("y");
  const Vector f = letters("f");
  const auto S = formula::tangential(W);
  const ex normal = formula::closing_normal<ex>(S, -f.z() / W.zz, x, y);
  const Vector after = formula::product<ex>(W, Vector(x, y, normal)) + f;
  document.equation("p_n", normal);
  document.prove({.text = "$v_n = 0$", .result = normal, .witness = -(f.z() + W.xz * x + W.yz * y) / W.zz});
  document.prove({.text = R"($v_t = S p_t + f_t - w f_n/W_{nn}$)",
                  .result = components(
                      Vector(S.xx * x + S.xy * y + f.x() - S.x * f.z(), S.xy * x + S.yy * y + f.y() - S.y * f.z(), 0)),
                  .witness = components(after)});
}

void turning(Document& document) {
  document.section("How a contact is carried along");
  document.text(
      R"(The axis turns with $\dot u = \omega \times u$. A cap is part of a sphere about $\pm d u$: it touches a plane of normal
$n$ at $r = \pm d u - R n$. The rim touches it at $r = -r_1 e - r_2 n$, $e$ along $q = n - (u \cdot n) u$.)");
  document.shipped("formula::cap_contact_rate, formula::rim_contact_rate", "scene/cluster/row.hpp");
  const realsymbol d("d");
  const possymbol R("R"), r1("r1", "r_1"), r2("r2", "r_2");
  document.prove({.text = R"(the cap: $\dot r$)",
                  .result = components(formula::cap_contact_rate<ex>(d, w, u)),
                  .witness = components(rate_with([&](const Vector& axis) { return Vector(d * axis - R * n); }))});
  const auto radial = [](const Vector& axis) { return Vector(n - axis.dot(n) * axis); };
  const Vector q = radial(u);
  const ex size = sqrt(q.dot(q));
  document.prove({.text = R"(the rim: $\dot r$)",
                  .result = components(formula::rim_contact_rate<ex>(r1, w, u, n, Vector(q / size), size)),
                  .witness = components(rate_with([&](const Vector& axis) {
                    const Vector out = radial(axis);
                    return Vector(-r1 / sqrt(out.dot(out)) * out - r2 * n);
                  }))});
  document.text(
      R"(With no torque $L$ stays, and so does $u \cdot L$; $\omega = L/I_t + (1/I_a - 1/I_t)(u \cdot L) u$ turns with $u$.)");
  document.shipped("formula::carried_rate", "scene/cluster/row.hpp");
  const goishi::Mobility<ex> body{.linear = possymbol("A"), .transverse = possymbol("B"), .axial = realsymbol("C")};
  const Vector turns = formula::turning<ex>(body, u, L);
  const Vector axis = u + t * turns.cross(u);
  const Vector moved = formula::turning<ex>(body, axis, L).cross(Vector(r + t * r_rate));
  const auto now = [&](const ex& form) { return form.diff(t).subs(t == 0); };
  document.prove(
      {.text =
           R"(the velocity $\omega \times r$ of the contact changes by $\dot\omega \times r + \omega \times \dot r$)",
       .result = components(formula::carried_rate<ex>(body, u, u.dot(L), turns, r, r_rate)),
       .witness = components(Vector(now(moved.x()), now(moved.y()), now(moved.z())))});
}

}  // namespace

int main() {
  return derive("A cluster's contacts", [](Document& document) {
    contact(document);
    turning(document);
  });
}
