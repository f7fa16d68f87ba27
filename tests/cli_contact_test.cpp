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
  static Words with(const Words& more) {
    Words words = {"contact", "--size", "33"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] std::string json(const Words& more) const {
    Words words = with(more);
    words.insert(words.end(), {"--format", "json"});
    return printed(words);
  }
  void expect(const Words& more, const std::string& line) const { expect_error(with(more), line); }
};

/// The text of the value behind a key.
std::string value_of(const std::string& json, const std::string& key) {
  std::smatch member;
  const std::regex pattern("\"" + key + "\": (\\[[^\\]]*\\]|\"[^\"]*\"|[^,\n]*)");
  return std::regex_search(json, member, pattern) ? member[1].str() : "no such key";
}

std::vector<double> numbers_of(const std::string& json, const std::string& key) {
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
    const std::vector<double> numbers = numbers_of(json, key);
    ASSERT_EQ(numbers.size(), 3U) << json;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(numbers[static_cast<std::size_t>(i)], v[i], error) << key;
    }
  };
  EXPECT_EQ(value_of(json, "status"), "\"" + std::string(to_string(expected.status)) + "\"");
  EXPECT_EQ(value_of(json, "feature"), "\"" + std::string(to_string(expected.feature)) + "\"");
  EXPECT_NEAR(numbers_of(json, "gap").at(0), expected.gap, 0.022e-12);
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
  Words nine = beside;
  nine.insert(nine.end(), {"--lines", "9"});
  EXPECT_EQ(value_of(json(nine), "gap"), "0");
  EXPECT_EQ(value_of(json(nine), "region"), "\"right side\"");
}

// --- the time of impact

TEST_F(CliContact, TheTimeOfAFlatDrop) {
  const Words drop = {"--position", "0,0,0.1", "--velocity", "0,0,0", "--horizon", "1"};
  // 0.1 − 0.0046 = g t²/2; the speed is 1.4 m/s, the gap's round-off below 1e-17 m.
  EXPECT_NEAR(numbers_of(json(drop), "time_of_impact").at(0), std::sqrt(2 * 0.0954 / 9.80665), 1e-16);
  EXPECT_EQ(value_of(json(drop), "impact_status"), "\"hit\"");
  EXPECT_EQ(value_of(json({"--position", "0,0,0.1"}), "impact_status"), "no such key");
  Words weaker = drop;
  weaker.insert(weaker.end(), {"--gravity", "1.6", "--against", "plane"});
  EXPECT_NEAR(numbers_of(json(weaker), "time_of_impact").at(0), std::sqrt(2 * 0.0954 / 1.6), 1e-16);
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
  EXPECT_NEAR(numbers_of(json(flight), "time_of_impact").at(0), expected, 1e-14);
  Words plane = flight;
  plane.insert(plane.end(), {"--against", "plane"});
  EXPECT_NEAR(numbers_of(json(plane), "time_of_impact").at(0), expected, 1e-14);
}

TEST_F(CliContact, TheOtherStoneStaysWhereItIs) {
  // Coaxial, 0.1 − 0.0092 apart at 1 m/s.
  const std::string answer = json({"--position", "0,0,0.1", "--against", "stone", "--other-position", "0,0,0",
                                   "--velocity", "0,0,-1", "--spin", "0,0,40", "--gravity", "0", "--horizon", "1"});
  EXPECT_NEAR(numbers_of(answer, "time_of_impact").at(0), 0.0908, 1e-14);
}

// --- text and help

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

