#include <fmt/format.h>

#include <cmath>

#include "verify/report/escape.hpp"
#include "verify/report/groups.hpp"
#include "verify/report/number.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify {

namespace {

std::string seconds(double value) {
  return fmt::format("{:.6f}", std::isfinite(value) ? std::max(0.0, value) : 0.0);
}

std::string what_was_found(const Result& result) {
  const Claim& claim = *result.claim;
  std::string out =
      fmt::format("function: {}\noracle: {} ({})\n", claim.function, claim.oracle, to_string(claim.family));
  for (std::size_t i = 0; i < claim.checks.size(); ++i) {
    const auto& [check, measured, judgement, seen] = result.checked(i);
    const int digits = digits_to_tell(measured.error, check.bound, 6);
    out += fmt::format("{}error {} {}, bound {} ({}), slack {}\ncases: {}\nworst case: {}\n",
                       check.name.empty() ? "" : check.name + ": ", plain_number(measured.error, digits), check.unit,
                       plain_number(check.bound, digits), check.reason, plain_number(judgement.slack), measured.cases,
                       measured.worst_case);
  }
  return out;
}

std::string test_case(const Group& group, const Result& result) {
  std::string out =
      fmt::format("    <testcase classname=\"goishi.{}\" name=\"{}: {}\" time=\"{}\">\n", xml(group.prefix),
                  xml(result.claim->id), xml(result.claim->statement), seconds(result.seconds));
  const std::string found = xml(what_was_found(result));
  if (result.verdict.holds) {
    out += fmt::format("      <system-out>{}</system-out>\n", found);
  } else {
    out += fmt::format("      <failure type=\"claim\" message=\"{}\">{}</failure>\n", xml(result.verdict.why), found);
  }
  return out + "    </testcase>\n";
}

std::string test_suite(const Group& group, const Run& run) {
  std::size_t failed = 0;
  double time = 0;
  std::string cases;
  for (const Result* result : group.results) {
    failed += result->verdict.holds ? 0 : 1;
    time += result->seconds;
    cases += test_case(group, *result);
  }
  std::string stamp = run.stamp.time;  // without zone, as the schema of most readers wants it
  if (stamp.ends_with('Z')) {
    stamp.pop_back();
  }
  const auto property = [](std::string_view name, std::string_view value) {
    return fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, xml(value));
  };
  return fmt::format(
             "  <testsuite name=\"goishi.{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
             "skipped=\"0\" "
             "time=\"{}\" timestamp=\"{}\">\n    <properties>\n",
             xml(group.prefix), group.results.size(), failed, seconds(time), xml(stamp)) +
         property("seed", fmt::format("{}", run.stamp.seed)) + property("tier", to_string(run.stamp.tier)) +
         property("commit", run.stamp.commit) + property("compiler", run.stamp.compiler) +
         property("machine", run.stamp.machine) + property("system", run.stamp.system) + "    </properties>\n" + cases +
         "  </testsuite>\n";
}

}  // namespace

std::string junit_report(const Run& run) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"goishi-verify\" tests=\"{}\" "
      "failures=\"{}\" errors=\"0\" time=\"{}\">\n",
      run.results.size(), run.failures(), seconds(run.seconds));
  for (const Group& group : grouped_results(run)) {
    out += test_suite(group, run);
  }
  return out + "</testsuites>\n";
}

}  // namespace goishi::verify
