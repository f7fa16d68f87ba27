/// The program `goishi contact`.

#include <cmath>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/state.hpp>
#include <regex>
#include <sstream>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

class CliContact : public Cli {
 protected:
  /// A good command with more words.
  static Words with(const Words& more) { return Words{"contact", "--size", "33"} + more; }
  [[nodiscard]] std::string json(const Words& more) const { return printed(with(more) + Words{"--format", "json"}); }
  void expect(const Words& more, const std::string& line) const { expect_error(with(more), line); }
};

/// The text of the value behind a key.
std::string value_of(const std::string& json, const std::string& key) {
  std::smatch member;
  const std::regex pattern("\"" + key + "\": (\\[[^\\]]*\\]|\"[^\"]*\"|[^,\n]*)");
  return std::regex_search(json, member, pattern) ? member[1].str() : "no such key";
}

std::vector<double> values_of(const std::string& json, const std::string& key) {
  const std::string value = value_of(json, key);
  const std::regex number("-?[0-9][-+.e0-9]*");
  std::vector<double> numbers;
  for (std::sregex_iterator i(value.begin(), value.end(), number), end; i != end; ++i) {
    numbers.push_back(std::strtod(i->str().c_str(), nullptr));
  }
  return numbers;
}

/// The same separation, to 1e-12 of the width (CONTACT-4) where it is not sharper.
void expect_same(const std::string& json, const Separation<double>& expected) {
  const auto expect_vector = [&](const std::string& key, const Vec3<double>& v, double error) {
    const std::vector<double> numbers = values_of(json, key);
    ASSERT_EQ(numbers.size(), 3U) << json;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(numbers[static_cast<std::size_t>(i)], v[i], error) << key;
    }
  };
  EXPECT_EQ(value_of(json, "status"), "\"" + std::string(to_string(expected.status)) + "\"");
  EXPECT_EQ(value_of(json, "feature"), "\"" + std::string(to_string(expected.feature)) + "\"");
  EXPECT_NEAR(values_of(json, "gap").at(0), expected.gap, 0.022e-12);
  expect_vector("normal", expected.n_W, 1e-9);
  expect_vector("point_on_stone", expected.p_stone, 0.022e-9);
  expect_vector("point_on_other", expected.p_other, 0.022e-9);
}

// --- separations

TEST_F(CliContact, JsonHasTheKeysAnd17Digits) {
  EXPECT_EQ(json({"--position", "0.01,0,0.0146"}),
            "{\n"
            "  \"status\": \"separated\",\n"
            "  \"gap\": 0.010000000000000000,\n"
            "  \"normal\": [0, 0, 1.0000000000000000],\n"
            "  \"point_on_stone\": [0.010000000000000000, 0, 0.010000000000000000],\n"
            "  \"point_on_other\": [0.010000000000000000, 0, 0],\n"
            "  \"feature\": \"lower cap\",\n"
            "  \"region\": \"out of reach\"\n"
            "}\n");
}

TEST_F(CliContact, EveryDigitIsRight) {
  // w = 8, h = 4: r = 5, d = 3. The axis leans by the cosine 4/5 to x: r − 3 · 4/5 over the cap's point.
  const std::string leaning = printed({"contact", "--width", "8", "--height", "4", "--position", "0,0,3", "--attitude",
                                       "0.948683298050513799599668063329816,0,0.316227766016837933199889354443272,0",
                                       "--against", "plane", "--format", "json"});
  EXPECT_EQ(value_of(leaning, "gap"), "0.40000000000000000");
  EXPECT_EQ(value_of(leaning, "point_on_stone"), "[1.8000000000000000, 0, 0.40000000000000000]");
  EXPECT_EQ(value_of(leaning, "region"), "null");
}

