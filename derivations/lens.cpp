/// \file
/// The sharp lens: its sphere from width and height; volume, surface area and both moments from integrals over the solid.

#include <goishi/mass/inertia.hpp>
#include <goishi/mass/volume.hpp>
#include <goishi/shape/lens.hpp>
#include <goishi/shape/stone.hpp>

#include "proof.hpp"
#include "solid.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

const possymbol w("w");
const possymbol h("h");

/// The sphere of the upper cap, from what defines it.
struct Sphere {
  ex offset;
  ex radius;
};

Sphere sphere(Document& document) {
  document.section("The sphere of a cap");
  document.text(
      R"(The lens of width $w$ and height $h$ is what two balls of radius $r$ have in common, whose centres stand at $(0, 0,
\mp d)$. In the meridian half plane (distance $\rho$ from the axis, height $z$) the upper cap is part of the circle
about $(0, -d)$ on which lie

- the pole $(0, h/2)$: $d + h/2 = r$;
- the rim $(w/2, 0)$: $(w/2)^2 + d^2 = r^2$.

Subtracting the square of the first equation from the second leaves one that is linear in $d$.)");
  const realsymbol d("d");
  const ex offset = GiNaC::lsolve(((pow(w / 2, 2) + d * d) - pow(d + h / 2, 2)).expand() == 0, d);
  const Sphere solved = {.offset = offset, .radius = offset + h / 2};
  document.equation("d", solved.offset.normal());

  document.shipped("formula::sphere_radius", "shape/lens.hpp");
  const ex radius = formula::sphere_radius<ex>(w, h);
  document.equation("r", radius);
  document.prove({.text = "$r$ is the distance of centre and pole", .result = radius, .witness = solved.radius});
  document.shipped("formula::sphere_offset", "shape/lens.hpp");
  const ex shipped_offset = formula::sphere_offset<ex>(w, h);
  document.equation("d", shipped_offset);
  document.prove({.text = "$d$ is the solution", .result = shipped_offset, .witness = solved.offset});
  document.prove({.text = "the factored form, which keeps its digits near the ball, is the textbook's $r - h/2$",
                  .result = shipped_offset,
                  .witness = radius - h / 2});
  return solved;
}

