#pragma once
/// \file
/// For `derivations/mutants`, included first in every proof program of its changed copy of the source: a term or a number
/// of a shipped formula asks here, while the program runs, whether it is to be wrong.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <type_traits>
#include <vector>

namespace goishi::mutant {

/// Which change this run makes, from the environment: 2 × place for a sign or a number, 2 × place + 1 for a size, none if
/// unset. And, on request, which places it comes to.
class Run {
 public:
  [[nodiscard]] bool makes(int place, int change) {
    if (reached_file_ != nullptr) {
      const std::size_t at = static_cast<std::size_t>(place);
      reached_.resize(std::max(reached_.size(), at + 1));
      reached_[at] = true;
    }
    return active_ == 2 * place + change;
  }
  ~Run() {
    if (reached_file_ != nullptr) {
      std::ofstream out(reached_file_);
      for (std::size_t place = 0; place < reached_.size(); ++place) {
        if (reached_[place]) {
          out << place << "\n";
        }
      }
    }
  }

 private:
  static int number(const char* text) { return text == nullptr ? -1 : std::atoi(text); }

  int active_ = number(std::getenv("GOISHI_MUTANT"));
  const char* reached_file_ = std::getenv("GOISHI_MUTANT_REACHED");
  std::vector<bool> reached_;
};

inline bool makes(int place, int change) {
  static Run run;
  return run.makes(place, change);
}

template <class X>
concept Dense = requires {
  typename X::PlainObject;
};
template <class X>
concept Quaternion = requires(const X& x) {
  x.coeffs(), x.vec();
};

/// A term's value; negative, or a thousandth too large (twice, if it counts), when it is this term's turn.
template <class X>
[[nodiscard]] constexpr auto term(int place, const X& x) {
  if constexpr (Quaternion<X>) {
    return X(term(place, x.coeffs()));
  } else if constexpr (Dense<X>) {
    using Plain = typename X::PlainObject;
    using T = typename X::Scalar;
    return makes(place, 0) ? Plain(-x) : makes(place, 1) ? Plain(x * T(T(1001) / T(1000))) : Plain(x);
  } else if (std::is_constant_evaluated()) {
    return x;
  } else if constexpr (std::integral<X>) {
    return makes(place, 0) ? X(-x) : makes(place, 1) ? X(2 * x) : x;
  } else {
    return makes(place, 0) ? X(-x) : makes(place, 1) ? X(x * X(X(1001) / X(1000))) : x;
  }
}

/// A number of a formula; the next one, when it is its turn.
[[nodiscard]] constexpr int number(int place, int n) {
  return !std::is_constant_evaluated() && makes(place, 0) ? n + 1 : n;
}

}  // namespace goishi::mutant
