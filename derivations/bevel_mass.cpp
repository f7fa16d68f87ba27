/// \file
/// The bevelled stone: volume, surface area and both moments, from integrals over caps and band.

#include <goishi/mass/inertia.hpp>
#include <goishi/mass/volume.hpp>
#include <goishi/shape/lens.hpp>
#include <goishi/shape/stone.hpp>
#include <string>
#include <utility>
#include <vector>

#include "proof.hpp"
#include "solid.hpp"
#include "torus.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

/// The shipped formulas, as they stand, in letters; and what the library puts in for each letter when it is given the height,
/// bevel and offset of the torus's stone.
struct Shipped {
  explicit Shipped(const Torus& torus) {
    const auto made = formula::bevelled_stone<ex>(0, torus.height, torus.bevel, torus.offset);
    const auto values = formula::bevel_terms(made, torus.joint.value);
    stone.bevel_major_radius = letter("r1", "r_1", made.bevel_major_radius);
    stone.bevel_minor_radius = letter("r2", "r_2", made.bevel_minor_radius);
    stone.joint_radius = letter("Px", "P_x", made.joint_radius);
    terms = {.cap_height = letter("k", "k", values.cap_height),
             .half_band = letter("g", "g", values.half_band),
             .angle = letter("angle", R"(\alpha)", values.angle),
             .arc = {.c2 = letter("C2", "C_2", values.arc.c2),
                     .three_c3 = 3 * letter("C3", "C_3", values.arc.three_c3 / 3),
                     .c4 = letter("C4", "C_4", values.arc.c4),
                     .fifteen_c5 = 15 * letter("C5", "C_5", values.arc.fifteen_c5 / 15),
                     .d1 = letter("D1", "D_1", values.arc.d1),
                     .d2 = letter("D2", "D_2", values.arc.d2),
                     .fifteen_d3 = 15 * letter("D3", "D_3", values.arc.fifteen_d3 / 15)}};
  }

  ex letter(const std::string& name, const std::string& tex, const ex& value) {
    const possymbol symbol(name, tex);
    meaning[symbol] = resolve_roots(value).normal();
    return symbol;
  }

  exmap meaning;
  goishi::Stone<ex> stone;
  formula::BevelTerms<ex> terms;
};

void arc_integrals(Document& document) {
  document.section("Integrals over the arc");
  document.text(R"($C_n = \int_0^\alpha \cos^n\varphi\,\mathrm{d}\varphi$ and $D_n = \int_0^\alpha \sin^2\varphi
\cos^n\varphi\,\mathrm{d}\varphi$: the derivative by $\alpha$ is the integrand, and at $\alpha = 0$ the value is 0.
($c$, $s$: cosine and sine of $\alpha$.))");
  document.shipped("formula::arc_integrals", "mass/volume.hpp");
  const possymbol alpha("alpha", R"(\alpha)");
  const symbol c("c");
  const symbol s("s");
  const auto arc = formula::arc_integrals<ex>(alpha, c, s);
  const symbol t("t");  // tan(α/2)
  const exmap half_angle = {{c, (1 - t * t) / (1 + t * t)}, {s, 2 * t / (1 + t * t)}};
  const exmap at_zero = {{alpha, 0}, {c, 1}, {s, 0}};
  const auto slope = [&](const ex& f) { return f.diff(alpha) - s * f.diff(c) + c * f.diff(s); };
  struct Row {
    const char* name;
    ex shipped;
    ex integrand;
  };
  const std::vector<Row> rows = {
      {"C_2", arc.c2, pow(c, 2)},
      {"C_3", arc.three_c3 / 3, pow(c, 3)},
      {"C_4", arc.c4, pow(c, 4)},
      {"C_5", arc.fifteen_c5 / 15, pow(c, 5)},
      {"D_1", arc.d1, s * s * c},
      {"D_2", arc.d2, s * s * pow(c, 2)},
      {"D_3", arc.fifteen_d3 / 15, s * s * pow(c, 3)},
  };
  for (const Row& row : rows) {
    const std::string name = row.name;
    document.equation(name, row.shipped);
    document.prove({.text = R"($\mathrm{d})" + name + R"(/\mathrm{d}\alpha = )" + latex(row.integrand) + "$",
                    .result = row.shipped,
                    .witness = row.integrand.subs(half_angle),
                    .meaning = half_angle,
                    .view = slope});
    document.prove({.text = "$" + name + "(0) = 0$",
                    .result = row.shipped,
                    .witness = 0,
                    .meaning = at_zero,
                    .controls = {row.shipped + 1}});
  }
}

void terms(Document& document, const Torus& torus) {
  document.section("What the formulas share");
  document.text("$k$ is the height of a cap above its joint, $g$ half the band.");
  document.shipped("formula::bevel_terms", "mass/volume.hpp");
  const possymbol h("h");
  const possymbol b("b");
  const possymbol d("d");
  const auto made = formula::bevel_terms(formula::bevelled_stone<ex>(0, h, b, d), torus.joint.value);
  const exmap by_torus = {{h, torus.height}, {b, torus.bevel}, {d, torus.offset}};
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness, .meaning = by_torus});
  };
  prove("$k$ reaches from the joint to the pole", made.cap_height,
        torus.sphere_radius - torus.offset - torus.minor * torus.joint.sine);
  prove("$g$ reaches from the plane of the rim to the joint", made.half_band, torus.minor * torus.joint.sine);
  prove(R"($\alpha$)", made.angle, torus.joint.value);
}

