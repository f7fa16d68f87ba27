/// The program `goishi`: tables that are checked, and files that cannot be written.

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

using CliCheck = Cli;
using CliOutput = Cli;

// --- --check

TEST_F(CliCheck, AgreesWithWhatWasWritten) {
  for (const std::string name : {"a.txt", "a", "a.md", "a.csv", "a.json", "a.hpp", "a.h"}) {
    const std::string file = (work() / name).string();
    EXPECT_EQ(printed({"table", "--output", file}), "");
    EXPECT_EQ(printed({"table", "--check", file}), file + ": all 96 rows agree\n");
    EXPECT_EQ(run({"table", "--color", "white", "--check", file}).status, 1);
  }
  EXPECT_EQ(contents(work() / "a.csv"), printed({"table", "--format", "csv"}));
  EXPECT_EQ(contents(work() / "a.md"), printed({"table", "--format", "markdown"}));
  EXPECT_EQ(contents(work() / "a"), printed({"table"}));
  const std::string other = (work() / "b.csv").string();
  EXPECT_EQ(printed({"table", "--format", "json", "--output", other}), "");
  EXPECT_EQ(contents(other), printed({"table", "--format", "json"}));
}

TEST_F(CliCheck, NamesTheFirstRowThatDiffers) {
  for (const std::string name : {"a.txt", "a.md", "a.csv", "a.json", "a.hpp"}) {
    const std::string file = (work() / name).string();
    EXPECT_EQ(printed({"table", "--bevel", "1mm", "--output", file}), "");
    std::string text = contents(file);
    // The mass of the black 33, 5.58… g, stands in no other row.
    text.replace(text.find("0.00558"), 7, "0.00658");
    put(file, text);
    const Result result = run({"table", "--bevel", "1mm", "--check", file});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1);
    EXPECT_TRUE(result.err.starts_with("goishi: " + file + ": 33 black, bevel 0.001 m (line ")) << result.err;
    EXPECT_NE(result.err.find("0.00658"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("0.00558"), std::string::npos) << result.err;
    EXPECT_EQ(contents(file), text);
  }
}

TEST_F(CliCheck, SeesWhatIsMissingAndWhatIsTooMuch) {
  const std::string file = (work() / "a.csv").string();
  const std::string text = printed({"table", "--format", "csv"});
  const auto difference = [&](const std::string& changed) {
    put(file, changed);
    const Result result = run({"table", "--check", file});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err.find('\n') + 1, result.err.size()) << result.err;
    return result.err.substr(("goishi: " + file + ": ").size());
  };
  EXPECT_EQ(difference(""), "line 1 is missing: 'number,color,bevel_m,width_m,height_m,outer_widt…'\n");
  EXPECT_EQ(difference(text + "more\n"), "line 98 is too much: 'more'\n");
  EXPECT_EQ(difference(text.substr(0, text.size() - 1)), "50 black, bevel 0.001 m (line 97) does not end\n");
  const std::string shorter = text.substr(0, text.find("\n33,white,0,") + 1);
  EXPECT_TRUE(difference(shorter).starts_with("33 white, sharp (line 26) is missing: '33,white,"));
  EXPECT_TRUE(difference("N" + text.substr(1)).starts_with("line 1 differs: 'Number,"));
}

TEST_F(CliCheck, FileThatCannotBeRead) {
  const std::string folder = work().string();
  expect_error({"table", "--check", folder + "/none.csv"},
               "check = " + folder + "/none.csv: cannot be read: No such file or directory");
  expect_error({"table", "--check", folder}, "check = " + folder + ": cannot be read: Is a directory");
  // What has no end is read only as far as it can agree.
  EXPECT_EQ(run({"table", "--check", "/dev/zero"}, "timeout 10 ").status, 1);
  expect_error({"table", "--check", "a", "--output", "b"}, "check = a: must not be given with --output (b)");
}

// --- --output

TEST_F(CliOutput, FolderThatDoesNotExist) {
  const std::string file = (work() / "none" / "table.csv").string();
  expect_error({"table", "--output", file}, "output = " + file + ": cannot be written: No such file or directory");
  EXPECT_TRUE(files().empty());
  expect_error({"table", "--output", work().string()},
               "output = " + work().string() + ": cannot be written: Is a directory");
  EXPECT_TRUE(files().empty());
}

