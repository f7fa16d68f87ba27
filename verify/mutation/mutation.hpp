#pragma once
/// \file
/// For `verify/mutants`, in its changed copy of the library: what can be wrong there asks here, while the program runs,
/// whether it is its turn. A change is 4 × place + 0, 1 or 2; `live(place)` is a place that no constant expression comes to.

#include <sys/resource.h>
#include <sys/time.h>

#include <concepts>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <type_traits>
#include <utility>

namespace goishi::mutant {

inline constexpr int most_places = 1 << 17;
inline constexpr int to_true = 0, to_false = 1, to_other = 2;  // of a condition
inline constexpr int sign = 0, size = 1;                       // of a term

/// What this run does, and what it comes to.
struct Run {
  int active = -1;
  std::uint64_t work = 0;                    // places passed: the same on every machine
  unsigned char stage = 1;                   // 1 before a unit, 2 in it
  unsigned char reached[most_places] = {};   // by stage
  unsigned char constant[most_places] = {};  // reached, and of a type that has no such change
};
inline Run run;

/// Writes the places reached, a line each: place, stages, whether there is something to change; and the work.
inline void write_reached() {
  if (const char* const file = std::getenv("GOISHI_MUTANT_REACHED")) {
    std::ofstream out(file);
    out << run.work << "\n";
    for (int place = 0; place < most_places; ++place) {
      if (run.reached[place] != 0 || run.constant[place] != 0) {
        out << place << " " << int(run.reached[place]) << "\n";
      }
    }
  }
}

/// Ends the program by SIGPROF once it has used so much of the processor's time from now on   [s].
inline void end_after(double seconds) {
  const auto whole = static_cast<time_t>(seconds);
  const itimerval timer{.it_interval = {0, 0},
                        .it_value = {whole, static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(whole)))}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

/// Before any other constructor asks. A program that takes too long, or grows without end, is stopped.
[[gnu::constructor(101)]] static void begin_run() {
  if (const char* const text = std::getenv("GOISHI_MUTANT")) {
    run.active = std::atoi(text);
    const rlimit memory{.rlim_cur = rlim_t(4) << 30, .rlim_max = rlim_t(4) << 30};
    setrlimit(RLIMIT_AS, &memory);
  }
  if (const char* const seconds = std::getenv("GOISHI_MUTANT_SECONDS")) {
    end_after(std::atof(seconds));
  }
  static bool begun = false;
  if (!begun) {
    begun = true;
    if (std::getenv("GOISHI_MUTANT_REACHED") != nullptr) {
      std::atexit(write_reached);
    }
  }
}

inline int live(int place) {
  return place;
}

constexpr bool makes(int place, int change) {
  return !std::is_constant_evaluated() && run.active == 4 * place + change;
}

/// A place with something to change is come to.
constexpr void reach(int place) {
  if (!std::is_constant_evaluated()) {
    run.reached[place] |= run.stage;
    ++run.work;
  }
}

/// One where this type has no such change.
constexpr void pass(int place) {
  if (!std::is_constant_evaluated()) {
    run.constant[place] = 1;
  }
}

template <class X>
concept Dense = requires {
  typename X::PlainObject;
  typename X::Scalar;
};
template <class X>
concept Quaternion = requires(const X& x) {
  x.coeffs();
  x.vec();
  x.conjugate();
};
/// A product or sum that multiprecision numbers have not worked out yet.
template <class X>
concept Pending = requires {
  typename X::result_type;
  typename X::left_type;
};

template <class X>
struct ValueOf {
  using type = X;
};
template <Dense X>
requires(!Quaternion<X>) struct ValueOf<X> {
  using type = typename X::PlainObject;
};
template <Pending X>
struct ValueOf<X> {
  using type = typename X::result_type;
};
/// What an operation gives, worked out.
template <class X>
using value_t = typename ValueOf<std::remove_cvref_t<X>>::type;

// --- formulas

/// A term's value; negative, or a thousandth too large, when it is this term's turn.
template <class X>
[[nodiscard]] constexpr decltype(auto) term(int place, X&& x) {
  using V = std::remove_cvref_t<X>;
  if constexpr (Quaternion<V>) {
    reach(place);
    V changed = x;
    if (makes(place, sign)) {
      changed.coeffs() = -x.coeffs();
    }
    if (makes(place, size)) {
      changed.coeffs() = x.coeffs() * typename V::Scalar(typename V::Scalar(1001) / typename V::Scalar(1000));
    }
    return changed;
  } else if constexpr (Dense<V>) {
    reach(place);
    using Plain = typename V::PlainObject;
    using T = typename V::Scalar;
    return makes(place, sign) ? Plain(-x) : makes(place, size) ? Plain(x * T(T(1001) / T(1000))) : Plain(x);
  } else if constexpr (!std::integral<V> && requires { value_t<V>(-x), value_t<V>(x * value_t<V>(1000)); }) {
    reach(place);
    using R = value_t<V>;
    return makes(place, sign) ? R(-x) : makes(place, size) ? R(R(x) * R(R(1001) / R(1000))) : R(x);
  } else {
    pass(place);
    if constexpr (std::is_lvalue_reference_v<X&&>) {
      return (x);
    } else {
      return V(std::move(x));
    }
  }
}

// --- numbers and names

/// A whole number of the source; the next one, or its negative, when it is its turn.
template <class N>
[[nodiscard]] constexpr N number(int place, N n) {
  reach(place);
  return makes(place, to_other) ? N(n + 1) : makes(place, sign) ? N(-n) : n;
}

/// The other, when it is its turn; of two types there is nothing to take.
template <class X, class Y>
[[nodiscard]] constexpr decltype(auto) pick(int place, X&& x, Y&& y) {
  if constexpr (std::same_as<X&&, Y&&> && std::is_lvalue_reference_v<X&&>) {
    reach(place);
    return makes(place, to_other) ? (y) : (x);
  } else if constexpr (std::same_as<X, Y> && std::is_enum_v<X>) {
    reach(place);
    return makes(place, to_other) ? X(y) : X(x);
  } else if constexpr (std::is_lvalue_reference_v<X&&>) {
    pass(place);
    return (x);
  } else {
    pass(place);
    return std::remove_cvref_t<X>(std::move(x));
  }
}

/// Whether a statement is left out.
[[nodiscard]] constexpr bool drop(int place) {
  reach(place);
  return makes(place, to_true);
}

// --- conditions

template <class R>
[[nodiscard]] constexpr R truth_value(int place, R is, R other) {
  return makes(place, to_true) ? R(true) : makes(place, to_false) ? R(false) : makes(place, to_other) ? other : is;
}

/// What is asked whether it is true.
template <class X>
[[nodiscard]] constexpr auto truth(int place, const X& x) {
  if constexpr (std::is_constructible_v<bool, const X&>) {
    reach(place);
    return truth_value<bool>(place, static_cast<bool>(x), !static_cast<bool>(x));
  } else if constexpr (std::is_constructible_v<X, bool>) {  // of a batch
    reach(place);
    return truth_value<X>(place, x, X(!x));
  } else {
    pass(place);
    return x;
  }
}

// --- operators: the one that is written, and the one that it becomes

// NOLINTBEGIN(bugprone-macro-parentheses)
#define GOISHI_MUTANT_RELATION(name, symbol, opposite)                                                 \
  template <class A, class B>                                                                          \
  [[nodiscard]] constexpr auto name(int place, const A& a, const B& b) {                               \
    using R = std::remove_cvref_t<decltype(a symbol b)>;                                               \
    if constexpr (std::is_constructible_v<R, bool> && requires { R(a opposite b); }) {                 \
      reach(place);                                                                                    \
      return makes(place, to_other) ? R(a opposite b) : truth_value<R>(place, a symbol b, a symbol b); \
    } else {                                                                                           \
      pass(place);                                                                                     \
      return a symbol b;                                                                               \
    }                                                                                                  \
  }
GOISHI_MUTANT_RELATION(less, <, <=)
GOISHI_MUTANT_RELATION(greater, >, >=)
GOISHI_MUTANT_RELATION(less_equal, <=, <)
GOISHI_MUTANT_RELATION(greater_equal, >=, >)
GOISHI_MUTANT_RELATION(equal, ==, !=)
GOISHI_MUTANT_RELATION(not_equal, !=, ==)
#undef GOISHI_MUTANT_RELATION

#define GOISHI_MUTANT_OPERATOR(name, symbol, other)                              \
  template <class A, class B>                                                    \
  [[nodiscard]] constexpr auto name(int place, const A& a, const B& b) {         \
    using R = value_t<decltype(a symbol b)>;                                     \
    if constexpr (Quaternion<A>) { /* turned the other way */                    \
      reach(place);                                                              \
      return makes(place, to_other) ? R(a.conjugate() symbol b) : R(a symbol b); \
    } else if constexpr (requires { R(a other b); }) {                           \
      reach(place);                                                              \
      return makes(place, to_other) ? R(a other b) : R(a symbol b);              \
    } else if constexpr (requires { R(b other a); }) {                           \
      reach(place);                                                              \
      return makes(place, to_other) ? R(b other a) : R(a symbol b);              \
    } else {                                                                     \
      pass(place);                                                               \
      return R(a symbol b);                                                      \
    }                                                                            \
  }
GOISHI_MUTANT_OPERATOR(plus, +, -)
GOISHI_MUTANT_OPERATOR(minus, -, +)
GOISHI_MUTANT_OPERATOR(times, *, /)
GOISHI_MUTANT_OPERATOR(divided, /, *)
GOISHI_MUTANT_OPERATOR(rest, %, *)
#undef GOISHI_MUTANT_OPERATOR
// NOLINTEND(bugprone-macro-parentheses)

template <class X>
[[nodiscard]] constexpr auto negated(int place, const X& x) {
  using R = value_t<decltype(-x)>;
  reach(place);
  return makes(place, to_other) ? R(x) : R(-x);
}

}  // namespace goishi::mutant
