#include <fmt/format.h>

#include "verify/report/escape.hpp"
#include "verify/report/groups.hpp"
#include "verify/report/html.hpp"
#include "verify/report/report.hpp"
#include "verify/report/svg.hpp"

namespace goishi::verify {

namespace {

/// A white and a black stone in profile.
constexpr std::string_view emblem =
    "<svg class=\"emblem\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 50 46\" width=\"50\" "
    "height=\"46\" role=\"presentation\">"
    "<path d=\"M3 34q0-1 1-1.6a35 35 0 0 1 42 0q1 .6 1 1.6t-1 1.6a35 35 0 0 1-42 0q-1-.6-1-1.6z\" "
    "class=\"slate\" stroke=\"currentColor\" stroke-width=\"1.5\"/>"
    "<path d=\"M3 15q0-1 1-1.6a35 35 0 0 1 42 0q1 .6 1 1.6t-1 1.6a35 35 0 0 1-42 0q-1-.6-1-1.6z\" "
    "class=\"shell\" stroke=\"currentColor\" stroke-width=\"1.5\"/></svg>";

std::string head(const std::string& title) {
  std::string out =
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\" "
      "xml:lang=\"en\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  out += fmt::format("<title>{} – Goishi verification</title>\n<style>\n", title);
  out += page::style();
  out += fmt::format("@media screen and (prefers-color-scheme: dark) {{ {} }}\n", svg_dark_colours());
  out += "</style>\n</head>\n<body>\n<header>\n";
  return out.append(emblem) + "\n<h1>Goishi <span>shape, mass and motion of Go stones, verified</span></h1>\n";
}

constexpr std::string_view foot = "</main>\n</body>\n</html>\n";

}  // namespace

std::string html_report(const Run& run, const std::vector<Section>& sections, const Pages& pages) {
  const bool good = run.failures() == 0 && !run.results.empty();
  const std::string verdict = xml(verdict_line(run));
  std::string out = head(verdict);
  out += fmt::format("<p class=\"verdict {}\">{} {}</p>\n", good ? "good" : "bad", page::mark(good), verdict);
  out += page::failures(run) + page::stamp(run.stamp, run.seconds, page::Seed::shown) + "</header>\n<main>\n" +
         page::how_to_read(run, pages) + page::overview(run);
  for (const Section& section : sections) {
    out += page::section(section);
  }
  return out.append(page::details(run)).append(foot);
}

std::string html_page(const Section& section, const Stamp& stamp, double seconds) {
  std::string out = head(xml(section.title));
  out += page::stamp(stamp, seconds, page::Seed::hidden) + "</header>\n<main>\n" + page::section(section);
  return out.append(foot);
}

}  // namespace goishi::verify
