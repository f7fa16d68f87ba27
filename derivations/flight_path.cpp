/// \file
/// A stone in free flight as contact sees it: centre and axis, the gap along a normal as a function of time, and its
/// first zero.

#include <goishi/contact/gap_along.hpp>

#include "moving.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;

/// A path with its axis u turning about the unit vector k.
struct Path {
  possymbol t{"t"};
  realsymbol rate{"Omega", R"(\Omega)"}, C{"C"}, S{"S"};
  Vector p = letters("p"), v = letters("v"), a = letters("b"), u = letters("u"), k = letters("m");
  goishi::FlightPath<ex> path{.p_W = p, .v_W = v, .a_W = a, .u_W = u, .k_W = k, .rate = rate};
  Relations relations = Relations().unit(k).square(S, 1 - pow(C, 2));
  ex cosine = cos(rate * t), sine = sin(rate * t);

  /// By the cosine C and sine S of half the angle.
  [[nodiscard]] ex by_halves(const ex& e) const { return e.subs(exmap{{cosine, C * C - S * S}, {sine, 2 * S * C}}); }
  /// u turned about k.
  [[nodiscard]] Vector turned_axis() const { return turned(quaternion(C, Vector(S * k)), u); }
};

void motion(Document& document, const Path& path) {
  document.section("Centre and axis");
  document.text(
      R"(The centre is on a parabola, $p + v t + \frac12 a t^2$. The axis $u$ turns about the direction $k$, $|k| = 1$, at the
rate $\Omega$: by the quaternion $(C, S k)$, $C$ and $S$ for cosine and sine of $\Omega t/2$.)");
  document.shipped("formula::centre_at", "motion/flight_path.hpp");
  document.prove({.text = "the centre",
                  .result = components(formula::centre_at<ex>(path.path, path.t)),
                  .witness = components(Vector(path.p + path.t * path.v + path.t * path.t / 2 * path.a))});
  document.shipped("formula::axis_at", "motion/flight_path.hpp");
  const auto axis = [&](const goishi::FlightPath<ex>& of) { return components(formula::axis_at<ex>(of, path.t)); };
  goishi::FlightPath<ex> back = path.path, about_u = path.path;
  back.k_W = -path.k;
  about_u.k_W = path.u;
  about_u.u_W = path.k;
  document.prove(path.relations({.text = R"(Rodrigues: the axis is $(C, S k)\, u\, \overline{(C, S k)}$)",
                                 .result = axis(path.path),
                                 .witness = components(path.turned_axis()),
                                 .view = [&](const ex& e) { return path.by_halves(e); }}));
  document.prove(path.relations({.text = "about $-k$ it turns the other way",
                                 .result = axis(back),
                                 .witness = components(turned(quaternion(path.C, Vector(-path.S * path.k)), path.u)),
                                 .view = [&](const ex& e) { return path.by_halves(e); },
                                 .controls = {axis(path.path), axis(about_u)}}));

  document.shipped("formula::turned_on", "motion/flight_path.hpp");
  const realsymbol delta("delta", R"(\delta)"), a("a"), cos_a("ca", R"(\cos a)"), sin_a("sa", R"(\sin a)");
  const auto turned_on = formula::turned_on<ex>({.sin = sin_a, .cos = cos_a}, delta);
  const auto taylor = [&](const ex& function) {
    const ex series = GiNaC::series_to_poly(function.series(delta == 0, 3));
    return series.subs(exmap{{cos(a), cos_a}, {sin(a), sin_a}});
  };
  document.prove({.text = R"($\sin(a + \delta)$ up to the order $\delta^2$)",
                  .result = turned_on.sin,
                  .witness = taylor(sin(a + delta))});
  document.prove({.text = R"($\cos(a + \delta)$)", .result = turned_on.cos, .witness = taylor(cos(a + delta))});

  document.text(
      R"(Of the free flight of a top (chapter *Free flight*): with $k$ the direction of $L$, $u$ the symmetry axis and $\Omega =
|L|/I_t$.)");
  const Top top;
  const goishi::FlightPath<ex> flown{.p_W = path.p,
                                     .v_W = path.v,
                                     .a_W = path.a,
                                     .u_W = turned(top.q, Vector(0, 0, 1)),
                                     .k_W = top.n,
                                     .rate = ex(top.length * top.mobility.transverse)};
  const ex angle = flown.rate * top.t;
  document.prove(top.relations(
      {.text = "it is the symmetry axis of the shipped flight",
       .result = components(formula::axis_at<ex>(flown, top.t)),
       .witness = components(turned(top.path, Vector(0, 0, 1))),
       .view =
           [&](const ex& e) {
             return e.subs(exmap{{cos(angle), top.C * top.C - top.S * top.S}, {sin(angle), 2 * top.S * top.C}});
           },
       .controls = scaled(components(formula::axis_at<ex>(flown, top.t)))}));
}

