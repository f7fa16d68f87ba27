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
    expect_error(Words{"spin", "--spin", spin, "--time", time, "--axial", "0.02", "--transverse", "0.04"} + more, line);
  }

  void expect_moments(const std::string& axial, const std::string& transverse, const std::string& line) const {
    expect_error({"spin", "--spin", "2,4,6", "--time", "1", "--axial", axial, "--transverse", transverse}, line);
  }

  void expect_stone(const Words& more, const std::string& line) const {
    expect_error(Words{"spin", "--spin", "2,4,6", "--time", "1", "--size", "33"} + more, line);
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

TEST_F(CliSpinError, Values) {
  const std::string vector =
      ": must be 3 decimal numbers with commas between them, bare (rad/s) or with a unit (rad/s)";
  for (const std::string typed : {"1", "1,2", "1,2,3,4", "1,2,3,", ",1,2,3", "1,,3", "1 2 3", "1;2;3", "(1,2,3)"}) {
    expect_with(typed, "1", {}, "spin = " + typed + vector);
  }
  expect_error({"spin", "--size", "33", "--time", "1", "--spin", "1,", "2,", "3"}, "not expected: 2, 3");
  const std::string rule = ": must not turn the body by more than 1e20 rad, beyond which 50 digits are too few";
  expect_with("2,4,6", "1e20", {}, "time = 1e20" + rule);
  expect_with("2,4,6", "-1e20", {}, "time = -1e20" + rule);
  expect_with("2e19,4e19,6e19", "1", {}, "time = 1" + rule);
  for (const std::string bad : {"0", "-1"}) {
    expect_moments(bad, "1", "axial = " + bad + ": must be positive and finite");
    expect_moments("1", bad, "transverse = " + bad + ": must be positive and finite");
  }
  expect_moments(
      "2.001", "1",
      "axial = 2.001: must satisfy the triangle inequality: no principal moment above the sum of the other two "
      "(transverse 1)");
  EXPECT_EQ(run({"spin", "--axial", "2", "--transverse", "1", "--spin", "1,2,3", "--time", "1"}).status, 0);
}

TEST_F(CliSpinError, Stone) {
  expect_stone({"--color", "red"}, "color = red: must be white or black");
  expect_stone({"--density", "2800", "--mass", "5g"}, "density = 2800: must not be given with --mass (5g)");
  expect_error({"spin", "--width", "22mm", "--spin", "1,2,3", "--time", "1"}, "not expected: --width 22mm");
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
  const std::string rule = ": must be so long that at most 100000000 steps are taken";
  expect({"--method", "published", "--step", "0.99e-8"}, "step = 0.99e-8" + rule);
  expect({"--method", "published", "--step", "1e-100000000"}, "step = 1e-100000000" + rule);
  // 3 intervals of 1/3 s: 33 333 334 steps each.
  expect({"--method", "published", "--step", "0.9999999e-8", "--series", "4"}, "step = 0.9999999e-8" + rule);
}

TEST_F(CliSpinError, BeyondTheRangeOfADouble) {
  const std::string rule =
      ": must, in SI units, be 0 or from 1e-100 to 1e100 in magnitude: every method but 'exact' computes in double";
  const Words method = {"--method", "published", "--step", "1"};
  expect_with("0,1e101,0", "1", method, "spin = 0,1e101,0" + rule);
  expect_with("0,0,-1e-101", "1", method, "spin = 0,0,-1e-101" + rule);
  expect_with("2,4,6", "1e101", {"--method", "published", "--step", "1e101"}, "step = 1e101" + rule);
  expect_error(words_of("spin --axial 1e-101 --transverse 1e-101 --spin 1,2,3 --time 1") + method,
               "axial = 1e-101" + rule);
}

TEST_F(CliSpinError, SeriesAndFormat) {
  for (const std::string typed : {"0", "1", "-2", "2.5", "100001", "99999999999999999999"}) {
    expect({"--series", typed}, "series = " + typed + ": must be a whole number from 2 to 100000");
  }
  expect({"--series", "3", "--format", "json"}, "format = json: must not be given with --series (3)");
  for (const std::string typed : {"csv", "xml", ""}) {
    expect({"--format", typed}, "format = " + typed + ": must be text or json");
  }
}

}  // namespace
}  // namespace goishi::cli_test
