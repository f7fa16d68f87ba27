/// The report: what people and programs read of a run, whatever the claims say.

#include "verify/report/report.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "tests/report_sample.hpp"
#include "verify/bits/kinds.hpp"
#include "verify/bits/section.hpp"
#include "verify/report/escape.hpp"
#include "verify/report/svg.hpp"

namespace goishi::verify {
namespace {

namespace fs = std::filesystem;

using test::nan;

using test::contains;
using test::count;

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// No byte that XML forbids or that is not UTF-8, no number that is none.
void expect_clean(const std::string& text) {
  EXPECT_EQ(valid_utf8(text), text);
  EXPECT_TRUE(
      std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; }));
}

// --- text

TEST(ReportText, ClaimThatHolds) {
  Sample sample;
  const std::string text = text_line(sample.add("MASS-1", 1.25, 4));
  EXPECT_EQ(text,
            "holds  MASS-1            1.25 ≤     4 ulp                slack   3.2      0.25 s\n"
            "       The volume is right.");
}

TEST(ReportText, ClaimThatFailsSaysWhy) {
  Sample sample;
  const Result& result = sample.add("MASS-1", 4.0004, 4);
  const std::string text = text_line(result);
  EXPECT_TRUE(text.starts_with("FAILS  MASS-1"));
  for (const std::string& part : {std::string("4.0004 >     4 ulp"), std::string("slack 0.9999"), result.verdict.why,
                                  std::string("an oracle (brute force)"), std::string("w = 0x1.8p-6"),
                                  std::string("derived from six roundings"), std::string("12345")}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
}

TEST(ReportText, EachLineFitsATerminal) {
  Sample sample;
  fill(sample);
  sample.claims.front().statement.assign(1000, 'x');
  for (std::size_t i = 20; i < 1000; i += 20) {
    sample.claims.front().statement[i] = ' ';
  }
  std::string text = text_summary(sample.run);
  for (const Result& result : sample.run.results) {
    text += text_line(result);
  }
  expect_clean(text);
  std::istringstream lines(text_line(sample.run.results.front()));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(columns(line), 120U);
  }
}

