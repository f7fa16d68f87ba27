/// The program `goishi spin`: bad input.

#include <goishi/motion/steppers.hpp>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

class CliSpinError : public Cli {
 protected:
  /// A good command but for these words.
  void expect(const Words& more, const std::string& line) const { expect_with("2,4,6", "1", more, line); }

  void expect_with(const std::string& spin, const std::string& time, const Words& more, const std::string& line) const {
    Words words = {"spin", "--spin", spin, "--time", time, "--axial", "0.02", "--transverse", "0.04"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, line);
  }

  void expect_moments(const std::string& axial, const std::string& transverse, const std::string& line) const {
    expect_error({"spin", "--spin", "2,4,6", "--time", "1", "--axial", axial, "--transverse", transverse}, line);
  }

  void expect_stone(const Words& more, const std::string& line) const {
    Words words = {"spin", "--spin", "2,4,6", "--time", "1", "--size", "33"};
    words.insert(words.end(), more.begin(), more.end());
    expect_error(words, line);
  }
};

TEST_F(CliSpinError, WhatIsNeeded) {
  expect_error({"spin"}, "a body is needed: --size, or --axial and --transverse");
  expect_error({"spin", "--size", "33"}, "a spin is needed: --spin, such as --spin 0,5,60");
  expect_error({"spin", "--size", "33", "--spin", "1,2,3"}, "a time is needed: --time, such as --time 2.5");
  expect_error({"spin", "--spin", "1,2,3", "--time", "1"}, "a body is needed: --size, or --axial and --transverse");
  expect_error({"spin", "--spin", "1,2,3", "--time", "1", "--axial", "1"}, "axial = 1: needs --transverse too");
  expect_error({"spin", "--spin", "1,2,3", "--time", "1", "--transverse", "1"}, "transverse = 1: needs --axial too");
  expect_stone({"--axial", "1", "--transverse", "1"}, "axial = 1: must not be given with --size (33)");
  expect_stone({"--transverse", "1"}, "transverse = 1: must not be given with --size (33)");
  expect({"--color", "black"}, "color = black: needs --size too");
  expect({"--bevel", "1mm"}, "bevel = 1mm: needs --size too");
  expect({"--mass", "5g"}, "mass = 5g: needs --size too");
  expect({"--density", "2800"}, "density = 2800: needs --size too");
}

TEST_F(CliSpinError, Spin) {
  for (const std::string typed : {"", "1", "1,2", "1,2,3,4", "1,2,3,", ",1,2,3", "1,,3", "1 2 3", "1;2;3", "1,2,x",
                                  "nan,2,3", "1,inf,3", "1,2,3rad", "(1,2,3)", "1,2,1e100000001"}) {
    expect_with(typed, "1", {}, "spin = " + typed + ": must be 3 decimal numbers with commas between them");
  }
  expect_error({"spin", "--size", "33", "--time", "1", "--spin", "1,", "2,", "3"},
               "The following arguments were not expected: 3 2,");
}

TEST_F(CliSpinError, Attitude) {
  for (const std::string typed : {"", "1", "1,0,0", "1,0,0,0,0", "nan,0,0,0", "1,0,0,inf"}) {
    expect({"--attitude", typed}, "attitude = " + typed + ": must be 4 decimal numbers with commas between them");
  }
  const std::string rule = ": must be a unit quaternion w,x,y,z to 15 digits; the sum of its squares is ";
  expect({"--attitude", "0,0,0,0"}, "attitude = 0,0,0,0" + rule + "0");
  expect({"--attitude", "1,1,0,0"}, "attitude = 1,1,0,0" + rule + "2.0000000000000000");
  expect({"--attitude", "0.5,0,0,0"}, "attitude = 0.5,0,0,0" + rule + "0.25000000000000000");
  expect({"--attitude", "0.707106781187,0.707106781187,0,0"},
         "attitude = 0.707106781187,0.707106781187,0,0" + rule + "1.0000000000012798");
  // 64 ε of double is 1.42e-14.
  expect({"--attitude", "1.0000000000000072,0,0,0"},
         "attitude = 1.0000000000000072,0,0,0" + rule + "1.0000000000000144");
  EXPECT_EQ(
      run({"spin", "--size", "33", "--spin", "1,2,3", "--time", "1", "--attitude", "1.000000000000007,0,0,0"}).status,
      0);
}

TEST_F(CliSpinError, Time) {
  for (const std::string typed : {"", "nan", "inf", "-inf", "soon"}) {
    expect_with("2,4,6", typed, {}, "time = " + typed + ": must be a decimal number, bare (s) or with a unit (s ms)");
  }
  expect_with("2,4,6", "1min", {}, "time = 1min: must have one of the units s ms, not 'min'");
  expect_with("2,4,6", "1e100000001", {}, "time = 1e100000001: must be 0 or from 1e-100000000 to 1e100000000 s");
  const std::string rule = ": must not turn the body by more than 1e20 rad, beyond which 50 digits are too few";
  expect_with("2,4,6", "1e20", {}, "time = 1e+20" + rule);
  expect_with("2,4,6", "-1e20", {}, "time = -1e+20" + rule);
  expect_with("2e19,4e19,6e19", "1", {}, "time = 1" + rule);
}

