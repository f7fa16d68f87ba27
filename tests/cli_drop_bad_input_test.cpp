/// The program `goishi drop`: bad input.

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

class CliDropError : public Cli {
 protected:
  /// A good command but for these words.
  void expect(const Words& more, const std::string& line) const {
    expect_error(Words{"drop", "--size", "33", "--from", "5cm"} + more, line);
  }

  /// One option with texts that all break the same rule.
  void expect_each(const std::string& option, const Words& texts, const std::string& rule,
                   const Words& more = {}) const {
    for (const std::string& text : texts) {
      expect(Words{"--" + option, text} + more, option + " = " + text + ": " + rule);
    }
  }
};

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

TEST_F(CliDropError, TheNames) {
  expect({"--color", "red"}, "color = red: must be white or black");
  expect_each("friction-model", {"", "wet", "Dry"}, "must be dry, slip-proportional or coulomb-contensou");
  expect_each("law", {"", "newton", "chatterjee_ruina", "Stronge"}, "must be chatterjee-ruina, published or stronge");
  expect_each("on", {"", "floor", "Board"}, "must be board, floor-board or plane");
}

TEST_F(CliDropError, TheValues) {
  expect({"--position", "1"},
         "position = 1: must be 2 decimal numbers with commas between them, bare (m) or with a unit (m, cm, mm, µm, "
         "nm, km)");
  expect_each("tilt", {"361", "-360.5"}, "must be from -360 to 360 degrees");
  expect_each("tilt-axis", {"0,0,0", "0,-0,0e5"}, "must not be zero", {"--tilt", "10"});
  expect_each("restitution", {"2", "-0.1", "1.0001"}, "must be from 0 to 1");
  expect({"--friction", "-0.1"}, "friction = -0.1: must be at least 0 (infinity is allowed)");
  for (const std::string option : {"rolling-resistance", "pivot-radius"}) {
    expect({"--" + option, "-1mm"}, option + " = -1mm: must be finite and at least 0");
  }
  expect_each("slip-coefficient", {"-1"}, "must be finite and at least 0", {"--friction-model", "slip-proportional"});
  expect_each("patch-radius", {"-1"}, "must be finite and at least 0", {"--friction-model", "coulomb-contensou"});
  expect_each("until",
              {"", "soon", "nan", "inf", "impacts", "-impacts", "0-impacts", "-1-impacts", "2-impact", "2.5-impacts",
               "99999999999-impacts", "3-impactss"},
              "must be rest, a time such as 500ms, or a count such as 5-impacts");
  expect_each("until", {"0", "-1"}, "must be positive and finite");
  expect_each("tolerance", {"0", "-1", "0.02", "1e-15"}, "must be from 100 ε to 0.01");
}

TEST_F(CliDropError, BeyondTheRangeOfADouble) {
  const std::string rule = "must, in SI units, be 0 or from 1e-20 to 1e20 in magnitude: a drop computes in double";
  const Words contensou = {"--friction-model", "coulomb-contensou"};
  const Words proportional = {"--friction-model", "slip-proportional"};
  for (const std::string typed : {"1.0001e20", "0.9999e-20"}) {
    for (const std::string option : {"mass", "density", "friction", "rolling-resistance", "pivot-radius", "gravity"}) {
      expect_each(option, {typed}, rule);
    }
    expect_each("slip-coefficient", {typed}, rule, proportional);
    expect_each("patch-radius", {typed}, rule, contensou);
    expect_each("position", {typed + ",0", "0,-" + typed}, rule);
    for (const std::string option : {"velocity", "spin", "gravity"}) {
      expect_each(option, {typed + ",0,0", "0,-" + typed + ",0", "0,0," + typed}, rule);
    }
    expect_error({"drop", "--size", "33", "--from", typed}, "from = " + typed + ": " + rule);
  }
  expect({"--until", "1.0001e20"}, "until = 1.0001e20: " + rule);
  expect({"--bevel", "0.9999e-20"}, "bevel = 0.9999e-20: " + rule);
  expect_error({"drop", "--width", "1e21", "--height", "1", "--from", "5cm"}, "width = 1e21: " + rule);
  expect_error({"drop", "--width", "1", "--height", "1e-21", "--from", "5cm"}, "height = 1e-21: " + rule);
}

TEST_F(CliDropError, Output) {
  expect_each("format", {"", "csv", "xml", "JSON"}, "must be text or json");
  const std::string file = (work() / "a.csv").string();
  expect_each("series", {"0", "1", "-2", "2.5", "1000001", "99999999999999999999"},
              "must be a whole number from 2 to 1000000", {"--csv", file});
  EXPECT_TRUE(files().empty());
  const std::string nowhere = (work() / "none" / "a.csv").string();
  expect({"--series", "3", "--csv", nowhere}, "csv = " + nowhere + ": cannot be written: No such file or directory");
  expect({"--series", "3", "--csv", work().string()},
         "csv = " + work().string() + ": cannot be written: Is a directory");
  EXPECT_TRUE(files().empty());
  expect({"--wobble"}, "not expected: --wobble");
  expect({"--until"}, "--until: 1 required WHEN missing");
}

}  // namespace
}  // namespace goishi::cli_test
