#pragma once
/// \file
/// The order of a Runge–Kutta method for every system y' = f(y), by Butcher's rooted trees.

#include <cstddef>
#include <numeric>
#include <vector>

#include "algebra.hpp"

namespace derivation {

/// A rooted tree. In an additive method, f = f₀ + f₁ + …, each vertex has the colour of its part of f; the root, whose
/// weights are the same for all, counts without.
struct Tree {
  std::size_t colour = 0;
  std::vector<Tree> branches = {};

  [[nodiscard]] int order() const {
    return std::accumulate(branches.begin(), branches.end(), 1,
                           [](int sum, const Tree& branch) { return sum + branch.order(); });
  }
  /// The condition of its weight is 1/γ.
  [[nodiscard]] int density() const {
    return std::accumulate(branches.begin(), branches.end(), order(),
                           [](int product, const Tree& branch) { return product * branch.density(); });
  }
};

/// All trees of an order with roots of colour 0. `smaller` are all trees with any root of lower orders.
inline std::vector<Tree> trees_of(int order, const std::vector<Tree>& smaller, std::size_t from = 0) {
  if (order == 1) {
    return {Tree{}};
  }
  std::vector<Tree> found;
  for (std::size_t i = from; i < smaller.size() && smaller[i].order() < order; ++i) {
    for (Tree tree : trees_of(order - smaller[i].order(), smaller, i)) {
      tree.branches.push_back(smaller[i]);
      found.push_back(tree);
    }
  }
  return found;
}

/// All trees up to an order, lower orders first.
inline std::vector<Tree> trees(int last_order, std::size_t colours) {
  std::vector<Tree> coloured, uncoloured;
  for (int order = 1; order <= last_order; ++order) {
    const std::vector<Tree> next = trees_of(order, coloured);
    uncoloured.insert(uncoloured.end(), next.begin(), next.end());
    for (const Tree& tree : next) {
      for (std::size_t colour = 0; colour < colours; ++colour) {
        coloured.push_back({colour, tree.branches});
      }
    }
  }
  return uncoloured;
}

using Row = std::vector<ex>;
using Tableau = std::vector<Row>;

/// By how much the weights miss a tree's condition.
inline ex defect(const Tree& tree, const std::vector<Tableau>& parts, const Row& weights) {
  struct Stages {
    const std::vector<Tableau>& given;
    Row operator()(const Tree& of, std::size_t count) const {
      Row product(count, 1);
      for (const Tree& branch : of.branches) {
        const Row inner = (*this)(branch, count);
        for (std::size_t i = 0; i < count; ++i) {
          const Row& row = given.at(branch.colour).at(i);
          product[i] *= std::inner_product(row.begin(), row.end(), inner.begin(), ex(0));
        }
      }
      return product;
    }
  };
  const Row stages = Stages{parts}(tree, weights.size());
  return std::inner_product(weights.begin(), weights.end(), stages.begin(), ex(0)) - ex(1) / tree.density();
}

/// The largest defect of the conditions of an order. Exact for exact numbers.
inline ex largest_defect(int first_order, int last_order, const std::vector<Tableau>& parts, const Row& weights) {
  ex largest = 0;
  for (const Tree& tree : trees(last_order, parts.size())) {
    const ex size = GiNaC::abs(defect(tree, parts, weights));
    if (first_order <= tree.order() && (size - largest).info(GiNaC::info_flags::positive)) {
      largest = size;
    }
  }
  return largest;
}

}  // namespace derivation
