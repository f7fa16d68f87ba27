#pragma once
/// \file
/// Exact results in a document's sentences.

#include <string>
#include <string_view>
#include <vector>

#include "verify/certify/certify.hpp"
#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify::certify {

/// A piece of a sentence with {} for each number, and what the numbers stand for.
struct Sentence {
  std::string pattern;
  std::vector<Ball> exact;
};

/// What README.md states of exact results: inertia and mass of size 33, the bevel's minor radius, spins and tilts.
[[nodiscard]] std::vector<Sentence> exact_results();

/// Finds each sentence, however its lines are broken, and certifies its numbers; one that is missing is a fault.
void judge_sentences(std::string_view document, const std::vector<Sentence>& sentences, Outcome& outcome);

}  // namespace goishi::verify::certify
