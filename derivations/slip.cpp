/// \file
/// A stone that slips on a plane: dry friction, the laws that are smooth in the slip, and where sliding has an answer
/// by hand.

#include <goishi/drop/equations/slip.hpp>
#include <string>

#include "contact.hpp"

namespace {

using namespace derivation;

void laws(Document& document) {
  const Vector b = letters_xyz("b"), need = letters_xyz(R"(\mathrm{need})");
  document.section("Dry friction");
  document.text(
      R"($F = N q$, $q = (-\mu c, -\mu s, 1)$, against a slip $\sigma(c, s)$, $c = \cos\varphi$, $s = \sin\varphi$.
$b = J\tau \times r$ is what the resistance of a normal force 1, its torque $\tau$, does to the contact point
(chapter *A stone in contact with a plane*, as are $W$ and $\mathrm{need}$). Then $\dot s = N(W q + b) -
\mathrm{need}$, and along the slip and across it $\dot s$ is $\dot\sigma$ and $\sigma\dot\varphi$.)");
  document.shipped("formula::slip_under", "drop/equations/slip.hpp");
  document.shipped("formula::slip_rate", "drop/equations/slip.hpp");
  const realsymbol c("c"), s("s");
  const Vector gained = M * Vector(-mu * c, -mu * s, 1) + b;
  const goishi::SlipRate<ex> dry = formula::slip_rate<ex>(W, b, need, mu, c, s);
  document.equation("N", dry.N);
  document.prove({.text = "$N$ keeps the contact point on the plane: its acceleration along $\\hat z$ is 0",
                  .result = dry.N,
                  .witness = 0,
                  .view = [&](const ex& x) { return x * gained.z() - need.z(); }});
  document.prove(
      {.text = "$D$, the shipped denominator of $N$: $(W q + b)_z$", .result = dry.denominator, .witness = gained.z()});
  const Vector rate = need.z() / gained.z() * gained - need;
  const ex across = rate.y() * c - rate.x() * s;
  document.prove({.text = R"($\dot\sigma$)", .result = dry.along, .witness = rate.x() * c + rate.y() * s});
  document.prove({.text = R"($\sigma\dot\varphi$)", .result = dry.across, .witness = across});
  document.prove({.text = R"($\frac{\mathrm{d}}{\mathrm{d}\varphi}(\sigma\dot\varphi)$, with $c' = -s$, $s' = c$)",
                  .result = dry.across_slope,
                  .witness = across.diff(s) * c - across.diff(c) * s});

  document.section("Friction that is smooth in the slip");
  document.text(R"($F = N q$, $q = (-k s_x, -k s_y, 1)$.)");
  document.shipped("formula::glide_rate", "drop/equations/slip.hpp");
  const possymbol k("k");
  const realsymbol sx("sx", "s_x"), sy("sy", "s_y");
  const goishi::GlideRate<ex> smooth = formula::glide_rate<ex>(W, b, need, k, sx, sy);
  const Vector won = M * Vector(-k * sx, -k * sy, 1) + b;
  document.prove(
      {.text = "$N$ keeps the contact point on the plane", .result = smooth.N, .witness = 0, .view = [&](const ex& x) {
         return x * won.z() - need.z();
       }});
  document.prove(
      {.text = "$D$, its denominator, again with this $q$", .result = smooth.denominator, .witness = won.z()});
  const Vector glide = need.z() / won.z() * won - need;
  document.prove({.text = R"($\dot s_x$)", .result = smooth.x, .witness = glide.x()});
  document.prove({.text = R"($\dot s_y$)", .result = smooth.y, .witness = glide.y()});
  document.prove({.text = R"(with $k = \mu/\sigma$ it is dry friction: $\dot s$ along the slip)",
                  .result = smooth.x * c + smooth.y * s,
                  .witness = dry.along,
                  .meaning = {{sx, c / k * mu}, {sy, s / k * mu}},
                  .controls = scaled(smooth.x * c + smooth.y * s)});
  document.shipped("formula::patch_friction", "drop/equations/slip.hpp");
  const possymbol patch("p"), creep("e"), sigma("sigma", R"(\sigma)"), spin("W", R"(\omega_z)");
  const ex law = formula::patch_friction<ex>(mu, patch, spin, pow(sigma, 2), pow(creep, 2));
  const ex turned = pow(patch * spin, 2) + pow(creep, 2);
  document.prove({.text = R"(friction per normal force stays within $\mu$: $(k\sigma)^2 = \mu^2 - \mu^2 (p^2\omega_z^2
+ e^2)/(\sigma^2 + p^2\omega_z^2 + e^2)$)",
                  .result = pow(law * sigma, 2),
                  .witness = pow(mu, 2) * (1 - turned / (pow(sigma, 2) + turned))});
  document.prove({.text = R"(no patch, no creep: $k = \mu/\sigma$)",
                  .result = law,
                  .witness = mu / sigma,
                  .meaning = {{patch, 0}, {creep, 0}},
                  .controls = scaled(law)});
}

