#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/report/escape.hpp"
#include "verify/report/groups.hpp"
#include "verify/report/html.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::page {

std::string mark(bool holds) {
  return holds ? "<span class=\"mark good\" role=\"img\" aria-label=\"holds\">✓</span>"
               : "<span class=\"mark bad\" role=\"img\" aria-label=\"does not hold\">✗</span>";
}

Judged judged(const Checked& of) {
  const double error = of.measured.error;
  const double bound = of.check.bound;
  const int digits = digits_to_tell(error, bound);
  const std::string unit =
      of.check.unit.empty() ? "" : fmt::format(" <span class=\"unit\">{}</span>", xml(of.check.unit));
  const double slack = of.judgement.slack;
  return {html_number(error, digits), html_number(bound, digits) + unit,
          std::isnan(slack) ? "–" : html_number(slack, slack_digits(slack))};
}

std::string slack_bar(const Judgement& judgement) {
  constexpr double length = 72;
  const double slack = judgement.slack;
  const double part = slack > 1 ? std::min(1.0, std::log(slack) / std::log(greatest_slack)) : 0.0;
  std::string out = fmt::format(
      "<svg class=\"bar {}\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} 6\" "
      "width=\"{}\" "
      "height=\"6\" aria-hidden=\"true\"><rect class=\"track\" width=\"{}\" height=\"6\" "
      "rx=\"3\"/>",
      judgement.holds ? "good" : "bad", length, length, length);
  out += fmt::format("<rect class=\"fill\" width=\"{:.1f}\" height=\"6\" rx=\"3\"/>", std::max(3.0, part * length));
  return out + "</svg>";
}

std::string stamp(const Stamp& stamp, double seconds, Seed seed) {
  std::string out = "<ul class=\"stamp\">\n";
  const auto entry = [&](std::string_view name, std::string_view value) {
    out += fmt::format("<li><span>{}</span> {}</li>\n", name, xml(value));
  };
  entry("Commit", stamp.commit);
  entry("Time", stamp.time);
  if (seed == Seed::shown) {
    entry("Seed", fmt::format("{}", stamp.seed));
  }
  entry("Tier", to_string(stamp.tier));
  entry("Took", duration(seconds));
  entry("Machine", stamp.machine);
  entry("System", stamp.system);
  entry("Compiler", stamp.compiler);
  return out + "</ul>\n";
}

std::string failures(const Run& run) {
  if (run.failures() == 0) {
    return "";
  }
  std::string out = "<ul class=\"failures\">\n";
  for (const Result& result : run.results) {
    if (!result.verdict.holds) {
      out += fmt::format("<li><a href=\"#{}\">{}</a> {}</li>\n", anchor(result.claim->id), xml(result.claim->id),
                         xml(result.verdict.why));
    }
  }
  return out + "</ul>\n";
}

std::string how_to_read(const Run& run, const Pages& pages) {
  const auto paragraph = [](const std::string& address, std::string_view before, std::string_view name) {
    return address.empty() ? "" : fmt::format("\n<p>{} <a href=\"{}\">{}</a>.</p>", before, xml(address), name);
  };
  const std::string others =
      paragraph(pages.derivations,
                "The claims measure. That the formulas are right for all values is proved:", "the derivations") +
      paragraph(pages.changes,
                "The library was changed, one place at a time, to see who notices:", "what the suite catches") +
      paragraph(pages.in_browser, "To see it move:", "the library in a browser");
  const auto of_family = [&run](OracleFamily family) {
    return std::ranges::count_if(run.results,
                                 [family](const Result& result) { return result.claim->family == family; });
  };
  return fmt::format(
      "<section class=\"how\">\n<h2>How to read this</h2>\n"
      "<p>Each claim is a sentence about the library, judged by an oracle: a witness. Of {2} of the {3} claims the "
      "witness is the same formula in more digits: they judge its rounding and its range, others that it is right. Of "
      "{4} it is the same function in another world. The others share no formula with what they judge. <b>Error</b> is "
      "the worst difference that was found. <b>Bound</b> is the "
      "greatest error with which a check still holds, and each bound has a reason. <b>Slack</b> is bound over error, "
      "and an error below the resolution of the quantity counts as that resolution: at 1 the error reaches the bound, "
      "and over {0} the bound guards nothing, so that the check fails. An error that is not a number fails. In the "
      "full tier each check also says how small an error of the values it still sees; one that sees none fails, "
      "unless it says that it counts. A claim of several checks holds if each does, and is shown by its weakest, the "
      "one whose error comes nearest to its bound. The bar shows the slack from 1 to {0} on a logarithmic scale. Each "
      "id leads to the details.</p>{1}\n</section>\n",
      plain_number(greatest_slack), others, of_family(OracleFamily::rounding), run.results.size(),
      of_family(OracleFamily::relation));
}

namespace {

std::string row(const Result& result) {
  const Claim& claim = *result.claim;
  const Checked weakest = result.weakest();
  const Judged shown = judged(weakest);
  const std::string check = claim.checks.size() < 2
                                ? ""
                                : fmt::format(" <span class=\"check\">Weakest of {} checks: {}.</span>",
                                              claim.checks.size(), xml(weakest.check.name));
  return fmt::format(
      "<tr{}>\n<td class=\"verdict-mark\">{}</td>\n"
      "<th scope=\"row\"><a href=\"#{}\">{}</a></th>\n<td class=\"statement\">{}</td>\n"
      "<td class=\"number\" data-label=\"error\">{}</td>\n"
      "<td class=\"number\" data-label=\"bound\">{}</td>\n"
      "<td class=\"number\" data-label=\"slack\">{} {}</td>\n"
      "<td class=\"number time\" data-label=\"time\">{}</td>\n</tr>\n",
      result.verdict.holds ? "" : " class=\"failed\"", mark(result.verdict.holds), anchor(claim.id), xml(claim.id),
      xml(claim.statement) + check, shown.error, shown.bound, shown.slack, slack_bar(weakest.judgement),
      duration(result.seconds));
}

}  // namespace

std::string overview(const Run& run) {
  if (run.results.empty()) {
    return "";
  }
  std::string out =
      "<section>\n<h2 id=\"overview\">Overview</h2>\n<table class=\"overview\">\n<thead>\n<tr>"
      "<th scope=\"col\"><span class=\"heard\">Verdict</span></th><th scope=\"col\">Claim</th>"
      "<th scope=\"col\">Statement</th><th scope=\"col\" class=\"number\">Error</th>"
      "<th scope=\"col\" class=\"number\">Bound</th><th scope=\"col\" class=\"number\">Slack</th>"
      "<th scope=\"col\" class=\"number\">Time</th></tr>\n</thead>\n";
  for (const Group& group : grouped_results(run)) {
    const auto holding = std::count_if(group.results.begin(), group.results.end(),
                                       [](const Result* result) { return result->verdict.holds; });
    out += fmt::format(
        "<tbody>\n<tr class=\"group\"><th colspan=\"7\" scope=\"colgroup\">{} "
        "<span>{} of {} hold</span></th></tr>\n",
        xml(group.title), holding, group.results.size());
    for (const Result* result : group.results) {
      out += row(*result);
    }
    out += "</tbody>\n";
  }
  return out + "</table>\n</section>\n";
}

}  // namespace goishi::verify::page
