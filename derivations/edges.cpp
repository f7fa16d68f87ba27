/// \file
/// Edges and rims: the separation along the normals of an edge of the board, a point and a stone's rim, and two rims.

#include <goishi/contact/arc.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/contact/pair_closed.hpp>
#include <goishi/contact/rim_rim.hpp>

#include "contact.hpp"

namespace {

using namespace derivation;
using goishi::detail::ArcPoint;
using goishi::detail::ArcView;

/// The stone's centre and axis, seen from an edge; the axis is a unit vector.
struct Edge {
  realsymbol pa{"pa", "p_a"}, pb{"pb", "p_b"}, ua{"ua", "u_a"}, ub{"ub", "u_b"}, out{"uo", "u_o"};
  goishi::detail::Arc<ex> arc{pa, pb, ua, ub, out};
  Relations unit = Relations().square(out, 1 - pow(ua, 2) - pow(ub, 2));
};

void view(Document& document) {
  document.section("Along an edge of the board");
  document.text(
      R"(The edge is the normals $n = (a, b) = (\cos t, \sin t)$ between those of two faces. Across the edge, the stone's
centre is $p = (p_a, p_b)$, seen from the edge, and its axis $(u_a, u_b)$; along the edge it is $u_o$. By $t$, $a' =
-b$ and $b' = a$.)");
  document.shipped("formula::arc_view", "contact/arc.hpp");
  const Edge edge;
  const realsymbol a("a"), b("b");
  const Relations relations = Relations(edge.unit).square(b, 1 - pow(a, 2));
  const auto by_t = [&](const ex& e) { return a * e.diff(b) - b * e.diff(a); };
  const ArcView<ex> seen = formula::arc_view<ex>(edge.arc, a, b);
  const ex axial = edge.ua * a + edge.ub * b, centre = edge.pa * a + edge.pb * b;
  document.prove({.text = "$m = u \\cdot n$", .result = seen.axial, .witness = axial});
  document.prove({.text = "$m'$", .result = seen.axial_rate, .witness = by_t(axial)});
  document.prove({.text = "$p \\cdot n$", .result = seen.centre, .witness = centre});
  document.prove({.text = "$(p \\cdot n)'$", .result = seen.centre_rate, .witness = by_t(centre)});
  document.prove(relations(
      {.text = "$1 - m^2$, without a difference", .result = seen.radial_square, .witness = 1 - pow(axial, 2)}));
}

/// f by t, with n_r for the radial part of the normal: m'' = −m, (p · n)'' = −p · n, n_r' = −m m'/n_r.
struct Along {
  realsymbol m{"m"}, rate{"m'"}, centre{"f", "p \\cdot n"}, centre_rate{"f'", "(p \\cdot n)'"};
  possymbol radial{"nr", "n_r"};
  realsymbol out{"uo", "u_o"};
  Relations relations = Relations().square(m, 1 - pow(radial, 2)).square(rate, pow(radial, 2) - pow(out, 2));
  ArcView<ex> view{
      .axial = m, .axial_rate = rate, .radial_square = pow(radial, 2), .centre = centre, .centre_rate = centre_rate};

  [[nodiscard]] ex by_t(const ex& e) const {
    return e.diff(m) * rate - e.diff(rate) * m + e.diff(centre) * centre_rate - e.diff(centre_rate) * centre -
           e.diff(radial) * m * rate / radial;
  }
};

void prove_point(Document& document, const ArcPoint<ex>& point, const ex& value, const ex& lever, const Along& along,
                 const std::function<ex(const ex&)>& seen) {
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(along.relations(
        {.text = text, .result = result, .witness = seen(witness), .view = seen, .controls = scaled(result)}));
  };
  prove("$f$", point.value, value);
  prove("$f'$", point.slope, along.by_t(value));
  prove("the curvature is $-f''$", point.curvature, -along.by_t(along.by_t(value)));
  prove(R"($\kappa$: $f' = (p + \kappa u) \cdot n'$)", along.centre_rate + point.lever * along.rate, along.by_t(value));
  prove(R"($\kappa$ itself)", point.lever, lever);
}

void arc(Document& document) {
  const Shape shape;
  const Along along;
  const realsymbol a("a"), b("b");
  document.text(
      R"(The separation is $f = p \cdot n - S(m)$, $S$ the stone's support. With $m'' = -m$, $(p \cdot n)'' = -p \cdot n$,
$m^2 + n_r^2 = 1$ and $m'^2 + u_o^2 = n_r^2$ its derivatives are these.)");
  for (const int side : {1, -1}) {
    document.section(side == 1 ? "Where the upper cap is met" : "Where the lower cap is met");
    document.shipped("formula::arc_on_cap", "contact/arc.hpp");
    const ex size = side * along.m;
    const ArcPoint<ex> cap = formula::arc_on_cap<ex>(shape.stone, along.view, a, b, size, side * shape.d);
    const auto seen = [&](const ex& e) { return e.subs(pow(along.radial, 2) == (1 - size) * (1 + size)).normal(); };
    prove_point(document, cap, along.centre - shape.r + shape.d * size, side * shape.d, along, seen);
    document.prove({.text = "the normal is the one that was given",
                    .result = cap.a + 2 * cap.b + 3 * cap.axial,
                    .witness = a + 2 * b + 3 * along.m});
  }
  document.section("Where the rim is met");
  document.shipped("formula::arc_on_rim", "contact/arc.hpp");
  const ArcPoint<ex> rim = formula::arc_on_rim<ex>(shape.stone, along.view, a, b, along.out, along.radial);
  prove_point(document, rim, along.centre - shape.r1 * along.radial - shape.r2, shape.r1 * along.m / along.radial,
              along, [](const ex& e) { return e; });
  document.prove({.text = "the normal is the one that was given",
                  .result = rim.a + 2 * rim.b + 3 * rim.axial,
                  .witness = a + 2 * b + 3 * along.m});
}

void cap_maximum(Document& document) {
  document.section("The maximum on a cap");
  document.text(R"(There $n$ is along $v = p + \sigma d u$ across the edge, $\sigma = \pm 1$, and $f = |v| - r$.)");
  const Edge edge;
  const Shape shape;
  const possymbol x("x"), reach("v", "|v|");
  document.shipped("formula::arc_cap_radial_square", "contact/arc.hpp");
  const ex va = edge.pa + x * edge.ua, vb = edge.pb + x * edge.ub, square = va * va + vb * vb;
  const ex radial = formula::arc_cap_radial_square<ex>(edge.arc, square);
  document.prove(edge.unit({.text = R"(it is $|v|^2 - (v \cdot u)^2$, for $v = p + x u$ with any $x$)",
                            .result = radial,
                            .witness = square - pow(va * edge.ua + vb * edge.ub, 2)}));
  document.shipped("formula::arc_cap_value", "contact/arc.hpp");
  for (const int sign : {1, -1}) {
    const ex value = formula::arc_cap_value<ex>(shape.stone, edge.arc, sign, reach);
    const ex a = edge.pa + sign * shape.d * edge.ua, b = edge.pb + sign * shape.d * edge.ub;
    document.prove(
        edge.unit({.text = std::string(R"($f\,(|v| + r) = |v|^2 - r^2$, $\sigma = )") + (sign == 1 ? "1$" : "-1$"),
                   .result = value,
                   .witness = a * a + b * b - pow(shape.r, 2),
                   .view = [&](const ex& e) { return (e * (reach + shape.r)).expand(); },
                   .controls = scaled(value)}));
  }
}

void lines(Document& document) {
  document.section("Bounds between two normals");
  document.text(
      R"($-f'' = f + \rho$, $\rho$ the radius of curvature of the outline. If $\rho$ were constant, $f$ would be a line: $w
\cdot n - \rho$. Where it is at least that, and the normals are less than a half turn apart, $f$ is below the line
that has its value and slope at one of them.)");
  document.shipped("formula::arc_line", "contact/arc.hpp");
  const realsymbol a0("a0", "a_0"), b0("b0", "b_0"), a("a"), b("b"), value("f"), slope("f'");
  const possymbol rho("rho", R"(\rho)");
  const Relations relations = Relations().square(b, 1 - pow(a, 2)).square(b0, 1 - pow(a0, 2));
  const auto by_t = [&](const ex& e) { return a * e.diff(b) - b * e.diff(a); };
  const ArcPoint<ex> from{a0, b0, value, slope, 0, 0, 0};
  const ex line = formula::arc_line<ex>(from, rho, a, b);
  const exmap there = {{a, a0}, {b, b0}};
  document.prove(relations({.text = R"($-f'' - f = \rho$)",
                            .result = line,
                            .witness = rho,
                            .view = [&](const ex& e) { return -by_t(by_t(relations(e))) - e; },
                            .controls = {line - rho, line.subs(rho == 2 * rho), line.subs(rho == -rho)}}));
  document.prove(relations({.text = "at the normal itself it is $f$",
                            .result = line,
                            .witness = value,
                            .view = [&](const ex& e) { return e.subs(there); },
                            .controls = scaled(line)}));
  document.prove(relations({.text = "and has the slope $f'$",
                            .result = line,
                            .witness = slope,
                            .view = [&](const ex& e) { return by_t(e).subs(there); },
                            .controls = scaled(line)}));
  document.shipped("formula::arc_line_a", "contact/arc.hpp");
  const ex of_w = a * formula::arc_line_a<ex>(from, rho) + b * formula::arc_line_b<ex>(from, rho);
  document.prove(relations({.text = R"(it is $w \cdot n - \rho$)", .result = of_w, .witness = line + rho}));
  document.shipped("formula::arc_rim_radius", "contact/arc.hpp");
  const Shape shape;
  const Along along;
  const ex square = pow(along.radial, 2);
  const ex radius = formula::arc_rim_radius<ex>(shape.stone, along.out, square, along.radial);
  const ex value_there = along.centre - shape.r1 * along.radial - shape.r2;
  document.prove(along.relations({.text = R"(on the rim $-f'' - f$ is $r_1 u_o^2/n_r^3 + r_2$)",
                                  .result = radius,
                                  .witness = -along.by_t(along.by_t(value_there)) - value_there,
                                  .controls = scaled(radius)}));
}

void point_and_rim(Document& document) {
  document.section("A point and a rim");
  document.text(
      R"(A circle of radius $r_1$ about the axis $u$, and a point $v$ at the height $H$ and the distance $\rho$ from the
axis, in the direction $e$ of a frame $q$: $v = H u + \rho e$, $u = q \hat z \bar q$, $e = q \hat x \bar q$. The
circle's nearest point is $r_1 e$.)");
  document.shipped("formula::from_rim", "contact/contact.hpp");
  const Quaternion q = quaternion_letters("q");
  const realsymbol H("H");
  const possymbol rho("rho", R"(\rho)"), r1("r1", "r_1");
  const Relations relations = Relations().unit(q);
  const Vector u = relations(turned(q, up)), e = relations(turned(q, Vector(1, 0, 0)));
  const Vector v = Vector(H * u) + Vector(rho * e);
  const goishi::FromRim<ex> seen = formula::from_rim<ex>(v, u, r1);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations({.text = text, .result = result, .witness = witness, .controls = scaled(result)}));
  };
  prove("$H$", seen.height, H);
  prove(R"($\rho - r_1$)", seen.beyond, rho - r1);
  prove("$v - r_1 e$", components(seen.away), components(Vector(v - r1 * e)));
}

void two_rims(Document& document) {
  document.section("Round a rim");
  document.text(
      R"(A point $x(\varphi)$ of a circle with the radius $c_1$, $x' = v$, $|v| = c_1$, and $x'' = -o$, $o$ its way from the
circle's middle; the other circle has the radius $c_2$ and lies about $\hat z$. With $\rho$ for the distance from
$\hat z$, $2F = (\rho - c_2)^2 + z^2$ is the square of the distance from that circle. $x = (\rho g, \rho h, z)$,
$g^2 + h^2 = 1$.)");
  document.shipped("formula::rim_point", "contact/rim_rim.hpp");
  const possymbol c1("c1", "c_1"), c2("c2", "c_2"), rho("rho", R"(\rho)");
  const realsymbol a("a"), b("b"), g("g"), h("h"), z("z");
  const Vector f = letters("f"), o = letters("o");
  const Relations relations = Relations().unit(f).square(b, 1 - pow(a, 2)).square(h, 1 - pow(g, 2));
  const Vector v = c1 * f, x(rho * g, rho * h, z);
  // The middle and the vectors at the angles 0 and a quarter turn that make x, v and o at (a, b).
  const Vector cosine = Vector(a * o) - Vector(b * v), sine = Vector(b * o) + Vector(a * v);
  const Vector middle = x - o;
  const goishi::detail::RimPoint<ex> point =
      formula::rim_point<ex>(middle, relations(cosine), relations(sine), c1, c2, a, b);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations({.text = text, .result = result, .witness = witness, .controls = scaled(result)}));
  };
  const ex rise = (x.x() * v.x() + x.y() * v.y()) / rho;
  const ex bend = (v.x() * v.x() + v.y() * v.y() - x.x() * o.x() - x.y() * o.y() - rise * rise) / rho;
  prove(R"($\rho$)", point.rho, rho);
  prove("the distance", point.distance, sqrt(pow(rho - c2, 2) + pow(z, 2)));
  prove(R"($F' = (\rho - c_2)\rho' + z z'$, $\rho' = (x \cdot x')_h/\rho$)", point.slope,
        (rho - c2) * rise + z * v.z());
  prove(
      R"($F'' = \rho'^2 + (\rho - c_2)\rho'' + z'^2 + z z''$, $\rho'' = (|x'|_h^2 + (x \cdot x'')_h - \rho'^2)/\rho$)",
      point.bend, rise * rise + (rho - c2) * bend + v.z() * v.z() - z * o.z());
  document.prove(
      {.text = "the angle is the one that was given", .result = point.a + 2 * point.b, .witness = a + 2 * b});
}

