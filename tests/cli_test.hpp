#pragma once
/// \file
/// Runs the built program as a user does, and keeps what it printed.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace goishi::cli_test {

namespace fs = std::filesystem;

struct Result {
  int status;  // exit status, -1: killed
  std::string out;
  std::string err;
};

inline std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

using Words = std::vector<std::string>;

/// The words of a text, between blanks.
inline Words words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// The words and then more of them.
inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A folder of its own for each test.
class Cli : public testing::Test {
 protected:
  Cli() {
    std::string name = (fs::temp_directory_path() / "goishi-cli-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("no folder for temporary files");
    }
    folder_ = name;
    fs::create_directory(folder_ / "work");
  }
  ~Cli() override { fs::remove_all(folder_); }

  /// Where the test's files are.
  [[nodiscard]] fs::path work() const { return folder_ / "work"; }

  /// Runs `goishi WORDS...`; `before` and `behind` are shell text, such as a limit and a redirection.
  [[nodiscard]] Result run(const Words& words, const std::string& before = "", const std::string& behind = "") const {
    std::string command = before + "\"$GOISHI_PROGRAM\"";
    for (const std::string& word : words) {
      command += " '" + word + "'";
    }
    command += " >'" + (folder_ / "out").string() + "' 2>'" + (folder_ / "err").string() + "' " + behind;
    ::setenv("GOISHI_PROGRAM", GOISHI_PROGRAM, 1);
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder_ / "out"), contents(folder_ / "err")};
  }

  /// Expects exit status 2, nothing printed, and exactly this line on standard error.
  void expect_error(const Words& words, const std::string& line) const {
    const Result result = run(words);
    EXPECT_EQ(result.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(result.out, "") << testing::PrintToString(words);
    EXPECT_EQ(result.err, "goishi: error: " + line + "\n") << testing::PrintToString(words);
  }

  /// What a successful run prints.
  [[nodiscard]] std::string printed(const Words& words) const {
    const Result result = run(words);
    EXPECT_EQ(result.status, 0) << testing::PrintToString(words) << result.err;
    EXPECT_EQ(result.err, "") << testing::PrintToString(words);
    return result.out;
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(work())) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

 private:
  fs::path folder_;
};

}  // namespace goishi::cli_test