TEST_F(CliContact, TheExamplesOfItsHelpRun) {
  const std::string all = printed({"contact", "--help"});
  for (const auto* option : {"--size", "--color", "--width", "--height", "--bevel", "--position", "--attitude",
                             "--against", "--other-position", "--other-attitude", "--lines", "--velocity", "--spin",
                             "--gravity", "--horizon", "--format", "Exit status:"}) {
    EXPECT_NE(all.find(option), std::string::npos) << option;
  }
  std::istringstream help(all);
  int examples = 0;
  for (std::string line; std::getline(help, line);) {
    if (line.starts_with("  goishi contact ")) {
      std::istringstream typed(line.substr(std::string("  goishi ").size()));
      EXPECT_FALSE(printed(Words{std::istream_iterator<std::string>(typed), {}}).empty()) << line;
      ++examples;
    }
  }
  EXPECT_GE(examples, 4);
  EXPECT_NE(printed({"--help"}).find("\n  contact "), std::string::npos);
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

TEST_F(CliContact, BadPoses) {
  for (const std::string typed : {"", "1,2", "1,2,3,4", "nan,0,0", "0,inf,0", "0,0,-inf", "1,2,3mm"}) {
    expect({"--position", typed}, "position = " + typed + ": must be 3 decimal numbers with commas between them");
    expect({"--position", "0,0,1", "--against", "stone", "--other-position", typed},
           "other-position = " + typed + ": must be 3 decimal numbers with commas between them");
  }
  const std::string rule = ": must be a unit quaternion w,x,y,z to 15 digits; the sum of its squares is ";
  expect({"--position", "0,0,1", "--attitude", "1,1,0,0"}, "attitude = 1,1,0,0" + rule + "2.0000000000000000");
  expect({"--position", "0,0,1", "--attitude", "1,0,0,nan"},
         "attitude = 1,0,0,nan: must be 4 decimal numbers with commas between them");
  expect({"--position", "0,0,1", "--against", "stone", "--other-position", "0,0,0", "--other-attitude", "0,0,0,0"},
         "other-attitude = 0,0,0,0" + rule + "0");
}

TEST_F(CliContact, BadValues) {
  const auto bad = [this](const std::string& option, const std::string& typed, const std::string& rule,
                          const Words& more = {}) {
    Words words = {"--position", "0,0,1", "--" + option, typed};
    words.insert(words.end(), more.begin(), more.end());
    expect(words, option + " = " + typed + ": " + rule);
  };
  for (const std::string typed : {"", "ball", "Board"}) {
    bad("against", typed, "must be board, plane or stone");
  }
  for (const std::string typed : {"", "0", "-1", "1.5", "x", "9 ", "99999999999"}) {
    bad("lines", typed, "must be a whole number, at least 1");
  }
  bad("format", "csv", "must be text or json");
  const Words flying = {"--velocity", "0,0,0"};
  bad("horizon", "0", "must be positive and finite", flying);
  bad("horizon", "-1", "must be positive and finite", flying);
  bad("horizon", "nan", "must be a decimal number, bare (s) or with a unit (s ms)", flying);
  bad("horizon", "inf", "must be a decimal number, bare (s) or with a unit (s ms)", flying);
  const Words soon = {"--horizon", "1"};
  bad("velocity", "0,0", "must be 3 decimal numbers with commas between them", soon);
  bad("spin", "nan,0,0", "must be 3 decimal numbers with commas between them", soon);
  bad("gravity", "inf", "must be a decimal number, in m/s²", {"--velocity", "0,0,0", "--horizon", "1"});
  expect({"--position", "0,0,1", "--bevel", "1m"}, "bevel = 1: must be at least 0 and below the height (0.0092)");
}

TEST_F(CliContact, BeyondTheRangeOfADouble) {
  const std::string rule = ": is beyond the range of a double, in which the time of impact computes";
  expect({"--position", "0,0,1e400", "--velocity", "0,0,0", "--horizon", "1"}, "position = 1e+400" + rule);
  expect({"--position", "0,0,1", "--velocity", "0,0,-1e400", "--horizon", "1"}, "velocity = -1e+400" + rule);
  expect({"--position", "0,0,1", "--velocity", "0,0,0", "--horizon", "1e-400"}, "horizon = 1e-400" + rule);
  // The separation has no such limit.
  EXPECT_EQ(value_of(json({"--position", "0,0,1e400", "--against", "plane"}), "gap").substr(0, 3), "1.0");
}

}  // namespace
}  // namespace goishi::cli_test
