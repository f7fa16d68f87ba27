/// \file
/// The support function of the stone: maximiser on cap and rim, its switch, thin stones; the distance from the core; which
/// points of two rims separate two stones most; and the bound that makes the time of impact safe.

#include <goishi/contact/gap_along.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/shape/surface.hpp>

#include "proof.hpp"
#include "torus.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

/// A direction n = (cos φ, sin φ) in the meridian half plane, rational in t = tan(φ/2).
struct Direction {
  possymbol t = possymbol("t", "t");
  ex radial = (1 - pow(t, 2)) / (1 + pow(t, 2));
  ex axial = 2 * t / (1 + pow(t, 2));
  realsymbol around_x = realsymbol("ax", R"(\cos\psi)"), around_y = realsymbol("ay", R"(\sin\psi)");  // about the axis
};

/// A stone by its torus, as `formula::bevelled_stone` makes it.
goishi::Stone<ex> stone_of(const Torus& torus) {
  goishi::Stone<ex> stone;
  stone.height = torus.height;
  stone.sphere_radius = torus.sphere_radius;
  stone.sphere_offset = torus.offset;
  stone.bevel_major_radius = torus.major;
  stone.bevel_minor_radius = torus.minor;
  stone.core_sphere_radius = torus.core_radius;
  stone.joint_cosine = torus.joint.cosine;
  return stone;
}

using Vector = Eigen::Matrix<ex, 3, 1>;

/// The shipped point is the farthest, in the direction n, of a ball about `centre`.
void point(Document& document, const Direction& n, const ex& reach, const ex& height, const Vector& centre,
           const ex& radius) {
  document.shipped("formula::support_point", "shape/surface.hpp");
  const Vector normal(n.radial * n.around_x, n.radial * n.around_y, n.axial);
  const Vector made = formula::support_point<ex>(reach, normal, height);
  const Vector letters(possymbol("la", "a_1"), possymbol("lb", "a_2"), possymbol("lc", "a_3"));
  const ex result = letters.dot(made);
  document.prove({.text = "the point itself, $n$ at the angle $\\psi$ about the axis",
                  .result = result,
                  .witness = letters.dot(centre + radius * normal),
                  .controls = {-result, result * ex(1001) / 1000, letters.dot(Vector(made.y(), made.x(), made.z())),
                               letters.dot(Vector(made.x(), made.y(), -made.z()))}});
}

void cap(Document& document, const goishi::Stone<ex>& stone, const Direction& n) {
  document.section("The cap");
  document.text(
      R"(The cap is part of the circle of radius $r$ about $(0, -d)$, so that the farthest point of that circle in the unit
direction $n = (n_r, \mu)$ is $(0, -d) + r n$, and $S = n \cdot ((0, -d) + r n) = r - d\mu$. Where this point is on the
cap, it is the farthest of the stone, which lies inside the circle.)");
  const ex square = pow(n.radial, 2);
  document.shipped("formula::cap_support", "shape/surface.hpp");
  const ex support = formula::cap_support<ex>(stone, n.axial, square);
  document.prove({.text = R"(the form without cancellation, $h/2 + d\,n_r^2/(1 + \mu)$, is $r - d\mu$)",
                  .result = support,
                  .witness = stone.sphere_radius - stone.sphere_offset * n.axial,
                  .controls = scaled(support)});
  document.shipped("formula::cap_support_height", "shape/surface.hpp");
  const ex height = formula::cap_support_height<ex>(stone, n.axial, square);
  document.prove({.text = R"($h/2 - r\,n_r^2/(1 + \mu)$ is the point's height $r\mu - d$)",
                  .result = height,
                  .witness = stone.sphere_radius * n.axial - stone.sphere_offset,
                  .controls = scaled(height)});
  point(document, n, stone.sphere_radius, height, Vector(0, 0, -stone.sphere_offset), stone.sphere_radius);
  document.shipped("formula::cap_gap", "contact/stone_plane.hpp");
  const possymbol z("z");
  const ex gap = formula::cap_gap<ex>(stone, z, n.axial, square);
  document.prove({.text = "the gap under a centre at height $z$ is $z - S$",
                  .result = gap,
                  .witness = z - (stone.sphere_radius - stone.sphere_offset * n.axial),
                  .controls = scaled(gap)});
}

