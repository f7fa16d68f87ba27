/// \file
/// The inertia tensor: of a body of revolution, in other axes, about another point; the talk's general form.

#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <goishi/rotation.hpp>
#include <string>

#include "proof.hpp"
#include "solid.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;
using Matrix = goishi::Mat3<ex>;
using Vector = goishi::Vec3<ex>;

const Vector point(x, y, z);

std::string indexed(const std::string& name, int index) {
  return name + std::to_string(index);
}

/// A vector or a symmetric matrix of independent symbols.
Vector letters(const std::string& name) {
  const auto letter = [&](const std::string& index) { return realsymbol(name + index, name + "_" + index); };
  return {letter("1"), letter("2"), letter("3")};
}

Matrix symmetric_letters(const std::string& name) {
  const auto letter = [&](const std::string& indices) {
    return realsymbol(name + indices, name + "_{" + indices + "}");
  };
  const ex xy = letter("12");
  const ex xz = letter("13");
  const ex yz = letter("23");
  Matrix matrix;
  matrix << letter("11"), xy, xz, xy, letter("22"), yz, xz, yz, letter("33");
  return matrix;
}

/// All entries of a matrix in one expression: aᵀ M b, with independent symbols for the vectors a and b.
ex entries(const Matrix& matrix) {
  static const Vector a = letters("a");
  static const Vector b = letters("b");
  return a.dot(Vector(matrix * b));
}

/// The definition's integrand, |p|² 1 − p pᵀ.
Matrix definition(const Vector& p) {
  Matrix matrix;
  const ex square = p.squaredNorm();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      matrix(i, j) = (i == j ? square : ex(0)) - p(i) * p(j);
    }
  }
  return matrix;
}

/// A body, as far as its tensor knows it: mass, centre of mass in the origin, second moments E_ij = ∫ x_i x_j dm.
struct Body {
  ex mass;
  Matrix second_moments;

  /// ∫ of a polynomial of degree 2 in x, y and z over the body.
  ex operator()(const ex& polynomial) const {
    const ex p = polynomial.expand();
    const ex plain = p.subs(exmap{{x, 0}, {y, 0}, {z, 0}});
    ex sum = plain * mass;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        sum += p.diff(GiNaC::ex_to<symbol>(point(i))).diff(GiNaC::ex_to<symbol>(point(j))) / 2 * second_moments(i, j);
      }
    }
    return sum;
  }

  Matrix operator()(const Matrix& integrand) const {
    return integrand.unaryExpr([this](const ex& entry) { return (*this)(entry); });
  }
};

/// Every rotation: a unit quaternion (1 − |u|², 2u) / (1 + |u|²), u any vector.
struct Rotation {
  Vector u = letters("u");
  ex scale = 1 / (1 + u.squaredNorm());
  ex scalar = (1 - u.squaredNorm()) * scale;
  Vector vector = Vector(2 * scale * u);

  goishi::Quat<ex> quaternion() const { return {scalar, vector.x(), vector.y(), vector.z()}; }

  /// q v q̄, by Hamilton's product (s, a)(t, b) = (st − a·b, sb + ta + a×b).
  Vector operator()(const Vector& v) const {
    const ex s = -vector.dot(v);
    const Vector w = Vector(scalar * v) + vector.cross(v);
    const Vector turned = Vector(-s * vector) + Vector(scalar * w) - w.cross(vector);
    return turned.unaryExpr([](const ex& entry) { return entry.normal(); });
  }
};