/// The arc of the band, as symbols in cos φ and sin φ.
struct Arc {
  explicit Arc(const Torus& torus) : radius(torus.major + torus.minor * cosine), height(torus.minor * sine) {}

  /// d/dφ.
  ex slope(const ex& f) const { return -sine * f.diff(cosine) + cosine * f.diff(sine); }

  symbol cosine = symbol("c", R"(\cos\varphi)");
  symbol sine = symbol("s", R"(\sin\varphi)");
  ex radius;
  ex height;
};

/// ∫ f over the whole stone at density 1: two caps and the band.
ex over_stone(const ex& f, const Torus& torus) {
  const ex squared_radius = pow(torus.sphere_radius, 2) - pow(z + torus.offset, 2);
  const ex cap = over_solid(f, squared_radius, torus.bevel / 2, torus.height / 2);
  const Arc arc(torus);
  const ex slice = over_disc(f).subs(exmap{{rho, arc.radius}, {z, arc.height}});
  const ex half_band = arc_integral(slice * arc.slope(arc.height), arc.cosine, arc.sine, torus.joint);
  return (2 * (cap + half_band)).normal();
}

void integrals(Document& document, const Torus& torus, const Shipped& shipped) {
  document.section("Volume and moments");
  document.text(
      R"(As for the lens, slices: discs of radius $\rho$ at height $z$ give $\pi\rho^2$, $\tfrac\pi2 \rho^4$ and $\tfrac\pi4
\rho^4 + \pi\rho^2 z^2$ for $V$, $I_a$ and $I_t$ at density 1. Above, and below, there is a cap,

$$\rho^2 = r^2 - (z + d)^2, \qquad \tfrac b2 \le z \le \tfrac h2,$$

and between them the band,

$$\rho = r_1 + r_2\cos\varphi, \qquad z = r_2\sin\varphi, \qquad \mathrm{d}z = r_2\cos\varphi\,\mathrm{d}\varphi,
\qquad |\varphi| \le \alpha.$$

The first integral is of a polynomial, the second of a polynomial in cosine and sine, done by exponentials
$\mathrm{e}^{\mathrm{i}n\varphi}$. All is stated in $r_1$, $r_2$ and $\tau$ (the derivation of the bevel has the
tangencies), with $\alpha$ and $\pi$ as further independent symbols.)");
  document.shipped("formula::bevelled_volume", "mass/volume.hpp");
  const ex volume = formula::bevelled_volume(shipped.stone, shipped.terms);
  document.equation("V", volume);
  document.prove({.text = "$V$ is the integral",
                  .result = volume,
                  .witness = over_stone(volume_element, torus),
                  .meaning = shipped.meaning});
  document.shipped("formula::bevelled_moments", "mass/inertia.hpp");
  const auto moments = formula::bevelled_moments(shipped.stone, shipped.terms);
  document.equation("I_a", moments.axial);
  document.prove({.text = "$I_a$ is the integral",
                  .result = moments.axial,
                  .witness = over_stone(axial_element, torus),
                  .meaning = shipped.meaning});
  document.equation("I_t", moments.transverse);
  document.prove({.text = "$I_t$ is the integral",
                  .result = moments.transverse,
                  .witness = over_stone(transverse_element, torus),
                  .meaning = shipped.meaning});
}

void surface(Document& document, const Torus& torus, const Shipped& shipped) {
  document.section("Surface area");
  document.text(
      R"(A cap's area is $\int 2\pi\sqrt{\rho^2 + (\rho\rho')^2}\,\mathrm{d}z$ with $\rho\rho' = \frac12 (\rho^2)'$, the band's
$\int 2\pi\rho\,\sqrt{\rho'^2 + z'^2}\,\mathrm{d}\varphi$. Under both roots stands the square of a constant, $r$ and
$r_2$.)");
  const ex squared_radius = pow(torus.sphere_radius, 2) - pow(z + torus.offset, 2);
  const ex cap_square = squared_radius + pow(squared_radius.diff(z) / 2, 2);
  const ex cap = integral(2 * Pi * positive_root(cap_square), z, torus.bevel / 2, torus.height / 2);
  const Arc arc(torus);
  const ex arc_square = (pow(arc.slope(arc.radius), 2) + pow(arc.slope(arc.height), 2))
                            .expand()
                            .subs(pow(arc.sine, 2) == 1 - pow(arc.cosine, 2));
  const ex half_band =
      arc_integral(2 * Pi * arc.radius * positive_root(arc_square.expand()), arc.cosine, arc.sine, torus.joint);
  document.shipped("formula::bevelled_surface_area", "mass/volume.hpp");
  const ex area = formula::bevelled_surface_area(shipped.stone, shipped.terms);
  document.equation("S", area);
  document.prove(
      {.text = "$S$ is the integral", .result = area, .witness = 2 * (cap + half_band), .meaning = shipped.meaning});
}

