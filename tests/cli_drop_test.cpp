/// The program `goishi drop`: what it computes.

#include <cmath>
#include <functional>
#include <goishi/mass/inertia.hpp>
#include <limits>
#include <numbers>

#include "compiled/drop.hpp"
#include "tests/cli_drop_test.hpp"

namespace goishi::cli_test {

namespace {

// --- against closed forms

TEST_F(CliDrop, AFlatDropRestsAfterThreeTimesItsFall) {
  const auto answer = json({"--from", "1m", "--restitution", "0.5"});
  const double fall = std::sqrt(2 * (1 - 0.0046) / 9.80665);
  const Value& end = answer["final"];
  EXPECT_STREQ(end["status"].GetString(), "rest");
  EXPECT_STREQ(end["touched"].GetString(), "board");
  EXPECT_NEAR(end["time"].GetDouble(), 3 * fall, 1e-12);
  // Nothing but round-off, of lengths up to 1 m, moves it off the height of its lowest point.
  EXPECT_NEAR(vector_of(end, "position").z(), 0.0046, 1e-15);
  EXPECT_EQ(vector_of(end, "velocity"), Vec3<double>(0, 0, 0));
  EXPECT_FALSE(end["lower_order"].GetBool());

  const Value& events = answer["events"];
  EXPECT_NEAR(events[1]["time"].GetDouble(), fall, 1e-14);
  EXPECT_NEAR(events[2]["time"].GetDouble(), 2 * fall, 1e-13);
  const double speed = 9.80665 * fall;
  EXPECT_NEAR(vector_of(events[1], "velocity_before").z(), -speed, 1e-13);
  EXPECT_NEAR(vector_of(events[1], "velocity").z(), speed / 2, 1e-13);
  const double mass = mass_properties(make_stone(0.022, 0.0092), Density{2800.0}).mass;
  EXPECT_NEAR(vector_of(events[1], "impulse").z(), 1.5 * speed * mass, 1e-15);
  EXPECT_NEAR(events[0]["energy"].GetDouble(), mass * 9.80665, 1e-15);
}

TEST_F(CliDrop, ASpinningStoneSettlesAtItsTilt) {
  // Slip-proportional friction keeps L · r; from 40 rad/s a sharp size 33 rises to 22.035°.
  const auto rows = series({"--from", "4.6mm", "--spin", "0,0.1,40", "--friction-model", "slip-proportional",
                            "--rolling-resistance", "0", "--pivot-radius", "0", "--until", "20s"},
                           3);
  EXPECT_NEAR(rows.back()[tilt], 22.035, 0.01);
}

// --- JSON

TEST_F(CliDrop, JsonHasTheKeysInOrderAnd17Digits) {
  EXPECT_EQ(printed(with({"--mass", "1", "--from", "0.0046", "--until", "1s", "--gravity", "8", "--format", "json"})),
            "{\n"
            "  \"events\": [\n"
            "    {\n"
            "      \"time\": 0,\n"
            "      \"kind\": \"start\",\n"
            "      \"position\": [0, 0, 0.0045999999999999999],\n"
            "      \"attitude\": [1.0000000000000000, 0, 0, 0],\n"
            "      \"velocity\": [0, 0, 0],\n"
            "      \"spin_body\": [0, 0, 0],\n"
            "      \"energy\": 0.036799999999999999\n"
            "    },\n"
            "    {\n"
            "      \"time\": 0,\n"
            "      \"kind\": \"contact\",\n"
            "      \"position\": [0, 0, 0.0045999999999999999],\n"
            "      \"attitude\": [1.0000000000000000, 0, 0, 0],\n"
            "      \"velocity\": [0, 0, 0],\n"
            "      \"spin_body\": [0, 0, 0],\n"
            "      \"energy\": 0.036799999999999999,\n"
            "      \"contact_point\": [0, 0, 0],\n"
            "      \"normal\": [0, 0, 1.0000000000000000],\n"
            "      \"feature\": \"lower cap\",\n"
            "      \"touched\": \"board\",\n"
            "      \"touched_feature\": \"surface\"\n"
            "    },\n"
            "    {\n"
            "      \"time\": 0,\n"
            "      \"kind\": \"rest\",\n"
            "      \"position\": [0, 0, 0.0045999999999999999],\n"
            "      \"attitude\": [1.0000000000000000, 0, 0, 0],\n"
            "      \"velocity\": [0, 0, 0],\n"
            "      \"spin_body\": [0, 0, 0],\n"
            "      \"energy\": 0.036799999999999999\n"
            "    }\n"
            "  ],\n"
            "  \"final\": {\n"
            "    \"status\": \"rest\",\n"
            "    \"touched\": \"board\",\n"
            "    \"time\": 0,\n"
            "    \"position\": [0, 0, 0.0045999999999999999],\n"
            "    \"attitude\": [1.0000000000000000, 0, 0, 0],\n"
            "    \"velocity\": [0, 0, 0],\n"
            "    \"spin_body\": [0, 0, 0],\n"
            "    \"energy\": 0.036799999999999999,\n"
            "    \"lower_order\": false,\n"
            "    \"counters\": {\n"
            "      \"impacts\": 0,\n"
            "      \"root_steps\": 1,\n"
            "      \"separations\": 1,\n"
            "      \"contact_evaluations\": 1,\n"
            "      \"steps_accepted\": 0,\n"
            "      \"steps_rejected\": 0,\n"
            "      \"evaluations_located\": 0,\n"
            "      \"edge_impacts\": 0\n"
            "    }\n"
            "  }\n"
            "}\n");
}

TEST_F(CliDrop, EventsAreConsistent) {
  const auto answer = json({"--bevel", "1mm", "--from", "5cm", "--tilt", "20", "--spin", "3,2,10"});
  const Value& events = answer["events"];
  EXPECT_STREQ(events[0]["kind"].GetString(), "start");
  const double half = 10 * std::numbers::pi / 180;  // about y
  const Value& attitude = events[0]["attitude"];
  EXPECT_NEAR(attitude[0].GetDouble(), std::cos(half), 1e-15);
  EXPECT_NEAR(attitude[2].GetDouble(), std::sin(half), 1e-15);
  const Value& last = events[events.Size() - 1];
  EXPECT_STREQ(last["kind"].GetString(), "rest");
  EXPECT_EQ(row_of(last), row_of(answer["final"]));
  int impacts = 0;
  for (rapidjson::SizeType i = 1; i < events.Size(); ++i) {
    const Value& event = events[i];
    EXPECT_LE(events[i - 1]["time"].GetDouble(), event["time"].GetDouble());
    // Of up to 2.5 mJ; the integration's own error is the tolerance, 1e-9.
    EXPECT_LE(event["energy"].GetDouble(), events[i - 1]["energy"].GetDouble() + 1e-11);
    if (std::string(event["kind"].GetString()) == "impact") {
      ++impacts;
      const Vec3<double> change = vector_of(event, "velocity") - vector_of(event, "velocity_before");
      const double mass = mass_properties(make_stone(0.022, 0.0092, 0.001), Density{2800.0}).mass;
      EXPECT_LT((change * mass - vector_of(event, "impulse")).norm(), 1e-17);
      EXPECT_NEAR(vector_of(event, "contact_point").z(), 0, 1e-15);
      EXPECT_TRUE(event.HasMember("spin_body_before"));
      EXPECT_STREQ(event["touched"].GetString(), "board");
    }
  }
  EXPECT_EQ(impacts, answer["final"]["counters"]["impacts"].GetInt());
}

// --- every option reaches the library

struct Case {
  std::string words;
  std::function<void(DropSettings<double>&)> set;
};

void slip_proportional(DropSettings<double>& settings) {
  settings.friction_model = FrictionModel::slip_proportional;
  settings.slip_coefficient = 2;
}

void contensou(DropSettings<double>& settings) {
  settings.friction_model = FrictionModel::coulomb_contensou;
  settings.patch_radius = 1e-3;
}

TEST_F(CliDrop, AgreesWithTheLibrary) {
  const Stone<double> stone = make_stone(0.022, 0.0092, 0.001);
  const RigidBody<double> body = make_rigid_body(mass_properties(stone, Mass{0.005}));
  const double half = 25 * std::numbers::pi / 360;  // 25° about (0, 3, 4)/5
  const Quat<double> q_WB(std::cos(half), 0, 0.6 * std::sin(half), 0.8 * std::sin(half));
  const State<double> start{
      .p_WB = {0.1, -0.2, 0.02},
      .q_WB = q_WB,
      .v_WB = {0.1, -0.05, -0.3},
      .L_W = formula::angular_momentum_W(q_WB, body, Vec3<double>(4.0, -3.0, 20.0)),
  };
  using Settings = DropSettings<double>;
  const std::vector<Case> cases = {
      {"", [](Settings&) {}},
      {"--restitution 0.3", [](Settings& s) { s.restitution = 0.3; }},
      {"--friction 0.1", [](Settings& s) { s.friction = 0.1; }},
      {"--friction inf", [](Settings& s) { s.friction = std::numeric_limits<double>::infinity(); }},
      {"--rolling-resistance 1mm", [](Settings& s) { s.rolling_resistance = 1e-3; }},
      {"--pivot-radius 0.5mm", [](Settings& s) { s.pivot_radius = 5e-4; }},
      {"--gravity 1.6", [](Settings& s) { s.gravity = Vec3<double>(0, 0, -1.6); }},
      {"--gravity 1,0.5,-9", [](Settings& s) { s.gravity = Vec3<double>(1, 0.5, -9); }},
      {"--law published", [](Settings& s) { s.law = ImpactLaw::published; }},
      {"--law stronge", [](Settings& s) { s.law = ImpactLaw::stronge; }},
      {"--friction-model slip-proportional", [](Settings& s) { s.friction_model = FrictionModel::slip_proportional; }},
      {"--friction-model slip-proportional --slip-coefficient 2", slip_proportional},
      {"--friction-model coulomb-contensou", [](Settings& s) { s.friction_model = FrictionModel::coulomb_contensou; }},
      {"--friction-model coulomb-contensou --patch-radius 1mm", contensou},
      {"--tolerance 1e-6", [](Settings& s) { s.tolerance = 1e-6; }},
      {"--until 3-impacts", [](Settings& s) { s.maximum_impacts = 3; }},
  };
  std::vector<Row> ends;
  for (const Case& one : cases) {
    for (const bool on_board : {true, false}) {
      Settings settings;
      settings.horizon = 0.25;
      one.set(settings);
      const DropResult<double> expected =
          on_board ? drop(stone, body, start, make_board<double>(), settings) : drop(stone, body, start, settings);
      const Words words = words_of(
          "--bevel 1mm --mass 5g --from 2cm --position 0.1,-0.2 --tilt 25 --tilt-axis 0,3,4 --velocity 0.1,-0.05,-0.3 "
          "--spin 4,-3,20 --on " +
          std::string(on_board ? "board " : "plane ") + (settings.maximum_impacts == 3 ? "" : "--until 250ms ") +
          one.words);
      const auto answer = json(words);
      const std::string& what = one.words;
      EXPECT_EQ(answer["events"].Size(), expected.events.size()) << what;
      EXPECT_EQ(answer["final"]["status"].GetString(), std::string(to_string(expected.status))) << what;
      const Vec3<double>& p = expected.state.p_WB;
      const Vec3<double>& v = expected.state.v_WB;
      const Quat<double>& q = expected.state.q_WB;
      const Vec3<double> w = formula::angular_velocity_B(expected.state, body);
      const Row row = {expected.time, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(),
                       q.z(),         v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
      ends.push_back(row_of(answer["final"]));
      // A few ulp between the moments, magnified by up to twenty impacts: 1.2e-10 (measured 2026-11-22).
      EXPECT_LT(greatest_difference(ends.back(), row), 1e-9) << what;
    }
  }
  // And every option but --on changes the end by far more than that.
  for (std::size_t i = 2; i < ends.size(); i += 2) {
    EXPECT_GT(greatest_difference(ends[0], ends[i]), 1e-7) << cases[i / 2].words;
  }
}

TEST_F(CliDrop, TheStoneIsTheOneAskedFor) {
  const auto energy_of = [this](const Words& words) { return json(words)["events"][0]["energy"].GetDouble(); };
  const Words from = {"--from", "1m", "--gravity", "1", "--until", "1ms"};
  const auto with_stone = [&](const Words& more) {
    Words words = from;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const auto mass = [](double width, double height_of_it, double bevel, double density) {
    return mass_properties(make_stone(width, height_of_it, bevel), Density{density}).mass;
  };
  EXPECT_NEAR(energy_of(with_stone({"--color", "black"})), mass(0.0223, 0.0098, 0, 2750), 1e-17);
  EXPECT_NEAR(energy_of(with_stone({"--bevel", "1mm"})), mass(0.022, 0.0092, 0.001, 2800), 1e-17);
  EXPECT_NEAR(energy_of(with_stone({"--density", "2.7g/cm3"})), mass(0.022, 0.0092, 0, 2700), 1e-17);
  const auto other = parsed(printed({"drop", "--width", "3cm", "--height", "1cm", "--mass", "10g", "--from", "6mm",
                                     "--tilt", "180", "--format", "json"}));
  EXPECT_NEAR(other["events"][0]["energy"].GetDouble(), 0.01 * 9.80665 * 0.006, 1e-18);
  EXPECT_NEAR(vector_of(other["final"], "position").z(), 0.005, 1e-15);
  EXPECT_STREQ(other["events"][1]["feature"].GetString(), "upper cap");
}

}  // namespace
}  // namespace goishi::cli_test