void body_of_revolution(Document& document) {
  document.section("A body of revolution");
  document.text(
      R"(The tensor about the origin is $I_{ij} = \int (|x|^2 \delta_{ij} - x_i x_j)\,\mathrm{d}m$. A slice of a body of
revolution is a disc of radius $\rho$ at height $z$. Over it all products of inertia vanish and the axes across are
alike:)");
  document.equation(R"(\iint xy\,\mathrm{d}x\,\mathrm{d}y)", over_disc(x * y));
  document.equation(R"(\iint xz\,\mathrm{d}x\,\mathrm{d}y)", over_disc(x * z));
  document.equation(R"(\iint (x^2 - y^2)\,\mathrm{d}x\,\mathrm{d}y)", over_disc(x * x - y * y));
  document.text(
      R"(The statement holds slice by slice, so for the body. (Here and below a matrix $M$ is compared in all entries at once,
as $a^\mathsf{T} M b$ with independent $a$, $b$.))");
  document.shipped("formula::principal_tensor", "mass/tensor.hpp");
  const realsymbol axial("Ia", "I_a");
  const realsymbol transverse("It", "I_t");
  const ex shipped = entries(formula::principal_tensor<ex>({.axial = axial, .transverse = transverse}));
  document.equation(R"(a^\mathsf{T} I b)", shipped);
  const Matrix slice = definition(point).unaryExpr([](const ex& entry) { return over_disc(entry); });
  document.prove({.text = R"($I = \operatorname{diag}(I_t, I_t, I_a)$)",
                  .result = shipped,
                  .witness = entries(slice),
                  .meaning = {{axial, over_disc(axial_element)}, {transverse, over_disc(transverse_element)}}});
}

/// Letters for a tensor, and the tensor of the body that they stand for.
struct TensorOf {
  explicit TensorOf(const Body& body) {
    const Matrix tensor = body(definition(point));
    for (int i = 0; i < 9; ++i) {
      meaning[letters(i)] = tensor(i);
    }
  }
  Matrix letters = symmetric_letters("I");
  exmap meaning;
};

Matrix rotation_matrix(const Rotation& rotation) {
  const Matrix R = rotation.quaternion().toRotationMatrix();
  return R.unaryExpr([](const ex& entry) { return entry.normal(); });
}

void rotations(Document& document, const Rotation& rotation) {
  document.section("Rotations");
  document.text(
      R"($q_{WB}$ takes a vector from frame B to frame W: $v_W = q v_B \bar q$. All rotations are reached by $q = (1 - |u|^2,\,
2u) / (1 + |u|^2)$, a unit quaternion for every $u \in \mathbb{R}^3$ (only $q = -1$ is missing, and it turns as $q =
1$ does).)");
  document.text(
      R"(*Shipped:* `goishi::rotation_matrix` in `src/goishi/rotation.hpp` checks $|q| = 1$ and returns Eigen's
`toRotationMatrix()`, which stands here for it.)");
  const Matrix R = rotation_matrix(rotation);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text, .result = result, .witness = witness, .controls = scaled(result)});
  };
  const Vector v = letters("v");
  const Vector a = letters("a");
  prove(R"($R v = q v \bar q$)", a.dot(Vector(R * v)), a.dot(rotation(v)));
  prove(R"($R R^\mathsf{T} = 1$)", entries(R * R.transpose()), entries(Matrix::Identity()));
  prove(R"($\det R = 1$)", R.determinant(), 1);
}

void other_axes(Document& document, const Rotation& rotation) {
  document.section("Other axes");
  document.text(
      R"(Of a body, the tensor knows the second moments $E_{ij} = \int x_i x_j\,\mathrm{d}m$, six independent symbols. In W the
point $x$ of the body is at $q x \bar q$; put into the definition, and integrated term by term, that is the tensor in
W.)");
  document.shipped("formula::rotated_tensor", "mass/tensor.hpp");
  const Body body = {.mass = realsymbol("m"), .second_moments = symmetric_letters("E")};
  TensorOf tensor(body);
  exmap meaning = tensor.meaning;
  const Matrix R = rotation_matrix(rotation);
  Matrix R_letters;
  for (int i = 0; i < 9; ++i) {
    R_letters(i) = realsymbol(indexed("R", i), indexed("R_{", 10 * (i % 3 + 1) + i / 3 + 1) + "}");
    meaning[R_letters(i)] = R(i);
  }
  const Matrix rotated = formula::rotated_tensor<ex>(tensor.letters, R_letters);
  document.equation("I_{W,12}", rotated(0, 1).expand());
  document.prove({.text = R"($I_W = R I_B R^\mathsf{T}$ is $\int (|x_W|^2 1 - x_W x_W^\mathsf{T})\,\mathrm{d}m$)",
                  .result = entries(rotated),
                  .witness = entries(body(definition(rotation(point)))),
                  .meaning = meaning});
  document.prove({.text = "the trace stays",
                  .result = rotated.trace(),
                  .witness = tensor.letters.trace().subs(meaning),
                  .meaning = meaning});
}