TEST_F(CliSpinError, Moments) {
  for (const std::string bad : {"0", "-1"}) {
    expect_moments(bad, "1", "axial = " + bad + ": must be positive and finite");
    expect_moments("1", bad, "transverse = " + bad + ": must be positive and finite");
  }
  for (const std::string bad : {"", "nan", "inf", "1g", "1 kg"}) {
    expect_moments(bad, "1", "axial = " + bad + ": must be a decimal number, in kg m²");
    expect_moments("1", bad, "transverse = " + bad + ": must be a decimal number, in kg m²");
  }
  expect_moments("1e100000001", "1", "axial = 1e100000001: must be 0 or from 1e-100000000 to 1e100000000 kg m²");
  expect_moments(
      "2.001", "1",
      "axial = 2.001: must satisfy the triangle inequality: no principal moment above the sum of the other two "
      "(transverse 1)");
  EXPECT_EQ(run({"spin", "--axial", "2", "--transverse", "1", "--spin", "1,2,3", "--time", "1"}).status, 0);
}

TEST_F(CliSpinError, Stone) {
  expect_stone({"--color", "red"}, "color = red: must be white or black");
  expect_stone({"--bevel", "1m"}, "bevel = 1: must be at least 0 and below the height (0.0092)");
  expect_stone({"--mass", "0"}, "mass = 0: must be positive and finite");
  expect_stone({"--density", "-1"}, "density = -1: must be positive and finite");
  expect_stone({"--density", "2800", "--mass", "5g"}, "density = 2800: must not be given with --mass (5g)");
  expect_error({"spin", "--size", "41", "--spin", "1,2,3", "--time", "1"},
               "size = 41: must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40");
  expect_error({"spin", "--width", "22mm", "--spin", "1,2,3", "--time", "1"},
               "The following arguments were not expected: 22mm --width");
}

TEST_F(CliSpinError, Method) {
  std::string names;
  for (const SchemeInfo& one : schemes) {
    names += " " + std::string(one.name);
  }
  for (const std::string typed : {"", "euler", "Exact", "runge_kutta_4"}) {
    expect({"--method", typed}, "method = " + typed + ": must be one of" + names);
  }
  expect({"--step", "1"}, "step = 1: needs a --method that takes steps; 'exact' takes none");
  for (const SchemeInfo& one : schemes) {
    if (one.scheme != Scheme::exact) {
      const std::string name(one.name);
      expect({"--method", name}, "method = " + name + ": needs --step too");
      expect_with("2,4,6", "-1", {"--method", name, "--step", "1"},
                  "time = -1: must not be negative with --method " + name + ", which steps forward");
    }
  }
}

TEST_F(CliSpinError, Step) {
  for (const std::string typed : {"0", "-1"}) {
    expect({"--method", "published", "--step", typed}, "step = " + typed + ": must be positive and finite");
  }
  for (const std::string typed : {"nan", "inf", ""}) {
    expect({"--method", "published", "--step", typed},
           "step = " + typed + ": must be a decimal number, bare (s) or with a unit (s ms)");
  }
  const std::string rule = ": must be so long that at most 1000000000 steps are taken";
  expect({"--method", "published", "--step", "0.99e-9"}, "step = 9.9e-10" + rule);
  expect({"--method", "published", "--step", "1e-100000000"}, "step = 1e-100000000" + rule);
  // 3 intervals of 1/3 s: 333 333 334 steps each.
  expect({"--method", "published", "--step", "0.99999999e-9", "--series", "4"}, "step = 9.9999999e-10" + rule);
}

TEST_F(CliSpinError, BeyondTheRangeOfADouble) {
  const std::string rule = ": is beyond the range of a double, in which every method but 'exact' computes";
  const Words method = {"--method", "published", "--step", "1"};
  expect_with("0,1e400,0", "1", method, "spin = 1e+400" + rule);
  expect_with("0,0,-1e-400", "1", method, "spin = -1e-400" + rule);
  expect_with("2,4,6", "1e400", {"--method", "published", "--step", "1e400"}, "step = 1e+400" + rule);
  expect_error({"spin", "--axial", "1e-400", "--transverse", "1e-400", "--spin", "1,2,3", "--time", "1", "--method",
                "published", "--step", "1"},
               "axial = 1e-400" + rule);
}

TEST_F(CliSpinError, SeriesAndFormat) {
  for (const std::string typed : {"", "0", "1", "-2", "2.5", "1e3", "x", "3 ", "100001", "99999999999999999999"}) {
    expect({"--series", typed}, "series = " + typed + ": must be a whole number from 2 to 100000");
  }
  expect({"--series", "3", "--format", "json"}, "format = json: must not be given with --series (3)");
  for (const std::string typed : {"csv", "xml", ""}) {
    expect({"--format", typed}, "format = " + typed + ": must be text or json");
  }
}

}  // namespace
}  // namespace goishi::cli_test
