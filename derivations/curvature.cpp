/// \file
/// The curvature of the profile: its jump at the joint of cap and bevel; why two arcs can never match; a profile with
/// continuous curvature, its support function, its domain, and an example.

#include <goishi/shape/bevel.hpp>
#include <goishi/shape/lens.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/shape/surface.hpp>

#include "curvature_example.hpp"
#include "profile.hpp"
#include "proof.hpp"
#include "torus.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

void radius_of_curvature(Document& document, const Normal& n) {
  document.section("The radius of curvature, from the support function");
  document.text(
      R"(Let $\varphi$ be the angle of the profile's outward normal $n = (\sin\varphi, \cos\varphi)$ from the axis,
and $t = n' = (\cos\varphi, -\sin\varphi)$ the tangent. With $S(\varphi) = n \cdot x$ the point of contact is
$x = S n + S' t$; since $t' = -n$, $x' = (S + S'')\,t$. So the arc's length per angle, the radius of curvature, is
$\rho = S + S''$.)");
  const possymbol w("w"), h("h"), b("b"), d("d");
  const goishi::Stone<ex> stone = formula::bevelled_stone<ex>(w, h, b, d);
  const auto of_support = [&](const ex& support) { return n.curvature_radius(support); };
  document.shipped("formula::cap_support", "shape/surface.hpp");
  const ex cap = formula::cap_support<ex>(stone, n.axial, pow(n.radial, 2));
  document.prove({.text = "the cap has the sphere's, $r = d + h/2$",
                  .result = cap,
                  .witness = d + h / 2,
                  .view = of_support,
                  .controls = scaled(cap)});
  document.shipped("formula::rim_support", "shape/surface.hpp");
  const ex rim = formula::rim_support<ex>(stone, n.radial);
  document.prove({.text = "the bevel has the torus's small one, $r_2 = r\\,(b/2)/(d + b/2)$",
                  .result = rim,
                  .witness = (d + h / 2) * b / (2 * d + b),
                  .view = of_support,
                  .controls = scaled(rim)});
}

void jump(Document& document, const Torus& torus, const Normal& n) {
  document.section("The jump at the joint, and why two arcs cannot match");
  document.shipped("formula::bevel", "shape/bevel.hpp");
  const possymbol h("h"), b("b"), d("d");
  const auto band = formula::bevel<ex>(h, b, d);
  document.prove({.text = "it is $r/r_2 = (2d + b)/b$ times as large on the bevel",
                  .result = band.minor_radius,
                  .witness = (2 * d + b) / b,
                  .view = [&](const ex& minor) { return (d + h / 2) / minor; }});
  document.prove({.text = "in terms of any torus $r_1$, $r_2$, $\\alpha$ too",
                  .result = band.minor_radius,
                  .witness = torus.sphere_radius / torus.minor,
                  .meaning = {{h, torus.height}, {b, torus.bevel}, {d, torus.offset}},
                  .view = [&](const ex& minor) { return (d + h / 2) / minor; }});
  document.prove({.text = "the radii differ by $r - r_2 = r d/(d + b/2)$, positive unless $d = 0$",
                  .result = band.minor_radius,
                  .witness = (d + h / 2) * d / (d + b / 2),
                  .view = [&](const ex& minor) { return d + h / 2 - minor; }});
  document.text(
      R"(Can a better choice of the two arcs make them equal? No. Take any two circles that touch at $J$ with the
common normal $n$: their centres are $C = J - r n$ and $M = J - r_2 n$.)");
  const possymbol r("r"), minor("r2", "r_2"), x("x"), y("y");
  const ex apart =
      pow((x - minor * n.radial) - (x - r * n.radial), 2) + pow((y - minor * n.axial) - (y - r * n.axial), 2);
  document.prove({.text = "they stand $|CM| = |r - r_2|$ apart",
                  .result = apart,
                  .witness = pow(r - minor, 2),
                  .controls = scaled(apart)});
  document.text(
      R"(Equal curvature, $r = r_2$, makes $C = M$: both arcs are one circle, and the bevel is the cap itself, going
on. The cap's centre is on the axis, and the bevel's in the middle plane, where its tangent is to be parallel to the
axis; one centre is on both, so the stone is the ball. The same holds at each joint of any number of arcs. So a stone
that is not a ball needs a curve that is no circle between cap and rim.)");
  document.prove_limit("with $d = 0$ the shipped bevel is the cap: $r_1 = 0$", band.major_radius.subs(d == 0), 0);
  document.prove_limit("and $r_2 = h/2 = r$, whatever $b$", band.minor_radius.subs(d == 0), h / 2);
}

