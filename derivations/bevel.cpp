/// \file
/// The bevel: its torus is tangent to the caps; the core lens; the published function; the stone as a customer measures it.

#include <goishi/shape/bevel.hpp>
#include <goishi/shape/lens.hpp>
#include <goishi/shape/stone.hpp>

#include "enclosure.hpp"
#include "proof.hpp"
#include "torus.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

void tangency(Document& document) {
  document.section("Torus and caps are tangent");
  document.text(
      R"(In the meridian half plane (distance $\rho$ from the axis, height $z$) the upper cap is part of the circle of radius
$r = d + h/2$ about $C = (0, -d)$. The bevel is part of the circle of radius $r_2$ about $M = (r_1, 0)$. They touch at
the joint $J = (P_x, b/2)$: $J$ lies on both circles, and $C$, $M$, $J$ on one line.)");
  document.shipped("formula::bevel", "shape/bevel.hpp");
  const possymbol h("h");
  const possymbol b("b");
  const possymbol d("d");
  const ex r = d + h / 2;
  const auto band = formula::bevel<ex>(h, b, d);
  document.equation("P_x", band.joint_radius);
  document.equation("r_2", band.minor_radius);
  document.equation("r - r_2", band.core_sphere_radius);

  const ex joint_height = b / 2;
  const ex joint_square = pow(r, 2) - pow(joint_height + d, 2);
  const auto square = [](const ex& result) { return pow(result, 2); };
  document.prove({.text = "$J$ lies on the cap: $P_x^2 + (d + b/2)^2 = r^2$",
                  .result = band.joint_radius,
                  .witness = joint_square,
                  .view = square,
                  .controls = {band.joint_radius * 2, band.joint_radius + h}});
  const ex share = band.major_radius / band.joint_radius;
  document.prove({.text = "$C$, $M$, $J$ lie on one line: $r_1 / d = P_x / (d + b/2)$",
                  .result = share,
                  .witness = d / (d + b / 2)});
  document.prove({.text = "$J$ lies on the bevel: $(P_x - r_1)^2 + (b/2)^2 = r_2^2$",
                  .result = band.minor_radius,
                  .witness = joint_square * pow(1 - share, 2) + pow(joint_height, 2),
                  .view = square,
                  .controls = {band.minor_radius * 2, band.minor_radius + h}});
  document.prove(
      {.text = "the line goes on through the joint: $|CM| + |MJ| = |CJ|$, that is $(r - r_2)^2 = d^2 + r_1^2$",
       .result = band.minor_radius,
       .witness = d * d + joint_square * pow(share, 2),
       .view = [&](const ex& minor) { return pow(r - minor, 2); }});
  document.prove({.text = "the core lens has sphere radius $r - r_2$",
                  .result = band.core_sphere_radius,
                  .witness = r - band.minor_radius});
  document.prove({.text = "the joint's normal is $CJ/r$: its axial part",
                  .result = band.joint_sine,
                  .witness = (joint_height + d) / r});
  document.prove({.text = "its radial part", .result = band.joint_cosine / band.joint_radius, .witness = 1 / r});
  document.prove({.text = R"(it has length 1: $\cos^2\alpha + \sin^2\alpha = 1$)",
                  .result = band.joint_sine,
                  .witness = 1 - pow(band.joint_cosine, 2),
                  .view = square,
                  .controls = {band.joint_sine * 2, 1 - band.joint_sine}});
  document.text(
      R"(The last identity of lengths says more: the core lens (sphere radius $r - r_2$, offset $d$, rim radius $r_1$) swept by
a ball of radius $r_2$ is the bevelled stone. A point of the core's cap moves out by $r_2$ to the sphere of radius
$r$, a point of its rim to the torus.)");
}