TEST_F(CliContact, NoSizeIsTooSmallOrTooLarge) {
  // The same at every scale: over the plane, and apart from its like.
  for (const std::string scale : {"", "e300", "e-300", "e99999999", "e-99999999"}) {
    const std::string lens = "contact --width 8" + scale + " --height 4" + scale + " --format json --position ";
    const std::string unit = "1.0000000000000000" + (scale.empty() || scale[1] == '-' ? scale : "e+" + scale.substr(1));
    EXPECT_EQ(value_of(printed(words_of(lens + "0,0,3" + scale + " --against plane")), "gap"), unit);
    EXPECT_EQ(value_of(printed(words_of(lens + "0,0,0 --against stone --other-position 0,0,5" + scale)), "gap"), unit);
  }
  const std::string far =
      printed(words_of("contact --size 33 --format json --position 0,0,1e-300 --against stone "
                       "--other-position 0,0,1e300"));
  EXPECT_EQ(value_of(far, "gap"), "1.0000000000000000e+300");
  EXPECT_EQ(value_of(far, "normal"), "[0, 0, -1.0000000000000000]");
}

TEST_F(CliContact, WhatTouchesHasTheGapZero) {
  for (const Words& pose : {Words{"--position", "0,0,0.0046"},
                            {"--position", "0,0,0.011", "--attitude", "0.70710678118654752,0.70710678118654752,0,0"},
                            {"--position", "0.2231,0,-0.05"}}) {
    const std::string touching = json(pose);
    EXPECT_EQ(value_of(touching, "gap"), "0");
    EXPECT_EQ(value_of(touching, "status"), "\"separated\"");
  }
}

TEST_F(CliContact, WithTheBoardAgreesWithTheLibrary) {
  const Board<double> real = make_board<double>();
  const Quat<double> q(0.8, 0.0, 0.6, 0.0);
  for (const Vec3<double>& p :
       {Vec3<double>(0.0, 0.0, 0.005), Vec3<double>(0.2161, 0.0, 0.002), Vec3<double>(-0.214, 0.1, 0.003),
        Vec3<double>(0.215, -0.23, 0.004), Vec3<double>(0.215, 0.2, -0.05), Vec3<double>(0.22, 0.232, -0.05)}) {
    std::ostringstream position;
    position.precision(17);
    position << p.x() << "," << p.y() << "," << p.z();
    const std::string answer = json({"--bevel", "1mm", "--position", position.str(), "--attitude", "0.8,0,0.6,0"});
    const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
    expect_same(answer, separation(stone, Pose<double>{.p_WB = p, .q_WB = q}, real));
    EXPECT_EQ(value_of(answer, "region"),
              "\"" + std::string(to_string(region_of(real, p, outer_width(stone) / 2))) + "\"");
  }
}

TEST_F(CliContact, WithAnotherStoneAgreesWithTheLibrary) {
  const std::string answer =
      json({"--color", "black", "--bevel", "1mm", "--position", "0.01,0.004,0.012", "--attitude", "0.8,0,0.6,0",
            "--against", "stone", "--other-position", "0,0,0.005", "--other-attitude", "0,0.6,0,0.8"});
  const Stone<double> stone = make_stone(0.0223, 0.0098, 0.001);
  expect_same(answer, separation(stone, {.p_WB = {0.01, 0.004, 0.012}, .q_WB = Quat<double>(0.8, 0.0, 0.6, 0.0)}, stone,
                                 {.p_WB = {0.0, 0.0, 0.005}, .q_WB = Quat<double>(0.0, 0.6, 0.0, 0.8)}));
  EXPECT_EQ(value_of(answer, "region"), "null");
  // Coincident centres are ordinary.
  EXPECT_EQ(value_of(json({"--position", "0,0,0", "--against", "stone", "--other-position", "0,0,0"}), "gap"),
            "-0.0092000000000000000");
}

TEST_F(CliContact, TheBoardIsTheRealOneUnlessLinesAreGiven) {
  const Words beside = {"--position", "0.1131,0,-0.05"};
  // 0.2121 wide at 19 lines: 0.2121 − 0.1131 + 0.011 is farther than up. At 9 lines its side is at 0.1021: it touches.
  EXPECT_EQ(value_of(json(beside), "gap"), "-0.054600000000000000");
  EXPECT_EQ(value_of(json(beside), "region"), "\"primary\"");
  const Words nine = beside + Words{"--lines", "9"};
  EXPECT_EQ(value_of(json(nine), "gap"), "0");
  EXPECT_EQ(value_of(json(nine), "region"), "\"right side\"");
}

// --- the time of impact

