/// The program `goishi drop`: bad input.

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

class CliDropError : public Cli {
 protected:
  /// A good command but for these words.
  void expect(const Words& more, const std::string& line) const {
    Words words = {"drop", "--size", "33", "--from", "5cm"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, line);
  }

  /// One option with texts that all break the same rule.
  void expect_each(const std::string& option, const Words& texts, const std::string& rule,
                   const Words& more = {}) const {
    for (const std::string& text : texts) {
      Words words = {"--" + option, text};
      words.insert(words.end(), more.begin(), more.end());
      expect(words, option + " = " + text + ": " + rule);
    }
  }
};

const std::string range = "must be 0 or from 1e-20 to 1e20";
const std::string not_a_length = "must be a decimal number, bare (m) or with a unit (m cm mm um µm nm km)";

TEST_F(CliDropError, WhatIsNeeded) {
  expect_error({"drop"}, "a stone is needed: --size, or --width and --height");
  expect_error({"drop", "--size", "33"}, "a height is needed: --from, such as --from 5cm");
  expect_error({"drop", "--width", "1"}, "width = 1: needs --height too");
  expect_error({"drop", "--width", "2", "--height", "1", "--color", "black"}, "color = black: needs --size too");
  expect({"--width", "1", "--height", "1"}, "width = 1: must not be given with --size (33)");
  expect({"--mass", "1", "--density", "1"}, "density = 1: must not be given with --mass (1)");
  expect({"--tilt-axis", "1,0,0"}, "tilt-axis = 1,0,0: needs --tilt too");
  expect({"--series", "5"}, "series = 5: needs --csv too");
  expect({"--csv", "a.csv"}, "csv = a.csv: needs --series too");
  expect({"--slip-coefficient", "1"}, "slip-coefficient = 1: needs --friction-model slip-proportional");
  expect({"--slip-coefficient", "1", "--friction-model", "dry"},
         "slip-coefficient = 1: needs --friction-model slip-proportional");
  expect({"--patch-radius", "1mm"}, "patch-radius = 1mm: needs --friction-model coulomb-contensou");
}

TEST_F(CliDropError, TheStone) {
  expect({"--bevel", "1m"}, "bevel = 1: must be at least 0 and below the height (0.0092)");
  expect({"--mass", "0"}, "mass = 0: must be positive and finite");
  expect({"--color", "red"}, "color = red: must be white or black");
  expect_error({"drop", "--size", "41", "--from", "5cm"},
               "size = 41: must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40");
  expect_error({"drop", "--width", "1e21", "--height", "1", "--from", "5cm"},
               "width = 1e+21: " + range + " m, in magnitude");
  expect_error({"drop", "--width", "1", "--height", "1e-21", "--from", "5cm"},
               "height = 1e-21: " + range + " m, in magnitude");
  expect({"--mass", "1e21"}, "mass = 1e+21: " + range + " kg, in magnitude");
}

TEST_F(CliDropError, TheStart) {
  for (const std::string typed : {"", "nan", "inf", "high"}) {
    expect_error({"drop", "--size", "33", "--from", typed}, "from = " + typed + ": " + not_a_length);
  }
  expect_error({"drop", "--size", "33", "--from", "5ft"},
               "from = 5ft: must have one of the units m cm mm um µm nm km, not 'ft'");
  expect_error({"drop", "--size", "33", "--from", "1e21"}, "from = 1e+21: " + range + " m, in magnitude");
  expect_each("position", {"", "1", "1,2,3", "nan,0", "0,inf", "1mm,0"},
              "must be 2 decimal numbers with commas between them");
  expect({"--position", "1e21,0"}, "position = 1e+21: " + range + " m, in magnitude");
  expect_each("velocity", {"", "1,2", "1,2,3,4", "nan,0,0", "0,inf,0"},
              "must be 3 decimal numbers with commas between them");
  expect({"--velocity", "0,0,-1e21"}, "velocity = -1e+21: " + range + " m/s, in magnitude");
  expect_each("spin", {"", "1,2", "nan,0,0", "0,0,-inf"}, "must be 3 decimal numbers with commas between them");
  expect({"--spin", "0,1e-21,0"}, "spin = 1e-21: " + range + " rad/s, in magnitude");
  expect_each("tilt", {"", "nan", "inf", "10deg", "flat"}, "must be a decimal number, in degrees");
  expect_each("tilt", {"361", "-360.5"}, "must be from -360 to 360 degrees");
  expect_each("tilt-axis", {"0,0,0", "0,-0,0e5"}, "must not be zero", {"--tilt", "10"});
  expect_each("tilt-axis", {"", "x", "1,0", "nan,0,0"}, "must be 3 decimal numbers with commas between them",
              {"--tilt", "10"});
}

