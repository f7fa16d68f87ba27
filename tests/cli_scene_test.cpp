/// The program `goishi scene`: what is played is what the file says, and as `goishi drop` has it.

#include "tests/cli_scene_test.hpp"

#include <map>
#include <numbers>
#include <random>

namespace goishi::cli_test {

namespace {

// --- alone, as a drop

/// The events and the end of a scene with one stone are those of the drop, to the last digit.
void expect_same_as_drop(const rapidjson::Document& scene, const rapidjson::Document& drop) {
  const Value& told = scene["events"];
  const Value& events = drop["events"];
  // A drop tells where it was left, a scene goes on.
  const bool is_left = events[events.Size() - 1]["kind"] == "end";
  ASSERT_EQ(told.Size(), events.Size() - (is_left ? 1 : 0));
  for (rapidjson::SizeType i = 0; i < told.Size(); ++i) {
    EXPECT_EQ(told[i]["stone"].GetInt(), 0);
    EXPECT_FALSE(told[i].HasMember("other"));
    EXPECT_EQ(told[i].MemberCount(), events[i].MemberCount() + 1) << i;
    for (const auto& member : events[i].GetObject()) {
      EXPECT_EQ(told[i][member.name], member.value) << i << member.name.GetString();
    }
  }
  for (const char* key : {"position", "attitude", "velocity", "spin_body", "energy"}) {
    EXPECT_EQ(final_of(scene, 0)[key], drop["final"][key]) << key;
  }
  EXPECT_EQ(scene["final"]["time"], drop["final"]["time"]);
}

TEST_F(CliScene, OneStoneIsADrop) {
  expect_same_as_drop(
      played_with(R"("stones": [{"position": [0.01, -0.02, 0.05], "tilt_deg": 20.3, "tilt_axis": [1, 2, 0],
                                         "velocity": [0.1, 0, -0.2], "spin_body": [3, 2, 10]}])"),
      json({"--bevel", "1mm", "--from", "5cm", "--position", "0.01,-0.02", "--tilt", "20.3", "--tilt-axis", "1,2,0",
            "--velocity", "0.1,0,-0.2", "--spin", "3,2,10"}));
}

TEST_F(CliScene, EverySettingIsTheDrops) {
  expect_same_as_drop(played_with(R"("settings": {"gravity": [1, 0, -9], "law": "stronge", "tolerance": 1e-5,
                       "stone_board": {"restitution": 0.4, "friction": 0.2, "rolling_resistance": 2e-4,
                         "pivot_radius": 1e-4, "friction_model": "slip-proportional", "slip_coefficient": 2}},
                     "stones": [{"position": [0, 0, 0.02], "tilt_deg": 10}], "end": {"time": 0.3})"),
                      json({"--bevel",
                            "1mm",
                            "--from",
                            "2cm",
                            "--tilt",
                            "10",
                            "--gravity",
                            "1,0,-9",
                            "--law",
                            "stronge",
                            "--tolerance",
                            "1e-5",
                            "--restitution",
                            "0.4",
                            "--friction",
                            "0.2",
                            "--rolling-resistance",
                            "0.2mm",
                            "--pivot-radius",
                            "0.1mm",
                            "--friction-model",
                            "slip-proportional",
                            "--slip-coefficient",
                            "2",
                            "--until",
                            "0.3"}));
  expect_same_as_drop(
      played_with(R"("settings": {"stone_board": {"friction_model": "coulomb-contensou", "patch_radius": 2e-4}},
                     "stones": [{"position": [0, 0, 0.0047], "tilt_deg": 5, "spin_body": [5, 0, 40]}], "end": {"time": 0.1})"),
      json({"--bevel", "1mm", "--from", "4.7mm", "--tilt", "5", "--spin", "5,0,40", "--friction-model",
            "coulomb-contensou", "--patch-radius", "0.2mm", "--until", "0.1"}));
}