void rim(Document& document, const goishi::Stone<ex>& stone, const Direction& n) {
  document.section("The rim");
  document.text(
      R"(The rim is the circle of radius $r_1$ in the middle plane, moved out by a ball of radius $r_2$. Its farthest point
in the direction $n$ is $(r_1, 0) + r_2 n$, and $S = n \cdot ((r_1, 0) + r_2 n)$.)");
  document.shipped("formula::rim_support", "shape/surface.hpp");
  const ex support = formula::rim_support<ex>(stone, n.radial);
  const ex reach = formula::rim_support_reach<ex>(stone, n.radial);
  const ex far_r = stone.bevel_major_radius + stone.bevel_minor_radius * n.radial;
  const ex far_z = stone.bevel_minor_radius * n.axial;
  document.prove({.text = "$S = r_1 n_r + r_2$",
                  .result = support,
                  .witness = n.radial * far_r + n.axial * far_z,
                  .controls = scaled(support)});
  document.shipped("formula::rim_support_reach", "shape/surface.hpp");
  document.prove({.text = "the point's distance from the axis, over $n_r$",
                  .result = reach,
                  .witness = far_r / n.radial,
                  .controls = scaled(reach)});
  point(document, n, reach, far_z,
        Vector(stone.bevel_major_radius * n.around_x, stone.bevel_major_radius * n.around_y, 0),
        stone.bevel_minor_radius);
  document.shipped("formula::rim_gap", "contact/stone_plane.hpp");
  const possymbol z("z");
  const ex gap = formula::rim_gap<ex>(stone, z, n.radial);
  document.prove({.text = "the gap under a centre at height $z$ is $z - S$",
                  .result = gap,
                  .witness = z - (n.radial * far_r + n.axial * far_z),
                  .controls = scaled(gap)});
}

/// Where a tilted stone meets a surface below it. The axis in W is that which sees the normal at the angle φ.
void level(Document& document, const goishi::Stone<ex>& stone, const Direction& n) {
  document.section("A surface z = const");
  document.text(
      R"(A stone over a surface of the normal $W_z$, its axis $u = (n_r \cos\psi, n_r \sin\psi, \mu)$: it meets the surface
with its farthest point in the direction $-W_z$. On a cap that is the point of the sphere below the centre of the
sphere, which is $d$ along the axis, up for the lower cap; on the rim it is the point of the circle that is lowest, along
$W_z - \mu u$ from the centre, downwards, and $r_2$ below it.)");
  document.shipped("formula::level_contact", "contact/stone_plane.hpp");
  const Vector u(n.radial * n.around_x, n.radial * n.around_y, n.axial);
  const Vector letters(possymbol("la", "a_1"), possymbol("lb", "a_2"), possymbol("lc", "a_3")), down(0, 0, -1);
  const auto prove = [&](const char* text, const ex& support, const ex& slope, const Vector& lowest) {
    const auto found = [&](const ex& s, const ex& k) { return letters.dot(formula::level_contact<ex>(u, s, k)); };
    document.prove({.text = text,
                    .result = found(support, slope),
                    .witness = letters.dot(lowest),
                    .controls = {found(support, -slope), found(-support, slope), found(support * 2, slope),
                                 found(support, slope * ex(1001) / 1000), -found(support, slope)}});
  };
  prove("the lower cap, $-S' = d$", formula::cap_support<ex>(stone, n.axial, pow(n.radial, 2)), stone.sphere_offset,
        Vector(stone.sphere_offset * u + stone.sphere_radius * down));
  // Down along the plane of the rim: (W_z − μu)/n_r.
  const Vector up_the_rim = (Vector(-down) - n.axial * u) / n.radial;
  prove("the rim, $-S' = r_1 \\mu/n_r$", formula::rim_support<ex>(stone, n.radial),
        formula::rim_slope<ex>(stone, n.axial, n.radial),
        Vector(stone.bevel_minor_radius * down - stone.bevel_major_radius * up_the_rim));
}

