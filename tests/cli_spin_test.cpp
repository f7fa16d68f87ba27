/// The program `goishi spin`.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/steppers.hpp>
#include <goishi/shape/catalogue.hpp>
#include <regex>
#include <sstream>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

using CliSpin = Cli;
using Hundred = boost::multiprecision::cpp_bin_float_100;

const Words kane_body = {"spin", "--axial", "0.02", "--transverse", "0.04", "--spin", "2,4,6"};

Words with(const Words& words, const Words& more) {
  return words + more;
}

/// The words with the option's value replaced.
Words with_value(Words words, const std::string& option, const std::string& value) {
  *std::next(std::ranges::find(words, option)) = value;
  return words;
}

/// The texts of the numbers behind a key, a number or an array of them.
std::vector<std::string> texts_of(const std::string& json, const std::string& key) {
  std::smatch member;
  const std::regex pattern("\"" + key + "\": (\\[[^\\]]*\\]|[^,\n]*)");
  std::vector<std::string> texts;
  if (std::regex_search(json, member, pattern)) {
    const std::string value = member[1];
    const std::regex number("[-+.e0-9]+");
    for (std::sregex_iterator i(value.begin(), value.end(), number), end; i != end; ++i) {
      texts.push_back(i->str());
    }
  }
  return texts;
}

std::vector<double> numbers_of(const std::string& json, const std::string& key) {
  std::vector<double> numbers;
  for (const std::string& text : texts_of(json, key)) {
    numbers.push_back(std::strtod(text.c_str(), nullptr));
  }
  return numbers;
}

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected, double error) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], error) << "component " << i;
  }
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

// --- the exact motion

TEST_F(CliSpin, OfThePublishedCase) {
  // Kane's symmetric top, as Drake's free body test has it; 15 digits are published.
  const std::string json = printed(with(kane_body, {"--time", "10", "--format", "json"}));
  expect_near(numbers_of(json, "attitude"),
              {-0.185871916511538, 0.195938189833834, -0.785967065292867, -0.556161513134347}, 5e-16);
  expect_near(numbers_of(json, "spin_body"), {-3.64362359659628, 2.59306904773606, 6.0}, 5e-15);
  EXPECT_EQ(texts_of(json, "angular_momentum"),
            (std::vector<std::string>{"0.080000000000000000", "0.16000000000000000", "0.12000000000000000"}));
  EXPECT_EQ(texts_of(json, "energy"), std::vector<std::string>{"0.76000000000000000"});
}

TEST_F(CliSpin, NothingIsTooLightOrTooSlow) {
  const std::vector<std::string> attitude =
      texts_of(printed(with(kane_body, {"--time", "10", "--format", "json"})), "attitude");
  const std::pair<std::string, std::string> scales[] = {
      {"e300", "e-300"}, {"e-300", "e300"}, {"e99999990", "e-99999990"}, {"e-99999990", "e99999990"}};
  for (const auto& [scale, inverse] : scales) {
    EXPECT_EQ(
        texts_of(printed(words_of("spin --axial 0.02" + inverse + " --transverse 0.04" + inverse + " --spin 2" + scale +
                                  ",4" + scale + ",6" + scale + " --time 10" + inverse + " --format json")),
                 "attitude"),
        attitude);
  }
}

TEST_F(CliSpin, JsonHasTheKeysAnd17Digits) {
  const std::string json = printed(with(kane_body, {"--time", "10", "--format", "json"}));
  const std::string number = "-?\\d[.]\\d{16}|-?0[.]0*[1-9]\\d{16}";
  const std::string three = "\\[(" + number + ")(, (" + number + ")){2}\\]";
  EXPECT_TRUE(std::regex_match(
      json, std::regex("\\{\n  \"attitude\": \\[(" + number + ")(, (" + number + ")){3}\\],\n  \"spin_body\": " +
                       three + ",\n  \"angular_momentum\": " + three + ",\n  \"energy\": (" + number + ")\n\\}\n")))
      << json;
}