void nearest(Document& document) {
  document.section("The nearest points of two rims");
  document.text(
      R"($w = D - c_1 e_1 - c_2 e_2$ leads from a point of one circle to one of the other; as the angles $\varphi_i$ grow,
$e_i' = f_i$ and $f_i' = -e_i$, $|f_i| = 1$. Newton's step for $F = \frac12 |w|^2$ has $F'' \Delta\varphi = -F'$.)");
  document.shipped("formula::rims_turn", "contact/pair_closed.hpp");
  const possymbol c1("c1", "c_1"), c2("c2", "c_2");
  const Vector D = letters("d"), e1 = letters("e"), f1 = letters("f"), e2 = letters("k"), f2 = letters("u");
  const Vector w = D - Vector(c1 * e1) - Vector(c2 * e2);
  const auto turned_by = [&](const ex& form, const Vector& e, const Vector& f) {
    ex sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += form.diff(GiNaC::ex_to<symbol>(e(i))) * f(i) - form.diff(GiNaC::ex_to<symbol>(f(i))) * e(i);
    }
    return sum;
  };
  const ex half = w.dot(w) / 2, F1 = turned_by(half, e1, f1), F2 = turned_by(half, e2, f2);
  const ex F11 = turned_by(F1, e1, f1), F12 = turned_by(F1, e2, f2), F22 = turned_by(F2, e2, f2);
  const Relations relations = Relations().unit(f1).unit(f2);
  const goishi::detail::RimsTurn<ex> newton = formula::rims_turn<ex>(w, c1, e1, f1, c2, e2, f2);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove(relations({.text = text, .result = result, .witness = witness, .controls = scaled(result)}));
  };
  prove(R"($F_{11}/c_1$)", c1 * newton.bend1, F11);
  prove(R"($F_{22}/c_2$)", c2 * newton.bend2, F22);
  prove("the determinant, over $c_1 c_2$", c1 * c2 * newton.determinant, F11 * F22 - pow(F12, 2));
  prove(R"($\Delta\varphi_1$, times the determinant)", c1 * c2 * newton.step1, F12 * F2 - F22 * F1);
  prove(R"($\Delta\varphi_2$, times the determinant)", c1 * c2 * newton.step2, F12 * F1 - F11 * F2);
}

}  // namespace

int main() {
  return derive("Edges and rims", [](Document& document) {
    view(document);
    arc(document);
    cap_maximum(document);
    lines(document);
    point_and_rim(document);
    two_rims(document);
    nearest(document);
  });
}