void joint(Document& document, const goishi::Stone<ex>& stone, const Torus& torus, const Direction& n) {
  document.section("The switch");
  document.text(
      R"(Cap and rim change at the joint's normal, $n = (\cos\alpha, \sin\alpha)$. There both give the same support and the
same slope by the direction's angle $\varphi$: the support function is $C^1$, and its gradient, the support point, is
continuous.)");
  const ex cosine = torus.joint.cosine;
  const ex sine = torus.joint.sine;
  const ex on_cap = formula::cap_support<ex>(stone, sine, pow(cosine, 2));
  document.prove({.text = "the values agree",
                  .result = on_cap,
                  .witness = formula::rim_support<ex>(stone, cosine),
                  .controls = scaled(on_cap)});
  // d/dφ = (dt/dφ) d/dt, and dt/dφ = (1 + t²)/2.
  const auto slope = [&](const ex& of_t) { return of_t.diff(n.t) * (1 + pow(n.t, 2)) / 2; };
  const ex at_joint = 1 / (1 + torus.tau);
  const ex cap_slope = slope(formula::cap_support<ex>(stone, n.axial, pow(n.radial, 2))).subs(n.t == at_joint);
  const ex rim_slope = slope(formula::rim_support<ex>(stone, n.radial)).subs(n.t == at_joint);
  document.prove(
      {.text = "the slopes agree", .result = cap_slope, .witness = rim_slope, .controls = scaled(cap_slope)});
}

void core(Document& document, const goishi::Stone<ex>& stone) {
  document.section("The distance from the core's sphere");
  document.text(
      R"(A point at the distance $\rho$ from the axis and the height $\zeta$ has the distance $q = \sqrt{\rho^2 + (\zeta +
d)^2}$ from the sphere's centre, and $q - R$ from the sphere. The core's rim is on the sphere, $R^2 = r_1^2 + d^2$. With
$\rho = s\,(1 - p^2)/(1 + p^2)$, $\zeta + d = 2 s p/(1 + p^2)$ the root is $s$.)");
  document.shipped("formula::core_sphere_distance", "shape/surface.hpp");
  const possymbol s("s");
  const possymbol p("p");
  const ex rho = s * (1 - pow(p, 2)) / (1 + pow(p, 2));
  const ex zeta = 2 * s * p / (1 + pow(p, 2)) - stone.sphere_offset;
  const ex distance = formula::core_sphere_distance<ex>(stone, rho, zeta, s);
  document.prove({.text = "it is $q - R$",
                  .result = distance,
                  .witness = s - stone.core_sphere_radius,
                  .controls = scaled(distance)});
}

