/// The program `goishi`: bad input, and files that cannot be written.

#include <sys/stat.h>

#include <algorithm>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

using CliError = Cli;
using CliCheck = Cli;
using CliOutput = Cli;

const std::string not_a_length = ": must be a decimal number, bare (m) or with a unit (m cm mm um µm nm km)";
const std::string no_unit_of_length = ": must have one of the units m cm mm um µm nm km, not ";
const std::string out_of_range = ": must be 0 or from 1e-100000000 to 1e100000000 m";
const std::string not_positive = ": must be positive and finite";
const std::string sizes = ": must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40";

// --- numbers

TEST_F(CliError, Width) {
  const auto expect = [this](const std::string& typed, const std::string& line) {
    expect_error({"inertia", "--width", typed, "--height", "9mm"}, line);
  };
  expect("0", "width = 0" + not_positive);
  expect("-0.022", "width = -0.022" + not_positive);
  expect("-22mm", "width = -0.022" + not_positive);
  for (const std::string typed :
       {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "", " ", "abc", "mm", ".", "-", "+-1", "e5"}) {
    expect(typed, "width = " + typed + not_a_length);
  }
  expect("1e100000001", "width = 1e100000001" + out_of_range);
  expect("1e99999999999999999999999", "width = 1e99999999999999999999999" + out_of_range);
  expect("1e-100000000mm", "width = 1e-100000000mm" + out_of_range);
  expect("22parsec", "width = 22parsec" + no_unit_of_length + "'parsec'");
  expect("22 kg", "width = 22 kg" + no_unit_of_length + "'kg'");
  expect("22 mm mm", "width = 22 mm mm" + no_unit_of_length + "'mm mm'");
  expect("22MM", "width = 22MM" + no_unit_of_length + "'MM'");
  expect("0x1p3", "width = 0x1p3" + no_unit_of_length + "'x1p3'");
  expect("1,5mm", "width = 1,5mm" + no_unit_of_length + "',5mm'");
  expect("1e", "width = 1e" + no_unit_of_length + "'e'");
  expect("2\n2", "width = 2\\x0a2" + no_unit_of_length + "'\\x0a2'");
}

TEST_F(CliError, Height) {
  const auto expect = [this](const std::string& typed, const std::string& line) {
    expect_error({"inertia", "--width", "22mm", "--height", typed}, line);
  };
  expect("0", "height = 0" + not_positive);
  expect("-9mm", "height = -0.009" + not_positive);
  expect("nan", "height = nan" + not_a_length);
  expect("inf", "height = inf" + not_a_length);
  expect("30mm", "height = 0.03: must not exceed the width (0.022)");
  expect_error({"inertia", "--width", "22mm", "--height", "30mm", "--measured"},
               "height = 0.03: must not exceed the outer_width (0.022)");
  expect_error({"inertia", "--width", "-1", "--height", "30mm", "--measured"}, "width = -1" + not_positive);
}

TEST_F(CliError, Bevel) {
  const auto expect = [this](const std::string& typed, const std::string& line) {
    expect_error({"inertia", "--width", "22mm", "--height", "9mm", "--bevel", typed}, line);
    expect_error({"inertia", "--width", "22mm", "--height", "9mm", "--measured", "--bevel", typed}, line);
  };
  const std::string rule = ": must be at least 0 and below the height (0.009)";
  expect("-1mm", "bevel = -0.001" + rule);
  expect("9mm", "bevel = 0.009" + rule);
  expect("0.9cm", "bevel = 0.009" + rule);
  expect("10mm", "bevel = 0.01" + rule);
  expect("nan", "bevel = nan" + not_a_length);
  expect_error({"table", "--bevel", "6.3mm"}, "bevel = 0.0063: must be at least 0 and below the height (0.0063)");
  expect_error({"table", "--bevel", "-1"}, "bevel = -1: must be at least 0 and below the height (0.0063)");
  expect_error({"table", "--bevel", "1furlong"}, "bevel = 1furlong" + no_unit_of_length + "'furlong'");
}