void from_torus(Document& document, const Torus& torus) {
  document.section("Every stone, from its torus");
  document.text(
      R"(Now the other way round. Take any $r_1, r_2 > 0$ and any angle $0 < \alpha < \pi/2$ of the joint's normal
$(\cos\alpha, \sin\alpha)$. The normal through $M = (r_1, 0)$ meets the axis at $(0, -d)$, and the rest follows:

$$d = r_1 \tan\alpha, \qquad r = r_2 + \frac{r_1}{\cos\alpha}, \qquad \frac h2 = r - d, \qquad \frac b2 = r_2
\sin\alpha.$$

With $\tan(\alpha/2) = 1/(1 + \tau)$, $\tau > 0$, all of them are rational functions with positive coefficients, and
so are the roots of the squares below: no sign is left to choice. Given $h$, $b$ and $d$, the shipped functions find
the torus again.)");
  document.shipped("formula::bevel", "shape/bevel.hpp");
  const possymbol h("h");
  const possymbol b("b");
  const possymbol d("d");
  const possymbol w("w");
  const exmap by_torus = {{h, torus.height}, {b, torus.bevel}, {d, torus.offset}};
  const auto band = formula::bevel<ex>(h, b, d);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness, .meaning = by_torus});
  };
  prove("$r_1$", band.major_radius, torus.major);
  prove("$r_2$", band.minor_radius, torus.minor);
  prove("$r - r_2$", band.core_sphere_radius, torus.core_radius);
  prove(R"($P_x = r_1 + r_2 \cos\alpha$)", band.joint_radius, torus.joint_radius);
  prove(R"($\cos\alpha$)", band.joint_cosine, torus.joint.cosine);
  prove(R"($\sin\alpha$)", band.joint_sine, torus.joint.sine);

  document.shipped("formula::bevelled_stone", "shape/stone.hpp");
  const auto stone = formula::bevelled_stone<ex>(w, h, b, d);
  prove("width $w$ of the generating lens", stone.width, w);
  prove("height $h$", stone.height, torus.height);
  prove("bevel $b$", stone.bevel, torus.bevel);
  prove("sphere radius $r$", stone.sphere_radius, torus.sphere_radius);
  prove("sphere offset $d$", stone.sphere_offset, torus.offset);
  prove("$r_1$", stone.bevel_major_radius, torus.major);
  prove("$r_2$", stone.bevel_minor_radius, torus.minor);
  prove("$r - r_2$", stone.core_sphere_radius, torus.core_radius);
  prove("joint radius $P_x$", stone.joint_radius, torus.joint_radius);
  prove("joint cosine", stone.joint_cosine, torus.joint.cosine);
  prove("joint sine", stone.joint_sine, torus.joint.sine);

  document.shipped("outer_width", "shape/stone.hpp");
  document.prove({.text = R"(the stone is widest where $\varphi = 0$, $\rho = r_1 + r_2$)",
                  .result = goishi::outer_width(stone),
                  .witness = 2 * (torus.major + torus.minor),
                  .meaning = by_torus});
}

/// What the talk's function returns. `sign` is that of y² under the root: 1 as published, −1 corrected.
struct PublishedBevel {
  ex major_radius;
  ex minor_radius;
};

PublishedBevel published_bevel(const ex& r, const ex& d, const ex& b, int sign) {
  const ex y = b / 2 + d;
  const ex px = sqrt(r * r + sign * y * y);
  const ex r1 = px * d / (d + b / 2);
  return {.major_radius = r1, .minor_radius = r - sqrt(d * d + r1 * r1)};
}

void published(Document& document, const Torus& torus) {
  document.section("The published function");
  document.text(
      R"(`CalculateBevel` of the talk has $P_x = \sqrt{y^2 + r^2}$, $y = d + b/2$, then $r_1 = P_x d / y$ and $r_2 = r -
\sqrt{d^2 + r_1^2}$. With the sign that the sphere asks for, $P_x = \sqrt{r^2 - y^2}$, it would be right, in a form
that cancels:)");
  const auto stone = formula::bevelled_stone<ex>(0, torus.height, torus.bevel, torus.offset);
  const PublishedBevel corrected = published_bevel(torus.sphere_radius, torus.offset, torus.bevel, -1);
  const PublishedBevel printed = published_bevel(torus.sphere_radius, torus.offset, torus.bevel, 1);
  document.prove({.text = "with $r^2 - y^2$ it gives the shipped $r_1$",
                  .result = stone.bevel_major_radius,
                  .witness = corrected.major_radius,
                  .controls = {printed.major_radius}});
  document.prove({.text = "and the shipped $r_2$",
                  .result = stone.bevel_minor_radius,
                  .witness = corrected.minor_radius,
                  .controls = {printed.minor_radius}});
  document.refute("as published, $r_1$ is another", printed.major_radius, stone.bevel_major_radius);
  document.refute("as published, $r_2$ is another", printed.minor_radius, stone.bevel_minor_radius);

  const ex w = 22;
  const ex h = ex(92) / 10;
  const ex r = (w * w + h * h) / (4 * h);
  const ex wrong = published_bevel(r, r - h / 2, 1, 1).minor_radius;
  const ex right = formula::bevel<ex>(h, 1, r - h / 2).minor_radius;
  document.check(R"(for $22 \times 9.2$ mm, $b = 1$ mm the published function returns $r_2 = -5.85$ mm)",
                 decimals(-wrong, 2) == "5.85");
  document.check("the shipped one returns $r_2 = 0.68$ mm", decimals(right, 2) == "0.68");
}