void slopes(Document& document) {
  const Vector b = letters_xyz("b"), need = letters_xyz(R"(\mathrm{need})");
  const realsymbol sx("sx", "s_x"), sy("sy", "s_y"), c("c");
  document.section("The force of friction");
  document.shipped("formula::friction_force", "drop/equations/slip.hpp");
  const possymbol N("N"), drag("D");
  const ex force = components(formula::friction_force<ex>(N, drag, sx, sy));
  document.prove({.text = "it is $-D (s_x, s_y, 0)$ and the normal force",
                  .result = force,
                  .witness = components(Vector(N * up - drag * Vector(sx, sy, 0)))});

  document.section("The slope of a smooth law");
  document.text(
      R"(Friction per normal force is $k s$, and damping takes $c s$ of $\dot s$. With $k = \mu/R$, $R^2 = |s|^2 + f$, the
slope of $k s$ is $k (1 - s s^\mathsf{T}/R^2)$; $f$ does not depend on the slip. A constant $k$ has no such part.)");
  document.shipped("formula::glide_slope", "drop/equations/slip.hpp");
  const possymbol k("k"), f("f"), R("R");
  const auto prove = [&](const std::string& law, const ex& by_slip, const ex& there, const ex& share,
                         const auto& in_letters) {
    const goishi::GlideRate<ex> rate = formula::glide_rate<ex>(W, b, need, by_slip, sx, sy);
    const goishi::GlideRate<ex> now = formula::glide_rate<ex>(W, b, need, there, sx, sy);
    const goishi::GlideSlope<ex> slope = formula::glide_slope<ex>(W, b, now, there, share, sx, sy, c);
    const ex x = rate.x - c * sx, y = rate.y - c * sy;
    const auto statement = [&](const std::string& name, const ex& result, const ex& witness) {
      document.prove({.text = law + name, .result = result, .witness = in_letters(witness)});
    };
    statement(R"(: $\partial\dot s_x/\partial s_x$)", slope.xx, x.diff(sx));
    statement(R"(: $\partial\dot s_x/\partial s_y$)", slope.xy, x.diff(sy));
    statement(R"(: $\partial\dot s_y/\partial s_x$)", slope.yx, y.diff(sx));
    statement(R"(: $\partial\dot s_y/\partial s_y$)", slope.yy, y.diff(sy));
  };
  const ex square = pow(sx, 2) + pow(sy, 2);
  prove("the patch", formula::patch_friction<ex>(mu, 0, 0, square, f), mu / R, 1 / pow(R, 2),
        [&](const ex& e) { return resolve_roots(e.subs(f == pow(R, 2) - square).expand()); });
  prove("in proportion", k, k, 0, [](const ex& e) { return e; });
}

