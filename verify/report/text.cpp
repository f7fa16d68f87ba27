#include <fmt/format.h>

#include <cmath>

#include "verify/report/escape.hpp"
#include "verify/report/groups.hpp"
#include "verify/report/number.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify {

namespace {

constexpr std::size_t terminal = 120;
constexpr std::size_t least_for_words = 40;

/// `head`, then the words in the columns beside it.
std::string hanging(const std::string& head, std::string_view words) {
  const std::size_t indent = columns(head);
  std::string out;
  for (const std::string& line :
       wrapped(printable(words), std::max(terminal - std::min(terminal, indent), least_for_words))) {
    out += out.empty() ? head : "\n" + std::string(indent, ' ');
    out += line;
  }
  return out;
}

/// "1.34e-15 ≤ 1e-13 relative", with as many digits as it takes to tell the two apart.
std::string comparison(const Checked& of) {
  const double error = of.measured.error, bound = of.check.bound;
  const int digits = digits_to_tell(error, bound);
  const char* const sign = error <= bound ? "≤" : error > bound ? ">" : "?";
  return fmt::format("{:>9} {} {:>5} {}", plain_number(error, digits), sign, plain_number(bound, digits),
                     printable(of.check.unit));
}

}  // namespace

std::string text_line(const Result& result) {
  const Claim& claim = *result.claim;
  const Checked weakest = result.weakest();
  const double slack = weakest.judgement.slack;
  const std::string head = fmt::format("{}  {} {} slack {:>5} {:>9.2f} s", result.verdict.holds ? "holds" : "FAILS",
                                       padded(printable(claim.id), 12), padded(comparison(weakest), 36),
                                       plain_number(slack, slack_digits(slack)), result.seconds);
  std::string out = head + "\n" + hanging("       ", claim.statement);
  if (1 < claim.checks.size()) {
    out += "\n" +
           hanging("       ", fmt::format("(the weakest of {} checks: {})", claim.checks.size(), weakest.check.name));
  }
  if (!result.verdict.holds) {
    const auto detail = [&](std::string_view name, std::string_view words) {
      out += "\n" + hanging(fmt::format("       {:<11} ", name), words);
    };
    detail("why", result.verdict.why);
    detail("function", claim.function);
    detail("oracle", fmt::format("{} ({})", claim.oracle, to_string(claim.family)));
    for (std::size_t i = 0; i < claim.checks.size(); ++i) {
      const Checked of = result.checked(i);
      if (!of.check.name.empty()) {
        detail(of.judgement.holds ? "check" : "FAILS", fmt::format("{}: {}", of.check.name, comparison(of)));
      }
      detail("bound from", of.check.reason);
      detail("cases", fmt::format("{}", of.measured.cases));
      if (!of.measured.worst_case.empty()) {
        detail("worst case", of.measured.worst_case);
      }
    }
    for (const Figure& figure : result.measurement.figures) {
      detail("", fmt::format("{}: {}", figure.name, figure.value));
    }
  }
  return out;
}

std::string text_summary(const Run& run) {
  const std::size_t failed = run.failures();
  std::string out = "\n";
  if (failed > 0) {
    for (const Result& result : run.results) {
      if (!result.verdict.holds) {
        out += hanging(fmt::format("FAILS  {} ", padded(printable(result.claim->id), 11)), result.verdict.why) + "\n";
      }
    }
  }
  const Stamp& stamp = run.stamp;
  out += fmt::format("{}: {} hold, {} failed; seed {}, tier {}, {}\n", verdict_line(run), run.results.size() - failed,
                     failed, stamp.seed, to_string(stamp.tier), duration(run.seconds));
  const auto about = [&](std::string_view name, const std::string& value) {
    out += hanging(fmt::format("{:<9} ", name), value) + "\n";
  };
  about("commit", stamp.commit);
  about("compiler", stamp.compiler);
  about("machine", fmt::format("{}; {}", stamp.machine, stamp.system));
  return out;
}

}  // namespace goishi::verify