void measured(Document& document, const Torus& torus) {
  document.section("The measured stone");
  document.text(
      R"(A lens's width from its height and offset: the rim lies on the sphere, $(w/2)^2 + d^2 = (d + h/2)^2$.)");
  document.shipped("formula::generating_width", "shape/bevel.hpp");
  const possymbol w("w");
  const possymbol h("h");
  const possymbol b("b");
  const possymbol d("d");
  const ex width = formula::generating_width<ex>(h, d);
  document.equation("w", width);
  document.prove({.text = "the rim lies on the sphere",
                  .result = width,
                  .witness = 4 * (pow(d + h / 2, 2) - d * d),
                  .view = [](const ex& result) { return pow(result, 2); },
                  .controls = {2 * width, width + h}});

  document.prove_limit("the width comes back from the offset",
                       formula::generating_width<ex>(h, formula::sphere_offset<ex>(w, h)), w);

  document.text(
      R"(The finished stone has width $w = 2(r_1 + r_2)$, which is less than its lens had. Which $d$ gives a wanted $w$? From
$r_1 = P_x d/y$ and $r_2 = r(b/2)/y$, $y = d + b/2$: $2 P_x d = w y - r b$. Squared, with $P_x^2 = r^2 - y^2$, this is
a cubic in $d$ with the factor $y$; a quadratic remains, and the product of its roots is negative: exactly one is
positive.)");
  const ex y = d + b / 2;
  const ex r = d + h / 2;
  const ex quadratic = 4 * (h - b) * d * d - (w - h) * (w + h - 2 * b) * d - pow(w - h, 2) * b / 2;
  document.prove(
      {.text =
           R"($4(r^2 - y^2)d^2 - (wy - rb)^2 = y\,\left[4(h-b)\,d^2 - (w-h)(w+h-2b)\,d - \tfrac12 (w-h)^2 b\right]$)",
       .result = y * quadratic,
       .witness = 4 * (r * r - y * y) * d * d - pow(w * y - r * b, 2)});
  document.shipped("formula::measured_sphere_offset", "shape/bevel.hpp");
  const ex offset = formula::measured_sphere_offset<ex>(w, h, b);
  document.equation("d", offset);
  document.prove({.text = "every stone's $d$ comes back from the width $2(r_1 + r_2)$ of the finished stone",
                  .result = offset,
                  .witness = torus.offset,
                  .meaning = {{w, 2 * (torus.major + torus.minor)}, {h, torus.height}, {b, torus.bevel}}});

  document.text(
      R"(And for every $w > h > b > 0$ there is such a stone. With $\delta = w - h$ and $u = 2\delta + \varepsilon$, $\delta,
\varepsilon > 0$, the choice $h - b = u\varepsilon / (4(u + 2b))$ makes all roots rational, and reaches every $h - b >
0$.)");
  const possymbol delta("delta", R"(\delta)");
  const possymbol epsilon("epsilon", R"(\varepsilon)");
  const ex u = 2 * delta + epsilon;
  const ex height = b + u * epsilon / (4 * (u + 2 * b));
  const auto outer_width = [&](const ex& result) {
    const ex made = resolve_roots(result.subs(exmap{{w, height + delta}, {h, height}})).normal();
    return goishi::outer_width(
        formula::bevelled_stone<ex>(formula::generating_width<ex>(height, made), height, b, made));
  };
  document.prove({.text = "$2(r_1 + r_2) = w$", .result = offset, .witness = height + delta, .view = outer_width});
  document.prove_limit("without a bevel it is the lens: $d = (w^2 - h^2)/(4h)$", offset.subs(b == 0),
                       (w * w - h * h) / (4 * h));
  document.prove_limit("and for $w = h$ the ball: $d = 0$", offset.subs(w == h), 0);
}

}  // namespace

int main() {
  return derive("The bevel", [](Document& document) {
    const Torus torus;
    tangency(document);
    from_torus(document, torus);
    published(document, torus);
    measured(document, torus);
  });
}
