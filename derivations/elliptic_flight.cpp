/// \file
/// Jacobi's solution of free rotation: that it solves Euler's equations, the addition theorems that lead along it, and
/// the turn about the momentum.

#include <goishi/motion/elliptic_flight.hpp>
#include <string>

#include "relations.hpp"

namespace {

using namespace derivation;
namespace formula = goishi::formula;
using Jacobi = goishi::elliptic::Jacobi<ex>;
using Solution = goishi::JacobiSolution<ex>;

/// sn, cn and dn at one argument, of one parameter.
struct Functions {
  realsymbol sn, cn, dn;
  ex m;

  Functions(const std::string& index, const ex& parameter)
      : sn("sn" + index, R"(\mathrm{sn}_{)" + index + "}"),
        cn("cn" + index, R"(\mathrm{cn}_{)" + index + "}"),
        dn("dn" + index, R"(\mathrm{dn}_{)" + index + "}"),
        m(parameter) {}

  [[nodiscard]] Jacobi jacobi() const { return {.sn = sn, .cn = cn, .dn = dn}; }
  void bind(Relations& relations) const { relations.square(cn, 1 - pow(sn, 2)).square(dn, 1 - m * pow(sn, 2)); }
  /// By the argument: sn' = cn dn, cn' = −sn dn, dn' = −m sn cn.
  [[nodiscard]] ex rate(const ex& e) const {
    return e.diff(sn) * cn * dn - e.diff(cn) * sn * dn - e.diff(dn) * m * sn * cn;
  }
};

/// The body by ρ = B/A, and the solution by A and C.
struct Top {
  possymbol ratio{"rho", R"(\rho)"}, Ia{"Ia", "I_a"}, Ic{"Ic", "I_c"}, A{"A"}, C{"C"}, size{"L", "|L|"};
  ex Ib = pow(ratio, 2) * Ia * Ic / (pow(ratio, 2) * Ia - Ia + Ic);
  Vector moments = Vector(Ia, Ib, Ic);
  ex kappa = 1 - 1 / pow(ratio, 2), n = 1 - pow(ratio, 2), m = kappa * pow(ratio * A / C, 2);
  ex rate = C / ratio * (1 / Ia - 1 / Ic);  // λ
  Functions start{"0", m}, now{"t", m};

  [[nodiscard]] Relations relations() const {
    Relations bound = Relations().square(size, pow(A, 2) + pow(C, 2));
    start.bind(bound);
    now.bind(bound);
    return bound;
  }
  [[nodiscard]] Vector momentum(const Functions& at) const { return {A * at.cn, ratio * A * at.sn, C * at.dn}; }