void gap(Document& document, const Path& path) {
  document.section("The gap along a normal");
  document.text(
      R"(To $n$ the axis stands as $u(t) \cdot n = A + B \cos\Omega t + C \sin\Omega t$, and over a plane the centre is at a
height $c_0 + c_1 t + \frac12 c_2 t^2$.)");
  document.shipped("formula::wobble", "contact/gap_along.hpp");
  const Vector n = letters("n");
  const goishi::Stone<ex> stone;
  const goishi::Wobble<ex> part = formula::wobble<ex>(stone, path.path, n);
  const ex along = formula::wobble_at<ex>(part, path.cosine, path.sine);
  document.check("the wobble is of the stone that was given", part.stone == &stone);
  document.shipped("formula::wobble_at", "contact/gap_along.hpp");
  document.prove(path.relations({.text = R"(it is $u(t) \cdot n$)",
                                 .result = along,
                                 .witness = path.turned_axis().dot(n),
                                 .view = [&](const ex& e) { return path.by_halves(e); }}));
  document.shipped("formula::wobble_rate", "contact/gap_along.hpp");
  const ex rate = formula::wobble_rate<ex>(part, path.cosine, path.sine);
  document.prove({.text = "its rate", .result = rate, .witness = along.diff(path.t)});
  const realsymbol c0("c0", "c_0"), c1("c1", "c_1"), c2("c2", "c_2");
  document.shipped("formula::parabola", "contact/gap_along.hpp");
  const ex height = c0 + c1 * path.t + c2 * path.t * path.t / 2;
  document.prove({.text = "the height", .result = formula::parabola<ex>(c0, c1, c2, path.t), .witness = height});
  document.shipped("formula::parabola_rate", "contact/gap_along.hpp");
  document.prove(
      {.text = "its rate", .result = formula::parabola_rate<ex>(c1, c2, path.t), .witness = height.diff(path.t)});
  document.text(
      R"(So the gap is $c_0 + c_1 t + \frac12 c_2 t^2 - S(u(t) \cdot n)$, and its rate that of the height less $S'$ times
that of $u \cdot n$; $S$ and $S'$ are in the chapter on the support function, and so is the bound $M$ of $-H''$.)");
}

void zeros(Document& document) {
  document.section("When it can be zero at the earliest");
  document.text(
      R"(From $H \ge 0$ and $H'$, and with $-M \le H''$, the gap is at least $H + H' s + \frac12 c s^2$, $c = -M$, after a
time $s$. Its zeros are $(-H' \pm R)/c$, $R^2 = H'^2 - 2 c H$.)");
  const possymbol H("H"), R("R");
  const realsymbol V("V", "H'"), c("c");
  document.shipped("formula::falling_square", "contact/gap_along.hpp");
  const ex bend = (pow(V, 2) - pow(R, 2)) / (2 * H);
  document.prove({.text = "$R^2$",
                  .result = formula::falling_square<ex>(H, V, c),
                  .witness = pow(R, 2),
                  .meaning = {{c, bend}},
                  .controls = scaled(formula::falling_square<ex>(H, V, c))});
  const auto left = [&](const ex& s) { return H + V * s + c * s * s / 2; };
  document.shipped("formula::falling_zero", "contact/gap_along.hpp");
  const ex falling = formula::falling_zero<ex>(H, V, R);
  document.prove({.text = R"($2H/(R - H')$ is one, the first where $H' < 0$: $R - H' > 0$)",
                  .result = falling,
                  .witness = 0,
                  .meaning = {{c, bend}},
                  .view = left,
                  .controls = scaled(falling)});
  document.shipped("formula::bending_zero", "contact/gap_along.hpp");
  const ex bending = formula::bending_zero<ex>(V, R, c);
  document.prove({.text = R"($(H' + R)/(-c)$ is one, for $c < 0$ and $H' \ge 0$ the only one after $s = 0$)",
                  .result = bending,
                  .witness = 0,
                  .meaning = {{H, (pow(V, 2) - pow(R, 2)) / (2 * c)}},
                  .view = left,
                  .controls = scaled(bending)});
  document.prove({.text = R"(they are the same one: $2H/(R - H') = (H' + R)/(-c)$)",
                  .result = falling,
                  .witness = bending,
                  .meaning = {{H, (pow(V, 2) - pow(R, 2)) / (2 * c)}},
                  .controls = {-falling, falling.subs(R == -R), bending.subs(R == -R)}});
}

}  // namespace

int main() {
  return derive("A flying stone as contact sees it", [](Document& document) {
    const Path path;
    motion(document, path);
    gap(document, path);
    zeros(document);
  });
}
