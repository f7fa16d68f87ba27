#include "verify/suite/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goishi::verify {

std::string_view to_string(OracleFamily family) {
  switch (family) {
    case OracleFamily::proof:
      return "proof";
    case OracleFamily::exact:
      return "exact solution";
    case OracleFamily::invariant:
      return "invariant";
    case OracleFamily::relation:
      return "relation";
    case OracleFamily::quadrature:
      return "quadrature";
    case OracleFamily::integration:
      return "integration of the equations";
    case OracleFamily::brute_force:
      return "brute force";
    case OracleFamily::other_formula:
      return "another formula in more digits";
    case OracleFamily::rounding:
      return "rounding of the same formula";
    case OracleFamily::published:
      return "published numbers";
    case OracleFamily::regression:
      return "regression";
  }
  return "unknown";
}

std::string_view to_string(Tier tier) {
  return tier == Tier::quick ? "quick" : "full";
}

namespace {

/// FNV-1a: the same everywhere, unlike std::hash.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 14695981039346656037ULL;
  for (const char character : text) {
    value = (value ^ static_cast<unsigned char>(character)) * 1099511628211ULL;
  }
  return value;
}

}  // namespace

Context::Context(Tier tier, std::uint64_t seed, std::string_view claim_id, double perturbation)
    : tier_(tier), random_(hash(claim_id) ^ (seed * 0x9E3779B97F4A7C15ULL)), perturbation_(perturbation) {}

Judgement judge(const Check& check, const Measured& measured) {
  if (measured.cases == 0) {
    return {.why = "no case was compared"};
  }
  // Each condition is the one that must hold, negated: a NaN fails.
  if (!(measured.error <= check.bound)) {
    return {.slack = check.bound / measured.error,
            .why = fmt::format("the error {:.9g} {} is not within the bound {:.9g}", measured.error, check.unit,
                               check.bound)};
  }
  if (check.bound == 0.0) {
    return {.holds = true, .slack = 1.0};
  }
  const double slack = check.bound / std::max(measured.error, check.resolution);
  if (!(slack <= greatest_slack)) {
    return {.slack = slack,
            .why = fmt::format("the bound {:.4g} {} is {:.3g} times what is measured and guards nothing", check.bound,
                               check.unit, slack)};
  }
  return {.holds = true, .slack = slack};
}

Verdict judge(const Claim& claim, const Measurement& measurement) {
  Verdict verdict{.holds = true};
  const auto fail = [&](const std::string& check, const std::string& why) {
    if (verdict.holds) {
      verdict.why = check.empty() ? why : check + ": " + why;
    }
    verdict.holds = false;
  };
  for (const Check& check : claim.checks) {
    const auto found = std::ranges::find(measurement.checks, check.name, &Measured::check);
    verdict.measured.push_back(found == measurement.checks.end() ? Measured{.check = check.name} : *found);
    verdict.judgements.push_back(judge(check, verdict.measured.back()));
    if (!verdict.judgements.back().holds) {
      fail(check.name, verdict.judgements.back().why);
    }
  }
  if (claim.checks.empty()) {
    fail("", "it has no check");
  }
  for (const Measured& measured : measurement.checks) {
    if (std::ranges::find(claim.checks, measured.check, &Check::name) == claim.checks.end()) {
      fail(measured.check, "was measured, and is no check of the claim");
    }
  }
  return verdict;
}

std::size_t Verdict::weakest() const {
  // What fails; then what has an error, by its slack; what is exact, and holds, at the end.
  const auto rank = [this](std::size_t i) {
    const bool exact = measured[i].error == 0.0 && judgements[i].slack == 1.0;
    return std::pair(!judgements[i].holds ? 0 : exact ? 2 : 1, judgements[i].slack);
  };
  std::size_t weakest = 0;
  for (std::size_t i = 1; i < judgements.size(); ++i) {
    if (rank(i) < rank(weakest)) {
      weakest = i;
    }
  }
  return weakest;
}

}  // namespace goishi::verify
