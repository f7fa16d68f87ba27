/// \file
/// A stone that rocks on its cap: its frequency, its energy at any tilt, and its decay.

#include <goishi/drop/equations/contact_motion.hpp>
#include <goishi/drop/equations/slip.hpp>
#include <string>

#include "cap.hpp"

namespace {

using namespace derivation;

void small_rocking(Document& document, const SmallMotion& small) {
  document.section("Rocking");
  document.text(
      R"(Small motions about lying flat on the lower cap: $u = (\epsilon x, \epsilon y, 1)$, $L = (\epsilon l_x,
\epsilon l_y, 0)$, all to the first order in $\epsilon$, $X = x + iy$ and $l = l_x + i l_y$. Per unit of mass, $a = r
- d$.)");
  document.shipped("formula::contact_motion, rolling_force, glide_rate",
                   "drop/equations/contact_motion.hpp, drop/equations/slip.hpp");
  const Motion now = small.at(0);
  const ex axis = small.first_order(now.u_rate);
  document.prove({.text = R"($\dot X = -i l/I_t$)", .result = axis, .witness = -GiNaC::I * small.l / transverse});
  const Vector rolls = formula::rolling_force(now.W, none, now.need);
  const goishi::GlideRate<ex> glides = formula::glide_rate<ex>(now.W, none, now.need, 0, 0, 0);
  const ex rolling = small.first_order(Vector(now.r.cross(rolls)));
  const ex gliding = small.first_order(Vector(now.r.cross(Vector(0, 0, glides.N))));
  const auto frequency = [&](const std::string& text, const ex& moment, const ex& square) {
    document.prove({.text = text,
                    .result = moment,
                    .witness = -square * small.X,
                    .view = [&](const ex& rate) { return -GiNaC::I * rate / transverse; },
                    .controls = scaled(moment)});
  };
  frequency(R"(rolling: $\ddot X = -\omega^2 X$, $\omega^2 = \frac{g d}{I_t + a^2}$)", rolling,
            g * shape.d / (transverse + arm * arm));
  frequency(R"(without friction: $\omega^2 = \frac{g d}{I_t}$)", gliding, g * shape.d / transverse);
}

void large_rocking(Document& document) {
  document.section("At any tilt");
  document.text(
      R"(Rocking in a plane at the tilt $\theta$ with the rate $\dot\theta$: $u = (\sin\theta, 0, \cos\theta)$, $L =
(0, I_t\dot\theta, 0)$. Half-angle tangent. The kinetic energies, from which with $g S$ the period follows by a
quadrature:)");
  document.shipped("formula::contact_kinetic_energy", "drop/equations/contact_motion.hpp");
  const possymbol t("t");
  const realsymbol rate("theta'", R"(\dot\theta)");
  const ex z = (1 - t * t) / (1 + t * t), across = 2 * t / (1 + t * t);
  const Motion now = on_cap(Vector(across, 0, z), Vector(0, transverse * rate, 0), across * across);
  const auto prove = [&](const std::string& text, const ex& kinetic, const ex& inertia) {
    document.prove(
        {.text = text, .result = kinetic, .witness = inertia * rate * rate / 2, .controls = scaled(kinetic)});
  };
  document.prove({.text = R"(it does turn so: $\dot u = \dot\theta\, (\cos\theta, 0, -\sin\theta)$)",
                  .result = components(now.u_rate),
                  .witness = rate * components(Vector(z, 0, -across)),
                  .controls = scaled(components(now.u_rate))});
  prove(R"(rolling: $\frac12 (I_t + r^2 + d^2 - 2 r d \cos\theta)\,\dot\theta^2$)",
        formula::contact_kinetic_energy<ex>(now, 0, 0),
        transverse + pow(shape.r, 2) + pow(shape.d, 2) - 2 * shape.r * shape.d * z);
  prove(R"(without friction, the centre at rest along the plane: $\frac12 (I_t + d^2 \sin^2\theta)\,\dot\theta^2$)",
        formula::contact_kinetic_energy<ex>(now, now.point.x(), now.point.y()), transverse + pow(shape.d * across, 2));
  document.prove({.text = R"(the height, $S = r - d \cos\theta$)",
                  .result = now.height,
                  .witness = shape.r - shape.d * z,
                  .controls = scaled(now.height)});
}

void decay(Document& document, const SmallMotion& small) {
  const Motion now = small.at(0);
  const Vector rolls = formula::rolling_force(now.W, none, now.need);
  document.section("Its decay");
  document.text(
      R"(Rolling with a resistance $\delta$, in a plane, to the leading order. Where the stone turns back, at the
tilts $\theta_1$ and then $\theta_2$ on the other side, all its energy is that of height. In between it loses $\int
\delta N\,|\mathrm{d}\theta|$.)");
  const realsymbol theta("theta", R"(\theta)");
  const possymbol delta("delta", R"(\delta)"), kappa("kappa", R"(\kappa)"), w("w", R"(\omega)");
  const possymbol before("t1", R"(\theta_1)"), after("t2", R"(\theta_2)");
  const ex height =
      on_cap(Vector(sin(theta), 0, cos(theta)), none, pow(sin(theta), 2)).height.diff(theta, 2).subs(theta == 0);
  document.prove(
      {.text =
           R"($\frac{\mathrm{d}^2 S}{\mathrm{d}\theta^2} = d$ at $\theta = 0$: the energy is $\frac12 g d \theta^2$)",
       .result = height,
       .witness = shape.d});
  const ex power = formula::resistance<ex>(pow(delta, 2), pow(kappa, 2), Vector(0, w, 0), 0).y() * w;
  document.prove(
      {.text = R"(per normal force the torque's power is $-\delta |\omega|$)", .result = power, .witness = -delta * w});
  document.prove({.text = "$N = g$", .result = rolls.z().subs(small.epsilon == 0), .witness = g});
  document.prove({.text = "and to the first order it does not change",
                  .result = small.first_order(rolls.z()),
                  .witness = 0,
                  .controls = {small.first_order(rolls.x())}});
  const auto balance = [&](const ex& second) {
    return g * shape.d * (before * before - second * second) / 2 - g * delta * (before + second);
  };
  document.prove(
      {.text = R"($\frac12 g d (\theta_1^2 - \theta_2^2) = g \delta (\theta_1 + \theta_2)$: each half swing takes
$2\delta/d$)",
       .result = balance(before - 2 * delta / shape.d),
       .witness = 0,
       .controls = {balance(before - delta / shape.d), balance(before), balance(before + 2 * delta / shape.d)}});
  const Vector turned = on_cap(Vector(sin(theta), 0, cos(theta)), none, pow(sin(theta), 2)).r.cross(up);
  document.prove({.text = R"(the moment that turns it back is $N d \sin\theta$: below $\delta N$ the stone rests)",
                  .result = turned.y(),
                  .witness = -shape.d * sin(theta)});
}

}  // namespace

int main() {
  return derive("A stone that rocks", [](Document& document) {
    const SmallMotion small;
    small_rocking(document, small);
    large_rocking(document);
    decay(document, small);
  });
}
