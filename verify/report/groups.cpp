#include "verify/report/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "verify/report/number.hpp"

namespace goishi::verify {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 26> titles = {{
    {"SINE", "Sine and cosine of our own"},
    {"ATAN", "The arctangent of our own"},
    {"SHAPE", "Shape of lens and bevel"},
    {"MASS", "Volume, area and moments of inertia"},
    {"GSL", "Against numerical integration of the solid"},
    {"ENCLOSURE", "Enclosures: intervals that hold the exact value"},
    {"CERTIFIED", "Closed forms and rigorous integration"},
    {"LAW", "Limits and laws"},
    {"TENSOR", "The inertia tensor about any point, in any frame"},
    {"MESH", "Meshes, what they enclose, boxes"},
    {"TABLE", "The inertia table and the catalogue of sizes"},
    {"PUBLISHED", "What was published, and what is right"},
    {"DOMAIN", "To the ends of what is said to be taken"},
    {"FLIGHT", "Free flight against Odeint"},
    {"ELLIPTIC", "Free flight without a symmetry axis"},
    {"BATCH", "Many stones at once"},
    {"MOTION", "Laws of free motion"},
    {"ORDER", "Steppers: order, drift, divergence"},
    {"CASE", "Published cases of rigid-body motion"},
    {"SURFACE", "The surface of a stone"},
    {"BOARD", "The board"},
    {"CONTACT", "Contact"},
    {"TOI", "Time of impact"},
    {"IMPACT", "Impact and friction"},
    {"DROP", "From flight to rest"},
    {"SCENE", "A board with many stones"},
}};

std::string title_of(std::string_view prefix) {
  const auto* const found =
      std::find_if(titles.begin(), titles.end(), [&](const auto& entry) { return entry.first == prefix; });
  return std::string(found == titles.end() ? prefix : found->second);
}

}  // namespace

std::vector<Group> grouped_results(const Run& run) {
  std::vector<Group> groups;
  for (const Result& result : run.results) {
    const std::string& id = result.claim->id;
    const std::string prefix = id.substr(0, id.find('-'));
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& other) { return other.prefix == prefix; });
    if (group == groups.end()) {
      groups.push_back({prefix, title_of(prefix), {}});
      group = groups.end() - 1;
    }
    group->results.push_back(&result);
  }
  return groups;
}

int slack_digits(double slack) {
  return slack < 1 ? digits_to_tell(slack, 1.0) : slack > greatest_slack ? digits_to_tell(slack, greatest_slack) : 3;
}

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string verdict_line(const Run& run) {
  const std::size_t all = run.results.size();
  const std::size_t failed = run.failures();
  if (all == 0) {
    return "No claim was measured";
  }
  if (failed > 0) {
    return fmt::format("{} of {} {} not hold", failed, counted(all, "claim"), failed == 1 ? "does" : "do");
  }
  return all == 1 ? "The one claim holds" : fmt::format("All {} claims hold", all);
}

}  // namespace goishi::verify