TEST_F(CliScene, TheBoardAndTheStoneAreThoseAskedFor) {
  expect_same_as_drop(
      played(file(R"({"stone": {"size": 40, "color": "black", "standard": "nihon-kiin", "density": 2100},
                              "board": {"standard": "nihon-kiin", "kind": "floor-board"},
                              "stones": [{"position": [0.2, 0, 0.03], "velocity": [0.5, 0, 0]}]})")),
      parsed(printed({"drop", "--size", "40", "--color", "black", "--standard", "nihon-kiin", "--density", "2.1g/cm3",
                      "--on", "floor-board", "--from", "3cm", "--position", "0.2,0", "--velocity", "0.5,0,0",
                      "--format", "json"})));
  expect_same_as_drop(played(file(R"({"stone": {"width": 0.02, "height": 0.01, "mass": 0.005},
                              "stones": [{"position": [0, 0, 0.03], "tilt_deg": 73.5}]})")),
                      parsed(printed({"drop", "--width", "2cm", "--height", "1cm", "--mass", "5g", "--from", "3cm",
                                      "--tilt", "73.5", "--format", "json"})));
  // Onto a floor 5 cm below; over the border, and beside it.
  const std::string board = R"("board": {"lines": 3, "spacing": [0.03, 0.04], "border": [0.02, 0.05],
                                         "thickness": 0.03, "legs": 0.02}, )";
  const auto lands = [&](const std::string& place) {
    return vector_of(final_of(played_with(board + R"("stones": [{"position": [)" + place + R"(, 0.01]}])"), 0),
                     "position");
  };
  EXPECT_NEAR(lands("0.049, 0").z(), 0.0046, 1e-6);
  EXPECT_NEAR(lands("0.07, 0").z(), 0.0046 - 0.05, 1e-6);
  EXPECT_NEAR(lands("0, 0.089").z(), 0.0046, 1e-6);
  EXPECT_NEAR(lands("0, 0.11").z(), 0.0046 - 0.05, 1e-6);
}

TEST_F(CliScene, AStartIsAsGiven) {
  const auto scene = played_with(R"("stones": [{"point": [18, 8], "from": 0.03},
      {"position": [0, 0, 0.1], "attitude": [0.8, 0, -0.6, 0], "spin_body": [1, 2, 3]}], "end": {"time": 1e-19})");
  EXPECT_LT((vector_of(final_of(scene, 0), "position") - Vec3<double>(9 * 0.022, -0.0237, 0.03)).norm(), 1e-16);
  const Value& q = final_of(scene, 1)["attitude"];
  for (const auto& [i, value] : {std::pair(0U, 0.8), {1U, 0.0}, {2U, -0.6}, {3U, 0.0}}) {
    EXPECT_NEAR(q[i].GetDouble(), value, 1e-15) << i;
  }
  EXPECT_LT((vector_of(final_of(scene, 1), "spin_body") - Vec3<double>(1, 2, 3)).norm(), 1e-14);
}

// --- groups

TEST_F(CliScene, AGroupStandsInRowsAndLayers) {
  const auto scene = played_with(R"("groups": [
      {"points": "3x2", "from": 0.05, "layers": 2, "layer_spacing": 0.03, "velocity": [0, 0.5, 1], "spin_body": [1, 2, 3]},
      {"points": "2x1", "from": 0.2, "spacing": [0.05, 0.07], "middle": [0.01, -0.02]}], "end": {"time": 1e-19})");
  for (int id = 0; id < 12; ++id) {
    const Vec3<double> p(0.022 * (id % 3 - 1), 0.0237 * ((id / 3 % 2) - 0.5), 0.05 + 0.03 * (id / 6));
    EXPECT_LT((vector_of(final_of(scene, id), "position") - p).norm(), 1e-15) << id;
    EXPECT_LT((vector_of(final_of(scene, id), "velocity") - Vec3<double>(0, 0.5, 1)).norm(), 1e-15) << id;
    EXPECT_LT((vector_of(final_of(scene, id), "spin_body") - Vec3<double>(1, 2, 3)).norm(), 1e-14) << id;
  }
  EXPECT_LT((vector_of(final_of(scene, 12), "position") - Vec3<double>(-0.015, -0.02, 0.2)).norm(), 1e-15);
  EXPECT_LT((vector_of(final_of(scene, 13), "position") - Vec3<double>(0.035, -0.02, 0.2)).norm(), 1e-15);
  EXPECT_EQ(scene["final"]["stones"].Size(), 14U);
}

