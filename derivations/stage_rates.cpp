/// \file
/// The forces of rolling and of dry slip at the inner stages of a step, without the contact matrix.

#include <goishi/drop/equations/stage_rates.hpp>
#include <string>

#include "contact.hpp"

namespace {

using namespace derivation;
using goishi::StageMotion;

const possymbol lambda("lambda", R"(\lambda)"), lambda_c("lambda_c", R"(\lambda_c)");
const possymbol B("B");
const realsymbol C("C"), c("c"), s("s");
const goishi::Mobility<ex> mobility{.linear = 1, .transverse = B, .axial = C};

/// A contact on any stone, r = −S' u_h − S ẑ, under any resistance: what it does to the contact point, b = J τ × r, is
/// any vector across r.
struct Stage {
  Vector u = letters("u"), need = letters("n"), torque = letters("T"), x = letters("x");
  realsymbol slope{"S'"}, height{"S"};
  Vector r = Vector(-slope * u.x(), -slope* u.y(), -height);
  Vector b = x.cross(r);
  ex square = r.dot(r), across_square = r.cross(u).dot(r.cross(u));
  StageMotion<ex> made = [this] {
    goishi::ContactTurn<ex> turn;
    turn.u = u;
    turn.r = r;
    turn.need = need;
    return formula::stage_motion<ex>(mobility, turn, torque, b);
  }();
  /// The same with letters for λ and λ_c.
  StageMotion<ex> motion = [this] {
    StageMotion<ex> lettered = made;
    lettered.lambda = lambda;
    lettered.lambda_c = lambda_c;
    return lettered;
  }();
  /// λ 1 − r rᵀ/I_t + (1/I_a − 1/I_t) c cᵀ
  Matrix W = Matrix(lambda * Matrix::Identity() - B * r * r.transpose() + C * motion.c * motion.c.transpose());

