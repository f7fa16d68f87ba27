#pragma once
/// \file
/// What an impact law is told about the two surfaces, and what it answers.

#include <cstddef>
#include <goishi/error.hpp>
#include <goishi/impact/contact_matrix.hpp>
#include <limits>
#include <string_view>

namespace goishi {

/// Restitution e and Coulomb friction μ of a pair of surfaces. Made by `make_material`.
template <class T>
struct Material {
  T restitution = scalar::unset<T>();
  T friction = scalar::unset<T>();  // infinity is allowed
};

/// Throws InvalidArgument unless 0 <= e <= 1 and 0 <= μ, infinity allowed.
template <Ordered T>
void require_material(const Material<T>& material) {
  require(T(0) <= material.restitution && material.restitution <= T(1), "restitution", material.restitution,
          "must be from 0 to 1");
  require(T(0) <= material.friction, "friction", material.friction, "must be at least 0 (infinity is allowed)");
}

/// Domain  0 <= e <= 1, 0 <= μ, infinity allowed; else InvalidArgument.
template <Ordered T>
[[nodiscard]] Material<T> make_material(const T& restitution, const T& friction) {
  const Material<T> material{.restitution = restitution, .friction = friction};
  require_material(material);
  return material;
}

/// The same where one of the two, or both, are whole numbers (`scalar::promoted_t`).
template <class E, class F>
requires scalar::detail::AnyInteger<E, F>
[[nodiscard]] Material<scalar::promoted_t<E, F>> make_material(const E& restitution, const F& friction) {
  using T = scalar::promoted_t<E, F>;
  return make_material<T>(T(restitution), T(friction));
}

/// How an impulse is found from restitution and friction. Without friction all are the same: v_n⁺ = −e v_n⁻.
enum class ImpactLaw {
  chatterjee_ruina,  // the default: v_n⁺ = −e v_n⁻ exactly, closed form, energy cannot grow
  published,         // the talk's: normal impulse, then friction, again while the contact still approaches
  stronge            // energetic restitution, the impact integrated in its normal impulse: the reference
};

[[nodiscard]] constexpr bool is_law(ImpactLaw law) {
  return ImpactLaw::chatterjee_ruina <= law && law <= ImpactLaw::stronge;
}

[[nodiscard]] constexpr std::string_view to_string(ImpactLaw law) {
  constexpr std::string_view names[] = {"chatterjee_ruina", "published", "stronge"};
  return names[static_cast<std::size_t>(law)];
}

enum class ImpactOutcome {
  separating,    // the contact does not approach: no impulse
  stuck,         // friction stayed below its limit. stronge: no slip is left; chatterjee_ruina: only what the
                 // restitution's own impulse makes, e W p_I; published: none along the slip that friction met
  slid,          // friction reached its limit
  not_converged  // the law's cap was reached: the impulse is what it had by then
};

[[nodiscard]] constexpr std::string_view to_string(ImpactOutcome outcome) {
  constexpr std::string_view names[] = {"separating", "stuck", "slid", "not converged"};
  return names[static_cast<std::size_t>(outcome)];
}

/// What a law answers, on the first of two bodies; the second gets the opposite.
template <class T>
struct Impulse {
  ImpactOutcome outcome = ImpactOutcome::separating;
  Vec3<T> impulse_W = Vec3<T>::Zero();                              // [N s]
  T normal = T(0);                                                  // its part along the normal, >= 0
  Vec3<T> velocity_before = Vec3<T>::Constant(scalar::unset<T>());  // [m/s] of the contact points, first − second
  Vec3<T> velocity_after = Vec3<T>::Constant(scalar::unset<T>());
  T energy_change = T(0);  // [J] of both bodies
  int rounds = 0;          // normal-and-friction rounds, or steps of the integration
};

namespace detail {

/// A contact that approaches, as a law sees it: the bodies are gone.
template <class T, template <class> class Matrix = ContactMatrix>
struct Collision {
  const Matrix<T>& W;
  const Vec3<T>& v;  // of the contact points, first − second; v · n < 0
  const Vec3<T>& n;  // unit, out of the second towards the first
  T restitution;
  T friction;  // > 0
};

/// Products of five numbers from this one to its inverse are normal: 2^−k, k = 3/16 of T's exponents (double: 1e-57; float:
/// 1e-7). 0 where T is not built in: of those none has an end that matters.
template <Ordered T>
[[nodiscard]] constexpr T least_ordinary() {
  T result(std::floating_point<T> ? 1 : 0);
  if constexpr (std::floating_point<T>) {
    for (int i = 0; i < -3 * std::numeric_limits<T>::min_exponent / 16; ++i) {
      result = result / T(2);
    }
  }
  return result;
}

template <class T>
struct LawImpulse {
  ImpactOutcome outcome;
  Vec3<T> p;
  int rounds;
};

template <Ordered T>
[[noreturn, gnu::noinline, gnu::cold]] void throw_unanswerable(T energy) {
  throw_invalid("energy", energy, "must be a number that its type can hold: the contact is too fast");
}

/// A product that is finite only if the answer is.
template <Ordered T>
inline void require_answer(const T& energy) {
  if (!scalar::is_finite(energy)) [[unlikely]] {
    throw_unanswerable<T>(energy);
  }
}

/// Units of velocity and of W in which every law is the same, and no product on its way leaves T's range.
template <class T>
struct Units {
  T speed, trace;
  [[nodiscard]] ContactMatrix<T> of(const ContactMatrix<T>& W) const {
    return {T(W.xx / trace), T(W.yy / trace), T(W.zz / trace), T(W.xy / trace), T(W.xz / trace), T(W.yz / trace)};
  }
  [[nodiscard]] Vec3<T> of(const Vec3<T>& v) const { return {T(v.x() / speed), T(v.y() / speed), T(v.z() / speed)}; }
  [[nodiscard]] LawImpulse<T> back(const LawImpulse<T>& found) const {
    const Vec3<T> p = formula::scaled(T(speed / trace), found.p);
    // An eighth of the range is left for the energy, p · (v + v⁺)/2.
    require_answer(T(T(8) * speed * (scalar::abs(p.x()) + scalar::abs(p.y()) + scalar::abs(p.z()))));
    return {found.outcome, p, found.rounds};
  }
};

/// The greatest component of v, and the trace of W.
template <Ordered T>
[[nodiscard]] Units<T> units_of(const ContactMatrix<T>& W, const Vec3<T>& v) {
  return {.speed = v.cwiseAbs().maxCoeff(), .trace = T(W.xx + W.yy + W.zz)};
}

}  // namespace detail
}  // namespace goishi