TEST_F(CliError, MassAndDensity) {
  for (const std::string typed : {"0", "-1"}) {
    expect_error({"inertia", "--size", "33", "--mass", typed}, "mass = " + typed + not_positive);
    expect_error({"inertia", "--size", "33", "--density", typed}, "density = " + typed + not_positive);
    expect_error({"table", "--density", typed}, "density = " + typed + not_positive);
  }
  for (const std::string typed : {"nan", "inf"}) {
    expect_error({"inertia", "--size", "33", "--mass", typed},
                 "mass = " + typed + ": must be a decimal number, bare (kg) or with a unit (kg g mg)");
    expect_error({"table", "--density", typed},
                 "density = " + typed +
                     ": must be a decimal number, bare (kg/m³) or with a unit (kg/m³ kg/m3 kg/m^3 "
                     "g/cm³ g/cm3 g/cm^3)");
  }
  expect_error({"inertia", "--size", "33", "--mass", "5lb"},
               "mass = 5lb: must have one of the units kg g mg, not 'lb'");
  expect_error({"inertia", "--size", "33", "--density", "5g"},
               "density = 5g: must have one of the units kg/m³ kg/m3 kg/m^3 g/cm³ g/cm3 g/cm^3, "
               "not 'g'");
  expect_error({"inertia", "--size", "33", "--density", "2800", "--mass", "5g"},
               "density = 2800: must not be given with --mass (5g)");
}

TEST_F(CliError, SizeAndColor) {
  for (const std::string typed : {"41", "0", "-33", "33.0", "33mm", "abc", "", "99999999999999999999"}) {
    expect_error({"inertia", "--size", typed}, "size = " + typed + sizes);
  }
  expect_error({"inertia", "--size", "33", "--color", "red"}, "color = red: must be white or black");
  expect_error({"inertia", "--size", "33", "--color", "both"}, "color = both: must be white or black");
  expect_error({"table", "--color", "red"}, "color = red: must be white, black or both");
}

// --- combinations

TEST_F(CliError, WhichStone) {
  expect_error({"inertia"}, "a stone is needed: --size, or --width and --height");
  expect_error({"inertia", "--size", "33", "--width", "22mm", "--height", "9mm"},
               "width = 22mm: must not be given with --size (33)");
  expect_error({"inertia", "--size", "33", "--height", "9mm"}, "height = 9mm: must not be given with --size (33)");
  expect_error({"inertia", "--width", "22mm"}, "width = 22mm: needs --height too");
  expect_error({"inertia", "--height", "9mm"}, "height = 9mm: needs --width too");
  expect_error({"inertia", "--width", "22mm", "--height", "9mm", "--color", "black"},
               "color = black: needs --size too");
}

TEST_F(CliError, Formats) {
  expect_error({"inertia", "--size", "33", "--format", "csv"}, "format = csv: must be text or json");
  expect_error({"table", "--format", "xml"}, "format = xml: must be text, markdown, csv, json or cpp");
  expect_error({"table", "--units", "imperial"}, "units = imperial: must be si or cgs");
  expect_error({"table", "--units", "cgs", "--format", "cpp"}, "units = cgs: must be si with --format cpp");
  expect_error({"table", "--density", "1e400", "--format", "cpp"},
               "density = 1e+400: is beyond the range of a double, which --format cpp prints");
}

TEST_F(CliError, Usage) {
  expect_error({}, "a command is needed: table, inertia, spin, contact or drop");
  expect_error({"bake"}, "The following argument was not expected: bake");
  expect_error({"--bake"}, "The following argument was not expected: --bake");
  expect_error({"table", "--bake"}, "The following argument was not expected: --bake");
  expect_error({"table", "extra"}, "The following argument was not expected: extra");
  expect_error({"inertia", "--size"}, "--size: 1 required N missing");
  expect_error({"inertia", "--width", "22", "mm", "--height", "9mm"}, "The following argument was not expected: mm");
}

// --- --check

TEST_F(CliCheck, AgreesWithWhatWasWritten) {
  for (const std::string name : {"a.txt", "a", "a.md", "a.csv", "a.json", "a.hpp", "a.h"}) {
    const std::string file = (work() / name).string();
    EXPECT_EQ(printed({"table", "--output", file}), "");
    EXPECT_EQ(printed({"table", "--check", file}), file + ": all 56 rows agree\n");
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
  EXPECT_EQ(difference(text + "more\n"), "line 58 is too much: 'more'\n");
  EXPECT_EQ(difference(text.substr(0, text.size() - 1)), "40 black, bevel 0.001 m (line 57) does not end\n");
  const std::string shorter = text.substr(0, text.find("\n33,white,0,") + 1);
  EXPECT_TRUE(difference(shorter).starts_with("33 white, sharp (line 26) is missing: '33,white,"));
  EXPECT_TRUE(difference("N" + text.substr(1)).starts_with("line 1 differs: 'Number,"));
}

TEST_F(CliCheck, FileThatCannotBeRead) {
  const std::string folder = work().string();
  expect_error({"table", "--check", folder + "/none.csv"},
               "check = " + folder + "/none.csv: cannot be read: No such file or directory");
  expect_error({"table", "--check", folder}, "check = " + folder + ": cannot be read: Is a directory");
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