void stone(Document& document, const Sphere& sphere) {
  document.section("The sharp stone");
  document.text(
      R"(A sharp stone is a bevelled stone whose torus has shrunk to the rim: $r_1 = w/2$, $r_2 = 0$, and the joint of cap and
bevel is the rim. The cap's normal there is $((w/2, 0) - (0, -d))/r$.)");
  document.shipped("formula::sharp_stone", "shape/stone.hpp");
  const auto sharp = formula::sharp_stone<ex>(w, h);
  document.prove({.text = "width $w$", .result = sharp.width, .witness = w});
  document.prove({.text = "height $h$", .result = sharp.height, .witness = h});
  document.prove({.text = "no bevel", .result = sharp.bevel, .witness = 0, .controls = {h}});
  document.prove({.text = "sphere radius $r$", .result = sharp.sphere_radius, .witness = sphere.radius});
  document.prove({.text = "sphere offset $d$", .result = sharp.sphere_offset, .witness = sphere.offset});
  document.prove({.text = "$r_1 = w/2$", .result = sharp.bevel_major_radius, .witness = w / 2});
  document.prove({.text = "$r_2 = 0$", .result = sharp.bevel_minor_radius, .witness = 0, .controls = {h}});
  document.prove({.text = "the core lens is the lens", .result = sharp.core_sphere_radius, .witness = sphere.radius});
  document.prove({.text = "joint radius $w/2$", .result = sharp.joint_radius, .witness = w / 2});
  document.prove(
      {.text = "radial part of the joint's normal", .result = sharp.joint_cosine, .witness = w / 2 / sphere.radius});
  document.prove({.text = "axial part of the joint's normal",
                  .result = sharp.joint_sine,
                  .witness = sphere.offset / sphere.radius});
  document.prove({.text = "the normal has length 1",
                  .result = sharp.joint_cosine,
                  .witness = 1,
                  .view = [&](const ex& cosine) { return pow(cosine, 2) + pow(sharp.joint_sine, 2); },
                  .controls = {2 * sharp.joint_cosine, 1 - sharp.joint_cosine}});
}

void slices(Document& document, const Sphere& sphere) {
  document.section("Volume and moments, in slices");
  document.text(
      R"(Cut at height $z$, the solid shows a disc of radius $\rho$, $\rho^2 = r^2 - (|z| + d)^2$. Over the disc, in polar
coordinates,)");
  document.equation(R"(\iint \mathrm{d}x\,\mathrm{d}y)", over_disc(volume_element));
  document.equation(R"(\iint (x^2 + y^2)\,\mathrm{d}x\,\mathrm{d}y)", over_disc(axial_element));
  document.equation(R"(\iint (y^2 + z^2)\,\mathrm{d}x\,\mathrm{d}y)", over_disc(transverse_element));
  document.text(
      R"(With $\rho^2(z)$ put in, each is a polynomial in $z$. Its integral from $0$ to $h/2$, twice, is the volume $V$, the
axial moment $I_a$ and the transverse moment $I_t$ at density 1. The last one answers the talk's question "can you
derive $I_x$?".)");
  const ex squared_radius = pow(sphere.radius, 2) - pow(z + sphere.offset, 2);
  const auto over_lens = [&](const ex& element) {
    return (2 * over_solid(element, squared_radius, 0, h / 2)).normal();
  };
  const ex volume = over_lens(volume_element);
  const ex axial = over_lens(axial_element);
  const ex transverse = over_lens(transverse_element);
  document.equation("V", volume);
  document.equation("I_a", axial);
  document.equation("I_t", transverse);

  document.shipped("formula::lens_volume", "mass/volume.hpp");
  const ex shipped_volume = formula::lens_volume<ex>(w, h);
  document.equation("V", shipped_volume);
  document.prove({.text = "$V$ is the integral", .result = shipped_volume, .witness = volume});

  document.shipped("formula::lens_moments", "mass/inertia.hpp");
  const auto moments = formula::lens_moments<ex>(w, h);
  document.equation("I_a", moments.axial);
  document.equation("I_t", moments.transverse);
  document.prove({.text = "$I_a$ is the integral", .result = moments.axial, .witness = axial});
  document.prove({.text = "$I_t$ is the integral", .result = moments.transverse, .witness = transverse});

  document.shipped("formula::lens_moments_per_mass", "mass/inertia.hpp");
  const auto per_mass = formula::lens_moments_per_mass<ex>(w, h);
  document.equation("I_a/m", per_mass.axial);
  document.equation("I_t/m", per_mass.transverse);
  document.prove(
      {.text = "$I_a/m$ is the ratio of the integrals", .result = per_mass.axial, .witness = axial / volume});
  document.prove(
      {.text = "$I_t/m$ is the ratio of the integrals", .result = per_mass.transverse, .witness = transverse / volume});

  document.text(
      R"(The talk prints a closed form of its integral for the axial moment, its $I_y$, in $h$ and $r$. It is right (the density
it was used with is not).)");
  const ex talk = Pi * pow(h, 3) * (3 * h * h - 30 * h * sphere.radius + 80 * pow(sphere.radius, 2)) / 480;
  document.prove(
      {.text = R"($I_a = \frac{\pi}{480} h^3 (3h^2 - 30hr + 80r^2)$)", .result = moments.axial, .witness = talk});
}

void shells(Document& document, const Sphere& sphere) {
  document.section("The same in shells");
  document.text(
      R"(A second way cuts the solid into cylinders of radius $s$ and height $2(u - d)$, $u = \sqrt{r^2 - s^2}$. With
$s\,\mathrm{d}s = -u\,\mathrm{d}u$, where $u$ runs from $r$ on the axis down to $d$ at the rim, no root is left:

$$V = 4\pi \int_d^r (u - d)\,u\,\mathrm{d}u, \qquad I_a = 4\pi \int_d^r (r^2 - u^2)(u - d)\,u\,\mathrm{d}u.$$)");
  const symbol u("u");
  const auto over_shells = [&](const ex& weight) {
    return 4 * Pi * integral(weight * (u - sphere.offset) * u, u, sphere.offset, sphere.radius);
  };
  document.prove({.text = "$V$", .result = formula::lens_volume<ex>(w, h), .witness = over_shells(1)});
  document.prove({.text = "$I_a$",
                  .result = formula::lens_moments<ex>(w, h).axial,
                  .witness = over_shells(pow(sphere.radius, 2) - u * u)});
}

