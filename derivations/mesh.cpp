/// \file
/// What a mesh encloses, tetrahedron by tetrahedron; where its corners are on a cap.

#include <array>
#include <goishi/mesh/mesh_mass.hpp>
#include <goishi/mesh/tessellation.hpp>
#include <string>

#include "proof.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;
using Matrix = goishi::Mat3<ex>;
using Vector = goishi::Vec3<ex>;

Vector letters(const std::string& name) {
  const auto letter = [&](const std::string& index) { return realsymbol(name + index, name + "_" + index); };
  return {letter("1"), letter("2"), letter("3")};
}

/// All entries of a matrix in one expression: pᵀ M q, with independent symbols for p and q.
ex entries(const Matrix& matrix) {
  static const Vector p = letters("p");
  static const Vector q = letters("q");
  return p.dot(Vector(matrix * q));
}

ex component(const Vector& v) {
  static const Vector p = letters("p");
  return p.dot(v);
}

void tetrahedra(Document& document) {
  document.section("A tetrahedron");
  document.text(
      R"(Its points are $x = \alpha a + \beta b + \gamma c$ with $\alpha, \beta, \gamma \ge 0$ and $\alpha + \beta + \gamma \le 1$,
and $\mathrm{d}V = \det(a, b, c)\,\mathrm{d}\alpha\,\mathrm{d}\beta\,\mathrm{d}\gamma$, negative where they turn the other
way. Over the boundary of a solid, cut into triangles, what lies between the origin and the boundary outside the solid is
counted once with each sign.)");
  document.shipped("formula::tetrahedron", "mesh/mesh_mass.hpp");
  const Vector a = letters("a"), b = letters("b"), c = letters("c");
  const symbol alpha("alpha", "\\alpha"), beta("beta", "\\beta"), gamma("gamma", "\\gamma");
  const Vector x = Vector(alpha * a) + Vector(beta * b) + Vector(gamma * c);
  ex determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += a(i) * (b(j) * c(k) - b(k) * c(j));
  }
  const auto over = [&](const ex& polynomial) {
    const ex inner = integral(polynomial.expand(), gamma, 0, 1 - alpha - beta).expand();
    return determinant * integral(integral(inner, beta, 0, 1 - alpha).expand(), alpha, 0, 1);
  };
  const goishi::Integrals<ex> shipped = formula::tetrahedron<ex>(a, b, c);
  document.prove({.text = R"($V = \int \mathrm{d}V$)", .result = shipped.volume, .witness = over(1)});
  document.prove({.text = R"($\int x\,\mathrm{d}V$)",
                  .result = component(shipped.first),
                  .witness = component(x.unaryExpr([&](const ex& entry) { return over(entry); }))});
  const Matrix square = x * x.transpose();
  document.prove({.text = R"($\int x x^\mathsf{T}\,\mathrm{d}V$)",
                  .result = entries(shipped.second),
                  .witness = entries(square.unaryExpr([&](const ex& entry) { return over(entry); }))});
}

void tensor(Document& document) {
  document.section("The tensor about the centre of mass");
  document.text(
      R"(With $V$, $F = \int x\,\mathrm{d}V$ and $E = \int x x^\mathsf{T}\,\mathrm{d}V$ the centre is $g = F/V$, and the tensor
about it $\int (|x - g|^2 1 - (x - g)(x - g)^\mathsf{T})\,\mathrm{d}V$, which is integrated term by term.)");
  document.shipped("formula::central_tensor", "mesh/mesh_mass.hpp");
  goishi::Integrals<ex> body;
  const realsymbol V("V");
  body.volume = V;
  body.first = letters("F");
  const ex xy = realsymbol("Exy", "E_{12}"), yz = realsymbol("Eyz", "E_{23}"), zx = realsymbol("Ezx", "E_{31}");
  body.second << realsymbol("Exx", "E_{11}"), xy, zx, xy, realsymbol("Eyy", "E_{22}"), yz, zx, yz,
      realsymbol("Ezz", "E_{33}");
  const Vector x = letters("x");
  const Vector r = x - Vector(body.first / V);
  Matrix definition = -(r * r.transpose());
  definition.diagonal() += Vector::Constant(r.squaredNorm());
  const auto over = [&](const ex& polynomial) {
    const ex f = polynomial.expand();
    const exmap origin = {{x(0), 0}, {x(1), 0}, {x(2), 0}};
    ex sum = f.subs(origin) * V;
    for (int i = 0; i < 3; ++i) {
      const ex slope = f.diff(GiNaC::ex_to<symbol>(x(i)));
      sum += slope.subs(origin) * body.first(i);
      for (int j = 0; j < 3; ++j) {
        sum += slope.diff(GiNaC::ex_to<symbol>(x(j))) / 2 * body.second(i, j);
      }
    }
    return sum;
  };
  document.prove({.text = R"($\operatorname{tr}(S)\,1 - S$ with $S = E - F F^\mathsf{T}/V$)",
                  .result = entries(formula::central_tensor(body)),
                  .witness = entries(definition.unaryExpr([&](const ex& entry) { return over(entry); }))});
}

void pentagon(Document& document) {
  document.section("Where a cap has its corners");
  document.text(
      R"(A fifth of the cap lies between the corners $a$ and $b$ of the pentagon. Ring $t$ has the points $t((1 - s) a + s b)$ of
the flat triangle; the circle as far from the middle has $t c$. The first is weighted with $1 - t$, the second with $t$,
and both are moved outwards by $1 + \frac{\sin\alpha}{5}(1 - t)$.)");
  document.shipped("formula::pentagon_place", "mesh/tessellation.hpp");
  const realsymbol t("t"), s("s"), sine("sine", R"(\sin\alpha)"), p("p"), q("q");
  const auto pair = [](const std::string& name) {
    return std::array<ex, 2>{realsymbol(name + "1", name + "_1"), realsymbol(name + "2", name + "_2")};
  };
  const std::array<ex, 2> a = pair("a"), b = pair("b"), c = pair("c");
  const std::array<ex, 2> shipped = formula::pentagon_place<ex>(t, s, a, b, c, sine);
  const auto flat = [&](std::size_t i) { return t * (a[i] + s * (b[i] - a[i])); };
  const auto place = [&](std::size_t i) { return (1 + sine * (1 - t) / 5) * (flat(i) + t * (t * c[i] - flat(i))); };
  document.prove(
      {.text = "the two, weighted", .result = p * shipped[0] + q * shipped[1], .witness = p * place(0) + q * place(1)});
  document.prove({.text = "on the rim it is the circle, so that caps and band meet",
                  .result = (p * shipped[0] + q * shipped[1]).subs(t == 1).expand(),
                  .witness = p * c[0] + q * c[1]});
}

}  // namespace

int main() {
  return derive("Meshes", [](Document& document) {
    tetrahedra(document);
    tensor(document);
    pentagon(document);
  });
}