TEST_F(CliScene, ColoursAlternate) {
  const std::string text = printed({"scene", file(R"({"stone": {"size": 33, "color": "both", "bevel": 0.001},
                                                      "groups": [{"points": "3x3", "from": 0.01}]})")});
  EXPECT_NE(text.find("\n5 × The white stone of size 33, bevel 0.001 m, "), std::string::npos) << text;
  EXPECT_NE(text.find("\n4 × The black stone of size 33, bevel 0.001 m, "), std::string::npos) << text;
}

/// By the generator's own definition, so that a file is one scene for ever.
TEST_F(CliScene, RandomIsForEver) {
  const std::string more = R"("velocity": 0.5, "spin_body": 7, "position": 0.001})";
  const auto group = [&](const std::string& random) {
    return played_with(R"("groups": [{"points": "2x1", "spacing": [0.1, 0.1], "from": 0.1, "random": {)" + random +
                       R"(}], "settings": {"gravity": [0, 0, 0], "step": 0.002}, "end": {"time": 1e-19})");
  };
  const auto scene = group(R"("seed": 12345678901, "tilt_deg": 40, )" + more);
  std::mt19937_64 random(12345678901U);
  const auto draw = [&] { return std::ldexp(static_cast<double>(random() / 2048), -52) - 1; };
  for (int id = 0; id < 2; ++id) {
    const double angle = 40 * std::numbers::pi / 180 * (draw() + 1) / 2, side = std::numbers::pi * draw();
    const Value& state = final_of(scene, id);
    const Value& q = state["attitude"];
    EXPECT_NEAR(q[0].GetDouble(), std::cos(angle / 2), 1e-15);
    EXPECT_NEAR(q[1].GetDouble(), std::sin(angle / 2) * std::cos(side), 1e-15);
    EXPECT_NEAR(q[2].GetDouble(), std::sin(angle / 2) * std::sin(side), 1e-15);
    EXPECT_NEAR(q[3].GetDouble(), 0, 1e-15);
    for (const auto& [key, middle, reach] :
         {std::tuple("position", Vec3<double>(id == 0 ? -0.05 : 0.05, 0, 0.1), 0.001),
          std::tuple("velocity", Vec3<double>(0, 0, 0), 0.5), std::tuple("spin_body", Vec3<double>(0, 0, 0), 7.0)}) {
      const double x = draw(), y = draw(), z = draw();
      EXPECT_LT((vector_of(state, key) - middle - reach * Vec3<double>(x, y, z)).norm(), 1e-14 * (1 + reach)) << key;
    }
  }
  // What is not asked for changes nothing of what is; another seed does.
  const auto tilt_of_last = [](const rapidjson::Document& of) {
    const Value& q = final_of(of, 1)["attitude"];
    return Vec3<double>(q[0].GetDouble(), q[1].GetDouble(), q[2].GetDouble());
  };
  EXPECT_LT((tilt_of_last(group(R"("seed": 12345678901, "tilt_deg": 40})")) - tilt_of_last(scene)).norm(), 1e-15);
  EXPECT_GT((tilt_of_last(group(R"("seed": 12345678902, "tilt_deg": 40})")) - tilt_of_last(scene)).norm(), 1e-3);
}

// --- actions

const std::string weightless = R"("settings": {"gravity": [0, 0, 0], "step": 0.002, "impact_speed": 0.005}, )";

TEST_F(CliScene, AnImpulseMovesAndTurns) {
  const auto scene = played(file(R"({"stone": {"size": 33, "mass": 0.005}, )" + weightless +
                                 R"("stones": [{"position": [0, 0, 0.1]}, {"position": [0, 0.1, 0.1]}],
      "actions": [{"at": 0.25, "impulse": {"id": 0, "impulse": [0.005, 0, 0]}},
                  {"at": 0.25, "impulse": {"id": 1, "impulse": [0.005, 0, 0], "offset": [0, 0.01, 0]}}],
      "end": {"time": 0.5}})"));
  const auto inertia = parsed(printed({"inertia", "--size", "33", "--mass", "5g", "--format", "json"}));
  for (const int id : {0, 1}) {
    EXPECT_LT((vector_of(final_of(scene, id), "position") - Vec3<double>(0.25, id == 0 ? 0 : 0.1, 0.1)).norm(), 1e-15);
  }
  EXPECT_EQ(vector_of(final_of(scene, 0), "spin_body").norm(), 0);
  const double w = -0.005 * 0.01 / inertia["axial"].GetDouble();
  EXPECT_NEAR(vector_of(final_of(scene, 1), "spin_body").z(), w, 1e-13 * std::abs(w));
  int pushes = 0;
  for (const Value& event : scene["events"].GetArray()) {
    pushes += event["kind"] == "push" && event["time"].GetDouble() == 0.25 ? 1 : 0;
  }
  EXPECT_EQ(pushes, 2);
}

TEST_F(CliScene, AHandHoldsAndLetsGo) {
  const std::string start = R"("stones": [{"position": [0, 0, 0.1]}], "actions": [
      {"at": 0.1, "hold": {"id": 0, "velocity": [0.1, 0, 0.2], "spin_world": [0, 0, 3], "duration": 0.5}})";
  const auto held = played_with(start + R"(], "end": {"time": 0.3})");
  EXPECT_STREQ(final_of(held, 0)["mode"].GetString(), "held");
  const double fallen = 9.80665 * 0.1 * 0.1 / 2;
  EXPECT_LT((vector_of(final_of(held, 0), "position") - Vec3<double>(0.02, 0, 0.14 - fallen)).norm(), 1e-15);
  EXPECT_NEAR(final_of(held, 0)["attitude"][3].GetDouble(), std::sin(3 * 0.2 / 2), 1e-15);
  const auto let_go = played_with(start + R"(, {"at": 0.3, "release": {"id": 0}}], "end": {"time": 0.31})");
  EXPECT_STREQ(final_of(let_go, 0)["mode"].GetString(), "flight");
  EXPECT_NEAR(vector_of(final_of(let_go, 0), "velocity").z(), 0.2 - 9.80665 * 0.01, 1e-12);
}

