/// The checkers themselves: what must fail fails, above all NaN.

#include <gtest/gtest.h>

#include <atomic>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <chrono>
#include <cmath>
#include <limits>

#include "tests/expectations.hpp"
#include "verify/suite/claim.hpp"
#include "verify/suite/run.hpp"
#include "verify/suite/ulps.hpp"

namespace {

using namespace goishi::verify;

using goishi::test::infinity;
using goishi::test::nan;

Claim claim_with(double bound, double resolution = 0.0) {
  return {.id = "TEST-1",
          .statement = "A claim.",
          .function = "none",
          .family = OracleFamily::exact,
          .oracle = "none",
          .checks = {{.unit = "ulp", .bound = bound, .reason = "none", .resolution = resolution}},
          .measure = {}};
}

Measurement measured(double error, std::uint64_t cases = 1) {
  return {.checks = {{.error = error, .cases = cases}}};
}

TEST(Judge, HoldsWithinTheBound) {
  const Verdict verdict = judge(claim_with(4.0), measured(2.0));
  EXPECT_TRUE(verdict.holds);
  EXPECT_EQ(verdict.judgements.at(0).slack, 2.0);
  EXPECT_TRUE(verdict.why.empty());
}

TEST(Judge, FailsAboveTheBound) {
  EXPECT_FALSE(judge(claim_with(4.0), measured(4.000001)).holds);
}

TEST(Judge, FailsOnNan) {
  EXPECT_FALSE(judge(claim_with(4.0), measured(nan)).holds);
  EXPECT_FALSE(judge(claim_with(nan), measured(1.0)).holds);
  EXPECT_FALSE(judge(claim_with(0.0), measured(nan)).holds);
}

TEST(Judge, FailsOnABoundThatGuardsNothing) {
  EXPECT_TRUE(judge(claim_with(100.0), measured(1.0)).holds);
  EXPECT_FALSE(judge(claim_with(100.1), measured(1.0)).holds);
  EXPECT_FALSE(judge(claim_with(4.0), measured(0.0)).holds);      // no resolution given: 0 is suspicious
  EXPECT_TRUE(judge(claim_with(4.0, 1.0), measured(0.0)).holds);  // less than one ulp counts as one
  EXPECT_FALSE(judge(claim_with(infinity), measured(1.0)).holds);
}

TEST(Judge, FailsWithoutCases) {
  EXPECT_FALSE(judge(claim_with(4.0), measured(1.0, 0)).holds);
}

TEST(Judge, ExactClaimsTakeZeroAndNothingElse) {
  EXPECT_TRUE(judge(claim_with(0.0), measured(0.0)).holds);
  EXPECT_FALSE(judge(claim_with(0.0), measured(std::numeric_limits<double>::denorm_min())).holds);
}

/// Two checks, by name.
Claim claim_of_two() {
  Claim claim = claim_with(4.0);
  claim.checks = {{.name = "place", .unit = "m", .bound = 4.0, .reason = "none"},
                  {.name = "time", .unit = "s", .bound = 100.0, .reason = "none"}};
  return claim;
}

TEST(Verdict, TheWeakestIsNearestToItsBound) {
  const auto of = [](double first, double second) {
    Verdict verdict;
    verdict.judgements = {
        judge(Check{.unit = "faults", .bound = 0.0, .reason = ""}, {.error = first, .cases = 1}),
        judge(Check{.unit = "m", .bound = 8.0, .reason = "", .resolution = 8.0}, {.error = second, .cases = 1})};
    return verdict.weakest();
  };
  EXPECT_EQ(of(0.0, 2.0), 1U);  // not what is exact; though by its resolution the slack is 1
  EXPECT_EQ(of(0.0, 0.0), 0U);
  EXPECT_EQ(of(1.0, 8.0), 0U);  // what fails
  EXPECT_EQ(of(0.0, 9.0), 1U);
}

TEST(Judge, EachCheckByItself) {
  const auto found = [](double place, double time) {
    return Measurement{
        .checks = {{.check = "time", .error = time, .cases = 1}, {.check = "place", .error = place, .cases = 1}}};
  };
  const Verdict good = judge(claim_of_two(), found(2.0, 80.0));
  EXPECT_TRUE(good.holds);
  EXPECT_EQ(good.judgements.at(0).slack, 2.0);
  EXPECT_EQ(good.judgements.at(1).slack, 1.25);
  EXPECT_EQ(good.weakest(), 1U);
  const Verdict loose = judge(claim_of_two(), found(2.0, 0.5));  // a bound that guards nothing, beside one that does
  EXPECT_FALSE(loose.holds);
  EXPECT_EQ(loose.weakest(), 1U);
  EXPECT_EQ(loose.why.find("time: "), 0U);
  EXPECT_FALSE(judge(claim_of_two(), found(nan, 80.0)).holds);
}

TEST(Judge, EveryCheckIsMeasuredAndNoOther) {
  Measurement half{.checks = {{.check = "place", .error = 2.0, .cases = 1}}};
  EXPECT_FALSE(judge(claim_of_two(), half).holds);
  half.checks.push_back({.check = "time", .error = 80.0, .cases = 1});
  EXPECT_TRUE(judge(claim_of_two(), half).holds);
  half.checks.push_back({.check = "tmie", .error = 0.0, .cases = 1});
  EXPECT_FALSE(judge(claim_of_two(), half).holds);
  Claim none = claim_with(1.0);
  none.checks.clear();
  EXPECT_FALSE(judge(none, {}).holds);
}

TEST(Checks, KeepsEachByItsName) {
  Checks checks;
  checks["place"].see(1.0, [] { return "a"; });
  Worst& time = checks["time"];
  checks["spin"].see(9.0, [] { return "b"; });
  time.see(70.0, [] { return "c"; });
  checks["place"].see(3.0, [] { return "d"; });
  const Measurement found = checks.measurement();
  ASSERT_EQ(found.checks.size(), 3U);
  EXPECT_EQ(found.checks[0].check, "place");
  EXPECT_EQ(found.checks[0].worst_case, "d");
  EXPECT_EQ(found.checks[1].error, 70.0);
}

TEST(Worst, KeepsTheWorstAndNan) {
  Worst worst;
  worst.see(1.0, [] { return "a"; });
  worst.see(3.0, [] { return "b"; });
  worst.see(2.0, [] { return "c"; });
  EXPECT_EQ(worst.measured().error, 3.0);
  EXPECT_EQ(worst.measured().worst_case, "b");
  worst.see(nan, [] { return "d"; });
  worst.see(4.0, [] { return "e"; });
  EXPECT_TRUE(std::isnan(worst.measured().error));
  EXPECT_EQ(worst.measured().worst_case, "d");
  EXPECT_EQ(worst.measured().cases, 5U);
}

/// An infinite allowance makes every error 0.
TEST(Worst, AnAllowanceGuardsSomething) {
  EXPECT_EQ(part_of(3.0, 2.0), 1.5);
  for (const double allowed : {infinity, -infinity, nan, 0.0, -1.0}) {
    EXPECT_TRUE(std::isnan(part_of(0.5, allowed))) << allowed;
    Worst worst;
    worst.see(0.5, 1.0, [] { return "a"; });
    worst.see(0.5, allowed, [] { return "b"; });
    EXPECT_TRUE(std::isnan(worst.error())) << allowed;
    EXPECT_EQ(worst.measured().worst_case, "b");
    EXPECT_FALSE(judge(claim_with(1.0, 0.1), worst.measurement()).holds);
  }
  Worst worst;
  worst.see(3.0, 2.0, [] { return "a"; });
  EXPECT_EQ(worst.error(), 1.5);
  worst.see(infinity, 2.0, [] { return "b"; });
  EXPECT_FALSE(judge(claim_with(10.0, 1.0), worst.measurement()).holds);
}

TEST(Worst, OfNothingIsNan) {
  EXPECT_TRUE(std::isnan(Worst().measured().error));
}

TEST(Ulps, CountsInTheGridOfTheResult) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  EXPECT_EQ(ulps(1.0, Wide(1)), 0.0);
  EXPECT_EQ(ulps(std::nextafter(1.0, 2.0), Wide(1)), 1.0);
  EXPECT_EQ(ulps(std::nextafter(1.0F, 2.0F), Wide(1)), 1.0);
  EXPECT_EQ(ulps(1.0, Wide(1) + Wide(std::numeric_limits<double>::epsilon()) / 4), 0.25);
  EXPECT_EQ(ulps(-3.0, Wide(-3) + Wide(std::numeric_limits<double>::epsilon())), 0.5);
}

