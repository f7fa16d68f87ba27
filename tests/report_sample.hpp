#pragma once
/// \file
/// A run with made-up claims, for the tests of the report: good, bad and hostile ones.

#include <deque>
#include <limits>
#include <string>

#include "verify/suite/run.hpp"

namespace goishi::verify {

inline const std::string nasty = "<&>\"' ]]> \x01\x1b[31m λ碁\xff\xc0\x80 end";

/// A run of made-up claims, judged as a real one.
struct Sample {
  std::deque<Claim> claims;
  Run run;

  Sample() {
    run.stamp = {"a processor, 2 threads",
                 "a system",
                 "a compiler, Release, -O3",
                 "0123456789abcdef-dirty",
                 "2025-05-04T10:11:12Z",
                 18446744073709551615ULL,
                 Tier::full};
    run.seconds = 12.345;
  }
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;

  Result& add(const std::string& id, double error, double bound, OracleFamily family = OracleFamily::brute_force) {
    claims.push_back({id,
                      "The volume is right.",
                      "volume",
                      family,
                      "an oracle",
                      {{.unit = "ulp", .bound = bound, .reason = "derived from six roundings", .resolution = 1.0}},
                      {}});
    Result result;
    result.claim = &claims.back();
    result.measurement.checks = {{.error = error, .cases = 12345, .worst_case = "w = 0x1.8p-6"}};
    result.verdict = judge(claims.back(), result.measurement);
    result.seconds = 0.25;
    run.results.push_back(result);
    return run.results.back();
  }
};

inline void fill(Sample& sample) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  sample.add("SHAPE-1", 1.25, 4);
  Result& curves = sample.add("MASS-1", 2.5, 4);
  curves.measurement.figures = {{"volume", "1.8505405 cm³"}};
  curves.measurement.plots = {
      {"Error",
       "h/w",
       "error [ulp]",
       true,
       false,
       false,
       {{"sharp", {{1e-9, 1}, {1e-3, 2.5}, {1, 0.5}, {0, 1}}, true}, {nasty, {{1e-8, nan}, {1, 2}}, false}}}};
  sample.add("MASS-2", 4.0004, 4);
  sample.add("LAW-1", nan, 4);
  sample.add("LAW-2", infinity, 4);
  sample.add("LAW-3", 0, 400);
  sample.claims.push_back({nasty,
                           nasty,
                           nasty,
                           OracleFamily::exact,
                           nasty,
                           {{.name = nasty, .unit = nasty, .bound = 4, .reason = nasty, .resolution = 1},
                            {.name = "other", .unit = "", .bound = 0, .reason = "none", .counts = true}},
                           {}});
  Result hostile = sample.run.results.front();
  hostile.claim = &sample.claims.back();
  hostile.measurement.checks = {{.check = nasty, .error = 1, .cases = 1, .worst_case = nasty},
                                {.check = "other", .error = 0, .cases = 7}};
  hostile.measurement.figures = {{nasty, nasty}};
  hostile.verdict = judge(sample.claims.back(), hostile.measurement);
  hostile.verdict.holds = hostile.verdict.judgements.front().holds = false;
  hostile.verdict.why = hostile.verdict.judgements.front().why = nasty;
  hostile.verdict.seen = {9, 0};
  sample.run.results.push_back(hostile);
}

}  // namespace goishi::verify
