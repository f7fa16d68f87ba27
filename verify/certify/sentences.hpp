#pragma once
/// \file
/// Exact results in a document's sentences.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verify/certify/certify.hpp"
#include "verify/oracles/numbers/ball.hpp"

namespace goishi::verify::certify {

/// A piece of a sentence with {} for each number, and what the numbers stand for.
struct Sentence {
  std::string document;  // where it must stand, below the root of the source tree
  std::string pattern;
  std::vector<Ball> exact;
};

/// The documents that state exact results, the longest path first.
inline constexpr std::array<std::string_view, 3> documents = {"verify/claims/published/README.md",
                                                              "src/goishi/README.md", "README.md"};

/// Which of them a file is, by the end of its path; any other is a README.md.
[[nodiscard]] std::string_view document_of(const std::filesystem::path& file);

/// What a document states of exact results: inertia and mass of size 33, the bevel's minor radius, spins and tilts.
[[nodiscard]] std::vector<Sentence> exact_results(std::string_view document);

/// Finds each sentence, however its lines are broken, and certifies its numbers; one that is missing is a fault.
void judge_sentences(std::string_view document, const std::vector<Sentence>& sentences, Outcome& outcome);

}  // namespace goishi::verify::certify