TEST_F(CliScene, AHandsWorkIsCounted) {
  const std::string text = R"("stones": [{"position": [0, 0, 0.0046]}, {"position": [0.03, 0, 0.0046]}],
      "actions": [{"at": 0, "hold": {"id": 0, "velocity": [0.05, 0, 0], "duration": 1}})";
  const auto scene = played_with(text + R"(], "end": {"time": 1.1})");
  EXPECT_GT(vector_of(final_of(scene, 1), "position").x(), 0.05 + 0.019);
  const double work = scene["final"]["hand_work"].GetDouble();
  EXPECT_GT(work, 0.1 * 0.3 * 0.00516 * 9.8 * 0.04);
  // Also that of a stone that is there no more.
  const auto removed = played_with(text + R"(, {"at": 1.1, "remove": {"id": 0}}], "end": {"time": 1.1})");
  EXPECT_EQ(removed["final"]["hand_work"], scene["final"]["hand_work"]);
  EXPECT_EQ(removed["final"]["stones"].Size(), 1U);
}

TEST_F(CliScene, GravityTurnsStonesComeAndGo) {
  const auto scene = played_with(R"("stones": [{"position": [0, 0, 0.5]}, {"position": [0.1, 0, 0.5]}], "actions": [
      {"at": 0.2, "gravity": [2, 0, 0]}, {"at": 0.1, "remove": {"id": 1}},
      {"at": 0.2, "add": {"position": [0, 0.1, 0.5], "velocity": [0, 0, 1]}}], "end": {"time": 0.3})");
  ASSERT_EQ(scene["final"]["stones"].Size(), 2U);
  EXPECT_LT((vector_of(final_of(scene, 0), "velocity") - Vec3<double>(0.2, 0, -9.80665 * 0.2)).norm(), 1e-12);
  EXPECT_LT((vector_of(final_of(scene, 2), "position") - Vec3<double>(0.01, 0.1, 0.6)).norm(), 1e-12);
}

/// Two stones: who did it is told, and what is between them.
TEST_F(CliScene, TwoStonesMeet) {
  const auto scene = played_with(weightless + R"("stones": [{"position": [-0.05, 0, 0.1], "velocity": [1, 0, 0]},
      {"position": [0, 0, 0.1]}], "end": {"time": 0.1})");
  int told = 0;
  for (const Value& event : scene["events"].GetArray()) {
    if (event["kind"] == "impact") {
      EXPECT_EQ(event["other"].GetInt(), 1 - event["stone"].GetInt());
      EXPECT_STREQ(event["touched"].GetString(), "stone");
      EXPECT_NEAR(std::abs(vector_of(event, "normal").x()), 1, 1e-6);
      ++told;
    }
  }
  EXPECT_EQ(told, 2);
  // e = 0.5
  EXPECT_NEAR(vector_of(final_of(scene, 0), "velocity").x(), 0.25, 1e-6);
  EXPECT_NEAR(vector_of(final_of(scene, 1), "velocity").x(), 0.75, 1e-6);
  const auto softer = played_with(R"("settings": {"gravity": [0, 0, 0], "step": 0.002, "impact_speed": 0.005,
      "stone_stone": {"restitution": 0}}, "stones": [{"position": [-0.05, 0, 0.1], "velocity": [1, 0, 0]},
      {"position": [0, 0, 0.1]}], "end": {"time": 0.1})");
  EXPECT_NEAR(vector_of(final_of(softer, 1), "velocity").x(), 0.5, 1e-6);
}