TEST(ReportText, Summary) {
  Sample sample;
  fill(sample);
  const std::string text = text_summary(sample.run);
  for (const char* part : {"5 of 7 claims do not hold: 2 hold, 5 failed", "FAILS  LAW-1", "seed 18446744073709551615",
                           "tier full", "12.3 s", "0123456789abcdef-dirty", "a compiler, Release"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
  EXPECT_TRUE(contains(text_summary(Sample().run), "No claim was measured"));
}

// --- JSON

/// Empty when the text is JSON that the schema accepts, else what is wrong.
std::string schema_error(const std::string& text) {
  static const std::string schema_text = content_of(GOISHI_REPORT_SCHEMA);
  rapidjson::Document schema_json;
  schema_json.Parse(schema_text.c_str());
  EXPECT_FALSE(schema_json.HasParseError());
  const rapidjson::SchemaDocument schema(schema_json);
  rapidjson::Document document;
  document.Parse<rapidjson::kParseValidateEncodingFlag>(text.c_str(), text.size());
  if (document.HasParseError()) {
    return "not JSON";
  }
  rapidjson::SchemaValidator validator(schema);
  return document.Accept(validator) ? "" : validator.GetInvalidSchemaKeyword();
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(ReportJson, KeepsToTheSchema) {
  Sample sample;
  EXPECT_EQ(schema_error(json_report(sample.run)), "");
  fill(sample);
  for (const OracleFamily family :
       {OracleFamily::proof, OracleFamily::exact, OracleFamily::invariant, OracleFamily::relation,
        OracleFamily::rounding, OracleFamily::brute_force, OracleFamily::published, OracleFamily::regression}) {
    sample.add("FAMILY-1", 1, 2, family);
  }
  EXPECT_EQ(schema_error(json_report(sample.run)), "");
  sample.run.stamp.tier = Tier::quick;
  EXPECT_EQ(schema_error(json_report(sample.run)), "");
}

TEST(ReportJson, TheSchemaRefuses) {
  Sample sample;
  sample.add("MASS-1", 1.25, 4);
  const std::string good = json_report(sample.run);
  EXPECT_EQ(schema_error(good), "");
  EXPECT_NE(schema_error(replaced(good, "\"error\": 1.25", "\"error\": null")), "");
  EXPECT_NE(schema_error(replaced(good, "\"why\": \"\"", "\"why\": \"so\"")), "");
  EXPECT_NE(schema_error(replaced(good, "\"holds\": true", "\"holds\": false")), "");
  EXPECT_NE(schema_error(replaced(good, "\"cases\": 12345", "\"cases\": 0")), "");
  EXPECT_NE(schema_error(replaced(good, "\"seed\"", "\"Seed\"")), "");
  EXPECT_NE(schema_error(replaced(good, "\"unit\": \"ulp\",", "")), "");
  EXPECT_NE(schema_error(replaced(good, "brute force", "hearsay")), "");
}

TEST(ReportJson, KeepsEveryBit) {
  Sample sample;
  sample.add("MASS-1", 0.1 + 0.2, 4);
  sample.add("MASS-2", nan, 4);
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(json_report(sample.run).c_str());
  EXPECT_EQ(document["claims"][0]["checks"][0]["error"].GetDouble(), 0.1 + 0.2);
  EXPECT_TRUE(document["claims"][1]["checks"][0]["error"].IsNull());
  EXPECT_FALSE(document["claims"][1]["holds"].GetBool());
  EXPECT_EQ(document["stamp"]["seed"].GetUint64(), 18446744073709551615ULL);
  EXPECT_EQ(document["summary"]["failed"].GetUint64(), 1U);
}

// --- JUnit

TEST(ReportJunit, CountsAndExplains) {
  Sample sample;
  fill(sample);
  const std::string text = junit_report(sample.run);
  expect_clean(text);
  EXPECT_EQ(count(text, "<testcase "), sample.run.results.size());
  EXPECT_EQ(count(text, "<failure "), sample.run.failures());
  EXPECT_TRUE(contains(text, "tests=\"7\" failures=\"5\""));
  EXPECT_TRUE(contains(text,
                       "classname=\"goishi.MASS\" name=\"MASS-1: The volume is right.\" "
                       "time=\"0.250000\""));
  EXPECT_TRUE(contains(text, "&lt;&amp;&gt;&quot;&#39; ]]&gt; [31m λ碁"));
  EXPECT_TRUE(contains(junit_report(Sample().run), "tests=\"0\" failures=\"0\""));
}

// --- HTML

TEST(ReportHtml, SaysTheVerdictFirst) {
  Sample sample;
  EXPECT_TRUE(contains(html_report(sample.run), "No claim was measured"));
  sample.add("MASS-1", 1.25, 4);
  sample.add("MASS-2", 1.25, 4);
  EXPECT_TRUE(contains(html_report(sample.run), "<title>All 2 claims hold"));
  sample.add("MASS-3", 5, 4);
  EXPECT_TRUE(contains(html_report(sample.run), "<title>1 of 3 claims does not hold"));
}

TEST(ReportHtml, ShowsEverything) {
  Sample sample;
  fill(sample);
  const std::string text = html_report(sample.run);
  expect_clean(text);
  for (const Result& result : sample.run.results) {
    const std::string id = anchor(result.claim->id);
    EXPECT_EQ(count(text, "id=\"" + id + "\""), 1U) << id;
    EXPECT_TRUE(contains(text, "href=\"#" + id + "\"")) << id;
  }
  for (const char* part :
       {"a processor, 2 threads", "a system", "0123456789abcdef-dirty", "2025-05-04T10:11:12Z", "18446744073709551615",
        "12.3 s", "derived from six roundings", "brute force", "1.8505405 cm³", "12\u202F345", "not a number",
        "data-series=\"sharp\" data-points=\"3\"", "&lt;&amp;&gt;&quot;&#39;"}) {
    EXPECT_TRUE(contains(text, part)) << part;
  }
  EXPECT_FALSE(contains(text, "derivations"));
  EXPECT_TRUE(contains(html_report(sample.run, {}, {.derivations = "the derivations.html"}),
                       "<a href=\"the derivations.html\">"));
  EXPECT_FALSE(contains(text, "in a browser"));
  EXPECT_TRUE(contains(html_report(sample.run, {}, {.in_browser = "../page & more.html"}),
                       "<a href=\"../page &amp; more.html\">"));
  EXPECT_FALSE(contains(text, "what the suite catches"));
  EXPECT_TRUE(contains(html_report(sample.run, {}, {.changes = "mutants.html"}), "<a href=\"mutants.html\">"));
  EXPECT_FALSE(contains(text, "<script"));
  EXPECT_FALSE(contains(text, " src="));
  EXPECT_FALSE(contains(text, "url("));
}

/// report.xml and report.html in CTest have the same sample judged by the parsers of others.
TEST(ReportSample, IsWritten) {
  const char* const wanted = std::getenv("GOISHI_REPORT_SAMPLE");
  const fs::path folder = wanted != nullptr
                              ? fs::path(wanted)
                              : fs::path(testing::TempDir()) / ("goishi-report-" + std::to_string(getpid()));
  fs::create_directories(folder);
  Sample sample;
  fill(sample);
  write_file(folder / "report.html",
             html_report(sample.run, {}, {.derivations = "derivations.html", .changes = "mutants.html"}));
  write_file(folder / "junit.xml", junit_report(sample.run));
  write_file(folder / "empty.html", html_report(Sample().run));
  write_file(folder / "empty.xml", junit_report(Sample().run));
  write_file(folder / "plot.svg", svg_plot(sample.run.results[1].measurement.plots.front()));
  EXPECT_EQ(content_of(folder / "junit.xml"), junit_report(sample.run));
  if (wanted == nullptr) {
    fs::remove_all(folder);
  }
}

// --- the same bits

TEST(ReportBits, EachHashStandsBesideTheErrorsOfWhatItHashes) {
  Sample sample;
  sample.add("MASS-1", 1.25, 4);
  const Section section = bits::page_section(sample.run);
  ASSERT_EQ(section.tables.size(), 1U);
  const std::vector<Table::Row>& rows = section.tables.front().rows;
  ASSERT_EQ(rows.size(), bits::kinds().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string line = bits::line(bits::kinds()[i]);
    EXPECT_TRUE(contains(line, rows[i].cells[0] + ": " + rows[i].cells[1] + " ")) << line;
  }
  EXPECT_TRUE(contains(rows[1].cells[3], "MASS-1: 1.25 of 4 ulp; MASS-2; ")) << rows[1].cells[3];
}

}  // namespace
}  // namespace goishi::verify