TEST_F(CliOutput, NoPartialFileWhenThereIsNoRoom) {
  // A limit of one block for a file stands for a full folder.
  const std::string file = (work() / "table.csv").string();
  const Result fresh = run({"table", "--output", file}, "ulimit -f 1; ");
  EXPECT_EQ(fresh.status, 2);
  EXPECT_EQ(fresh.err, "goishi: error: output = " + file + ": cannot be written: File too large\n");
  EXPECT_TRUE(files().empty());

  put(file, "as it was");
  EXPECT_EQ(run({"table", "--output", file}, "ulimit -f 1; ").status, 2);
  EXPECT_EQ(contents(file), "as it was");
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(CliOutput, BadInputLeavesTheFileAlone) {
  const std::string file = (work() / "table.csv").string();
  put(file, "as it was");
  EXPECT_EQ(run({"table", "--bevel", "1m", "--output", file}).status, 2);
  EXPECT_EQ(contents(file), "as it was");
}

TEST_F(CliOutput, FullStandardOutput) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full here";
  }
  for (const Words& words : {Words{"table"}, {"inertia", "--size", "33"}, {"--help"}}) {
    const Result result = run(words, "", ">/dev/full");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "goishi: error: standard output: cannot be written: No space left on device\n");
  }
}

TEST_F(CliOutput, ClosedStandardOutput) {
  const std::string file = (work() / "drop.csv").string();
  for (const std::string command : {"table", "inertia --size 33", "spin --size 33 --spin 1,2,3 --time 1", "--version",
                                    "contact --size 33 --position 0,0,1", "drop --size 33 --from 1cm", "drop --help"}) {
    const Result result = run(words_of(command), "", ">&-");
    EXPECT_EQ(result.status, 2) << command;
    EXPECT_EQ(result.err, "goishi: error: standard output: cannot be written: Bad file descriptor\n");
  }
  // What was to be written elsewhere is there, whole.
  EXPECT_EQ(run(words_of("drop --size 33 --from 1cm --series 3 --csv " + file), "", ">&-").status, 2);
  EXPECT_EQ(std::ranges::count(contents(file), '\n'), 4);
}

TEST_F(CliOutput, AReaderThatGoesAwayGetsNoMessage) {
  const std::string status = (work() / "status").string();
  const Result result = run(words_of("spin --size 33 --spin 1,2,3 --time 1 --series 2000"), "{ ",
                            ">&3; echo $? >'" + status + "'; } 3>&1 | head -1 >/dev/null");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(contents(status), std::to_string(128 + SIGPIPE) + "\n");
}

TEST_F(CliOutput, TheSameInEveryLanguage) {
  for (const std::string command : {"inertia --size 33 --bevel 1mm", "contact --size 33 --position 0,0,0.01",
                                    "drop --size 33 --from 1.5cm --format json"}) {
    const Result result = run(words_of(command), "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 ");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, printed(words_of(command)));
  }
}

TEST_F(CliOutput, AFileThatMayNotBeWrittenStays) {
  const std::string file = (work() / "table.csv").string();
  put(file, "as it was");
  fs::permissions(file, fs::perms::owner_read);
  if (::access(file.c_str(), W_OK) == 0) {
    GTEST_SKIP() << "root may write everything";
  }
  expect_error({"table", "--output", file}, "output = " + file + ": cannot be written: Permission denied");
  EXPECT_EQ(contents(file), "as it was");
}

TEST_F(CliOutput, WritesThroughAPipe) {
  // Not /dev/full: a program that replaced what it should write to would, as root, replace that.
  const std::string pipe = (work() / "pipe.csv").string();
  const std::string copy = (work() / "copy.csv").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Result result = run({"table", "--output", pipe}, "", "& timeout 5 cat '" + pipe + "' >'" + copy + "'; wait $!");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(contents(copy), printed({"table", "--format", "csv"}));
}

TEST_F(CliOutput, KeepsPermissionsAndFollowsLinks) {
  const fs::path file = work() / "table.csv";
  put(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file, work() / "link.csv");
  EXPECT_EQ(printed({"table", "--output", (work() / "link.csv").string()}), "");
  EXPECT_TRUE(fs::is_symlink(work() / "link.csv"));
  EXPECT_EQ(contents(file), printed({"table", "--format", "csv"}));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files().size(), 2U);
}

TEST_F(CliOutput, StandardOutputByName) {
  EXPECT_EQ(printed({"table", "--output", "/dev/stdout"}), printed({"table"}));
  const std::string log = (work() / "log").string();
  put(log, "first\n");
  EXPECT_EQ(run({"table", "--output", "/dev/stdout"}, "", ">>'" + log + "'").status, 0);
  EXPECT_EQ(contents(log), "first\n" + printed({"table"}));
}

}  // namespace
}  // namespace goishi::cli_test
