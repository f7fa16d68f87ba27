/// \file
/// Impact laws: Chatterjee and Ruina's in closed form, and the impact that slips as a process.

#include <array>
#include <goishi/impact/impulses.hpp>
#include <goishi/impact/stronge.hpp>
#include <string>

#include "impact.hpp"

namespace {

using namespace derivation;

const realsymbol kappa("kappa", R"(\kappa)");

/// ‖x‖² in the metric of W.
ex square(const Vector& x) {
  return x.dot(Vector(M * x));
}

void chatterjee_ruina(Document& document) {
  document.section("Chatterjee and Ruina's law");
  document.text(
      R"($p_I = j_I n$ is the frictionless plastic impulse, $p_{II}$ the sticking one. Below, $p_{II}$ is any vector and $v = -W
p_{II}$.)");
  document.shipped("formula::sticking_impulse, chatterjee_ruina_impulse, cone_fraction", "impact/impulses.hpp");
  document.prove({.text = "$v + W p_{II} = 0$",
                  .result = components(formula::sticking_impulse(W, v)),
                  .witness = components(-Vector(M.inverse() * v))});
  const Vector s = letters("s");
  const realsymbol plastic("j", "j_I");
  const Vector met = -Vector(M * s);
  const ex K = n.dot(Vector(M * n));
  const exmap meaning = {{plastic, formula::normal_impulse<ex>(met.dot(n), K, 0)}};
  const Vector pI = Vector(plastic * n);
  const Vector made = formula::chatterjee_ruina_impulse<ex>(plastic, s, n, e, kappa);
  document.equation(R"(a \cdot p)", components(made));
  document.prove({.text = R"($p = (1 + e) p_I + \kappa (p_{II} - p_I)$)",
                  .result = components(made),
                  .witness = components(Vector((1 + e) * pI) + Vector(kappa * (s - pI)))});
  document.prove({.text = R"(exact restitution, whatever $\kappa$: $n \cdot v^+ = -e\, n \cdot v$)",
                  .result = n.dot(met + Vector(M * made)),
                  .witness = -e * n.dot(met),
                  .meaning = meaning,
                  .controls = {n.dot(met - Vector(M * made)),
                               n.dot(met + Vector(M * formula::chatterjee_ruina_impulse<ex>(plastic, s, n, 0, kappa))),
                               n.dot(met + Vector(M * Vector((1 + e) * pI + kappa * s)))}});
  document.prove({.text = R"($p_{II} - p_I$ is orthogonal to $p_I$ in the metric of $W$)",
                  .result = pI.dot(Vector(M * (s - pI))),
                  .witness = 0,
                  .meaning = meaning,
                  .controls = {pI.dot(Vector(M * (s + pI))), pI.dot(Vector(M * s)), pI.dot(s - pI)}});
  const Vector gone = met + Vector(M * made);
  document.prove(
      {.text = R"(the energy changes by $\frac12(\|p - p_{II}\|^2 - \|p_{II}\|^2) = -\frac12\left((1 - e^2)\|p_I\|^2
+ \kappa(2 - \kappa)\|p_{II} - p_I\|^2\right)$: never up for $0 \le e \le 1$ and $0 \le \kappa \le 2$)",
       .result = formula::work(made, met, gone),
       .witness = (-((1 - e * e) * square(pI) + kappa * (2 - kappa) * square(Vector(s - pI))) / 2).subs(meaning),
       .meaning = meaning,
       .controls = scaled(formula::work(made, met, gone))});
  const Vector left = met + Vector(M * pI);
  document.prove({.text = R"($W (p_{II} - p_I) = -v_I$, $v_I = v + W p_I$: friction's power on the slip that the plastic
normal impulse leaves is $-\kappa\, v_I \cdot W^{-1} v_I \le 0$)",
                  .result = components(Vector(M * (s - pI))),
                  .witness = components(-left),
                  .controls = {components(Vector(M * s)), components(Vector(M * (pI - s)))}});
  document.prove({.text = "and $v_I$ lies across the normal",
                  .result = n.dot(left),
                  .witness = 0,
                  .meaning = meaning,
                  .controls = {n.dot(met), n.dot(met - Vector(M * pI))}});
  document.text(R"(On the cone: $T = |p_{II,t}|$, $g = p_{II,n} - j_I$, all over any $c > 0$.)");
  const possymbol c("c"), T("T"), g("g");
  const Relations unit = Relations().unit(n);
  document.prove(unit({.text = R"($p_n = (1 + e) j_I + \kappa g$ for $|n| = 1$)",
                       .result = n.dot(made),
                       .witness = (1 + e) * plastic + kappa * (n.dot(s) - plastic)}));
  document.prove(unit({.text = R"($p_t = \kappa\, p_{II,t}$)",
                       .result = components(Vector(n.dot(n) * made - n.dot(made) * n)),
                       .witness = components(Vector(kappa * (s - Vector(n.dot(s) * n)))),
                       .controls = scaled(components(Vector(n.dot(n) * made - n.dot(made) * n)))}));
  const ex fraction = formula::cone_fraction<ex>(c * mu * (1 + e) * plastic, c * T, c * mu * g);
  document.prove(
      {.text = R"($|p_t| = \mu p_n$)", .result = fraction, .witness = mu * (1 + e) * plastic, .view = [&](const ex& x) {
         return x * T - mu * x * g;
       }});
}

