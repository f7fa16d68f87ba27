#pragma once
/// \file
/// Impacts: from how two bodies meet at a point to the impulse between them and how they leave. Every law is
/// symmetric in the two bodies; a fixed one is a body that does not answer.

#include <goishi/impact/chatterjee_ruina.hpp>
#include <goishi/impact/stronge.hpp>
#include <goishi/published/impact_law.hpp>

namespace goishi {

/// An impact of a body on a fixed one.
template <class T>
struct Impact {
  Impulse<T> impulse;
  BodyVelocity<T> body;  // after
};

/// An impact of two bodies.
template <class T>
struct TwoBodyImpact {
  Impulse<T> impulse;     // on the first; the second gets the opposite
  BodyVelocity<T> first;  // after
  BodyVelocity<T> second;
};

namespace detail {

/// By a law that is not the default; in units in which no product leaves the range of T.
template <Ordered T>
[[nodiscard]] LawImpulse<T> other_impulse(ImpactLaw law, const Collision<T>& c) {
  const Units<T> units = units_of(c.W, c.v);
  const ContactMatrix<T> W = units.of(c.W);
  const Vec3<T> v = units.of(c.v);
  const Collision<T> met{W, v, c.n, c.restitution, c.friction};
  return units.back(law == ImpactLaw::published ? published(met) : stronge(met));
}

/// The answer to an impulse p, after which the contact moves with `after`.
template <Ordered T>
[[nodiscard]] inline Impulse<T> answer(const LawImpulse<T>& found, const Vec3<T>& n_W, const Vec3<T>& before,
                                       const Vec3<T>& after) {
  const Vec3<T>& p = found.p;  // and component by component: see vector.hpp
  return {.outcome = found.outcome,
          .impulse_W = {p.x(), p.y(), p.z()},
          .normal = formula::dot(p, n_W),
          .velocity_before = {before.x(), before.y(), before.z()},
          .velocity_after = {after.x(), after.y(), after.z()},
          .energy_change = formula::work(p, before, after),
          .rounds = found.rounds};
}

/// The impulse of a contact that meets with velocity v. `response(p)` is W p, `matrix()` W itself, which is made only
/// where friction needs it.
template <Ordered T, class Response, class Matrix>
[[nodiscard]] inline Impulse<T> impulse_of(ImpactLaw law, const Material<T>& material, const Vec3<T>& n_W,
                                           const Vec3<T>& v_W, const Response& response, const Matrix& matrix) {
  const T approach = formula::dot(v_W, n_W);
  if (!(approach < T(0))) {
    require_answer(approach);
    return answer({ImpactOutcome::separating, Vec3<T>(T(0), T(0), T(0)), 0}, n_W, v_W, v_W);
  }
  if (!(T(0) < material.friction)) {
    const Vec3<T> Wn = response(n_W);
    const T j = formula::normal_impulse(approach, formula::dot(n_W, Wn), material.restitution);
    require_answer(T(approach * j));
    return answer({ImpactOutcome::slid, formula::scaled(j, n_W), 1}, n_W, v_W, formula::plus(v_W, j, Wn));
  }
  if (law == ImpactLaw::chatterjee_ruina) [[likely]] {  // in line, so in registers: no address of W or v leaves
    const ContactMatrix<T> W = matrix();
    const LawImpulse<T> found = chatterjee_ruina<T>({W, v_W, n_W, material.restitution, material.friction});
    return answer(found, n_W, v_W, formula::plus(v_W, formula::product(W, found.p)));
  }
  const ContactMatrix<T> W = matrix();
  const Vec3<T> v(v_W.x(), v_W.y(), v_W.z());  // a copy, for the same reason
  const LawImpulse<T> found = other_impulse<T>(law, {W, v, n_W, material.restitution, material.friction});
  return answer(found, n_W, v, formula::plus(v, formula::product(W, found.p)));
}

/// Whether the default law needs no matrix: of one body, with friction, in units where no product leaves the range.
template <Ordered T>
[[nodiscard]] inline bool is_answered_by_parts(ImpactLaw law, const Collision<T, PointMatrix>& met) {
  return law == ImpactLaw::chatterjee_ruina && T(0) < met.friction && is_ordinary(met) &&
         least_ordinary<T>() < met.W.mobility.linear;
}

template <Ordered T>
[[nodiscard]] inline Impulse<T> answer_by_parts(const Collision<T, PointMatrix>& met) {
  const LawImpulse<T> found = chatterjee_ruina_ordinary(met);
  return answer(found, met.n, met.v, formula::plus(met.v, formula::product(met.W, found.p)));
}

/// Whether no impulse changes how a body moves.
template <Ordered T>
[[nodiscard]] inline bool is_fixed(const Mobility<T>& mobility) {
  return !(T(0) < mobility.linear) && !(T(0) < mobility.transverse) && !(T(0) < mobility.transverse + mobility.axial);
}

template <Ordered T>
inline void require_contact(ImpactLaw law, const Material<T>& material, const Vec3<T>& p_WC, const Vec3<T>& n_W) {
  require(is_law(law), "law", static_cast<int>(law), "must be one of the three");
  require_material(material);
  if (!(scalar::is_finite(T(p_WC.x() + p_WC.y() + p_WC.z())) && is_unit(n_W))) [[unlikely]] {
    require_point(p_WC, "contact point");
    require_direction(n_W);
  }
}

}  // namespace detail

/// A body meets a fixed one at p_WC; n_W, unit, points out of the fixed body.
///
/// Domain  one of the three laws; 0 <= e <= 1, 0 <= μ, infinity allowed; unit normal and axis, a mobility of `make_mobility`,
///         all finite, and the energy of the impact, too; else InvalidArgument. Of any size: DOMAIN-8. A contact that does not
///         approach gets no impulse (`ImpactOutcome::separating`).
/// Error   v_n⁺ + e v_n⁻ of chatterjee_ruina within 1e-14 of |v| (claim IMPACT-1). No law gains energy (IMPACT-4),
///         every impulse is in the friction cone (IMPACT-5). Beside Stronge's law: IMPACT-8.
/// Cost    chatterjee_ruina: one symmetric 3 × 3 solution, no allocation. Without friction, no matrix.
/// Proof   derivations/impact.cpp.
template <Ordered T>
[[nodiscard]] Impact<T> resolve(ImpactLaw law, const Material<T>& material, const Vec3<T>& p_WC, const Vec3<T>& n_W,
                                const ImpactBody<T>& body) {
  detail::require_contact(law, material, p_WC, n_W);
  detail::require_body(body);
  const Vec3<T> r = formula::minus(p_WC, body.p_WB), v = formula::point_velocity(body, r);
  const PointMatrix<T> W = formula::point_matrix(body.mobility, body.u_W, r);
  const detail::Collision<T, PointMatrix> met{W, v, n_W, material.restitution, material.friction};
  if (detail::is_answered_by_parts(law, met)) [[likely]] {
    const Impulse<T> impulse = detail::answer_by_parts(met);
    return {.impulse = impulse, .body = formula::pushed(body, r, impulse.impulse_W)};
  }
  Impact<T> result{
      .impulse = detail::impulse_of(
          law, material, n_W, v, [&](const Vec3<T>& p) { return formula::response(body.mobility, body.u_W, r, p); },
          [&] { return formula::contact_matrix(body.mobility, body.u_W, r); }),
      .body = formula::pushed(body, r, result.impulse.impulse_W)};
  return result;
}

/// Two bodies meet at p_WC; n_W, unit, points out of the second towards the first. Exchanging the bodies and turning
/// the normal round exchanges the results (claim IMPACT-2).
/// Domain  as above; at least one of the two answers to an impulse.
template <Ordered T>
[[nodiscard]] TwoBodyImpact<T> resolve(ImpactLaw law, const Material<T>& material, const Vec3<T>& p_WC,
                                       const Vec3<T>& n_W, const ImpactBody<T>& first, const ImpactBody<T>& second) {
  detail::require_contact(law, material, p_WC, n_W);
  detail::require_body(first);
  detail::require_body(second);
  require(T(0) < first.mobility.linear + second.mobility.linear, "mobility", second.mobility.linear,
          "must not be that of a fixed body for both");
  const Vec3<T> r1 = formula::minus(p_WC, first.p_WB), r2 = formula::minus(p_WC, second.p_WB);
  const Vec3<T> v = formula::minus(formula::point_velocity(first, r1), formula::point_velocity(second, r2));
  // Beside a fixed body, as one alone.
  const bool first_is_fixed = detail::is_fixed(first.mobility);
  const PointMatrix<T> W = first_is_fixed ? formula::point_matrix(second.mobility, second.u_W, r2)
                                          : formula::point_matrix(first.mobility, first.u_W, r1);
  const detail::Collision<T, PointMatrix> met{W, v, n_W, material.restitution, material.friction};
  const bool alone = first_is_fixed || detail::is_fixed(second.mobility);
  TwoBodyImpact<T> result;
  if (alone && detail::is_answered_by_parts(law, met)) {
    result.impulse = detail::answer_by_parts(met);
  } else {
    result.impulse = detail::impulse_of(
        law, material, n_W, v,
        [&](const Vec3<T>& p) {
          return formula::plus(formula::response(first.mobility, first.u_W, r1, p),
                               formula::response(second.mobility, second.u_W, r2, p));
        },
        [&] {
          return formula::sum(formula::contact_matrix(first.mobility, first.u_W, r1),
                              formula::contact_matrix(second.mobility, second.u_W, r2));
        });
  }
  result.first = formula::pushed(first, r1, result.impulse.impulse_W);
  result.second = formula::pushed(second, r2, formula::scaled(T(-1), result.impulse.impulse_W));
  return result;
}

}  // namespace goishi
