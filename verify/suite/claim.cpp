#include "verify/suite/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

std::string Claim::subject() const {
  return std::filesystem::path(source).parent_path().filename().string();
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
            .part = measured.error / check.bound,
            .why = fmt::format("the error {:.9g} {} is not within the bound {:.9g}", measured.error, check.unit,
                               check.bound)};
  }
  if (check.bound == 0.0) {
    return {.holds = true, .slack = 1.0};
  }
  const double slack = check.bound / std::max(measured.error, check.resolution);
  if (!(slack <= greatest_slack)) {
    return {.slack = slack,
            .part = measured.error / check.bound,
            .why = fmt::format("the bound {:.4g} {} is {:.3g} times what is measured and guards nothing", check.bound,
                               check.unit, slack)};
  }
  return {.holds = true, .slack = slack, .part = measured.error / check.bound};
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
  const auto weaker = [](const Judgement& a, const Judgement& b) {
    return a.holds != b.holds ? !a.holds : a.part > b.part;
  };
  return static_cast<std::size_t>(std::ranges::min_element(judgements, weaker) - judgements.begin());
}

}  // namespace goishi::verify