TEST_F(CliDropError, TheContact) {
  expect_each("restitution", {"", "nan", "inf", "half", "1,0"}, "must be a decimal number");
  expect_each("restitution", {"2", "-0.1", "1.0001"}, "must be from 0 to 1");
  expect_each("friction", {"", "nan", "-inf", "Inf", "rough"}, "must be a decimal number");
  expect({"--friction", "-0.1"}, "friction = -0.1: must be at least 0 (infinity is allowed)");
  expect({"--friction", "1e21"}, "friction = 1e+21: " + range + ", in magnitude");
  for (const std::string option : {"rolling-resistance", "pivot-radius"}) {
    expect_each(option, {"", "nan", "inf", "little"}, not_a_length);
    expect({"--" + option, "-1mm"}, option + " = -0.001: must be finite and at least 0");
  }
  expect_each("friction-model", {"", "wet", "Dry"}, "must be dry, slip-proportional or coulomb-contensou");
  const Words proportional = {"--friction-model", "slip-proportional"};
  expect_each("slip-coefficient", {"", "nan", "inf", "1 m"}, "must be a decimal number, in s/m", proportional);
  expect_each("slip-coefficient", {"-1"}, "must be finite and at least 0", proportional);
  const Words contensou = {"--friction-model", "coulomb-contensou"};
  expect_each("patch-radius", {"", "nan", "inf"}, not_a_length, contensou);
  expect_each("patch-radius", {"-1"}, "must be finite and at least 0", contensou);
  expect_each("gravity", {"", "nan", "inf", "down", "1,2", "1,2,3,4", "0,0,nan", "9.8 m/s2"},
              "must be a decimal number, downwards, or x,y,z, in m/s²");
  expect({"--gravity", "1e21"}, "gravity = 1e+21: " + range + " m/s², in magnitude");
  expect_each("law", {"", "newton", "chatterjee_ruina", "Stronge"}, "must be chatterjee-ruina, published or stronge");
  expect_each("on", {"", "floor", "Board"}, "must be board or plane");
}

TEST_F(CliDropError, UntilAndTolerance) {
  expect_each("until",
              {"", "soon", "nan", "inf", "impacts", "-impacts", "0-impacts", "-1-impacts", "2-impact", "2.5-impacts",
               "99999999999-impacts", "3-impactss", "3 -impacts"},
              "must be rest, a time such as 500ms, or a count such as 5-impacts");
  expect_each("until", {"0", "-1"}, "must be positive and finite");
  expect({"--until", "5min"}, "until = 5min: must have one of the units s ms, not 'min'");
  expect({"--until", "1e21"}, "until = 1e+21: " + range + " s, in magnitude");
  expect_each("tolerance", {"", "nan", "fine"}, "must be a decimal number");
  expect_each("tolerance", {"0", "-1", "0.02", "1e-15"}, "must be from 100 ε to 0.01");
}

TEST_F(CliDropError, Output) {
  expect_each("format", {"", "csv", "xml", "JSON"}, "must be text or json");
  const std::string file = (work() / "a.csv").string();
  expect_each("series", {"", "0", "1", "-2", "2.5", "1e3", "x", "3 ", "100001", "99999999999999999999"},
              "must be a whole number from 2 to 100000", {"--csv", file});
  EXPECT_TRUE(files().empty());
  const std::string nowhere = (work() / "none" / "a.csv").string();
  expect({"--series", "3", "--csv", nowhere}, "csv = " + nowhere + ": cannot be written: No such file or directory");
  expect({"--series", "3", "--csv", work().string()},
         "csv = " + work().string() + ": cannot be written: Is a directory");
  EXPECT_TRUE(files().empty());
  expect({"--wobble"}, "The following argument was not expected: --wobble");
  expect({"--until"}, "--until: 1 required WHEN missing");
}

}  // namespace
}  // namespace goishi::cli_test
