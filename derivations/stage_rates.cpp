/// \file
/// The rates of a contact at the inner stages of a step, in their own form: no matrix, few divisions.

#include <goishi/drop/equations/stage_rates.hpp>
#include <string>

#include "contact.hpp"

namespace {

using namespace derivation;
using goishi::StageMotion;
namespace at = goishi::detail::at;

const possymbol rho("rho", R"(\rho)"), lambda("lambda", R"(\lambda)"), lambda_c("lambda_c", R"(\lambda_c)");
const possymbol B("B");
const realsymbol C("C"), c("c"), s("s");
const goishi::Mobility<ex> mobility{.linear = 1, .transverse = B, .axial = C};

Vector diagonal(const Vector& a, const Vector& b) {
  return {a.x() * b.x(), a.y() * b.y(), a.z() * b.z()};
}

void motion(Document& document) {
  document.section("The motion");
  document.text(
      R"(The same motion as in the chapter *A stone in contact with a plane*, of a stone with any height $S$, slope $S'$
and curvature $S''$ of its support function. $\nu = (\delta^2 \omega_h, \kappa^2 \omega_z)$, $\rho = \sqrt{\nu \cdot
\omega + \mathrm{floor}}$: the torque of resistance that goes with a normal force of 1 is $\tau = -\nu/\rho$.)");
  document.shipped("formula::stage_motion", "drop/equations/stage_rates.hpp");
  const possymbol delta("delta", R"(\delta)"), kappa("kappa", R"(\kappa)"), floor("f");
  const realsymbol S("S"), slope("S'"), curvature("S''");
  const Vector u = letters("u"), L = letters("L"), g = letters("g");
  const Geometry geometry{.height = S, .slope = slope, .curvature = curvature};
  const Motion now = formula::contact_motion(mobility, g, geometry, u, L);
  const ex d2 = pow(delta, 2), k2 = pow(kappa, 2);
  const StageMotion<ex> stage = formula::stage_motion<ex>(mobility, g, geometry, u, L, true, d2, k2, floor);
  const auto same = [&](const std::string& text, const Vector& result, const Vector& witness) {
    document.prove({.text = text, .result = components(result), .witness = components(witness)});
  };
  same(R"($\omega$)", stage.w, now.w);
  same(R"($\dot u$)", stage.u_rate, now.u_rate);
  same("$r$", stage.r, now.r);
  same(R"($\mathrm{need}$)", stage.need, now.need);
  document.prove({.text = R"($\omega \cdot u$)", .result = stage.spin_rate, .witness = now.spin_rate});
  same(R"($c = r \times u$)", stage.c, now.r.cross(u));
  document.prove({.text = R"($\lambda = 1 + |r|^2/I_t$)", .result = stage.lambda, .witness = 1 + B * now.r.dot(now.r)});
  document.prove({.text = R"($\lambda_c = \lambda + (1/I_a - 1/I_t)\,|c|^2$)",
                  .result = stage.lambda_c,
                  .witness = 1 + B * now.r.dot(now.r) + C * now.r.cross(u).dot(now.r.cross(u))});
  const Vector nu = diagonal(Vector(d2, d2, k2), now.w);
  same(R"($\nu$)", stage.nu, nu);
  document.prove({.text = R"($\rho^2$)", .result = pow(stage.root, 2), .witness = nu.dot(now.w) + floor});
  same(R"($J\nu \times r$)", stage.braked, Vector(B * nu + C * u.dot(nu) * u).cross(now.r));
  const StageMotion<ex> free = formula::stage_motion<ex>(mobility, g, geometry, u, L, false, 0, 0, floor);
  document.prove({.text = R"(without resistance $\rho = 1$)", .result = free.root, .witness = 1});
  const Vector resistance = formula::resistance<ex>(d2, k2, now.w, floor);
  same(R"($\tau = -\nu/\rho$ is the resistance that contact has)", Vector(-stage.nu / stage.root), resistance);
}

/// What the rates are made of, with letters of their own: r = −S' u_h − S ẑ, c = k (u_y, −u_x, 0), J ν × r any vector
/// across r.
struct Stage {
  Vector u = letters("u"), L = letters("L"), need = letters("n"), nu = letters("v"), x = letters("x");
  realsymbol slope{"S'"}, height{"S"}, k{"k"};
  Vector r = Vector(-slope * u.x(), -slope* u.y(), -height);
  Vector across = Vector(k * u.y(), -k* u.x(), 0);
  ex square = r.dot(r), across_square = across.dot(across);
  StageMotion<ex> motion = [this] {
    StageMotion<ex> made;
    made.u = u;
    made.L = L;
    made.w = B * L + C * u.dot(L) * u;
    made.u_rate = Vector(B * L.cross(u));
    made.spin_rate = made.w.dot(u);
    made.r = r;
    made.need = need;
    made.c = across;
    made.nu = nu;
    made.braked = x.cross(r);
    made.root = rho;
    made.lambda = lambda;
    made.lambda_c = lambda_c;
    return made;
  }();
  /// λ 1 − r rᵀ/I_t + (1/I_a − 1/I_t) c cᵀ
  Matrix W = Matrix(lambda * Matrix::Identity() - B * r * r.transpose() + C * across * across.transpose());
  Vector b = Vector(-motion.braked / rho);

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
  const Vector u = letters("u"), r = letters("r"), q = letters("q"), across = r.cross(u);
  const ex l = 1 + B * r.dot(r);
  document.prove({.text = R"($W = \lambda\,\mathbb{1} - r r^\mathsf{T}/I_t + (1/I_a - 1/I_t)\, c c^\mathsf{T}$)",
                  .result = components(Vector(full(formula::contact_matrix(mobility, u, r)) * q)),
                  .witness = components(Vector(l * q - B * r.dot(q) * r + C * across.dot(q) * across))});
  document.shipped("formula::stage_solution", "drop/equations/stage_rates.hpp");
  const Vector solved = formula::stage_solution<ex>(mobility, stage.motion, q);
  const auto spelt = [&](const ex& form) { return stage.spelt(form); };
  document.prove({.text = R"($W\, W^{-1} q = q$)",
                  .result = components(Vector(stage.W * solved)),
                  .witness = stage.spelt(components(q)),
                  .view = spelt});
  document.shipped("formula::stage_stiffness", "drop/equations/stage_rates.hpp");
  document.prove(
      {.text = "$W_{zz}$", .result = formula::stage_stiffness<ex>(mobility, stage.motion), .witness = stage.W(2, 2)});
}

void rolling(Document& document, const Stage& stage) {
  document.section("Rolling");
  document.text(
      R"($b = J\tau \times r = -(J\nu \times r)/\rho$ is what the resistance of a normal force 1 does to the contact
point. With $N = M\rho$ the force has to be $F = W^{-1}(\mathrm{need} + M\, J\nu \times r)$, $F_z = N$.)");
  document.shipped("formula::stage_room", "drop/equations/stage_rates.hpp");
  const ex room = formula::stage_room<ex>(stage.motion);
  const auto solution = [&](const Vector& q) { return formula::stage_solution<ex>(mobility, stage.motion, q); };
  const auto spelt = [&](const ex& form) { return stage.spelt(form); };
  document.prove({.text = R"($\lambda\rho\,(1 + \hat z \cdot W^{-1} b)$)",
                  .result = room,
                  .witness = stage.spelt(lambda * rho * (1 + solution(stage.b).z())),
                  .view = spelt});
  document.shipped("formula::stage_weight", "drop/equations/stage_rates.hpp");
  const ex weight = formula::stage_weight<ex>(mobility, stage.motion);
  document.prove({.text = R"($\lambda\,\hat z \cdot W^{-1} \mathrm{need}$)",
                  .result = weight,
                  .witness = stage.spelt(lambda * solution(stage.need).z()),
                  .view = spelt});
  const possymbol M("M");
  const Vector force = solution(Vector(stage.need + M * stage.motion.braked));
  document.prove({.text = R"($F_z = M\rho$ where $M$ is $\lambda\,\hat z \cdot W^{-1}\mathrm{need}$ over that room)",
                  .result = (force.z() - M * rho) * lambda,
                  .witness = stage.spelt(weight - M * room),
                  .view = spelt});
  document.prove({.text = R"($W F + F_z b = \mathrm{need}$: the force that keeps the contact point at rest)",
                  .result = components(Vector(stage.W * force + M * rho * stage.b)),
                  .witness = stage.spelt(components(stage.need)),
                  .view = spelt});
  document.shipped("formula::stage_rolling", "drop/equations/stage_rates.hpp");
  const possymbol damping("h");
  const Vector origin = letters("o");
  const auto rolled = formula::stage_rolling<ex>(mobility, stage.motion, damping, origin);
  const ex ratio = weight / room;
  const auto made = formula::stage_rates<ex>(
      mobility, stage.motion, damping, solution(Vector(stage.need + ratio * stage.motion.braked)), ratio, 0, 0, origin);
  ex result = 0, witness = 0;
  for (std::size_t i = 0; i < rolled.size(); ++i) {
    const realsymbol part("p" + std::to_string(i));
    result += part * rolled[i];
    witness += part * made[i];
  }
  document.prove({.text = "the rates are those of this force and this $M$, without slip",
                  .result = result,
                  .witness = witness,
                  .controls = {result + rho, 2 * result}});
}

void rates(Document& document, const Stage& stage) {
  document.section("The rates");
  document.text(
      R"(Those of the chapter on the contact phase under any force $F$, $F_z = M\rho$, with the torque $\tau =
-\nu/\rho$ of resistance.)");
  document.shipped("formula::stage_rates", "drop/equations/stage_rates.hpp");
  const possymbol M("M"), damping("h");
  const realsymbol sx("sx", "s_x"), sy("sy", "s_y"), fx("Fx", "F_x"), fy("Fy", "F_y");
  const Vector origin = letters("o"), F(fx, fy, M * rho);
  Motion now;
  now.u = stage.u;
  now.L = stage.L;
  now.w = stage.motion.w;
  now.u_rate = stage.motion.u_rate;
  now.r = stage.r;
  now.height = stage.height;
  now.spin_rate = stage.motion.spin_rate;
  now.point = now.w.cross(now.r);
  const goishi::detail::Kinetics<ex> kinetics{now, Vector(-stage.nu / rho), Vector(0, 0, 0)};
  const ex damped = formula::damping_power<ex>(now, damping, sx, sy);
  const auto whole = formula::contact_rates<ex>(kinetics, damping, damped, F, sx, sy, origin);
  const auto lean = formula::stage_rates<ex>(mobility, stage.motion, damping, F, M, sx, sy, origin);
  const std::vector<std::pair<std::size_t, std::string>> names = {
      {at::u, R"($\dot u_x$)"}, {at::u + 1, R"($\dot u_y$)"}, {at::u + 2, R"($\dot u_z$)"},
      {at::x, R"($\dot x$)"},   {at::y, R"($\dot y$)"},       {at::loss, "what is lost"},
      {at::L, R"($\dot L_x$)"}, {at::L + 1, R"($\dot L_y$)"}, {at::L + 2, R"($\dot L_z$)"}};
  for (const auto& [which, name] : names) {
    document.prove({.text = name, .result = lean[which], .witness = whole[which]});
  }
  const auto times = [&](const ex& form) { return (form * (1 + formula::dot(origin, stage.u))).normal(); };
  document.prove(Relations().unit(stage.u)({.text = R"($\dot\psi$, with $|u| = 1$)",
                                            .result = lean[at::spin],
                                            .witness = times(whole[at::spin]),
                                            .view = times,
                                            .controls = scaled(lean[at::spin])}));
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
  motion.braked = Vector(-rho * b);
  motion.root = rho;
  motion.lambda = lambda;
  const Matrix W = lambda * Matrix::Identity() - B * r * r.transpose() + C * across * across.transpose();
  const ContactMatrix<ex> entries{W(0, 0), W(1, 1), W(2, 2), W(0, 1), W(0, 2), W(1, 2)};
  const goishi::SlipRate<ex> lean = formula::stage_slip<ex>(mobility, motion, mu, c, s);
  const goishi::SlipRate<ex> whole = formula::slip_rate<ex>(entries, b, stage.need, mu, c, s);
  const auto normal = [](const ex& form) { return form.normal().numer_denom(); };
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    // Over the witness's denominator.
    const ex fraction = normal(witness);
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
  document.shipped("formula::stage_sliding", "drop/equations/stage_rates.hpp");
  const possymbol damping("h"), sigma("sigma", R"(\sigma)"), N("N");
  const Vector origin = letters("o");
  goishi::SlipRate<ex> slip;
  slip.N = N;
  const auto slid = formula::stage_sliding<ex>(mobility, stage.motion, slip, mu, c, s, sigma, damping, origin);
  const auto made = formula::stage_rates<ex>(mobility, stage.motion, damping, Vector(-mu * N * c, -mu * N * s, N),
                                             N / rho, sigma * c, sigma * s, origin);
  ex result = 0, witness = 0;
  for (std::size_t i = 0; i < slid.size(); ++i) {
    const realsymbol part("p" + std::to_string(i));
    result += part * slid[i];
    witness += part * made[i];
  }
  document.prove({.text = R"(the rates are those of $F = N(-\mu c, -\mu s, 1)$ and the slip $\sigma(c, s)$)",
                  .result = result,
                  .witness = witness,
                  .controls = {result + rho, 2 * result}});
}

}  // namespace

int main() {
  return derive("The rates at the inner stages of a step", [](Document& document) {
    motion(document);
    const Stage stage;
    matrix(document, stage);
    rates(document, stage);
    rolling(document, stage);
    sliding(document, stage);
  });
}