TEST_F(CliSpin, EveryDigitIsRight) {
  // With 100 digits. The spin in the body has a closed form of its own: it circles the symmetry axis.
  const auto digits = [](const Hundred& x) {
    const std::string text = x.str(16, std::ios_base::scientific);  // d.ddd…e±dd
    return Hundred(text);
  };
  const Moments<Hundred> moments{.axial = Hundred(2) / 100, .transverse = Hundred(4) / 100};
  const Quat<Hundred> q(Hundred(3) / 5, 0, Hundred(4) / 5, 0);
  const State<Hundred> start{.p_WB = {0, 0, 0},
                             .q_WB = q,
                             .v_WB = {0, 0, 0},
                             .L_W = q * Vec3<Hundred>(Hundred(8) / 100, Hundred(16) / 100, Hundred(12) / 100)};
  for (const std::string time : {"10", "-10", "0.1", "1e6", "-1e9", "1e18"}) {
    const std::string json =
        printed(with(kane_body, {"--attitude", "0.6,0,0.8,0", "--time", time, "--format", "json"}));
    const Hundred t(time);
    const State<Hundred> end = free_flight(start, moments, Vec3<Hundred>(0, 0, 0), t);
    const Hundred angle = 6 * t * (moments.axial - moments.transverse) / moments.transverse;
    const std::vector<std::pair<std::string, std::vector<Hundred>>> expected = {
        {"attitude", {end.q_WB.w(), end.q_WB.x(), end.q_WB.y(), end.q_WB.z()}},
        {"spin_body", {2 * cos(angle) - 4 * sin(angle), 2 * sin(angle) + 4 * cos(angle), 6}},
        {"angular_momentum", {start.L_W.x(), start.L_W.y(), start.L_W.z()}},
        {"energy", {Hundred(76) / 100}}};
    for (const auto& [key, values] : expected) {
      const std::vector<std::string> texts = texts_of(json, key);
      ASSERT_EQ(texts.size(), values.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(Hundred(texts[i]), digits(values[i])) << key << " " << texts[i] << " at " << time;
      }
    }
  }
}

TEST_F(CliSpin, WhatIsZeroIsPrintedAsZero) {
  // On its edge, spinning about its axis: round-off in the other components is no digit of theirs.
  const std::string json = printed({"spin", "--size", "33", "--spin", "0,0,5", "--time", "3", "--attitude",
                                    "0.70710678118654752,0.70710678118654752,0,0", "--format", "json"});
  EXPECT_EQ(texts_of(json, "spin_body"), (std::vector<std::string>{"0", "0", "5.0000000000000000"}));
  EXPECT_EQ(texts_of(json, "angular_momentum").front(), "0");
  EXPECT_EQ(texts_of(json, "angular_momentum").back(), "0");
}

TEST_F(CliSpin, OfAStoneAgreesWithTheLibrary) {
  const auto compare = [this](const Words& options, const Moments<double>& moments) {
    const std::string json = printed(
        with({"spin", "--spin", "1,-2,8", "--attitude", "0,-0.6,0,0.8", "--time", "2.5", "--format", "json"}, options));
    const RigidBody<double> body = make_rigid_body(1.0, moments);
    const Quat<double> q(0.0, -0.6, 0.0, 0.8);
    const Vec3<double> nothing(0.0, 0.0, 0.0);
    const Vec3<double> L_W = formula::angular_momentum_W(q, body, Vec3<double>(1.0, -2.0, 8.0));
    const State<double> start{.p_WB = nothing, .q_WB = q, .v_WB = nothing, .L_W = L_W};
    const State<double> end = free_flight(start, moments, nothing, 2.5);
    const Quat<double>& p = end.q_WB;
    // The documented error of the attitude, 8 ε (1 + turn), with turns of less than 40 rad; moments to a few ulp.
    expect_near(numbers_of(json, "attitude"), {p.w(), p.x(), p.y(), p.z()}, 41 * 8 * 0x1p-52);
    expect_near(numbers_of(json, "angular_momentum"), {L_W.x(), L_W.y(), L_W.z()}, 16 * 0x1p-52 * L_W.norm());
    const double energy = formula::rotational_energy(start, body);
    expect_near(numbers_of(json, "energy"), {energy}, 16 * 0x1p-52 * energy);
  };
  compare({"--size", "33"}, mass_properties(make_stone(0.022, 0.0092), Density{2800.0}).moments);
  compare({"--size", "33", "--color", "black", "--bevel", "1mm"},
          mass_properties(make_stone(0.0223, 0.0098, 0.001), Density{2750.0}).moments);
  compare({"--size", "33", "--mass", "5.2g"}, mass_properties(make_stone(0.022, 0.0092), Mass{0.0052}).moments);
  compare({"--size", "33", "--density", "2.7g/cm3"},
          mass_properties(make_stone(0.022, 0.0092), Density{2700.0}).moments);
}