/// What `detail::RimSearch` (contact/rim_rim.hpp) rests on. The normal is z; the tangents of the circles, at an angle β, lie
/// across it; each circle's radius makes an angle with z whose cosine is n_r. All by half-angle tangents.
void rims(Document& document) {
  document.section("Two rims");
  document.text(
      R"(Two stones' cores have rims that are circles of the radii $c_1$, $c_2$; $D$ leads from the second's centre to the
first's, and $n$, $|n| = 1$, from the second to the first. $n_{ri}$ is the length of the part of $n$ across the axis of stone
$i$, the unit vector $e_i$ its direction, $t_i$ the tangent of the circle there, across both $n$ and $e_i$, and $\beta$ the
angle from $t_1$ to $t_2$. Where both meet $n$ with their rims, the cores are apart by $g(n) = D \cdot n - c_1 n_{r1} - c_2
n_{r2}$. Where that is stationary, $w = D - c_1 e_1 - c_2 e_2 = g n$ is across both circles: it joins their points of
a stationary distance. With $k_i = c_i/n_{ri}$ the second derivative of $-g$ is $M = g + k_1 t_1 t_1^T + k_2 t_2
t_2^T$.)");
  const possymbol c1("c1", "c_1"), c2("c2", "c_2");
  const realsymbol g("g"), beta("b", R"(\tan\frac{\beta}{2})"), p1("p1", "p_1"), p2("p2", "p_2");
  const auto cosine = [](const ex& t) { return ex((1 - pow(t, 2)) / (1 + pow(t, 2))); };
  const auto sine = [](const ex& t) { return ex(2 * t / (1 + pow(t, 2))); };
  const Vector z(ex(0), ex(0), ex(1));
  const Vector t1(ex(1), ex(0), ex(0)), t2(cosine(beta), sine(beta), ex(0));
  const auto radial = [&](const Vector& t, const ex& p) { return Vector(cosine(p) * z + sine(p) * z.cross(t)); };
  const Vector e1 = radial(t1, p1), e2 = radial(t2, p2);
  // Round the circles by angles from there.
  const realsymbol a1("a1", R"(\phi_1)"), a2("a2", R"(\phi_2)");
  const Vector w = g * z - c1 * (cos(a1) * e1 + sin(a1) * t1 - e1) - c2 * (cos(a2) * e2 + sin(a2) * t2 - e2);
  const ex half_square = w.dot(w) / 2;
  const auto there = [&](const ex& e) { return e.subs(exmap{{a1, 0}, {a2, 0}}).normal(); };
  const ex curved =
      there(half_square.diff(a1, 2)) * there(half_square.diff(a2, 2)) - pow(there(half_square.diff(a1).diff(a2)), 2);
  const ex k1 = c1 / cosine(p1), k2 = c2 / cosine(p2);
  const ex determinant =
      (g + k1 + k2 * pow(cosine(beta), 2)) * (g + k2 * pow(sine(beta), 2)) - pow(k2 * cosine(beta) * sine(beta), 2);
  const auto slopes = [&](const Vector& between) {
    const ex half = between.dot(between) / 2;
    return ex(pow(there(half.diff(a1)), 2) + pow(there(half.diff(a2)), 2));
  };
  document.prove(
      {.text = R"(the distance is stationary there, whatever $g$; not so where $w$ has a part along a tangent)",
       .result = slopes(w),
       .witness = 0,
       .controls = {slopes(Vector(w + g * t1)), slopes(Vector(w + g * t2))}});
  document.prove({.text = R"(the determinant of the second derivative of $\frac12 |w|^2$ by the two angles is
$\frac{c_1^2 c_2^2}{k_1 k_2} \det M$)",
                  .result = (curved * k1 * k2 / pow(c1 * c2, 2)).normal(),
                  .witness = determinant,
                  .controls = scaled(determinant)});
  document.text(
      R"(At a maximum of $g$, $M$ is not negative. Where the cores overlap, $g < 0$, so $-g$ is at most the least eigenvalue
of $k_1 t_1 t_1^T + k_2 t_2 t_2^T$, which is at most $\min(k_1, k_2) \sin^2\beta$; then both diagonal derivatives,
$c_i^2 (1 + g/k_i)$, are not negative either. So such a maximum, where $M$ is definite, is a local *minimum* of the distance of
the circles; in the limit the second derivative is not negative.)");
}

