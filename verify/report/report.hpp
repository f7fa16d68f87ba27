#pragma once
/// \file
/// The report of a run, for people and for programs.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verify/suite/run.hpp"

namespace goishi::verify {

/// One line a claim: verdict, id, error, bound, slack, time, statement; then what failed, and a summary line.
[[nodiscard]] std::string text_line(const Result& result);
[[nodiscard]] std::string text_summary(const Run& run);

/// `report.schema.json` describes it.
[[nodiscard]] std::string json_report(const Run& run);

[[nodiscard]] std::string junit_report(const Run& run);

/// Numbers and words in rows, for a page. The first cell of a row is its head.
struct Table {
  struct Row {
    std::vector<std::string> cells;
    std::optional<bool> holds;  // a verdict in the last column
  };
  std::string caption;
  std::vector<std::string> head;
  std::vector<Row> rows;
};

/// What a page shows beside the claims. All text is plain.
struct Section {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<Table> tables;
  std::vector<Plot> plots;
  std::vector<Section> parts;
};

/// Addresses of other pages; empty where there is none to lead to.
struct Pages {
  std::string derivations = {};  // the symbolic proofs
  std::string in_browser = {};   // the library in a browser
  std::string changes = {};      // what the suite catches, by verify/mutants
};

/// One self-contained page (polyglot XHTML5, inline SVG and CSS, no script needed). Sections stand between the overview
/// and the details.
[[nodiscard]] std::string html_report(const Run& run, const std::vector<Section>& sections = {},
                                      const Pages& pages = {});

/// A page of one section alone, with the same stamp and style.
[[nodiscard]] std::string html_page(const Section& section, const Stamp& stamp, double seconds);

/// Writes to a temporary name, then renames: nothing is half-written. Throws std::runtime_error with one line.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace goishi::verify