TEST(Ulps, NanAndInfinityAreNan) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  EXPECT_TRUE(std::isnan(ulps(nan, Wide(1))));
  EXPECT_TRUE(std::isnan(ulps(infinity, Wide(1))));
  EXPECT_TRUE(std::isnan(ulps(1.0, Wide(nan))));
}

TEST(Matches, GlobsAndLists) {
  EXPECT_TRUE(matches("GSL-1", "*"));
  EXPECT_TRUE(matches("GSL-1", "GSL-*"));
  EXPECT_TRUE(matches("GSL-1", "MASS-*,GSL-?"));
  EXPECT_TRUE(matches("GSL-1", "GSL-1"));
  EXPECT_FALSE(matches("GSL-12", "GSL-?"));
  EXPECT_FALSE(matches("GSL-1", "gsl-1"));
  EXPECT_FALSE(matches("GSL-1", ""));
}

std::vector<Claim> three_claims() {
  std::vector<Claim> claims = {claim_with(1.0, 0.1), claim_with(1.0, 0.1), claim_with(1.0, 0.1)};
  claims[0].id = "A";
  claims[1].id = "B";
  claims[2].id = "C";
  claims[0].measure = [](Context& context) { return measured(context.uniform(0.2, 0.9)); };
  claims[1].measure = [](Context&) -> Measurement { throw std::runtime_error("no root found"); };
  claims[2].measure = [](Context& context) { return measured(context.produced(0.5)); };
  return claims;
}