  /// The solution in letters, as the first section proves it to be.
  [[nodiscard]] Solution solution() const {
    return {.ratio = ratio,
            .ratio2 = pow(ratio, 2),
            .n = n,
            .size = size,
            .A = A,
            .B = ratio * A,
            .C = C,
            .rate = rate,
            .sn = start.sn,
            .cn = start.cn,
            .dn = start.dn,
            .m = m,
            .m1 = 1 - m};
  }
};

/// Rational functions under relations: numerator and denominator reduced, so that equal ones become so.
ex reduced(const Relations& relations, const ex& e) {
  const ex fraction = e.normal().numer_denom();
  return (relations.of_polynomial(fraction.op(0)) / relations.of_polynomial(fraction.op(1))).normal();
}

/// The same, within every root first.
ex reduced_roots(const Relations& relations, const ex& e) {
  struct Reducer : GiNaC::map_function {
    explicit Reducer(const Relations& r) : given(r) {}
    ex operator()(const ex& node) override {
      const ex inner = node.nops() == 0 ? node : node.map(*this);
      const bool root = GiNaC::is_a<GiNaC::power>(inner) && inner.op(1).info(GiNaC::info_flags::rational) &&
                        !inner.op(1).info(GiNaC::info_flags::integer);
      return root ? pow(positive_root(reduced(given, inner.op(0))), 2 * inner.op(1)) : inner;
    }
    const Relations& given;
  };
  return reduced(relations, Reducer(relations)(e));
}

void solution(Document& document, const Top& top) {
  document.section("The solution");
  document.text(
      R"(A body with the moments $I_a$, $I_b$, $I_c$, $I_b$ strictly between the others, free of torque: in its own frame
$\dot L = L \times \omega$, $\omega_i = L_i/I_i$. The frame is such that $L_c > 0$ never vanishes. The solution is
$L = (A\,\mathrm{cn}\,u, \rho A\,\mathrm{sn}\,u, C\,\mathrm{dn}\,u)$, $u = u_0 + \lambda t$, of a parameter $m$;
index 0 is the start. Here the body is given by $\rho > 0$, which makes $I_b = \rho^2 I_a I_c/(\rho^2 I_a - I_a +
I_c)$, and the momentum by the solution. $\mathrm{cn}^2 = 1 - \mathrm{sn}^2$, $\mathrm{dn}^2 = 1 -
m\,\mathrm{sn}^2$.)");
  document.shipped("formula::jacobi_solution", "motion/elliptic_flight.hpp");
  const Relations relations = top.relations();
  const Solution made = formula::jacobi_solution<ex>(top.moments, top.momentum(top.start));
  const auto prove = [&](const std::string& text, const ex& result, const ex& witness) {
    document.prove({.text = text,
                    .result = result,
                    .witness = witness,
                    .view = [&](const ex& e) { return reduced_roots(relations, e); },
                    .controls = scaled(result)});
  };
  prove(R"($\rho^2$)", made.ratio2, pow(top.ratio, 2));
  prove(R"($\rho$)", made.ratio, top.ratio);
  prove("$A$", made.A, top.A);
  prove("$B = \\rho A$", made.B, top.ratio * top.A);
  prove("$C$", made.C, top.C);
  prove(R"($\mathrm{sn}\,u_0$)", made.sn, top.start.sn);
  prove(R"($\mathrm{cn}\,u_0$)", made.cn, top.start.cn);
  prove(R"($\mathrm{dn}\,u_0$)", made.dn, top.start.dn);
  prove(R"($m = (\rho^2 - 1) A^2/C^2$)", made.m, top.m);
  prove("$1 - m$", made.m1, 1 - top.m);
  prove(R"($n = 1 - \rho^2$)", made.n, top.n);
  prove(R"($\lambda = \frac{C}{\rho}\left(\frac1{I_a} - \frac1{I_c}\right)$)", made.rate, top.rate);
  prove(R"($|L|^2 = A^2 + C^2$)", pow(made.size, 2), pow(top.A, 2) + pow(top.C, 2));
  const ex five = formula::jacobi_solution<ex>(top.moments, Vector(3 * top.A, 0, 4 * top.A)).size;
  prove("and $|L|$ is the positive root: of $(3A, 0, 4A)$ it is $5A$", five, 5 * top.A);

  document.text(
      R"(With $\mathrm{sn}' = \mathrm{cn}\,\mathrm{dn}$, $\mathrm{cn}' = -\mathrm{sn}\,\mathrm{dn}$, $\mathrm{dn}' =
-m\,\mathrm{sn}\,\mathrm{cn}$ it solves Euler's equations. After a half turn $\mathrm{sn}$ and $\mathrm{cn}$ have the
other sign.)");
  document.shipped("formula::jacobi_momentum", "motion/elliptic_flight.hpp");
  for (const int flip : {1, -1}) {
    const Vector L = formula::jacobi_momentum<ex>(top.solution(), flip, top.now.jacobi());
    const Vector w(L.x() / top.Ia, L.y() / top.Ib, L.z() / top.Ic);
    document.prove({.text = flip == 1 ? R"($\dot L = L \times \omega$)" : R"(and with $-\mathrm{sn}$, $-\mathrm{cn}$)",
                    .result = components(L),
                    .witness = components(L.cross(w)),
                    .view = [&](const ex& e) { return top.rate * top.now.rate(e); },
                    .controls = scaled(components(L))});
    const Vector at_start = formula::jacobi_momentum<ex>(top.solution(), flip, top.start.jacobi());
    document.prove({.text = "at the start it is $L$, or $L$ turned by a half turn about the third axis",
                    .result = components(at_start),
                    .witness = components(Vector(flip * top.A * top.start.cn, flip * top.ratio * top.A * top.start.sn,
                                                 top.C * top.start.dn))});
  }
}

/// sn, cn and dn of u₀ + v.
void addition(Document& document) {
  document.section("The addition theorems");
  document.text(
      R"($\mathrm{sn}$, $\mathrm{cn}$ and $\mathrm{dn}$ of $u_0 + v$, from those of $u_0$ (index 0) and of $v$ (index $v$):
three functions of $v$ that begin as those of $u_0$ and have the derivatives that make them $\mathrm{sn}$,
$\mathrm{cn}$ and $\mathrm{dn}$ are them.)");
  document.shipped("formula::jacobi_sum", "motion/elliptic_flight.hpp");
  const realsymbol m("m");
  const Functions start("0", m), by("v", m);
  Relations relations;
  start.bind(relations);
  by.bind(relations);
  Solution first;
  first.sn = start.sn;
  first.cn = start.cn;
  first.dn = start.dn;
  first.m = m;
  const Jacobi sum = formula::jacobi_sum<ex>(first, by.jacobi());
  const exmap at_zero = {{by.sn, 0}, {by.cn, 1}, {by.dn, 1}};
  const auto prove = [&](const std::string& name, const ex& result, const ex& rate, const ex& begin) {
    document.prove({.text = name + " has the right derivative",
                    .result = result,
                    .witness = reduced(relations, rate),
                    .view = [&](const ex& e) { return reduced(relations, by.rate(e)); },
                    .controls = scaled(result)});
    document.prove({.text = name + " begins as at $u_0$",
                    .result = result,
                    .witness = begin,
                    .meaning = at_zero,
                    .controls = scaled(result)});
  };
  prove(R"($\mathrm{sn}$)", sum.sn, sum.cn * sum.dn, start.sn);
  prove(R"($\mathrm{cn}$)", sum.cn, -sum.sn * sum.dn, start.cn);
  prove(R"($\mathrm{dn}$)", sum.dn, -m * sum.sn * sum.cn, start.dn);
}

/// Π(n), from its parts.
void third_kind(Document& document) {
  document.section("The addition theorem of the third kind");
  document.text(
      R"(Let $K \Pi(n)$ have the derivative $K/(1 - n\,\mathrm{sn}^2)$, $K = \rho |L|/C$. From $u_0$ to $u = u_0 + v$ it
grows by that of $v$ less an excess $\epsilon$, which is 0 for $v = 0$ and has
$\frac{\mathrm{d}\epsilon}{\mathrm{d}v} = K/(1 - n\,\mathrm{sn}^2 v) - K/(1 - n\,\mathrm{sn}^2 u)$. Here $x =
|L|/C$, $K = \rho x$, $n = 1 - \rho^2$, $m = (\rho^2 - 1)(x^2 - 1)$, and $\mathrm{sn}\,u_0$ is that of $u - v$.)");
  document.shipped("formula::third_kind_excess", "motion/elliptic_flight.hpp");
  const possymbol ratio("rho", R"(\rho)"), size("x");
  const ex n = 1 - pow(ratio, 2), m = (pow(ratio, 2) - 1) * (pow(size, 2) - 1), K = ratio * size;
  const Functions by("v", m), sum("u", m);
  Relations relations;
  by.bind(relations);
  sum.bind(relations);
  const realsymbol sn0("sn0", R"(\mathrm{sn}_0)");
  Solution end;
  end.sn = sum.sn;
  end.cn = sum.cn;
  end.dn = sum.dn;
  end.m = m;
  const ex before = formula::jacobi_sum<ex>(end, {.sn = -by.sn, .cn = by.cn, .dn = by.dn}).sn;
  const auto excess = [&](const ex& of_n, const ex& of_m, const ex& sn_by) {
    Solution start;
    start.n = of_n;
    start.m = of_m;
    start.sn = sn0;
    return formula::third_kind_excess<ex>(start, sn_by, sum.jacobi());
  };
  // Of atan2(y, x), the derivative y'x − x'y over x² + y², and all denominators multiplied in.
  const auto left = [&](const ex& e) {
    const ex y = reduced_roots(relations, e.op(0)), x = e.op(1);
    const auto rate = [&](const ex& form) { return by.rate(form) + sum.rate(form); };
    const ex over_v = 1 - n * pow(by.sn, 2), over_u = 1 - n * pow(sum.sn, 2);
    const ex whole = (rate(y) * x - rate(x) * y) * over_v * over_u - K * (over_u - over_v) * (x * x + y * y);
    return relations.of_polynomial(whole.expand().subs(sn0 == before).normal().numer());
  };
  const ex shipped = excess(n, m, by.sn);
  document.prove(
      {.text = R"(the derivative of $\epsilon$)",
       .result = shipped,
       .witness = 0,
       .view = left,
       .controls = {excess(2 * n, m, by.sn), excess(n, 2 * m, by.sn), excess(n, m, 2 * by.sn),
                    atan2(-ex(shipped.op(0)), ex(shipped.op(1))), atan2(ex(shipped.op(0)), ex(shipped.op(1)) * 2)}});
  const realsymbol letter("b");
  const ex start = ex(shipped.op(0)).subs(by.sn == 0) + letter * ex(shipped.op(1)).subs(by.sn == 0);
  document.prove({.text = R"(for $v = 0$ it is the angle of $(1 - n\,\mathrm{sn}^2 u, 0)$, and $n \le 0$: 0)",
                  .result = start,
                  .witness = letter * (1 - n * pow(sum.sn, 2)),
                  .controls = scaled(start)});
}

/// The attitude, by the turn about the momentum.
void turn(Document& document, const Top& top) {
  document.section("The turn about the momentum");
  document.text(
      R"($\Pi(n)$ has the derivative $1/(1 - n\,\mathrm{sn}^2)$ by its argument; the longitude is the angle of $(L_a, L_b)$.
With $\dot\Pi = \lambda/(1 - n\,\mathrm{sn}^2 u)$, the whole integral from $u_0$ to $u$:)");
  document.shipped("formula::turn_about_momentum", "motion/elliptic_flight.hpp");
  const Relations relations = top.relations();
  const Solution solution = top.solution();
  const possymbol t("t");
  const realsymbol third("P", R"(\Pi)"), excess("e"), longitude("l"), third_rate("P'", R"(\dot\Pi)"),
      longitude_rate("l'", R"(\dot\ell)");
  const ex psi = formula::turn_about_momentum<ex>(solution, top.Ic, third, excess, longitude, t);
  const Vector L = top.momentum(top.now), w(L.x() / top.Ia, L.y() / top.Ib, L.z() / top.Ic);
  const ex wanted = (L.dot(w) + top.size * w.z()) / (top.size + L.z());
  const Vector L_rate = L.cross(w);
  const exmap rates = {{third_rate, top.rate / (1 - top.n * pow(top.now.sn, 2))},
                       {longitude_rate, (L.x() * L_rate.y() - L.y() * L_rate.x()) / (pow(L.x(), 2) + pow(L.y(), 2))}};
  document.prove({.text = R"($\dot\psi = (\omega \cdot L + |L|\,\omega_c)/(|L| + L_c)$)",
                  .result = psi,
                  .witness = 0,
                  .view =
                      [&](const ex& e) {
                        const ex rate = e.diff(t) + e.diff(third) * third_rate + e.diff(longitude) * longitude_rate;
                        return reduced(relations, rate.subs(rates) - wanted).numer().expand();
                      },
                  .controls = scaled(psi)});
  document.prove({.text = "what the parts of the integral have beyond it is taken off",
                  .result = psi,
                  .witness = -1,
                  .view = [&](const ex& e) { return e.diff(excess); },
                  .controls = scaled(psi)});

  document.shipped("formula::momentum_longitude", "motion/elliptic_flight.hpp");
  const ex angle = formula::momentum_longitude<ex>(solution, top.now.jacobi());
  document.prove(
      {.text = R"(its rate is that of the angle of $(L_a, L_b)$)",
       .result = angle,
       .witness = 0,
       .view =
           [&](const ex& e) {
             return reduced(relations, top.rate * top.now.rate(e) - longitude_rate.subs(rates)).numer().expand();
           },
       .controls = scaled(angle)});
  const exmap begins = {{top.now.sn, top.start.sn}, {top.now.cn, top.start.cn}, {top.now.dn, top.start.dn}};
  const realsymbol letter("b");
  const ex start = ex(angle.op(0)).subs(begins) + letter * ex(angle.op(1)).subs(begins);
  document.prove({.text = R"(at the start it is the angle of $(\mathrm{cn}_0^2 + \rho^2\,\mathrm{sn}_0^2, 0)$: 0)",
                  .result = start,
                  .witness = letter * (pow(top.start.cn, 2) + pow(top.ratio * top.start.sn, 2)),
                  .controls = scaled(start)});

  document.section("The attitude");
  document.text(
      R"($\ell = L/|L|$ keeps its direction in the world, and in the body $\dot\ell = \ell \times \omega$. The quaternion
$P$, of the length $\sqrt{2(1 + \ell_z)}$, turns $\ell$ to $\hat z$. The attitude $q \propto q_0 \bar P_0\,
e(\psi)\, P$, $e(\psi) = (\cos\frac\psi2, \hat z\sin\frac\psi2)$, has the angular velocity in the body $2 \bar q
\dot q = \dot\psi\,\bar P \hat z P + 2 \bar P \dot P$, over $|P|^2$.)");
  document.shipped("formula::shortest_to_z", "motion/elliptic_flight.hpp");
  const Vector l = letters("l"), omega = letters("w");
  const Relations unit = Relations().unit(l);
  const Quaternion P = formula::shortest_to_z<ex>(l);
  document.prove(unit({.text = R"($|P|^2$)", .result = squared_norm(P), .witness = 2 * (1 + l.z())}));
  document.prove(unit({.text = R"($P \ell \bar P = |P|^2 \hat z$)",
                       .result = components(turned(P, l)),
                       .witness = components(Vector(0, 0, 2 * (1 + l.z()))),
                       .controls = {components(turned(conjugated(P), l)), components(turned(P, omega))}}));
  document.prove({.text = R"(about an axis across $\hat z$: it is the shortest)",
                  .result = P.z(),
                  .witness = 0,
                  .controls = {P.x()}});
  const Vector l_rate = l.cross(omega);
  const Quaternion P_rate(l_rate.z(), l_rate.y(), -l_rate.x(), 0);
  const auto moved = [&](const Quaternion& by) {
    ex sum = 0;
    for (int i = 0; i < 3; ++i) {
      sum += components(by).diff(GiNaC::ex_to<symbol>(l(i))) * l_rate(i);
    }
    return sum;
  };
  document.prove({.text = R"($\dot P$)", .result = moved(P), .witness = components(P_rate)});
  const Vector carried = hamilton(conjugated(P), P_rate).vec();
  const Vector about = turned(conjugated(P), Vector(0, 0, 1));
  const ex turning = omega.dot(l) + omega.z();  // (1 + l_z) ψ'
  const ex whole = components(Vector(turning * about)) + 2 * (1 + l.z()) * components(carried);
  document.prove(unit(
      {.text =
           R"(with $\dot\psi = (\omega \cdot \ell + \omega_z)/(1 + \ell_z)$, the rate of the turn above, it is $\omega$)",
       .result = whole,
       .witness = 2 * pow(1 + l.z(), 2) * components(omega),
       .controls = {-whole, whole * ex(1001) / 1000,
                    components(Vector(turning * about)) - 2 * (1 + l.z()) * components(carried)}}));
  document.shipped("formula::turned_about_momentum", "motion/elliptic_flight.hpp");
  const Quaternion q = quaternion_letters("q"), frame = quaternion_letters("f"), first = quaternion_letters("p"),
                   last = quaternion_letters("r");
  const realsymbol psi_letter("psi", R"(\psi)");
  const ex attitude = components(formula::turned_about_momentum<ex>(q, frame, first, psi_letter, last));
  const ex other = components(formula::turned_about_momentum<ex>(q, frame, last, psi_letter, first));
  const Quaternion turned_by(cos(psi_letter / 2), 0, 0, sin(psi_letter / 2));
  document.prove(
      {.text = R"(the attitude is $q_0 f\, \bar P_0\, e(\psi)\, P\, \bar f$, $f$ the frame in the body)",
       .result = attitude,
       .witness = components(hamilton(
           q, hamilton(hamilton(hamilton(hamilton(frame, conjugated(first)), turned_by), last), conjugated(frame)))),
       .controls = {-attitude, other, attitude.subs(psi_letter == -psi_letter)}});
}

}  // namespace

int main() {
  return derive("Free flight of any body", [](Document& document) {
    const Top top;
    solution(document, top);
    addition(document);
    third_kind(document);
    turn(document, top);
  });
}
