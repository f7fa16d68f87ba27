#pragma once
/// \file
/// A run of the suite: which claims, how, and what the report says about the machine.

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verify/suite/claim.hpp"

namespace goishi::verify {

/// Where and with what a run was made.
struct Stamp {
  std::string machine;   // processor, cores
  std::string system;    // operating system
  std::string compiler;  // with build type and flags
  std::string commit;    // of the source, "-dirty" when changed
  std::string time;      // UTC, ISO 8601
  std::uint64_t seed = 0;
  Tier tier = Tier::quick;
};

[[nodiscard]] Stamp make_stamp(std::uint64_t seed, Tier tier);

struct Run {
  Stamp stamp;
  std::vector<Result> results;  // in the order of the claims
  double seconds = 0.0;
  bool hangs = false;  // a claim took longer than its limit, and is still at it: the program has to end by _Exit

  [[nodiscard]] std::size_t failures() const;
};

/// How long a claim may take   [s]: more than ten times what the longest does on the machines that we know.
[[nodiscard]] constexpr double longest(Tier tier) {
  return tier == Tier::quick ? 60.0 : 300.0;
}

/// Measures and judges each claim, on `threads` threads. A claim that throws does not hold, nor one that takes longer than
/// `limit` seconds: it is left alone, and the others go on. `done` is called after each claim, from one thread at a time,
/// with the number of claims finished.
[[nodiscard]] Run run_claims(const std::vector<Claim>& claims, const Stamp& stamp, unsigned threads,
                             const std::function<void(const Result&, std::size_t)>& done, double limit);
[[nodiscard]] Run run_claims(const std::vector<Claim>& claims, const Stamp& stamp, unsigned threads,
                             const std::function<void(const Result&, std::size_t)>& done);

/// Whether an id matches a pattern of letters, `*` and `?`; several patterns are separated by commas.
[[nodiscard]] bool matches(std::string_view id, std::string_view patterns);

}  // namespace goishi::verify
