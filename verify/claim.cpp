#include "verify/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace goishi::verify {

std::string_view to_string(OracleFamily family) {
  switch (family) {
    case OracleFamily::exact:
      return "exact solution";
    case OracleFamily::invariant:
      return "invariant";
    case OracleFamily::metamorphic:
      return "metamorphic relation";
    case OracleFamily::independent:
      return "independent computation";
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

Verdict judge(const Claim& claim, const Measurement& measurement) {
  if (measurement.cases == 0) {
    return {.holds = false, .slack = 0.0, .why = "no case was compared"};
  }
  // Each condition is the one that must hold, negated: a NaN fails.
  if (!(measurement.error <= claim.bound)) {
    return {.holds = false,
            .slack = claim.bound / measurement.error,
            .why = fmt::format("the error {:.9g} {} is not within the bound {:.9g}", measurement.error, claim.unit,
                               claim.bound)};
  }
  if (claim.bound == 0.0) {
    return {.holds = true, .slack = 1.0, .why = {}};
  }
  const double slack = claim.bound / std::max(measurement.error, claim.resolution);
  if (!(slack <= greatest_slack)) {
    return {.holds = false,
            .slack = slack,
            .why = fmt::format("the bound {:.4g} {} is {:.3g} times what is measured and guards nothing", claim.bound,
                               claim.unit, slack)};
  }
  return {.holds = true, .slack = slack, .why = {}};
}

}  // namespace goishi::verify