void another_point(Document& document) {
  document.section("About another point");
  document.text(
      R"(About a point P the body's points are $c + x$, where $c = C - P$ and $\int x\,\mathrm{d}m = 0$ because C is the centre
of mass.)");
  document.shipped("formula::shifted_tensor", "mass/tensor.hpp");
  const Body body = {.mass = realsymbol("m"), .second_moments = symmetric_letters("E")};
  const TensorOf tensor(body);
  const Vector c = letters("c");
  const Matrix shifted = formula::shifted_tensor<ex>(tensor.letters, body.mass, c);
  document.equation("I_{P,11}", shifted(0, 0));
  document.equation("I_{P,12}", shifted(0, 1));
  document.prove(
      {.text =
           R"($I_P = I_C + m(|c|^2 1 - c c^\mathsf{T})$ is $\int (|c + x|^2 1 - (c + x)(c + x)^\mathsf{T})\,\mathrm{d}m$)",
       .result = entries(shifted),
       .witness = entries(body(definition(Vector(c + point)))),
       .meaning = tensor.meaning});
  const Vector n = letters("n");
  document.prove({.text = R"(about an axis along $n$, that adds $m |c \times n|^2$ (parallel axes))",
                  .result = n.dot(Vector(shifted * n)),
                  .witness = n.dot(Vector(tensor.letters * n)) + body.mass * c.cross(n).squaredNorm()});
}

void general_form(Document& document, const Rotation& rotation) {
  document.section("The talk's general form");
  document.text(
      R"(A stone at $p$ with attitude $q$, about the origin of W: the point $x$ of the stone is at $p + q x \bar q$, and the
stone's second moments are $\operatorname{diag}(A, A, C)$. `goishi::inertia_tensor` composes the three functions in
this order.)");
  const realsymbol across("A");
  const realsymbol along("C");
  const realsymbol axial("Ia", "I_a");
  const realsymbol transverse("It", "I_t");
  Matrix second_moments = Matrix::Zero();
  second_moments.diagonal() << across, across, along;
  const Body stone = {.mass = realsymbol("m"), .second_moments = second_moments};
  const Vector p = letters("p");
  const auto general = [&](const Matrix& R) {
    const Matrix about_centre =
        formula::rotated_tensor<ex>(formula::principal_tensor<ex>({.axial = axial, .transverse = transverse}), R);
    return entries(formula::shifted_tensor<ex>(about_centre, stone.mass, p));
  };
  const exmap meaning = {{axial, stone(axial_element)}, {transverse, stone(transverse_element)}};
  const Matrix R = rotation_matrix(rotation);
  document.prove({.text = R"($I_W = R \operatorname{diag}(I_t, I_t, I_a) R^\mathsf{T} + m(|p|^2 1 - p p^\mathsf{T})$)",
                  .result = general(R),
                  .witness = entries(stone(definition(Vector(p + rotation(point))))),
                  .meaning = meaning,
                  .controls = {general(R.transpose()), general(-Matrix::Identity()), -general(R)}});
}

}  // namespace

int main() {
  return derive("The inertia tensor", [](Document& document) {
    const Rotation rotation;
    body_of_revolution(document);
    rotations(document, rotation);
    other_axes(document, rotation);
    another_point(document);
    general_form(document, rotation);
  });
}