void surface(Document& document, const Sphere& sphere) {
  document.section("Surface area");
  document.text(
      R"($S = 2 \int_0^{h/2} 2\pi \rho \sqrt{1 + \rho'^2}\,\mathrm{d}z$. On the cap $\rho\rho' = \frac12 (\rho^2)'$, so that
the square of the integrand, $4\pi^2(\rho^2 + (\rho\rho')^2)$, is a polynomial in $z$; it turns out constant.)");
  const ex squared_radius = pow(sphere.radius, 2) - pow(z + sphere.offset, 2);
  const ex integrand = sqrt((squared_radius + pow(squared_radius.diff(z) / 2, 2)).normal());
  document.shipped("formula::lens_surface_area", "mass/volume.hpp");
  const ex area = formula::lens_surface_area<ex>(w, h);
  document.equation("S", area);
  document.prove({.text = "$S$ is the integral",
                  .result = area,
                  .witness = 2 * integral(2 * Pi * resolve_roots(integrand), z, 0, h / 2)});
}

void limits(Document& document) {
  document.section("Limits");
  const auto moments = formula::lens_moments<ex>(w, h);
  const auto per_mass = formula::lens_moments_per_mass<ex>(w, h);
  const ex volume = formula::lens_volume<ex>(w, h);
  const ex area = formula::lens_surface_area<ex>(w, h);

  document.text("The ball, $h = w$.");
  const auto ball = [](const ex& result) { return result.subs(h == w); };
  document.prove_limit(R"($r = \frac12 w$)", ball(formula::sphere_radius<ex>(w, h)), w / 2);
  document.prove_limit("$d = 0$", ball(formula::sphere_offset<ex>(w, h)), 0);
  document.prove_limit(R"($V = \frac{\pi}{6} w^3$)", ball(volume), Pi * pow(w, 3) / 6);
  document.prove_limit(R"($S = \pi w^2$)", ball(area), Pi * pow(w, 2));
  document.prove_limit(R"($I_a = \frac{\pi}{60} w^5$)", ball(moments.axial), Pi * pow(w, 5) / 60);
  document.prove_limit(R"($I_t = \frac{\pi}{60} w^5$)", ball(moments.transverse), Pi * pow(w, 5) / 60);
  document.prove_limit(R"($I_a/m = \frac{1}{10} w^2$)", ball(per_mass.axial), pow(w, 2) / 10);
  document.prove_limit(R"($I_t/m = \frac{1}{10} w^2$)", ball(per_mass.transverse), pow(w, 2) / 10);

  document.text(R"(The thin lens, $h \to 0$: the leading term in $h$.)");
  const auto thin = [](const ex& result) { return result.normal().subs(h == 0); };
  document.prove_limit(R"($r \to w^2/(4h)$)", thin(h * formula::sphere_radius<ex>(w, h)), pow(w, 2) / 4);
  document.prove_limit(R"($d \to w^2/(4h)$)", thin(h * formula::sphere_offset<ex>(w, h)), pow(w, 2) / 4);
  document.prove_limit(R"($V \to \frac{\pi}{8} h w^2$)", thin(volume / h), Pi * pow(w, 2) / 8);
  document.prove_limit(R"($S \to \frac{\pi}{2} w^2$)", thin(area), Pi * pow(w, 2) / 2);
  document.prove_limit(R"($I_a \to \frac{\pi}{96} h w^4$)", thin(moments.axial / h), Pi * pow(w, 4) / 96);
  document.prove_limit(R"($I_t \to \frac{\pi}{192} h w^4$)", thin(moments.transverse / h), Pi * pow(w, 4) / 192);
  document.prove_limit(R"($I_a/m \to \frac{1}{12} w^2$)", thin(per_mass.axial), pow(w, 2) / 12);
  document.prove_limit(R"($I_t/m \to \frac{1}{24} w^2$)", thin(per_mass.transverse), pow(w, 2) / 24);
}

}  // namespace

int main() {
  return derive("The sharp lens", [](Document& document) {
    const Sphere solved = sphere(document);
    stone(document, solved);
    slices(document, solved);
    shells(document, solved);
    surface(document, solved);
    limits(document);
  });
}