TEST(Run, AClaimThatThrowsDoesNotHold) {
  const auto claims = three_claims();
  std::size_t finished = 0;
  const auto run =
      run_claims(claims, make_stamp(1, Tier::quick), 1, [&](const Result&, std::size_t count) { finished = count; });
  ASSERT_EQ(run.results.size(), 3U);
  EXPECT_EQ(finished, 3U);
  EXPECT_EQ(run.failures(), 1U);
  EXPECT_TRUE(run.results[0].verdict.holds);
  EXPECT_FALSE(run.results[1].verdict.holds);
  EXPECT_NE(run.results[1].verdict.why.find("no root found"), std::string::npos);
}

TEST(Run, IsTheSameForAnyNumberOfThreads) {
  const auto claims = three_claims();
  const auto error_of_first = [&](unsigned threads, std::uint64_t seed) {
    return run_claims(claims, make_stamp(seed, Tier::quick), threads, [](const Result&, std::size_t) {})
        .results[0]
        .measurement.checks.at(0)
        .error;
  };
  EXPECT_EQ(error_of_first(1, 7), error_of_first(3, 7));
  EXPECT_NE(error_of_first(1, 7), error_of_first(1, 8));
}

/// It is left alone, and the others are measured.
TEST(Run, AClaimThatHangsFails) {
  auto claims = three_claims();
  static std::atomic<bool> released = false;
  claims[1].measure = [](Context&) -> Measurement {
    while (!released) {
    }
    return measured(0.5);
  };
  const auto run = run_claims(
      claims, make_stamp(1, Tier::quick), 1, [](const Result&, std::size_t) {}, 0.1);
  released = true;
  EXPECT_TRUE(run.hangs);
  EXPECT_TRUE(run.results[0].verdict.holds);
  EXPECT_FALSE(run.results[1].verdict.holds);
  EXPECT_NE(run.results[1].verdict.why.find("longer than 0.1 s"), std::string::npos);
  EXPECT_TRUE(run.results[2].verdict.holds);
}

/// A check that nothing could make fail does not hold, in the full tier, unless it counts.
TEST(Run, ACheckSeesSomethingOrCounts) {
  Claim blind = claim_with(1.0, 0.1);
  blind.measure = [](Context&) { return measured(0.5); };
  Claim seeing = claim_with(1.0, 0.1);
  seeing.measure = [](Context& context) { return measured(std::abs(context.produced(1e6) - 1e6) + 0.5); };
  Claim counting = blind;
  counting.checks.front().counts = true;
  const std::vector<Claim> claims = {blind, seeing, counting};
  const auto full = run_claims(claims, make_stamp(1, Tier::full), 1, [](const Result&, std::size_t) {});
  EXPECT_FALSE(full.results[0].verdict.holds);
  EXPECT_TRUE(full.results[1].verdict.holds);
  EXPECT_EQ(full.results[1].verdict.seen.at(0), 6);
  EXPECT_TRUE(full.results[2].verdict.holds);
  EXPECT_EQ(run_claims(claims, make_stamp(1, Tier::quick), 1, [](const Result&, std::size_t) {}).failures(), 0U);
}

TEST(Context, PerturbsWhatIsProduced) {
  const Context exact(Tier::quick, 1, "A");
  const Context off(Tier::quick, 1, "A", 0.5);
  EXPECT_EQ(exact.produced(2.0), 2.0);
  EXPECT_EQ(off.produced(2.0), 3.0);
}

}  // namespace
