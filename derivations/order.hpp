#pragma once
/// \file
/// The order of a time step: its series in Δt against the exact motion's, and the conditions on a composition.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "proof.hpp"
#include "relations.hpp"
#include "series.hpp"

namespace derivation {

/// A torque-free body at the start of a step: any attitude, momentum in B and inverse moments.
struct Start {
  Quaternion q = quaternion_letters("q");
  Vector l = letters("l");
  Vector J = positive_letters("J");
  Relations relations = Relations().unit(q);

  [[nodiscard]] Vector w() const { return J.cwiseProduct(l); }
  [[nodiscard]] Vector L_W() const { return relations(turned(q, l)); }
  [[nodiscard]] Vector w_W() const { return relations(turned(q, w())); }

  /// The coefficient of Δtᵏ is homogeneous of degree k in l, and in J, so that l₃ = J₃ = 1 decides for all (l₃ = 0 by
  /// continuity): with fewer symbols, and so faster.
  static Start in_own_units() {
    Start start;
    start.l.z() = 1;
    start.J.z() = 1;
    return start;
  }

  /// One of many, in numbers.
  static Start example() {
    return {.q = {ex(1) / 5, ex(2) / 5, ex(2) / 5, ex(4) / 5},
            .l = {ex(3) / 5, ex(-2) / 3, ex(7) / 4},
            .J = {1, ex(3) / 2, ex(5) / 2},
            .relations = {}};
  }
};

/// The exact momentum in B as a series: l' = l × J l (Euler).
inline std::vector<Vector> exact_momenta(const Start& start, int last_power) {
  std::vector<Vector> l = {start.l};
  for (int n = 0; n < last_power; ++n) {
    Vector rate = Vector::Zero();
    for (int k = 0; k <= n; ++k) {
      rate += l.at(n - k).cross(Vector(start.J.cwiseProduct(l.at(k))));
    }
    l.push_back(start.relations(Vector(rate / (n + 1))));
  }
  return l;
}

/// The exact attitude as a series: q' = ½ q (0, J l).
inline std::vector<Quaternion> exact(const Start& start, int last_power) {
  const std::vector<Vector> l = exact_momenta(start, last_power);
  std::vector<Quaternion> y = {{1, 0, 0, 0}};
  for (int n = 0; n < last_power; ++n) {
    Eigen::Matrix<ex, 4, 1> rate = Eigen::Matrix<ex, 4, 1>::Zero();
    for (int k = 0; k <= n; ++k) {
      const Vector w = start.J.cwiseProduct(l.at(k));
      rate += hamilton(y.at(n - k), pure(Vector(w / 2))).coeffs();
    }
    y.push_back(start.relations(Quaternion(rate / ex(n + 1))));
  }
  for (Quaternion& coefficient : y) {
    coefficient = start.relations(hamilton(start.q, coefficient));
  }
  return y;
}

/// Attitudes after one step, by power of Δt.
using Step = std::function<SeriesQuaternion(const Start&)>;

/// Proves that a step has the exact motion's coefficients up to the power `order`, and not that of the next.
inline void prove_order(Document& document, const std::string& scheme, int order, const Step& step,
                        const Start& start = {}) {
  const auto coefficients = [&](const Start& from, int last_power) {
    Series::last_power = static_cast<std::size_t>(last_power);
    Series::relations = from.relations;
    const SeriesQuaternion end = step(from);
    std::vector<ex> found;
    for (int n = 0; n <= last_power; ++n) {
      found.push_back(from.relations(components(coefficient(end, static_cast<std::size_t>(n)))));
    }
    return found;
  };
  const symbol power("h");
  ex result = 0;
  ex witness = 0;
  std::vector<ex> controls;
  const std::vector<ex> found = coefficients(start, order);
  const std::vector<Quaternion> path = exact(start, order);
  for (int n = 0; n <= order; ++n) {
    result += found.at(n) * pow(power, n);
    witness += components(path.at(n)) * pow(power, n);
  }
  for (int n = 0; n <= order; ++n) {
    controls.push_back(result + found.at(n) * pow(power, n) / 1000);
  }
  document.prove({.text = scheme + R"(: the coefficients of $\Delta t^0, \dots, \Delta t^)" + std::to_string(order) +
                          "$ are those of the exact motion",
                  .result = result,
                  .witness = witness,
                  .controls = controls});
  const Start example = Start::example();
  document.refute(R"(and that of $\Delta t^)" + std::to_string(order + 1) + "$ is not: order " + std::to_string(order),
                  coefficients(example, order + 1).back(), components(exact(example, order + 1).back()));
}

inline SeriesQuaternion normalised(const SeriesQuaternion& raw) {
  const Series over = Series(1) / sqrt(raw.squaredNorm());
  return SeriesQuaternion(over * raw.w(), over * raw.x(), over * raw.y(), over * raw.z());
}

// --- compositions

/// A polynomial in the letters Y₁, Y₃, Y₅ … that do not commute: the coefficient of each word. A word's degree is the
/// sum of its indices.
using Words = std::map<std::vector<int>, ex>;

inline int degree(const std::vector<int>& word) {
  return std::accumulate(word.begin(), word.end(), 0);
}

/// exp(γ Y₁ + γ³ Y₃ + γ⁵ Y₅ + …) up to a degree: a word of r letters has γ^degree / r!.
inline Words exponential(const ex& gamma, int last_degree) {
  Words words = {{{}, 1}};
  std::vector<std::vector<int>> level = {{}};
  for (int length = 1; length <= last_degree; ++length) {
    std::vector<std::vector<int>> longer;
    for (const std::vector<int>& word : level) {
      for (int letter = 1; letter + degree(word) <= last_degree; letter += 2) {
        longer.push_back(word);
        longer.back().push_back(letter);
        words[longer.back()] = pow(gamma, degree(longer.back())) / GiNaC::factorial(length);
      }
    }
    level = longer;
  }
  return words;
}

inline Words product(const Words& left, const Words& right, int last_degree) {
  Words words;
  for (const auto& [first, a] : left) {
    for (const auto& [second, b] : right) {
      if (degree(first) + degree(second) <= last_degree) {
        std::vector<int> word = first;
        word.insert(word.end(), second.begin(), second.end());
        words[word] += a * b;
      }
    }
  }
  return words;
}

/// By how much the composition of steps with these substeps misses exp(Y₁), the exact flow: the largest defect of a
/// word's coefficient, of the words of a degree from `first_degree` to `last_degree`. Exact for exact numbers.
inline ex largest_defect(const std::vector<ex>& substeps, int first_degree, int last_degree) {
  Words words = {{{}, 1}};
  for (const ex& gamma : substeps) {
    words = product(words, exponential(gamma, last_degree), last_degree);
  }
  ex largest = 0;
  for (const auto& [word, coefficient] : words) {
    const bool only_ones = std::all_of(word.begin(), word.end(), [](int letter) { return letter == 1; });
    const ex wanted = only_ones ? 1 / GiNaC::factorial(static_cast<int>(word.size())) : ex(0);
    const ex defect = GiNaC::abs(coefficient - wanted);
    if (first_degree <= degree(word) && (defect - largest).info(GiNaC::info_flags::positive)) {
      largest = defect;
    }
  }
  return largest;
}

}  // namespace derivation
