/// The tables in the documents: what is written there, and which differences from a run are seen.

#include "verify/report/markdown.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/report_sample.hpp"

namespace goishi::verify::markdown {
namespace {

namespace fs = std::filesystem;

/// A claim of a folder, with checks of these errors, bounds and names.
void add(Sample& sample, const std::string& id, const std::string& folder, const std::vector<Check>& checks,
         const std::vector<double>& errors, const std::string& statement = "The volume is right.") {
  Result& result = sample.add(id, 1.0, 4.0);
  Claim& claim = sample.claims.back();
  claim.source = "claims/" + folder + "/file.cpp";
  claim.statement = statement;
  claim.checks = checks;
  result.measurement.checks.clear();
  for (std::size_t i = 0; i < checks.size(); ++i) {
    result.measurement.checks.push_back({.check = checks[i].name, .error = errors[i], .cases = 3});
  }
  result.verdict = judge(claim, result.measurement);
}

Check check(const std::string& name, double bound, double resolution = 0.0) {
  return {.name = name, .unit = "ulp", .bound = bound, .reason = "derived", .resolution = resolution};
}

void fill_two(Sample& sample, double volume = 1.25, double area = 1.0) {
  add(sample, "MASS-1", "mass", {check("volume", 4), check("area", 8), check("faults", 0)}, {volume, area, 0});
  add(sample, "BOARD-1", "shape", {check("", 0)}, {0}, "No pose | of *all* is <b>wrong</b>, I_a $x$.");
}

std::string in_place(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Markdown, ARowForEachClaimWithItsWeakestCheck) {
  Sample sample;
  fill_two(sample);
  EXPECT_EQ(claims_table(sample.run),
            "| claim | statement | witness | weakest check | error | bound |\n"
            "|---|---|---|---|---:|---|\n"
            "| MASS-1 | The volume is right. | brute force | volume | 1.2 | 4 ulp |\n"
            "| BOARD-1 | No pose \\| of \\*all\\* is \\<b>wrong\\</b>, I_a \\$x\\$. | brute force |  | 0 | 0 ulp |\n");
}

TEST(Markdown, ALongStatementIsCutAtAWord) {
  Sample sample;
  std::string statement;
  for (int i = 0; i < 100; ++i) {
    statement += "word ";
  }
  add(sample, "MASS-1", "mass", {check("", 4)}, {1}, statement);
  const std::string table = claims_table(sample.run);
  EXPECT_NE(table.find("word … |"), std::string::npos) << table;
  EXPECT_LT(table.size(), 400U);
}

TEST(Markdown, ARowForEachFolderInAnOrderOfItsOwn) {
  Sample sample;
  fill_two(sample);
  add(sample, "NEW-1", "new_folder", {check("", 4)}, {2});
  EXPECT_EQ(subjects_table(sample.run),
            "| subject | claims | witnesses | weakest check | error | bound |\n"
            "|---|---:|---|---|---:|---|\n"
            "| Shape: surface, board, rays | 1 | brute force 1 | BOARD-1 | 0 | 0 ulp |\n"
            "| Mass: volume, inertia, table | 1 | brute force 1 | MASS-1: volume | 1.2 | 4 ulp |\n"
            "| new_folder | 1 | brute force 1 | NEW-1 | 2 | 4 ulp |\n");
}

TEST(Markdown, AnErrorAndItsBoundAreToldApart) {
  Sample sample;
  add(sample, "MASS-1", "mass", {check("", 4)}, {3.9999});
  EXPECT_NE(claims_table(sample.run).find("| 3.9999 | 4 ulp |"), std::string::npos) << claims_table(sample.run);
}

TEST(Markdown, ItsOwnTablesDoNotDiffer) {
  Sample sample;
  fill_two(sample);
  add(sample, nasty, "mass", {check(nasty, 4), check("other", 4)}, {1, 3}, nasty);
  EXPECT_EQ(claims_differences(claims_table(sample.run), sample.run), std::vector<std::string>());
  EXPECT_EQ(subjects_differences(subjects_table(sample.run), sample.run), std::vector<std::string>());
}

TEST(Markdown, AnErrorMayDifferByAFactor) {
  Sample written;
  fill_two(written, 1.25);
  const std::string table = claims_table(written.run), subjects = subjects_table(written.run);
  for (const double near : {0.85, 1.0, 1.25, 1.7}) {
    Sample sample;
    fill_two(sample, near, near);
    EXPECT_TRUE(claims_differences(table, sample.run).empty()) << near;
    EXPECT_TRUE(subjects_differences(subjects, sample.run).empty()) << near;
  }
  for (const double far : {0.75, 2.0, 5.0}) {
    Sample sample;
    fill_two(sample, far, 0.5);
    ASSERT_EQ(claims_differences(table, sample.run).size(), 1U) << far;
    EXPECT_NE(claims_differences(table, sample.run).front().find("MASS-1"), std::string::npos);
    EXPECT_EQ(subjects_differences(subjects, sample.run).size(), 1U) << far;
  }
}

TEST(Markdown, AnErrorBelowTheResolutionCountsAsThat) {
  Sample written, sample;
  add(written, "MASS-1", "mass", {check("", 4, 1)}, {0.001});
  add(sample, "MASS-1", "mass", {check("", 4, 1)}, {0.9});
  EXPECT_TRUE(claims_differences(claims_table(written.run), sample.run).empty());
}

TEST(Markdown, AnotherCheckThatIsNearlyAsWeakMayStandThere) {
  Sample written, sample, strong;
  fill_two(written, 1.25, 2.4);  // slacks 3.2 and 3.33
  fill_two(sample, 1.2, 2.5);    // 3.33 and 3.2
  fill_two(strong, 1.25, 7.9);   // the area is the weakest by far
  EXPECT_NE(claims_table(written.run), claims_table(sample.run));
  EXPECT_TRUE(claims_differences(claims_table(written.run), sample.run).empty());
  EXPECT_TRUE(subjects_differences(subjects_table(written.run), sample.run).empty());
  EXPECT_EQ(claims_differences(claims_table(written.run), strong.run).size(), 1U);
}

TEST(Markdown, EverythingElseIsCompared) {
  Sample sample;
  fill_two(sample);
  const std::string table = claims_table(sample.run);
  const auto differences = [&](const std::string& from, const std::string& to) {
    return claims_differences(in_place(table, from, to), sample.run).size();
  };
  EXPECT_EQ(differences("The volume", "A volume"), 1U);
  EXPECT_EQ(differences("brute force", "proof"), 1U);
  EXPECT_EQ(differences("| volume |", "| area |"), 1U);
  EXPECT_EQ(differences("4 ulp", "5 ulp"), 1U);
  EXPECT_EQ(differences("4 ulp", "4 m"), 1U);
  EXPECT_EQ(differences("1.2 |", "1.2x |"), 1U);
  EXPECT_EQ(differences("1.2 |", "nan |"), 1U);
  EXPECT_EQ(differences("| claim |", "| id |"), 1U);
  EXPECT_EQ(differences("MASS-1", "MASS-2"), 2U);  // one is missing, and nothing is called as the other
  const std::size_t second = table.find("| BOARD-1");
  const std::size_t first = table.find("| MASS-1");
  const std::string head = table.substr(0, first), mass = table.substr(first, second - first);
  EXPECT_EQ(claims_differences(head + table.substr(second), sample.run).size(), 1U);
  EXPECT_EQ(claims_differences(head + table.substr(second) + mass, sample.run).size(), 1U);
  EXPECT_EQ(claims_differences(table + mass, sample.run).size(), 1U);
  EXPECT_EQ(claims_differences("", sample.run).size(), 1U);
}

TEST(Markdown, APartStandsBetweenItsMarkers) {
  const std::string empty = "# A\n\n<!-- goishi-verify: one -->\n<!-- end -->\nend\n";
  EXPECT_EQ(part(empty, "one"), "");
  const std::string full = with_part(empty, "one", "row\n");
  EXPECT_EQ(full, "# A\n\n<!-- goishi-verify: one -->\n\nrow\n\n<!-- end -->\nend\n");
  EXPECT_EQ(part(full, "one"), "row");
  EXPECT_EQ(with_part(full, "one", "row\n"), full);
  EXPECT_THROW((void)part(full, "two"), std::runtime_error);
  EXPECT_THROW((void)part(full + full, "one"), std::runtime_error);
  EXPECT_THROW((void)part("<!-- goishi-verify: one -->\nrow\n", "one"), std::runtime_error);
}

class MarkdownFiles : public ::testing::Test {
 protected:
  MarkdownFiles() : root_(fs::temp_directory_path() / ("goishi-markdown-" + std::to_string(::getpid()))) {
    fs::create_directories(root_ / "verify");
    write(root_ / "README.md", "# A\n<!-- goishi-verify: subjects -->\n<!-- end -->\n");
    write(root_ / "verify/README.md", "# B\n<!-- goishi-verify: claims -->\n<!-- end -->\n");
  }
  ~MarkdownFiles() override { fs::remove_all(root_); }
  MarkdownFiles(const MarkdownFiles&) = delete;
  MarkdownFiles& operator=(const MarkdownFiles&) = delete;

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path root_;
};

TEST_F(MarkdownFiles, AreWrittenAndCompared) {
  Sample sample, other;
  fill_two(sample, 1.25);
  fill_two(other, 3.0);
  EXPECT_EQ(table_differences(sample.run, root_).size(), 2U);
  write_tables(sample.run, root_);
  EXPECT_TRUE(table_differences(sample.run, root_).empty());
  const std::vector<std::string> found = table_differences(other.run, root_);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].starts_with("README.md: Mass")) << found[0];
  EXPECT_TRUE(found[1].starts_with("verify/README.md: MASS-1")) << found[1];
  EXPECT_TRUE(read(root_ / "README.md").starts_with("# A\n"));
}

TEST_F(MarkdownFiles, NothingIsWrittenWhereOneHasNoPart) {
  Sample sample;
  fill_two(sample);
  write(root_ / "verify/README.md", "# B\n");
  const std::string before = read(root_ / "README.md");
  EXPECT_THROW(require_parts(root_), std::runtime_error);
  EXPECT_THROW(write_tables(sample.run, root_), std::runtime_error);
  EXPECT_EQ(read(root_ / "README.md"), before);
  fs::remove(root_ / "README.md");
  EXPECT_THROW(require_parts(root_), std::runtime_error);
}

}  // namespace
}  // namespace goishi::verify::markdown