void equations(Document& document, const Normal& n, const Transition& at) {
  document.section("A profile with continuous curvature");
  document.text(
      R"(Prescribe the radius of curvature instead: $\rho = r$ up to $\varphi_a = \varphi_m - \delta$, linear from $r$
to $\rho_e$ on to $\varphi_b = \varphi_m + \delta$, then $\rho = \rho_e$ to the rim at $\pi/2$;
$0 \le \varphi_a < \varphi_b \le \pi/2$. From the pole on, $x' = \rho t$. The profile meets the axis at a right angle
and the rim's plane too, so that its mirror images join it with the same curvature; it has the width $w$ and the height
$h$ if

$$\int_0^{\pi/2} \rho \cos\varphi \, d\varphi = \frac w2, \qquad \int_0^{\pi/2} \rho \sin\varphi \, d\varphi = \frac
h2.$$

No function of the library makes this profile: what is stated of it is stated of this chapter's formulas.)");
  const possymbol r("r"), edge("re", R"(\rho_e)");
  const ex between = at.radius(r, edge, n);
  const ex across = between * n.radial + n.slope(between) * n.axial;
  const ex along = -between * n.axial + n.slope(between) * n.radial;
  const auto slope = [&](const ex& e) { return n.slope(e); };
  document.prove(
      {.text = R"($\rho\sin\varphi + \rho'\cos\varphi$ is an antiderivative of $\rho\cos\varphi$, for linear $\rho$)",
       .result = across,
       .witness = between * n.axial,
       .view = slope,
       .controls = scaled(across)});
  document.prove({.text = R"(and $-\rho\cos\varphi + \rho'\sin\varphi$ of $\rho\sin\varphi$)",
                  .result = along,
                  .witness = between * n.radial,
                  .view = slope,
                  .controls = scaled(along)});
  // The three pieces: r from 0 to φ_a, the transition, ρ_e from φ_b to π/2.
  const ex half_width =
      r * sine(at.before) + at.at_after(across, n) - at.at_before(across, n) + edge * (1 - sine(at.after));
  const ex half_height =
      r * (1 - cosine(at.before)) + at.at_after(along, n) - at.at_before(along, n) + edge * cosine(at.after);
  const ex sine_m = sine(at.m), cosine_m = cosine(at.m);
  document.prove(
      {.text = R"(with $\kappa = \sin\delta/\delta$, the first is $\rho_e + (r - \rho_e)\,\kappa\sin\varphi_m$)",
       .result = edge + (r - edge) * at.kappa * sine_m,
       .witness = half_width,
       .controls = scaled(edge + (r - edge) * at.kappa * sine_m)});
  document.prove({.text = R"(the second is $r - (r - \rho_e)\,\kappa\cos\varphi_m$)",
                  .result = r - (r - edge) * at.kappa * cosine_m,
                  .witness = half_height,
                  .controls = scaled(r - (r - edge) * at.kappa * cosine_m)});

  document.text(
      R"(These are a bevelled stone's $w/2 = r_1 + r_2$ and $h/2 = r - d$, with $r_1$ and $d$ shortened by
$\kappa < 1$. They are linear in $r$ and $\rho_e$, and their determinant is
$\kappa(\cos\varphi_m + \sin\varphi_m) - 1$. Solved:)");
  const possymbol w("w"), h("h"), kappa("kappa", R"(\kappa)"), c("c", R"(\cos\varphi_m)"), s("s", R"(\sin\varphi_m)");
  const Continuous solved = continuous(w, h, kappa, c, s);
  document.display(
      R"(r - \rho_e = \frac{w - h}{2\left(\kappa(\cos\varphi_m + \sin\varphi_m) - 1\right)}, \quad
\rho_e = \frac{\kappa(w\cos\varphi_m + h\sin\varphi_m) - w}{2\left(\kappa(\cos\varphi_m + \sin\varphi_m) - 1\right)},
\quad r = \frac h2 + (r - \rho_e)\,\kappa\cos\varphi_m)");
  const exmap meaning = {{kappa, at.kappa}, {c, cosine_m}, {s, sine_m}};
  document.prove({.text = "with these $r$ and $\\rho_e$ the profile is $w$ wide, exactly",
                  .result = solved.sphere_radius,
                  .witness = w / 2,
                  .meaning = meaning,
                  .view = [&](const ex& radius) {
                    return half_width.subs(exmap{{r, radius}, {edge, solved.edge_radius}});
                  }});
  document.prove({.text = "and $h$ thick",
                  .result = solved.edge_radius,
                  .witness = h / 2,
                  .meaning = meaning,
                  .view = [&](const ex& radius) {
                    return half_height.subs(exmap{{r, solved.sphere_radius}, {edge, radius}});
                  }});
}

void support(Document& document, const Normal& n, const Transition& at) {
  document.section("Its support function");
  document.text(
      R"(Where $\rho'' = 0$, $S = \rho + A\cos\varphi + B\sin\varphi$ is the general solution of $S + S'' = \rho$. On
the cap and at the rim that is a bevelled stone's, with $d = (r - \rho_e)\kappa\cos\varphi_m$,
$r_1 = (r - \rho_e)\kappa\sin\varphi_m$ and $r_2 = \rho_e$: the shipped functions serve. On the transition

$$S = \rho(\varphi) + \frac{r - \rho_e}{2\delta}\left(\cos\varphi_a \sin\varphi - \sin\varphi_b \cos\varphi\right).$$)");
  const possymbol w("w"), h("h");
  const Continuous made = continuous(w, h, at.kappa, cosine(at.m), sine(at.m));
  goishi::Stone<ex> stone;
  stone.height = h;
  stone.sphere_offset = made.offset;
  stone.bevel_major_radius = made.major_radius;
  stone.bevel_minor_radius = made.edge_radius;
  const ex cap = formula::cap_support<ex>(stone, n.axial, pow(n.radial, 2));
  const ex rim = formula::rim_support<ex>(stone, n.radial);
  const ex radius = at.radius(made.sphere_radius, made.edge_radius, n);
  const ex steep = (made.sphere_radius - made.edge_radius) / (2 * at.delta);
  const ex between = radius + steep * (cosine(at.before) * n.radial - sine(at.after) * n.axial);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness, .controls = scaled(result)});
  };
  prove(R"(on the transition $S + S'' = \rho$)", n.curvature_radius(between), radius);
  prove("on the cap $S + S'' = r$", n.curvature_radius(cap), made.sphere_radius);
  prove(R"(at the rim $S + S'' = \rho_e$)", n.curvature_radius(rim), made.edge_radius);
  prove(R"(at $\varphi_a$ the values agree)", at.at_before(cap, n), at.at_before(between, n));
  prove("and the slopes", at.at_before(n.slope(cap), n), at.at_before(n.slope(between), n));
  prove(R"(at $\varphi_b$ the values agree)", at.at_after(rim, n), at.at_after(between, n));
  prove("and the slopes", at.at_after(n.slope(rim), n), at.at_after(n.slope(between), n));
  prove("at the pole $S = h/2$", cap.subs(n.t == 0), h / 2);
  prove(R"(at $\pi/2$ $S = w/2$)", rim.subs(n.t == 1), w / 2);
  document.text(
      R"($S$ and $S'$ are continuous, and so is $S'' = \rho - S$: the support function is $C^2$ (a bevelled stone's is
$C^1$), and its gradient, the support point, is $C^1$.)");
}

