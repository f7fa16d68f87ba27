/// What the report is made of: numbers, text from elsewhere, files.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "tests/expectations.hpp"
#include "verify/report/escape.hpp"
#include "verify/report/number.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify {
namespace {

namespace fs = std::filesystem;

using test::infinity;
using test::nan;

using Lines = std::vector<std::string>;

using test::contains;

// --- numbers and text

TEST(Number, Plain) {
  EXPECT_EQ(plain_number(0), "0");
  EXPECT_EQ(plain_number(4), "4");
  EXPECT_EQ(plain_number(1e-13), "1e-13");
  EXPECT_EQ(plain_number(1.3449e-15), "1.34e-15");
  EXPECT_EQ(plain_number(-74.55), "-74.5");  // 74.55 is below itself in binary
  EXPECT_EQ(plain_number(0.00999999), "0.01");
  EXPECT_EQ(plain_number(999999.9), "1e6");
  EXPECT_EQ(plain_number(123456.7), "123457");
  EXPECT_EQ(plain_number(100), "100");
  EXPECT_EQ(plain_number(nan), "nan");
  EXPECT_EQ(plain_number(-infinity), "-inf");
  EXPECT_EQ(html_number(-1.25e-15), "−1.25\u202F×\u202F10<sup>−15</sup>");
  EXPECT_EQ(html_number(1e-13), "10<sup>−13</sup>");
  EXPECT_EQ(html_number(nan), "not a number");
}

TEST(Number, EnoughDigitsToTell) {
  EXPECT_EQ(digits_to_tell(4, 5), 3);
  EXPECT_EQ(digits_to_tell(4, 4), 3);
  EXPECT_EQ(plain_number(4.0004, digits_to_tell(4.0004, 4)), "4.0004");
  EXPECT_NE(plain_number(std::nextafter(4.0, 5.0), digits_to_tell(std::nextafter(4.0, 5.0), 4.0)), "4");
}

TEST(Number, Durations) {
  EXPECT_EQ(duration(0), "0 µs");
  EXPECT_EQ(duration(3.21e-6), "3.2 µs");
  EXPECT_EQ(duration(0.1204), "120 ms");
  EXPECT_EQ(duration(0.9999), "1 s");
  EXPECT_EQ(duration(12.345), "12.3 s");
  EXPECT_EQ(duration(119.9), "2 min 0 s");
  EXPECT_EQ(duration(nan), "?");
  EXPECT_EQ(grouped(1234567), "1\u202F234\u202F567");
  EXPECT_EQ(grouped(123), "123");
}

TEST(Escape, TextFromElsewhere) {
  EXPECT_EQ(valid_utf8("aλ碁\U0001F600"), "aλ碁\U0001F600");
  EXPECT_EQ(valid_utf8("\xff"
                       "a\xce"),
            "\uFFFD"
            "a\uFFFD");
  EXPECT_EQ(valid_utf8("\xc0\x80"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80").size(), 4U * 3U);    // over U+10FFFF
  EXPECT_EQ(printable("a\x1b[1m\nb\x7f"), "a [1m b ");
  EXPECT_EQ(xml(std::string_view("\0<\t\n&\xef\xbf\xbf", 8)), "&lt;\t\n&amp;\uFFFD");
  EXPECT_EQ(anchor("GSL-1 <λ>"), "GSL-1-----");
  EXPECT_EQ(columns("aλ碁e\u0301"), 5U);
  EXPECT_EQ(wrapped("one two  three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("", 7), (Lines{""}));
  EXPECT_EQ(shortened("one two", 5), "one …");
  EXPECT_EQ(shortened("one two", 7), "one two");
}

// --- files

class WriteFile : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(testing::TempDir()) / ("goishi-write-file-" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  static std::string content_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(folder), {}); }
  static std::string error_of(const fs::path& path, const std::string& content = "text") {
    try {
      write_file(path, content);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder;
};

TEST_F(WriteFile, Replaces) {
  write_file(folder / "report", "first, and longer");
  write_file(folder / "report", "second");
  EXPECT_EQ(content_of(folder / "report"), "second");
  EXPECT_EQ(entries(), 1);
}

TEST_F(WriteFile, LinkStaysALink) {
  write_file(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(folder / "target"), "new");
}

TEST_F(WriteFile, SaysWhyNot) {
  const std::string missing = error_of(folder / "missing" / "report");
  EXPECT_TRUE(contains(missing, "missing/report: No such file or directory")) << missing;
  EXPECT_TRUE(contains(error_of(folder), "Is a directory"));
  EXPECT_TRUE(contains(error_of("/dev/full"), "No space left on device"));
  EXPECT_EQ(error_of("/dev/null"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(error_of(folder / "missing" / "a\nb").find('\n'), std::string::npos);
  EXPECT_EQ(entries(), 0);
}

TEST_F(WriteFile, LeavesTheOldFileWhenTheNewOneDoesNotFit) {
  write_file(folder / "report", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {4096, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = error_of(folder / "report", std::string(100000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  static_cast<void>(std::signal(SIGXFSZ, handler));
  EXPECT_TRUE(contains(error, "File too large")) << error;
  EXPECT_EQ(content_of(folder / "report"), "old");
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace goishi::verify