TEST_F(CliContact, TheTimeOfAFlatDrop) {
  const Words drop = {"--position", "0,0,0.1", "--velocity", "0,0,0", "--horizon", "1"};
  // 0.1 − 0.0046 = g t²/2; the speed is 1.4 m/s, the gap's round-off below 1e-17 m.
  EXPECT_NEAR(values_of(json(drop), "time_of_impact").at(0), std::sqrt(2 * 0.0954 / 9.80665), 1e-16);
  EXPECT_EQ(value_of(json(drop), "impact_status"), "\"hit\"");
  EXPECT_EQ(value_of(json({"--position", "0,0,0.1"}), "impact_status"), "no such key");
  const Words weaker = drop + Words{"--gravity", "1.6", "--against", "plane"};
  EXPECT_NEAR(values_of(json(weaker), "time_of_impact").at(0), std::sqrt(2 * 0.0954 / 1.6), 1e-16);
}

TEST_F(CliContact, TheTimeIsNullWithoutAHit) {
  const std::string none = json({"--position", "0,0,0.1", "--velocity", "0,0,0", "--horizon", "100ms"});
  EXPECT_EQ(value_of(none, "time_of_impact"), "null");
  EXPECT_EQ(value_of(none, "impact_status"), "\"none\"");
  const std::string overlapping = json({"--position", "0,0,0.001", "--spin", "1,2,3", "--horizon", "1"});
  EXPECT_EQ(value_of(overlapping, "time_of_impact"), "null");
  EXPECT_EQ(value_of(overlapping, "impact_status"), "\"overlapping\"");
}

TEST_F(CliContact, ATurningStoneAgreesWithTheLibrary) {
  const Stone<double> stone = make_stone(0.022, 0.0092);
  const RigidBody<double> body = make_rigid_body(mass_properties(stone, Density{2800.0}));
  const Quat<double> q(0.8, 0.0, 0.6, 0.0);
  const Vec3<double> L_W = formula::angular_momentum_W(q, body, Vec3<double>(30.0, -10.0, 50.0));
  const FlightPath<double> path{.p_W = {0.0, 0.0, 0.05},
                                .v_W = {0.1, 0.0, -0.5},
                                .a_W = {0.0, 0.0, -9.80665},
                                .u_W = formula::symmetry_axis(q),
                                .k_W = L_W / L_W.norm(),
                                .rate = L_W.norm() / body.moments.x()};
  const Words flight = {"--position", "0,0,0.05", "--attitude", "0.8,0,0.6,0", "--velocity",
                        "0.1,0,-0.5", "--spin",   "30,-10,50",  "--horizon",   "1"};
  const double expected = time_of_impact(stone, path, make_board<double>(), 1.0).time;
  EXPECT_NEAR(values_of(json(flight), "time_of_impact").at(0), expected, 1e-14);
  const Words plane = flight + Words{"--against", "plane"};
  EXPECT_NEAR(values_of(json(plane), "time_of_impact").at(0), expected, 1e-14);
}

TEST_F(CliContact, TheOtherStoneStaysWhereItIs) {
  // Coaxial, 0.1 − 0.0092 apart at 1 m/s.
  const std::string answer = json({"--position", "0,0,0.1", "--against", "stone", "--other-position", "0,0,0",
                                   "--velocity", "0,0,-1", "--spin", "0,0,40", "--gravity", "0", "--horizon", "1"});
  EXPECT_NEAR(values_of(answer, "time_of_impact").at(0), 0.0908, 1e-14);
}

// --- text

TEST_F(CliContact, TextSaysWhatTouchesWhat) {
  const std::string text =
      printed(with({"--bevel", "1mm", "--position", "0,0,0.1", "--velocity", "0,0,0", "--horizon", "1"}));
  EXPECT_TRUE(text.starts_with("The white stone of size 33, bevel 0.001 m, against the board with 19 lines\n\n"))
      << text;
  for (const auto* line :
       {"status +separated", "gap +0[.]0954 +m", "normal, out of the other +n_x +0", " +n_z +1",
        "point on the stone +p_x +0 +m", "touching, of the stone +lower cap", "touching, of the other +surface",
        "region +out of reach", "impact +hit", "time of impact +t +0[.]139485 +s"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex("\n" + std::string(line) + "\n"))) << line << "\n" << text;
  }
  EXPECT_EQ(printed(with({"--position", "0,0,0.1", "--format", "text"})), printed(with({"--position", "0,0,0.1"})));
}