TEST_F(CliSpin, AttitudesOf17DigitsAreUnit) {
  const auto ask = [this](const std::string& attitude) {
    return printed(with(kane_body, {"--time", "0", "--attitude", attitude, "--format", "json"}));
  };
  EXPECT_EQ(ask("1,0,0,0"), printed(with(kane_body, {"--time", "0", "--format", "json"})));
  const std::vector<std::string> root(2, "0.70710678118654752");  // √½ = 0.707106781186547524…
  for (const std::string typed :
       {"0.70710678118654752", "0.7071067811865475", "0.7071067811865476", "7071067811865475.2e-16"}) {
    const std::vector<std::string> texts = texts_of(ask(typed + ", 0,0 ," + typed), "attitude");
    EXPECT_EQ(texts, (std::vector<std::string>{root[0], "0", "0", root[1]})) << typed;
  }
  // What the program prints, it reads.
  const std::vector<std::string> printed_attitude =
      texts_of(printed(with(kane_body, {"--time", "10", "--format", "json"})), "attitude");
  ASSERT_EQ(printed_attitude.size(), 4U);
  std::string typed = printed_attitude[0];
  for (std::size_t i = 1; i < 4; ++i) {
    typed += "," + printed_attitude[i];
  }
  EXPECT_EQ(texts_of(ask(typed), "attitude"), printed_attitude);
}

TEST_F(CliSpin, NumbersAreReadAsElsewhere) {
  const std::string expected = printed(with(kane_body, {"--time", "2.5", "--format", "json"}));
  for (const std::string time : {"2500ms", "2.5 s", "+2.5", "25e-1"}) {
    EXPECT_EQ(printed(with(kane_body, {"--time", time, "--format", "json"})), expected) << time;
  }
  for (const std::string spin : {"2, 4, 6", " 2 ,4 , 6 ", "2.0,+4,60e-1"}) {
    EXPECT_EQ(printed(with(with_value(kane_body, "--spin", spin), {"--time", "2.5", "--format", "json"})), expected);
  }
}

// --- text and series

TEST_F(CliSpin, TextNamesUnitsAndWhatIsAssumed) {
  const std::string text = printed({"spin", "--size", "33", "--bevel", "1mm", "--spin", "0,-5,60", "--time", "0"});
  EXPECT_TRUE(
      text.starts_with("The white stone of size 33, bevel 0.001 m, turning freely\n"
                       "Method exact: closed form of the symmetric top.\n\n"))
      << text;
  for (const auto* line : {"axial moment +I_a +2[.]12905e-07 +kg m² +\\(density assumed\\)", "time +t +0 +s",
                           "attitude +q_w +1", "spin in the body +ω_x +0 +rad/s", " +ω_y +-5 +rad/s",
                           "in the world +L_y +-6[.]27652e-07 +kg m²/s", "energy of rotation +E +0[.]000384797 +J"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex("\n" + std::string(line) + "\n"))) << line << "\n" << text;
  }
  EXPECT_EQ(printed(with(kane_body, {"--time", "0"})).find("assumed"), std::string::npos);
  EXPECT_EQ(printed(with(kane_body, {"--time", "0", "--format", "text"})), printed(with(kane_body, {"--time", "0"})));
}

TEST_F(CliSpin, SeriesHasAHeaderAndItsRows) {
  for (const std::string count : {"2", "5", "101"}) {
    const auto rows = rows_of(printed(with(kane_body, {"--time", "10", "--series", count})));
    ASSERT_EQ(rows.size(), std::stoul(count) + 1);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"time_s", "attitude_w", "attitude_x", "attitude_y", "attitude_z",
                                                 "spin_body_x_rad_s", "spin_body_y_rad_s", "spin_body_z_rad_s",
                                                 "angular_momentum_x_kg_m2_s", "angular_momentum_y_kg_m2_s",
                                                 "angular_momentum_z_kg_m2_s", "energy_J"}));
    for (const auto& row : rows) {
      EXPECT_EQ(row.size(), 12U);
    }
    EXPECT_EQ(rows[1], (std::vector<std::string>{"0", "1.0000000000000000", "0", "0", "0", "2.0000000000000000",
                                                 "4.0000000000000000", "6.0000000000000000", "0.080000000000000000",
                                                 "0.16000000000000000", "0.12000000000000000", "0.76000000000000000"}));
    EXPECT_EQ(rows.back()[0], "10.000000000000000");
  }
}

