/// The program `goishi scene`: bad input. One line, with the file, the place in it and the rule.

#include "tests/cli_scene_test.hpp"

namespace goishi::cli_test {

namespace {

class CliSceneError : public CliScene {
 protected:
  /// A whole file.
  void expect_of(const std::string& text, const std::string& line) const {
    const std::string name = file(text);
    expect_error({"scene", name}, name + ": " + line);
  }

  /// A file with stones of size 33 and these members more.
  void expect(const std::string& members, const std::string& line) const {
    expect_of(R"({"stone": {"size": 33}, )" + members + "}", line);
  }

  /// A file whose stones are of this shape.
  void expect_shape(const std::string& members, const std::string& line) const {
    expect_of(R"({"stone": {)" + members + "}}", line);
  }

  void expect_stone(const std::string& members, const std::string& line) const {
    expect(R"("stones": [{"position": [0, 0, 1]}, {)" + members + "}]", line);
  }

  void expect_group(const std::string& members, const std::string& line) const {
    expect(R"("groups": [{)" + members + "}]", line);
  }

  /// An action on a stone 5 cm over the board.
  void expect_action(const std::string& actions, const std::string& line) const {
    expect(R"("stones": [{"position": [0, 0, 0.05]}], "actions": [)" + actions + "]", line);
  }
};

TEST_F(CliSceneError, TheCommandLine) {
  const std::string good = file_with(R"("stones": [])");
  expect_error({"scene"}, "a scene is needed: goishi scene FILE");
  expect_error({"scene", "/nowhere.json"}, "file = /nowhere.json: cannot be read: No such file or directory");
  expect_error({"scene", good, "more"}, "not expected: more");
  expect_error({"scene", good, "--format", "xml"}, "format = xml: must be text or json");
  expect_error({"scene", good, "--series", "5"}, "series = 5: needs --csv too");
  expect_error({"scene", good, "--csv", "a.csv"}, "csv = a.csv: needs --series too");
  expect_error({"scene", good, "--csv", "a.csv", "--series", "1"},
               "series = 1: must be a whole number from 2 to 1000000");
  const std::string many = file_with(R"("groups": [{"points": "50x40", "spacing": [0.03, 0.03], "from": 0.1}])");
  expect_error({"scene", many, "--csv", "a.csv", "--series", "501"},
               "series = 501: must be a whole number from 2 to 500");
}

TEST_F(CliSceneError, WhatIsNoJson) {
  expect_of("", "line 1, column 1: The document is empty.");
  expect_of("{\n  \"stone\": {\"size\": 33}\n  \"end\": {}\n}",
            "line 3, column 3: Missing a comma or '}' after an object member.");
  expect_of(R"({"stone": {"size": NaN}})", "line 1, column 20: Invalid value.");
  expect_of(R"({"stone": {"size": 1e400}})", "line 1, column 20: Number too big to be stored in double.");
  expect_of(R"({"title": ")"
            "\xff"
            R"("})",
            "line 1, column 12: Invalid encoding in string.");
  expect_of(R"({"stone": {"size": 33}} x)",
            "line 1, column 25: The document root must not be followed by other values.");
  expect_of(std::string(1000000, '['), "line 1, column 1000001: Invalid value.");
}

