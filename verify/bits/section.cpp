#include "verify/bits/section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verify/bits/kinds.hpp"
#include "verify/report/number.hpp"

namespace goishi::verify::bits {

namespace {

/// "SINE-1: 0.77 of 0.84 ulp", the claim's weakest check.
std::string how_far_off(const std::string& id, const Run& run) {
  const auto found = std::ranges::find_if(run.results, [&id](const Result& result) { return result.claim->id == id; });
  if (found == run.results.end()) {
    return id;
  }
  const Checked weakest = found->weakest();
  const double error = weakest.measured.error, bound = weakest.check.bound;
  const int digits = digits_to_tell(error, bound);
  return fmt::format("{}: {} of {}{}{}", id, plain_number(error, digits), plain_number(bound, digits),
                     weakest.check.unit.empty() ? "" : " ", weakest.check.unit);
}

}  // namespace

Section page_section(const Run& run) {
  Table table{.caption = "One hash of all results of a kind of work, and how far off those are",
              .head = {"Kind of work", "Hash", "Results", "Error and bound, by the claims"},
              .rows = {}};
  for (const Kind& kind : kinds()) {
    Hash hash;
    kind.run(hash);
    std::string errors;
    for (const std::string& id : kind.claims) {
      errors += (errors.empty() ? "" : "; ") + how_far_off(id, run);
    }
    table.rows.push_back({.cells = {kind.name, digits(hash), grouped(hash.count()), errors}, .holds = {}});
  }
  return {
      .title = "The same bits",
      .paragraphs = {"The library gives one result for one input, to the last bit, whatever the compiler, its level of "
                     "optimisation, the processor and the width of its registers. The hashes of verify/bits/hashes.txt "
                     "are compared by tests; those here are of this run. Same bits say nothing of their truth: that "
                     "is what stands beside them."},
      .tables = {table},
      .plots = {},
      .parts = {}};
}

}  // namespace goishi::verify::bits