TEST_F(CliScene, TheLawsOfTwoStonesAreThoseAskedFor) {
  // Rim on rim, beside each other's middles.
  const auto meet = [&](const std::string& settings) {
    return played_with(R"("settings": {"gravity": [0, 0, 0], "step": 0.002, "impact_speed": 0.005, )" + settings +
                       R"(}, "stones": [{"position": [-0.05, 0, 0.1], "velocity": [1, 0, 0]},
                          {"position": [0, 0.005, 0.1]}], "end": {"time": 0.1})");
  };
  const auto smooth = meet(R"("stone_stone": {"friction": 0})"), usual = meet(R"("stone_stone": {})");
  EXPECT_NEAR(vector_of(final_of(smooth, 1), "spin_body").z(), 0, 1e-9);
  EXPECT_GT(std::abs(vector_of(final_of(usual, 1), "spin_body").z()), 1);
  const auto time_of_impact = [](const rapidjson::Document& scene) {
    for (const Value& event : scene["events"].GetArray()) {
      if (event["kind"] == "impact") {
        return event["time"].GetDouble();
      }
    }
    return 0.0;
  };
  // A millimetre apart they touch, along a normal that is as far from x as the middles from their line.
  const double earlier = time_of_impact(usual) - time_of_impact(meet(R"("clearance": 0.001)"));
  EXPECT_NEAR(earlier, 0.001, 1e-4);
}

/// Three stones that fall on each other: what each setting of clusters changes.
TEST_F(CliScene, TheSettingsOfClustersAreThoseAskedFor) {
  const auto fall = [&](const std::string& settings) {
    const auto scene = played_with(R"("settings": {"tolerance": 1e-4)" + settings + R"(},
      "groups": [{"points": "2x1", "spacing": [0.0215, 0.0215], "from": 0.005},
                 {"points": "1x1", "from": 0.02, "random": {"seed": 1, "position": 0.001}}], "end": {"time": 0.5})");
    const Value& counters = scene["final"]["counters"];
    return std::map<std::string, double>{{"impacts", counters["pair_impacts"].GetDouble()},
                                         {"steps", counters["steps"].GetDouble()},
                                         {"sweeps", counters["sweeps"].GetDouble()}};
  };
  auto usual = fall(""), fine = fall(R"(, "step": 1e-4)"), exact = fall(R"(, "solver_tolerance": 1e-8)"),
       plastic = fall(R"(, "impact_speed": 10)"), patient = fall(R"(, "leaving_time": 0.4)");
  EXPECT_GT(usual["impacts"], 0);
  EXPECT_GT(fine["steps"], 5 * usual["steps"]);
  EXPECT_GT(exact["sweeps"] / exact["steps"], 1.5 * usual["sweeps"] / usual["steps"]);
  EXPECT_EQ(plastic["impacts"], 0);
  EXPECT_GT(patient["steps"], 2 * usual["steps"]);
}

/// The width of the finished stone, or that of its lens.
TEST_F(CliScene, AMeasuredStoneIsWider) {
  const auto mass = [&](const std::string& more) {
    const std::string text = printed({"scene", file(R"({"stone": {"width": 0.022, "height": 0.0092, "bevel": 0.001)" +
                                                    more + R"(}, "stones": [{"position": [0, 0, 0.0046]}]})")});
    return text.substr(text.find("\nmass "), 19);
  };
  const auto printed_mass = [&](const Words& more) {
    const std::string text =
        printed(Words{"drop", "--width", "22mm", "--height", "9.2mm", "--bevel", "1mm", "--from", "4.6mm"} + more);
    return text.substr(text.find("\nmass "), 19);
  };
  EXPECT_EQ(mass(""), printed_mass({}));
  const auto inertia = parsed(
      printed({"inertia", "--width", "22mm", "--height", "9.2mm", "--bevel", "1mm", "--measured", "--format", "json"}));
  EXPECT_NEAR(std::stod(mass(R"(, "measured": true)").substr(6)), inertia["mass"].GetDouble(), 1e-7);
  EXPECT_NE(mass(""), mass(R"(, "measured": true)"));
}

}  // namespace

}  // namespace goishi::cli_test
