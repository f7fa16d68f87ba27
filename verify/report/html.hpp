#pragma once
/// \file
/// Parts of the page. Everything is XHTML that is HTML as well: each element is closed, each text escaped.

#include <string>
#include <string_view>

#include "verify/report/report.hpp"
#include "verify/suite/run.hpp"

namespace goishi::verify::page {

[[nodiscard]] std::string_view style();

/// ✓ or ✗, with the word for those who hear the page.
[[nodiscard]] std::string mark(bool holds);

/// Error, bound and slack as the overview and the details show them.
struct Judged {
  std::string error;
  std::string bound;
  std::string slack;
};
[[nodiscard]] Judged judged(const Checked& of);

/// A bar on a logarithmic scale from 1 to the greatest slack that is accepted.
[[nodiscard]] std::string slack_bar(const Judgement& judgement);

enum class Seed { shown, hidden };
[[nodiscard]] std::string stamp(const Stamp& stamp, double seconds, Seed seed);
[[nodiscard]] std::string failures(const Run& run);
/// With links to the symbolic proofs and to the page in a browser, each unless its address is empty.
[[nodiscard]] std::string how_to_read(const Run& run, const Pages& pages);
[[nodiscard]] std::string overview(const Run& run);
[[nodiscard]] std::string details(const Run& run);
[[nodiscard]] std::string section(const Section& section);

}  // namespace goishi::verify::page