// --- bad input

TEST_F(CliContact, WhatIsNeeded) {
  expect_error({"contact"}, "a stone is needed: --size, or --width and --height");
  expect({}, "a position is needed: --position, such as --position 0,0,0.01");
  expect_error({"contact", "--width", "1"}, "width = 1: needs --height too");
  expect({"--width", "1", "--height", "1"}, "width = 1: must not be given with --size (33)");
  expect_error({"contact", "--width", "2", "--height", "1", "--color", "black"}, "color = black: needs --size too");
  expect({"--position", "0,0,1", "--against", "stone"}, "against = stone: needs --other-position too");
  expect({"--position", "0,0,1", "--other-position", "0,0,0"}, "other-position = 0,0,0: needs --against stone");
  expect({"--position", "0,0,1", "--other-attitude", "1,0,0,0"}, "other-attitude = 1,0,0,0: needs --against stone");
  expect({"--position", "0,0,1", "--against", "plane", "--lines", "9"}, "lines = 9: needs --against board");
  expect({"--position", "0,0,1", "--velocity", "0,0,0"}, "velocity = 0,0,0: needs --horizon too");
  expect({"--position", "0,0,1", "--spin", "0,0,1"}, "spin = 0,0,1: needs --horizon too");
  expect({"--position", "0,0,1", "--gravity", "9.8"}, "gravity = 9.8: needs --horizon too");
  expect({"--position", "0,0,1", "--horizon", "1"}, "horizon = 1: needs --velocity or --spin too");
}

TEST_F(CliContact, BadValues) {
  const auto bad = [this](const std::string& option, const std::string& typed, const std::string& rule,
                          const Words& more = {}) {
    expect(Words{"--position", "0,0,1", "--" + option, typed} + more, option + " = " + typed + ": " + rule);
  };
  for (const std::string typed : {"", "ball", "Board"}) {
    bad("against", typed, "must be board, plane or stone");
  }
  for (const std::string typed : {"0", "-1", "1.5", "2147483648", "1e100000000"}) {
    bad("lines", typed, "must be a whole number from 1 to 2147483647");
  }
  bad("format", "csv", "must be text or json");
  for (const std::string typed : {"0", "-1"}) {
    bad("horizon", typed, "must be positive and finite", {"--velocity", "0,0,0"});
  }
  for (const std::string typed : {"0,0", "0,0,1,", "0;0;1"}) {
    expect({"--position", typed}, "position = " + typed +
                                      ": must be 3 decimal numbers with commas between them, bare (m) or with a unit "
                                      "(m, cm, mm, µm, nm, km)");
  }
}

TEST_F(CliContact, BeyondTheRangeOfADouble) {
  const std::string rule =
      ": must, in SI units, be 0 or from 1e-20 to 1e20 in magnitude: the time of impact computes in double";
  const auto bad = [&](const std::string& words, const std::string& option, const std::string& typed) {
    expect_error(words_of("contact " + words + " --" + option + " " + typed), option + " = " + typed + rule);
  };
  const std::string stone = "--size 33 ", still = "--velocity 0,0,0 ", soon = "--horizon 1 ",
                    there = "--position 0,0,1 ";
  for (const std::string typed : {"1.0001e20", "0.9999e-20"}) {
    bad(stone + soon + still, "position", "0,0," + typed);
    bad(stone + soon + still + there + "--against stone", "other-position", "0," + typed + ",0");
    bad(stone + soon + there, "velocity", typed + ",0,0");
    bad(stone + soon + there, "spin", "0,0,-" + typed);
    bad(stone + soon + still + there, "gravity", typed);
    bad(stone + still + there, "horizon", typed);
  }
  bad("--height 1 " + soon + still + there, "width", "1.0001e20");
  bad("--width 1 " + soon + still + there, "height", "0.9999e-20");
  bad(stone + soon + still + there, "bevel", "0.9999e-20");
  // The separation has no such limit.
  EXPECT_EQ(value_of(json({"--position", "0,0,1e400", "--against", "plane"}), "gap").substr(0, 3), "1.0");
}

}  // namespace
}  // namespace goishi::cli_test