/// Each kind of rule in the schema.
TEST_F(CliSceneError, TheSchema) {
  expect_of("[]", "/: must be of the type object");
  expect_of("{}", "/: needs stone");
  expect("\"siez\": 3", "/siez = 3: must be $schema, title, board, settings, stone, stones, groups, actions or end");
  expect(R"("a/b~": [])", "/a~1b~0: must be $schema, title, board, settings, stone, stones, groups, actions or end");
  expect(R"("stone": {"size": 34})", "/stone: must be given once");
  expect(R"("settings": {"step": 1, "step": 1})", "/settings/step: must be given once");
  expect(R"("board": {"lines": 19.5})", "/board/lines = 19.5: must be of the type integer");
  expect(R"("board": {"lines": 0})", "/board/lines = 0: must be at least 1");
  expect(R"("board": {"standard": "mine"})", "/board/standard = mine: must be talk or nihon-kiin");
  expect(R"("settings": {"step": 0})", "/settings/step = 0: must be at least 1e-20");
  expect(R"("settings": {"step": -1})", "/settings/step = -1: must be at least 1e-20");
  expect(R"("settings": {"step": "1ms"})", "/settings/step = 1ms: must be of the type number");
  expect(R"("settings": {"law": "newton"})", "/settings/law = newton: must be chatterjee-ruina, published or stronge");
  expect(R"("settings": {"tolerance": 0.1})", "/settings/tolerance = 0.1: must be at most 0.01");
  expect(R"("settings": {"solver_tolerance": 2})", "/settings/solver_tolerance = 2: must be at most 1");
  expect(R"("settings": {"gravity": [0, 0, -1e30]})", "/settings/gravity/2 = -1e+30: must be at least -1e+20");
  expect(R"("settings": {"gravity": [0, 0]})", "/settings/gravity: must have at least 3 members");
  expect(R"("settings": {"gravity": [0, 0, 0, 0]})", "/settings/gravity: must have at most 3 members");
  for (const std::string surface : {"stone_board", "stone_stone"}) {
    const std::string place = "/settings/" + surface;
    expect(R"("settings": {")" + surface + R"(": {"restitution": 1.5}})",
           place + "/restitution = 1.5: must be at most 1");
    expect(R"("settings": {")" + surface + R"(": {"friction": -1}})", place + "/friction = -1: must be at least 0");
  }
  expect(R"("settings": {"stone_board": {"slip_coefficient": 1}})",
         "/settings/stone_board: has slip_coefficient only with friction_model slip-proportional");
  expect(R"("settings": {"stone_board": {"patch_radius": 1e-4, "friction_model": "dry"}})",
         "/settings/stone_board: has patch_radius only with friction_model coulomb-contensou");
  expect(R"("end": {})", "/end: must have at least 1 member");
  expect(R"("end": {"time": 1, "rest_within": 1})", "/end: must have at most 1 member");
  expect(R"("end": {"time": 0})", "/end/time = 0: must be at least 1e-20");
}

TEST_F(CliSceneError, TheStones) {
  const std::string either = "/stone: needs size, or width and height, and not both";
  expect_shape("", either);
  expect_shape(R"("size": 33, "width": 1)", either);
  expect_shape(R"("width": 0.01)", either);
  expect_shape(R"("width": 2, "height": 1, "color": "white")", either);
  expect_shape(R"("size": 33, "measured": true)", either);
  expect_shape(R"("size": 33, "mass": 1, "density": 1)", "/stone: has mass or density, not both");
  expect_shape(R"("size": 33, "color": "red")", "/stone/color = red: must be white, black or both");
  expect_shape(
      R"("size": 21)",
      "/stone/size = 21: must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50");
  expect_shape(R"("size": 33, "bevel": 0.0092)",
               "/stone/bevel = 0.0092: must be at least 0 and below the height (0.0092)");
  expect_shape(R"("width": 0.01, "height": 0.02)", "/stone/height = 0.02: must not exceed the width (0.01)");
  const std::string where = "/stones/1: needs position, or point and from, and not both";
  expect_stone("", where);
  expect_stone(R"("point": [1, 2])", where);
  expect_stone(R"("position": [0, 0, 2], "from": 1)", where);
  expect_stone(R"("point": [1, 19], "from": 1)", "/stones/1/point = 19: must be a line of the board (0 … 18)");
  expect_stone(R"("position": [0, 0, 2], "attitude": [1, 0, 0, 0], "tilt_deg": 0)",
               "/stones/1: has attitude or tilt_deg, not both");
  expect_stone(R"("position": [0, 0, 2], "tilt_axis": [1, 0, 0])", "/stones/1: with tilt_axis needs tilt_deg");
  expect_stone(R"("position": [0, 0, 2], "tilt_deg": 1, "tilt_axis": [0, 0, 0])",
               "/stones/1/tilt_axis = 0 0 0: must not be zero");
  expect_stone(R"("position": [0, 0, 2], "attitude": [1, 1, 0, 0])",
               "/stones/1/attitude = 1,1,0,0: must be a unit quaternion w,x,y,z, its length within 0.001 of 1, not "
               "1.4142135623730950");
  expect_stone(R"("position": [0, 0, 2], "stone": {"size": 33, "color": "both"})",
               "/stones/1/stone/color = both: must be white or black, but for a group");
  expect_stone(
      R"("position": [0, 0, 2], "stone": {"size": 60})",
      "/stones/1/stone/size = 60: must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 "
      "49 50");
  expect_group(R"("points": "19x19")", "/groups/0: needs from");
  expect_group(R"("points": "0x19", "from": 1)",
               "/groups/0/points = 0x19: must be of the form ^[1-9][0-9]?[0-9]?x[1-9][0-9]?[0-9]?$");
  expect_group(R"("points": "2x2", "from": 1, "layers": 2)", "/groups/0: with layers needs layer_spacing");
  expect_group(R"("points": "2x2", "from": 1, "random": {"tilt_deg": 1})", "/groups/0/random: needs seed");
  expect_group(R"("points": "999x999", "from": 1)",
               "/groups/0/points = 999x999: must, with the layers, be no more than 100000 stones");
  expect(R"("settings": {"stone_board": {"rolling_resistance": 0.0111}})",
         "/settings/stone_board/rolling_resistance = 0.0111: is a length, and must not exceed half the width (0.011)");
  expect(R"("board": {"lines": 1, "border": [0, 1]})", "/board/border = 0: must be positive on a board with one line");
}

