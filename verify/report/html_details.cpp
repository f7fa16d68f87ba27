#include <fmt/format.h>

#include "verify/report/escape.hpp"
#include "verify/report/groups.hpp"
#include "verify/report/html.hpp"
#include "verify/report/number.hpp"
#include "verify/report/svg.hpp"

namespace goishi::verify::page {

namespace {

std::string entry(std::string_view name, const std::string& xhtml) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, xhtml);
}

/// Terms and what they stand for.
std::string facts(const Result& result) {
  const Claim& claim = *result.claim;
  std::string out = "<dl class=\"facts\">\n";
  if (!result.verdict.holds) {
    out += entry("Why not", fmt::format("<strong class=\"bad\">{}</strong>", xml(result.verdict.why)));
  }
  out += entry("Function", fmt::format("<code>{}</code>", xml(claim.function)));
  out +=
      entry("Oracle", fmt::format("{} <span class=\"family\">{}</span>", xml(claim.oracle), to_string(claim.family)));
  out += entry("Took", duration(result.seconds));
  return out + "</dl>\n";
}

/// One check, by terms.
std::string check(const Checked& of) {
  const Judged shown = judged(of);
  std::string out =
      of.check.name.empty() ? "" : fmt::format("<h4>{} {}</h4>\n", mark(of.judgement.holds), xml(of.check.name));
  out += "<dl class=\"facts\">\n";
  if (!of.judgement.holds) {
    out += entry("Why not", fmt::format("<strong class=\"bad\">{}</strong>", xml(of.judgement.why)));
  }
  out += entry("Error", shown.error);
  out += entry("Bound", fmt::format("{}<br/><span class=\"reason\">{}</span>", shown.bound, xml(of.check.reason)));
  out += entry("Slack", fmt::format("{} {}", shown.slack, slack_bar(of.judgement)));
  if (of.check.resolution > 0) {
    out += entry("Resolution", fmt::format("{} {}", html_number(of.check.resolution), xml(of.check.unit)));
  }
  if (of.seen != 0) {
    out += entry("Sees", fmt::format("values that are off by 10<sup>−{}</sup> of themselves", of.seen));
  } else if (of.check.counts) {
    out += entry("Sees", "what it counts: no value is compared");
  }
  out += entry("Cases", grouped(of.measured.cases));
  if (!of.measured.worst_case.empty() && of.measured.error != 0) {
    out += entry("Worst case", fmt::format("<code>{}</code>", xml(of.measured.worst_case)));
  }
  return out + "</dl>\n";
}

std::string checks(const Result& result) {
  std::string out;
  for (std::size_t i = 0; i < result.claim->checks.size(); ++i) {
    out += check(result.checked(i));
  }
  return out;
}

std::string figures(const Measurement& measurement) {
  if (measurement.figures.empty()) {
    return "";
  }
  std::string out = "<table class=\"figures\">\n<caption>Figures</caption>\n<tbody>\n";
  for (const Figure& figure : measurement.figures) {
    out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", xml(figure.name), xml(figure.value));
  }
  return out + "</tbody>\n</table>\n";
}

std::string plots(const Measurement& measurement) {
  std::string out;
  for (const Plot& plot : measurement.plots) {
    out += "<figure>\n" + svg_plot(plot) + "</figure>\n";
  }
  return out.empty() ? "" : "<div class=\"plots\">\n" + out + "</div>\n";
}

std::string detail(const Result& result) {
  const Claim& claim = *result.claim;
  return fmt::format(
             "<article class=\"claim\" id=\"{0}\">\n<h3>{1} {2} "
             "<a class=\"up\" href=\"#overview\">overview</a></h3>\n"
             "<p class=\"statement\">{3}</p>\n",
             anchor(claim.id), mark(result.verdict.holds), xml(claim.id), xml(claim.statement)) +
         facts(result) + checks(result) + figures(result.measurement) + plots(result.measurement) + "</article>\n";
}

}  // namespace

std::string details(const Run& run) {
  std::string out;
  for (const Group& group : grouped_results(run)) {
    out += fmt::format("<section>\n<h2>{}</h2>\n", xml(group.title));
    for (const Result* result : group.results) {
      out += detail(*result);
    }
    out += "</section>\n";
  }
  return out;
}

}  // namespace goishi::verify::page