void by_hand(Document& document) {
  document.section("From the tilt at which friction does not turn the stone");
  document.text(
      R"(The stone slips along $x$ on its lower cap and does not turn; its axis leans forward by $\psi$, $u =
(\sin\psi, 0, \cos\psi)$. At $d \sin\psi = \mu (r - d \cos\psi)$ normal force and friction have no torque together.
The plane may slope by $\beta$, down along $x$: $g (\sin\beta, 0, -\cos\beta)$. Half-angle tangents stand for $\psi$
and $\beta$.)");
  const Shape shape;
  const Touching any;
  const possymbol g("g"), t("t"), q("q");
  const auto cosine = [](const ex& tangent) -> ex { return (1 - pow(tangent, 2)) / (1 + pow(tangent, 2)); };
  const auto sine = [](const ex& tangent) -> ex { return 2 * tangent / (1 + pow(tangent, 2)); };
  const auto cap = [&](const ex& z) { return formula::cap_contact<ex>(shape.stone, 1, z, 1 - pow(z, 2)); };
  const Vector leaning(sine(t), 0, cosine(t)), gravity(g * sine(q), 0, -g * cosine(q));
  const Vector nothing = Vector::Zero();
  const Motion now = formula::contact_motion(any.mobility, gravity, cap(cosine(t)), leaning, nothing);
  const goishi::SlipRate<ex> slides = formula::slip_rate<ex>(now.W, nothing, now.need, mu, 1, 0);
  const exmap tilt = {{mu, shape.d * sine(t) / (shape.r - shape.d * cosine(t))}};
  const Vector force(-mu, 0, 1);
  document.prove({.text = "no torque",
                  .result = components(now.r.cross(force)),
                  .witness = 0,
                  .meaning = tilt,
                  .controls = {components(now.r.cross(Vector(mu, 0, 1))), components(now.r.cross(up))}});
  document.prove({.text = R"($N = g \cos\beta$)",
                  .result = slides.N,
                  .witness = g * cosine(q),
                  .meaning = tilt,
                  .controls = scaled(slides.N)});
  document.prove({.text = R"($\dot\sigma = g (\sin\beta - \mu \cos\beta)$; the direction stays)",
                  .result = slides.along + slides.across * realsymbol("b"),
                  .witness = (g * (sine(q) - mu * cosine(q))).subs(tilt),
                  .meaning = tilt,
                  .controls = scaled(slides.along)});
  document.text(
      R"(So the stone keeps its tilt. On the level it stops, $\dot\sigma = -\mu g$; on a slope it slides faster and
faster if $\tan\beta > \mu$.)");
  const possymbol v0("v0", "v_0");
  const ex time = v0 / (mu * g);
  document.prove({.text = R"(on the level it stops after the way $v_0^2/(2\mu g)$)",
                  .result = v0 * time - mu * g * pow(time, 2) / 2,
                  .witness = pow(v0, 2) / (2 * mu * g)});
  const Motion flat = formula::contact_motion(any.mobility, Vector(0, 0, -g), cap(1), up, nothing);
  document.prove({.text = R"(lying flat, the torque per normal force is $\mu (r - d)$: it tilts)",
                  .result = flat.r.cross(force).y(),
                  .witness = mu * (shape.r - shape.d)});

  document.section("A sliding ball");
  document.text(R"($d = 0$, $I_a = I_t = \frac25 r^2$. It slips along $x$ and turns about $y$, $L = (0, l, 0)$.)");
  const realsymbol l("l");
  const goishi::Moments<ex> moments{.axial = 2 * pow(shape.r, 2) / 5, .transverse = 2 * pow(shape.r, 2) / 5};
  goishi::Stone<ex> ball = shape.stone;
  ball.sphere_offset = 0;
  ball.height = 2 * shape.r;
  const Motion rolls = formula::contact_motion<ex>(formula::mobility<ex>(1, moments), Vector(0, 0, -g),
                                                   formula::cap_contact<ex>(ball, 1, any.u.z(), 1 - pow(any.u.z(), 2)),
                                                   any.u, Vector(0, l, 0));
  const goishi::SlipRate<ex> slips = formula::slip_rate<ex>(rolls.W, nothing, rolls.need, mu, 1, 0);
  document.prove({.text = "$N = g$", .result = slips.N, .witness = g, .controls = scaled(slips.N)});
  document.prove({.text = R"($\dot\sigma = -\frac72 \mu g$, while the centre has $\dot v = -\mu g$)",
                  .result = slips.along,
                  .witness = -mu * g * 7 / 2,
                  .controls = scaled(slips.along)});
  document.prove({.text = "across, nothing", .result = slips.across, .witness = 0, .controls = {slips.along}});
  const ex until = -v0 / slips.along;
  document.prove({.text = R"(from $v_0$ without spin the slip ends after the time $2 v_0/(7 \mu g)$)",
                  .result = until,
                  .witness = 2 * v0 / (7 * mu * g),
                  .controls = scaled(until)});
  const ex end = v0 - mu * slips.N * until;
  document.prove({.text = R"(and the ball rolls with $\frac57 v_0$)",
                  .result = end,
                  .witness = v0 * 5 / 7,
                  .controls = scaled(end)});
}

}  // namespace

int main() {
  return derive("A stone that slips on a plane", [](Document& document) {
    laws(document);
    slopes(document);
    by_hand(document);
  });
}
