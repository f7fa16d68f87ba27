#pragma once
/// \file
/// The report of a run, for people and for programs.

#include <filesystem>
#include <string>

#include "verify/run.hpp"

namespace goishi::verify {

/// One line a claim: verdict, id, error, bound, slack, time, statement; then what failed, and a summary line.
[[nodiscard]] std::string text_line(const Result& result);
[[nodiscard]] std::string text_summary(const Run& run);

/// `report.schema.json` describes it.
[[nodiscard]] std::string json_report(const Run& run);

[[nodiscard]] std::string junit_report(const Run& run);

/// One self-contained page (polyglot XHTML5, inline SVG and CSS, no script needed).
[[nodiscard]] std::string html_report(const Run& run);

/// Writes to a temporary name, then renames: nothing is half-written. Throws std::runtime_error with one line.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace goishi::verify