void impact(Document& document, const goishi::Stone<ex>& stone, const Torus& torus) {
  document.section("The bound of the time of impact");
  document.text(
      R"(A flying stone's axis has the height component $u = A + B\cos\Omega t + C\sin\Omega t$, and the gap to a plane is
$H = h_0 + v t - g t^2/2 - S(u)$. So $H'' = -g - S''(u)\,u'^2 - S'(u)\,u''$. On a cap $S = r - d|u|$; on the rim $S = r_1
\sqrt{1 - u^2} + r_2$.)");
  const realsymbol A("A");
  const realsymbol B("B");
  const realsymbol C("C");
  const possymbol rate("Omega", R"(\Omega)");
  const realsymbol time("time", "t");
  const ex u = A + B * cos(rate * time) + C * sin(rate * time);
  const realsymbol c("c");
  const realsymbol sine("sn", R"(\sin\Omega t)");
  const auto in_letters = [&](const ex& e) {
    return e.subs(exmap{{cos(rate * time), c}, {sin(rate * time), sine}}).expand();
  };
  const ex sum = in_letters(pow(u.diff(time, 2), 2) + pow(rate * u.diff(time), 2));
  document.prove(
      {.text = R"($u''^2 + \Omega^2 u'^2 = \Omega^4 (B^2 + C^2)$, and so $|u''| \le \Omega^2 \sqrt{B^2 + C^2}$)",
       .result = sum.subs(pow(sine, 2) == 1 - pow(c, 2)).expand(),
       .witness = (pow(rate, 4) * (pow(B, 2) + pow(C, 2))),
       .controls = scaled(sum.subs(pow(sine, 2) == 1 - pow(c, 2)))});
  document.shipped("formula::greatest_bend", "contact/gap_along.hpp");
  const possymbol swing("swing", R"(\sqrt{B^2 + C^2})"), offset("d");
  const Direction phase;
  const exmap at_the_top = {{B, swing * phase.radial}, {C, swing * phase.axial}};
  const exmap then = {{c, phase.radial}, {sine, phase.axial}};
  const ex bend = formula::greatest_bend<ex>(offset, rate, B, C);
  document.prove({.text = R"(it is $-d\,u''$ where $u$ is greatest, $\cos\Omega t : \sin\Omega t = B : C$)",
                  .result = bend,
                  .witness = (-offset * in_letters(u.diff(time, 2))).subs(then).subs(at_the_top),
                  .meaning = at_the_top,
                  .controls = scaled(bend)});
  // u = 2k/(1 + k²) on the rim, so that √(1 − u²) is rational.
  const possymbol k("k");
  const ex on_rim = 2 * k / (1 + pow(k, 2));
  const ex root = (1 - pow(k, 2)) / (1 + pow(k, 2));
  const auto by_u = [&](const ex& e) { return (e.diff(k) / on_rim.diff(k)).normal(); };
  const ex slope = by_u(formula::rim_support<ex>(stone, root));
  document.shipped("formula::rim_slope", "shape/surface.hpp");
  document.prove({.text = R"(on the rim $S' = -r_1 u/\sqrt{1 - u^2}$)",
                  .result = formula::rim_slope<ex>(stone, on_rim, root),
                  .witness = -slope,
                  .controls = {slope, formula::rim_slope<ex>(stone, root, on_rim), slope * ex(-1001) / 1000}});
  document.prove({.text = R"(and $S'' = -r_1/(1 - u^2)^{3/2} < 0$: it falls, up to the joint)",
                  .result = by_u(slope),
                  .witness = -stone.bevel_major_radius / pow(root, 3),
                  .controls = scaled(by_u(slope))});
  const ex at_joint = stone.bevel_major_radius * torus.joint.sine / torus.joint.cosine;
  document.prove({.text = R"(where it is $-d$, the cap's: $|S'| \le d$ everywhere)",
                  .result = at_joint,
                  .witness = stone.sphere_offset,
                  .controls = scaled(at_joint)});
  document.text(
      R"(With $S'' \le 0$ and $|S'| \le d$, $H'' \ge -M$ with $M = g + d\,\Omega^2\sqrt{B^2 + C^2}$, and from $H \ge 0$ the
step $s$ with $H + H's - Ms^2/2 = 0$ cannot pass a root. On the rim $n_r = \sqrt{1 - u^2}$ is not below $\cos\alpha$, so that
$-S'' \le r_1/\cos^3\alpha$; and $|u'| \le \Omega \sqrt{B^2 + C^2}$, by the first of these. So $H'' \le M^+$, if gravity
points down.)");
  document.shipped("formula::greatest_lift", "contact/gap_along.hpp");
  const ex lift = formula::greatest_lift<ex>(stone, rate, B, C);
  const ex at_the_joint = by_u(slope).subs(k == 1 / (1 + torus.tau));
  document.prove(
      {.text = R"(it is $-d\,u''$, as above, and $-S''\,u'^2$ with $S''$ at the joint and $u'$ where $u'' = 0$)",
       .result = lift,
       .witness = (-stone.sphere_offset * in_letters(u.diff(time, 2))).subs(then).subs(at_the_top) -
                  at_the_joint * pow(rate * swing, 2),
       .meaning = at_the_top,
       .controls = {-lift, lift * ex(1001) / 1000, lift.subs(B == 2 * B),
                    formula::greatest_bend<ex>(stone.sphere_offset, rate, B, C)}});
  document.text(
      R"(After that step from where $H' < 0$, $H \le \frac12 (M + M^+) s^2$. Where $H' + 2 M^+ s < 0$, too, $H$ falls there at
$-H' - M^+ s$ or faster, and for another $s$ at $-H' - 2 M^+ s$ or faster: if $\frac12 (M + M^+) s^2$ is less than what that
takes off in a time no longer than $s$, the root is not farther off than that time.)");
}

}  // namespace

int main() {
  return derive("The support function of the stone", [](Document& document) {
    const Torus torus;
    const goishi::Stone<ex> stone = stone_of(torus);
    const Direction n;
    cap(document, stone, n);
    rim(document, stone, n);
    level(document, stone, n);
    joint(document, stone, torus, n);
    core(document, stone);
    rims(document);
    impact(document, stone, torus);
  });
}