void steiner(Document& document, const Torus& torus, const Shipped& shipped) {
  document.section("A second witness: Steiner's formula");
  document.text(
      R"(The stone is a convex body, the core lens (width $2r_1$, sphere radius $R = r - r_2$, offset $d$), and all that is
within $r_2$ of it. So

$$V = V_0 + S_0 r_2 + M_0 r_2^2 + \tfrac{4\pi}{3} r_2^3, \qquad S = S_0 + 2 M_0 r_2 + 4\pi r_2^2,$$

where $M_0 = S_0/R + 2\pi r_1 \alpha$ is the core's mean curvature: that of its caps, and its rim of length $2\pi
r_1$, where the normal turns by $2\alpha$. ($V_0$, $S_0$: the sharp lens, proved in its own derivation.))");
  const ex width = 2 * torus.major;
  const ex height = 2 * (torus.core_radius - torus.offset);
  const ex volume = formula::lens_volume<ex>(width, height);
  const ex area = formula::lens_surface_area<ex>(width, height);
  const ex curvature = area / torus.core_radius + 2 * Pi * torus.major * torus.joint.value;
  const ex& r2 = torus.minor;
  document.prove({.text = "$V$",
                  .result = formula::bevelled_volume(shipped.stone, shipped.terms),
                  .witness = volume + area * r2 + curvature * pow(r2, 2) + 4 * Pi / 3 * pow(r2, 3),
                  .meaning = shipped.meaning});
  document.prove({.text = "$S$",
                  .result = formula::bevelled_surface_area(shipped.stone, shipped.terms),
                  .witness = area + 2 * curvature * r2 + 4 * Pi * pow(r2, 2),
                  .meaning = shipped.meaning});
}

void limits(Document& document, const Torus& torus) {
  document.section("Limits");
  const possymbol w("w");
  const possymbol h("h");
  document.text("Without a bevel, $b = 0$, the formulas give the sharp lens, whatever the angle.");
  const auto stone = formula::bevelled_stone<ex>(w, h, 0, formula::sphere_offset<ex>(w, h));
  const auto terms = formula::bevel_terms(stone, torus.joint.value);
  const auto lens = formula::sharp_stone<ex>(w, h);
  document.prove_limit("$r_1 = w/2$", stone.bevel_major_radius, lens.bevel_major_radius);
  document.prove_limit("$r_2 = 0$", stone.bevel_minor_radius, lens.bevel_minor_radius);
  document.prove_limit("sphere radius", stone.sphere_radius, lens.sphere_radius);
  document.prove_limit("$R = r$", stone.core_sphere_radius, lens.core_sphere_radius);
  document.prove_limit("$P_x = w/2$", stone.joint_radius, lens.joint_radius);
  document.prove_limit("joint cosine", stone.joint_cosine, lens.joint_cosine);
  document.prove_limit("joint sine", stone.joint_sine, lens.joint_sine);
  document.prove_limit("$V$", formula::bevelled_volume(stone, terms), formula::lens_volume<ex>(w, h));
  document.prove_limit("$S$", formula::bevelled_surface_area(stone, terms), formula::lens_surface_area<ex>(w, h));
  const auto moments = formula::bevelled_moments(stone, terms);
  document.prove_limit("$I_a$", moments.axial, formula::lens_moments<ex>(w, h).axial);
  document.prove_limit("$I_t$", moments.transverse, formula::lens_moments<ex>(w, h).transverse);

  document.text("On the ball, $d = 0$, any bevel gives the ball of diameter $h$.");
  const possymbol b("b");
  const possymbol rest("k");
  const ex diameter = b + 2 * rest;
  const auto ball = formula::bevelled_stone<ex>(diameter, diameter, b, 0);
  const auto ball_terms = formula::bevel_terms(ball, torus.joint.value);
  const auto ball_moments = formula::bevelled_moments(ball, ball_terms);
  document.prove_limit("$r_1 = 0$", ball.bevel_major_radius, 0);
  document.prove_limit("$r_2 = h/2$", ball.bevel_minor_radius, diameter / 2);
  document.prove_limit(R"($V = \frac\pi6 h^3$)", formula::bevelled_volume(ball, ball_terms), Pi * pow(diameter, 3) / 6);
  document.prove_limit(R"($S = \pi h^2$)", formula::bevelled_surface_area(ball, ball_terms), Pi * pow(diameter, 2));
  document.prove_limit(R"($I_a = \frac\pi{60} h^5$)", ball_moments.axial, Pi * pow(diameter, 5) / 60);
  document.prove_limit(R"($I_t = \frac\pi{60} h^5$)", ball_moments.transverse, Pi * pow(diameter, 5) / 60);
}

}  // namespace

int main() {
  return derive("The bevelled stone's volume, area and moments", [](Document& document) {
    const Torus torus;
    const Shipped shipped(torus);
    arc_integrals(document);
    terms(document, torus);
    integrals(document, torus, shipped);
    surface(document, torus, shipped);
    steiner(document, torus, shipped);
    limits(document, torus);
  });
}