TEST_F(CliSpin, SeriesIsWhatEachTimeGivesAlone) {
  for (const Words& method : {Words{}, Words{"--method", "splitting-4", "--step", "10ms"}}) {
    const auto rows = rows_of(printed(with(with(kane_body, {"--time", "0.2", "--series", "3"}), method)));
    ASSERT_EQ(rows.size(), 4U);
    const char* const times[] = {"0", "0.1", "0.2"};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string json = printed(with(with(kane_body, {"--time", times[i], "--format", "json"}), method));
      std::vector<std::string> texts;
      for (const auto* key : {"attitude", "spin_body", "angular_momentum", "energy"}) {
        std::ranges::copy(texts_of(json, key), std::back_inserter(texts));
      }
      EXPECT_EQ(std::vector<std::string>(rows[i + 1].begin() + 1, rows[i + 1].end()), texts) << times[i];
    }
  }
}

// --- methods

TEST_F(CliSpin, EveryMethodIsTheLibrarysStepper) {
  const RigidBody<double> body = make_rigid_body(1.0, Moments<double>{.axial = 0.02, .transverse = 0.04});
  const Vec3<double> nothing(0.0, 0.0, 0.0);
  const State<double> start{.p_WB = nothing, .q_WB = {1.0, 0.0, 0.0, 0.0}, .v_WB = nothing, .L_W = {0.08, 0.16, 0.12}};
  for (const SchemeInfo& one : schemes) {
    if (one.scheme == Scheme::exact) {
      continue;
    }
    // 0.3/0.1 is 3 steps; 0.3/0.11 is 3 of 0.1, too.
    for (const std::string step : {"0.1", "0.11", "100ms"}) {
      const std::string json = printed(
          with(kane_body, {"--time", "0.3", "--method", std::string(one.name), "--step", step, "--format", "json"}));
      const State<double> end =
          Stepper<double>(one.scheme, body, nothing, Freedom::angular).advance(start, 0.1, 3).state;
      const Quat<double>& q = end.q_WB;
      expect_near(numbers_of(json, "attitude"), {q.w(), q.x(), q.y(), q.z()}, 32 * 0x1p-52);
      expect_near(numbers_of(json, "angular_momentum"), {end.L_W.x(), end.L_W.y(), end.L_W.z()}, 32 * 0x1p-52);
    }
  }
}

TEST_F(CliSpin, AMethodThatBreaksDownGivesItsLastGoodState) {
  const Words words = with(kane_body, {"--time", "50", "--method", "runge-kutta-4", "--step", "5"});
  const std::string line =
      "goishi: error: step = 5: is too long for --method runge-kutta-4, which diverged after 0 s; the last good state "
      "is "
      "printed\n";
  const Result json = run(with(words, {"--format", "json"}));
  EXPECT_EQ(json.status, 1);
  EXPECT_EQ(json.err, line);
  EXPECT_NE(json.out.find(",\n  \"status\": \"diverged\",\n  \"time\": 0\n}\n"), std::string::npos) << json.out;
  EXPECT_EQ(texts_of(json.out, "attitude").front(), "1.0000000000000000");
  const Result text = run(words);
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.err, line);
  EXPECT_TRUE(std::regex_search(text.out, std::regex("\ntime +t +0 +s\n")));
  EXPECT_TRUE(std::regex_search(text.out, std::regex("\nstatus +diverged\n")));
  // A series has the start, and the last good state.
  const Result series = run(with(words, {"--series", "6"}));
  EXPECT_EQ(series.status, 1);
  EXPECT_EQ(rows_of(series.out).size(), 3U);
}

TEST_F(CliSpin, HelpNamesEveryMethod) {
  const std::string help = printed({"spin", "--help"});
  for (const SchemeInfo& one : schemes) {
    EXPECT_NE(help.find("  " + std::string(one.name) + " "), std::string::npos) << one.name;
    EXPECT_NE(help.find(one.what), std::string::npos) << one.name;
  }
}

}  // namespace
}  // namespace goishi::cli_test