void stronge(Document& document) {
  document.section("An impact that slips, as a process");
  document.text(
      R"(Coulomb: while the normal impulse grows by $\mathrm{d}p$, friction is $-\mu s/|s|\,\mathrm{d}p$. With $\mathrm{d}p =
c|s|\,\mathrm{d}\tau$: $v' = W(-c\mu x, -c\mu y, c|s|)$, $E' = c|s| z$, $v = (x, y, z)$. The witness differentiates again
and again, $|s|' = (x x' + y y')/|s|$; $s = |s|(1 - k^2, 2k)/(1 + k^2)$ is any slip. The coefficient of $\tau^n$ is the
$n$-th derivative over $n!$.)");
  document.shipped("formula::slip_series, value", "impact/stronge.hpp");
  const possymbol against("f"), along("g"), size("S"), k("k");
  const realsymbol x("x"), y("y"), z("z"), work("E");
  const Vector force(-against * x, -against * y, along * size);
  const Vector rate = M * force;
  const ex power = along * size * z;
  const auto differentiated = [&](const ex& of) {
    return (of.diff(x) * rate.x() + of.diff(y) * rate.y() + of.diff(z) * rate.z() + of.diff(work) * power +
            of.diff(size) * (x * rate.x() + y * rate.y()) / size)
        .expand();
  };
  constexpr std::size_t order = 4;
  const formula::SlipState<ex> start{.v = Vector(x, y, z), .work = work};
  const auto series = formula::slip_series<order, ex>(W, against, along, start);
  const exmap slip = {{x, size * (1 - k * k) / (1 + k * k)}, {y, size * 2 * k / (1 + k * k)}};
  const ex a0 = letter("a", 0);
  Vector derivative(x, y, z);
  ex energy = work;
  ex factorial = 1;
  for (std::size_t i = 1; i <= order; ++i) {
    derivative = Vector(differentiated(derivative.x()), differentiated(derivative.y()), differentiated(derivative.z()));
    energy = differentiated(energy);
    factorial *= static_cast<int>(i);
    document.prove({.text = "the coefficient of $\\tau^" + std::to_string(i) + "$",
                    .result = components(series[i].v) + a0 * series[i].work,
                    .witness = ((components(derivative) + a0 * energy) / factorial).subs(slip),
                    .view = [&](const ex& result) { return result.subs(slip); },
                    .controls = scaled(components(series[i].v) + a0 * series[i].work)});
  }
  const realsymbol tau("tau", R"(\tau)");
  std::array<formula::SlipState<ex>, 4> any;
  ex sum = 0;
  for (std::size_t i = 0; i < any.size(); ++i) {
    any[i] = {.v = letters("b" + std::string(i, 'c')), .work = realsymbol("e" + std::to_string(i))};
    sum += pow(tau, static_cast<int>(i)) * (components(any[i].v) + a0 * any[i].work);
  }
  const formula::SlipState<ex> value = formula::value<4, ex>(any, tau);
  document.prove({.text = R"(its value at $\tau$)", .result = components(value.v) + a0 * value.work, .witness = sum});
}

}  // namespace

int main() {
  return derive("Impact laws", [](Document& document) {
    chatterjee_ruina(document);
    stronge(document);
  });
}