void domain(Document& document, const Torus& torus, const Normal& n) {
  document.section("Its domain");
  document.text(
      R"(The determinant is positive: for $\varphi_m$ between $\delta$ and $\pi/2 - \delta$ the sum
$\cos\varphi_m + \sin\varphi_m$ is least at the ends, and there $\kappa(\cos\delta + \sin\delta) > 1$, since
$\sin\delta\,(\sin\delta + \cos\delta) - \delta$ grows from 0 on, up to $\delta = \pi/4$:)");
  const ex over = n.radial * (n.radial + n.axial) - n.phi;
  document.prove({.text = R"(its derivative is $2\sin\delta\,(\cos\delta - \sin\delta)$)",
                  .result = over,
                  .witness = 2 * n.radial * (n.axial - n.radial),
                  .view = [&](const ex& e) { return n.slope(e); },
                  .controls = scaled(over)});
  document.text(
      R"(So $r \ge \rho_e$ for $h \le w$. The profile is one, and convex, if $\rho_e > 0$, that is, if

$$\kappa\,(w\cos\varphi_m + h\sin\varphi_m) > w,$$

and must be refused otherwise. Without $\kappa$, which is less than 1, this is the condition that two arcs with their
joint at $\varphi_m$ exist:)");
  const possymbol w("w"), h("h"), m("m");
  const ex margin = w * cosine(m) + h * sine(m) - w;
  document.prove({.text = R"($w\cos\varphi_m + h\sin\varphi_m - w = 2m\,(h - wm)/(1 + m^2)$, $m = \tan(\varphi_m/2)$)",
                  .result = margin,
                  .witness = 2 * m * (h - w * m) / (1 + pow(m, 2)),
                  .controls = scaled(margin)});
  const ex rim_sine = w / 2 / formula::sphere_radius<ex>(w, h);
  document.prove({.text = R"(and $m = h/w$ is where the sharp lens has its rim, $\sin\varphi = (w/2)/r$)",
                  .result = rim_sine,
                  .witness = sine(h / w)});
  document.text(
      R"(So $\varphi_m$ must be less than the angle of the sharp lens's rim. The left side is greatest,
$\kappa\sqrt{w^2 + h^2}$, for $\tan\varphi_m = h/w$. As $\delta \to 0$, $\kappa \to 1$, and the bevelled stone of the
same width, height and joint comes back:)");
  // φ_m is from the axis, α from the middle plane.
  const Continuous limit =
      continuous(2 * (torus.major + torus.minor), torus.height, 1, torus.joint.sine, torus.joint.cosine);
  document.prove_limit(R"($\rho_e \to r_2$)", limit.edge_radius, torus.minor);
  document.prove_limit("$r$ to the sphere's", limit.sphere_radius, torus.sphere_radius);
  document.prove_limit(R"($(r - \rho_e)\kappa\sin\varphi_m \to r_1$)", limit.major_radius, torus.major);
  document.prove_limit(R"($(r - \rho_e)\kappa\cos\varphi_m \to d$)", limit.offset, torus.offset);
}

}  // namespace

int main() {
  return derive("The curvature of the profile", [](Document& document) {
    const Torus torus;
    const Normal n;
    const Transition at;
    radius_of_curvature(document, n);
    jump(document, torus, n);
    equations(document, n, at);
    support(document, n, at);
    domain(document, torus, n);
    example(document);
  });
}