TEST_F(CliSceneError, WhatOverlaps) {
  expect_stone(R"("position": [0.0217, 0, 1])",
               "/stones/1/position = 0.021700000000000001 0 1: stone 1 overlaps stone 0, 0.000212839 m deep");
  expect_stone(
      R"("position": [0, 0.1, 0.004])",
      "/stones/1/position = 0 0.10000000000000001 0.0040000000000000001: stone 1 overlaps the board, 0.0006 m deep");
  expect_stone(R"("position": [1, 0, -0.15])",
               "/stones/1/position = 1 0 -0.14999999999999999: stone 1 overlaps the floor, 0.0031 m deep");
  expect_group(R"("points": "3x1", "spacing": [0.02, 0.02], "from": 0.5)",
               "/groups/0/position = 0 0 0.5: stone 1 overlaps stone 0, 0.00139031 m deep");
}

TEST_F(CliSceneError, TheActions) {
  expect_action(R"({"at": 1})", "/actions/0: must have at least 2 members");
  expect_action(R"({"release": {"id": 0}})", "/actions/0: needs at");
  expect_action(R"({"at": 1, "release": {"id": 0}, "remove": {"id": 0}})", "/actions/0: must have at most 2 members");
  expect_action(R"({"at": 1, "kick": {"id": 0}})",
                "/actions/0/kick: must be at, impulse, hold, release, gravity, add or remove");
  expect_action(R"({"at": -1, "remove": {"id": 0}})", "/actions/0/at = -1: must be at least 0");
  expect_action(R"({"at": 1, "remove": {"id": -1}})", "/actions/0/remove/id = -1: must be at least 0");
  expect_action(R"({"at": 60, "remove": {"id": 0}})", "/actions/0/at = 60: is not before the end, 60 s");
  expect_action(R"({"at": 0, "impulse": {"id": 0}})", "/actions/0/impulse: needs impulse");
  expect_action(R"({"at": 0, "hold": {"id": 0, "duration": 0}})",
                "/actions/0/hold/duration = 0: must be at least 1e-20");
  const std::string nobody = "id = 1: must be that of a stone of the scene";
  expect_action(R"({"at": 0.1, "remove": {"id": 1}})", "/actions/0/remove/" + nobody);
  expect_action(R"({"at": 0.1, "impulse": {"id": 1, "impulse": [0, 0, 0]}})", "/actions/0/impulse/" + nobody);
  expect_action(R"({"at": 0.1, "hold": {"id": 1, "duration": 1}})", "/actions/0/hold/" + nobody);
  expect_action(R"({"at": 0.1, "release": {"id": 1}})", "/actions/0/release/" + nobody);
  expect_action(R"({"at": 0.1, "release": {"id": 0}})",
                "/actions/0/release/id = 0: must be that of a stone that is held");
  // In the order of their times, by the place in the file.
  expect_action(R"({"at": 0.2, "release": {"id": 0}}, {"at": 0.1, "remove": {"id": 0}})",
                "/actions/0/release/id = 0: must be that of a stone of the scene");
  expect_action(
      R"({"at": 0, "hold": {"id": 0, "duration": 1}}, {"at": 0.1, "impulse": {"id": 0, "impulse": [0, 0, 1]}})",
      "/actions/1/impulse/id = 0: is held by a hand, and no impulse moves it");
  expect_action(R"({"at": 0, "hold": {"id": 0, "velocity": [0, 0, -1], "duration": 0.1}})",
                "/actions/0/hold/velocity = 0 0 -1: moves the stone into what is below, 0.0454 s from now");
  expect_action(R"({"at": 0, "add": {"position": [0, 0, 0.055]}})",
                "/actions/0/add/position = 0 0 0.055: stone 1 overlaps stone 0, 0.0042 m deep");
}

/// A quaternion of few digits is told of, and made one.
TEST_F(CliSceneError, ANoteIsNoError) {
  const Result result = run(
      {"scene",
       file_with(R"("stones": [{"position": [0, 0, 1], "attitude": [0.8, 0, 0.60001, 0]}], "end": {"time": 0.1})")});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.find("goishi: note: attitude = 0.8,0,0.60001,0: is made a unit quaternion; "), 0U) << result.err;
}

}  // namespace

}  // namespace goishi::cli_test