  /// A form with λ and λ_c as what they stand for, free of their denominators.
  [[nodiscard]] ex spelt(const ex& form) const {
    return (form * lambda * lambda_c)
        .expand()
        .subs(lambda_c == lambda + C * across_square)
        .subs(lambda == 1 + B * square)
        .expand();
  }
};

void matrix(Document& document, const Stage& stage) {
  document.section("The contact matrix without the matrix");
  document.text(
      R"(The chapter *A stone in contact with a plane* has the motion, $r = -S' u_h - S \hat z$ and $\mathrm{need}$; $\tau$
is the resistance that goes with a normal force of 1, and $b = J\tau \times r$ what it does to the contact point, across
$r$.)");
  document.shipped("formula::stage_motion", "drop/equations/stage_rates.hpp");
  document.prove({.text = R"($c = r \times u$)",
                  .result = components(stage.made.c),
                  .witness = components(Vector(stage.r.cross(stage.u)))});
  document.prove(
      {.text = R"($\lambda = 1 + |r|^2/I_t$)", .result = stage.made.lambda, .witness = 1 + B * stage.square});
  document.prove({.text = R"($\lambda_c = \lambda + (1/I_a - 1/I_t)\,|c|^2$)",
                  .result = stage.made.lambda_c,
                  .witness = 1 + B * stage.square + C * stage.across_square});
  document.prove({.text = "it holds the motion and the resistance that it was given",
                  .result = components(Vector(stage.made.need + 2 * stage.made.torque + 3 * stage.made.brake)),
                  .witness = components(Vector(stage.need + 2 * stage.torque + 3 * stage.b))});
  const Vector u = letters("u"), r = letters("r"), q = letters("q"), across = r.cross(u);
  document.prove(
      {.text = R"($W = \lambda\,\mathbb{1} - r r^\mathsf{T}/I_t + (1/I_a - 1/I_t)\, c c^\mathsf{T}$)",
       .result = components(Vector(full(formula::contact_matrix(mobility, u, r)) * q)),
       .witness = components(Vector((1 + B * r.dot(r)) * q - B * r.dot(q) * r + C * across.dot(q) * across))});
  document.shipped("formula::stage_stiffness", "drop/equations/stage_rates.hpp");
  document.prove(
      {.text = "$W_{zz}$", .result = formula::stage_stiffness<ex>(mobility, stage.motion), .witness = stage.W(2, 2)});
  document.shipped("formula::stage_solution", "drop/equations/stage_rates.hpp");
  document.prove({.text = R"($W\, W^{-1} q = q$)",
                  .result = components(Vector(stage.W * formula::stage_solution<ex>(mobility, stage.motion, q))),
                  .witness = stage.spelt(components(q)),
                  .view = [&](const ex& form) { return stage.spelt(form); }});
}

void rolling(Document& document, const Stage& stage) {
  document.section("Rolling");
  const auto solution = [&](const Vector& q) { return formula::stage_solution<ex>(mobility, stage.motion, q); };
  const auto spelt = [&](const ex& form) { return stage.spelt(form); };
  document.shipped("formula::stage_room", "drop/equations/stage_rates.hpp");
  const ex room = formula::stage_room<ex>(stage.motion);
  document.prove({.text = R"($\lambda\,(1 + \hat z \cdot W^{-1} b)$)",
                  .result = room,
                  .witness = stage.spelt(lambda * (1 + solution(stage.b).z())),
                  .view = spelt});
  document.shipped("formula::stage_weight", "drop/equations/stage_rates.hpp");
  const ex weight = formula::stage_weight<ex>(mobility, stage.motion);
  document.prove({.text = R"($\lambda\,\hat z \cdot W^{-1} \mathrm{need}$)",
                  .result = weight,
                  .witness = stage.spelt(lambda * solution(stage.need).z()),
                  .view = spelt});
  document.text(R"($F = W^{-1}(\mathrm{need} - N b)$ with $N$ that over the room.)");
  document.shipped("formula::stage_rolling_force", "drop/equations/stage_rates.hpp");
  const possymbol N("N");
  const Vector force = solution(Vector(stage.need - N * stage.b));
  document.prove({.text = R"($F_z = N$)",
                  .result = (force.z() - N) * lambda,
                  .witness = stage.spelt(weight - N * room),
                  .view = spelt});
  document.prove({.text = R"($W F + N b = \mathrm{need}$: the force that keeps the contact point at rest)",
                  .result = components(Vector(stage.W * force + N * stage.b)),
                  .witness = stage.spelt(components(stage.need)),
                  .view = spelt});
  const ex shipped = components(formula::stage_rolling_force<ex>(mobility, stage.motion));
  document.prove({.text = "which the shipped force is",
                  .result = shipped,
                  .witness = components(solution(Vector(stage.need - weight / room * stage.b))),
                  .controls = scaled(shipped)});
}

void sliding(Document& document, const Stage& stage) {
  document.section("Dry slip");
  document.shipped("formula::stage_slip", "drop/equations/stage_rates.hpp");
  // Letters for all that it is made of: r, c, need and the brake b.
  const Vector r = letters("r"), across(realsymbol("cx", "c_x"), realsymbol("cy", "c_y"), 0), b = letters_xyz("b");
  StageMotion<ex> motion;
  motion.r = r;
  motion.c = across;
  motion.need = stage.need;
  motion.brake = b;
  motion.lambda = lambda;
  const Matrix W = lambda * Matrix::Identity() - B * r * r.transpose() + C * across * across.transpose();
  const ContactMatrix<ex> entries{W(0, 0), W(1, 1), W(2, 2), W(0, 1), W(0, 2), W(1, 2)};
  const goishi::SlipRate<ex> lean = formula::stage_slip<ex>(mobility, motion, mu, c, s);
  const goishi::SlipRate<ex> whole = formula::slip_rate<ex>(entries, b, stage.need, mu, c, s);
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    // Over the witness's denominator.
    const ex fraction = witness.normal().numer_denom();
    document.prove({.text = text,
                    .result = result,
                    .witness = fraction.op(0),
                    .view = [&, fraction](const ex& form) { return (form * fraction.op(1)).normal(); },
                    .controls = scaled(result)});
  };
  document.prove(
      {.text = "$D$, the denominator of the normal force", .result = lean.denominator, .witness = whole.denominator});
  prove("$N$", lean.N, whole.N);
  prove(R"($\dot\sigma$)", lean.along, whole.along);
  prove(R"($\sigma\dot\varphi$)", lean.across, whole.across);
  prove(R"($\frac{\mathrm{d}}{\mathrm{d}\varphi}(\sigma\dot\varphi)$)", lean.across_slope, whole.across_slope);
}

}  // namespace

int main() {
  return derive("Forces at the inner stages of a step", [](Document& document) {
    const Stage stage;
    matrix(document, stage);
    rolling(document, stage);
    sliding(document, stage);
  });
}
