/// The program `goishi scene`: examples, text, JSON, series, exit status, help.

#include "tests/cli_scene_test.hpp"

#include <map>

namespace goishi::cli_test {

namespace {

std::vector<std::string> csv_rows(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream in(text);
  for (std::string row; std::getline(in, row);) {
    rows.push_back(row);
  }
  return rows;
}

double number_behind(const std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  EXPECT_NE(at, std::string::npos) << mark;
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + mark.size(), nullptr);
}

// --- the examples

void expect_stones_in_their_places(const rapidjson::Document& board) {
  double farthest = 0;
  for (int id = 0; id < 361; ++id) {
    const Vec3<double> p = vector_of(final_of(board, id), "position");
    const Vec3<double> place(0.02233 * (id % 19 - 9), 0.02392 * (id / 19 - 9), 0);
    farthest = std::max(farthest, (p - place).head<2>().norm());
    EXPECT_LT(p.z(), 0.006) << id;
  }
  EXPECT_LT(farthest, 0.005);
  EXPECT_GT(farthest, 0.0005);
}

/// 14 of 30 were put on others: no layer, but a pile.
void expect_stones_on_stones(const rapidjson::Document& pile) {
  EXPECT_GT(vector_of(final_of(pile, 29), "position").z(), 0.015);
  EXPECT_LT(vector_of(final_of(pile, 0), "position").z(), 0.006);
  int on_stones = 0;
  for (const Value& contact : pile["final"]["contacts"].GetArray()) {
    on_stones += contact["touched"] == "stone" ? 1 : 0;
  }
  EXPECT_GE(on_stones, 2 * 14);
}

/// All rest, and the board and the floor bear their weight.
TEST_F(CliScene, TheExamplesComeToRest) {
  const std::map<std::string, unsigned> stones = {{"board", 361},  {"bump", 9},  {"hand", 2},
                                                  {"handful", 12}, {"pile", 30}, {"snap", 4}};
  ASSERT_EQ(examples().size(), stones.size());
  for (const fs::path& example : examples()) {
    const std::string name = example.stem();
    ASSERT_TRUE(stones.contains(name)) << name;
    const auto scene = played(example.string());
    const Value& end = scene["final"];
    EXPECT_STREQ(end["status"].GetString(), "rest") << name;
    EXPECT_LT(end["time"].GetDouble(), 10) << name;
    EXPECT_EQ(end["stones"].Size(), stones.at(name)) << name;
    for (const Value& stone : end["stones"].GetArray()) {
      EXPECT_STREQ(stone["mode"].GetString(), "rest") << name;
      EXPECT_EQ(vector_of(stone, "velocity").norm(), 0) << name;
    }
    double force = 0;
    for (const Value& contact : end["contacts"].GetArray()) {
      force += contact.HasMember("other") ? 0 : vector_of(contact, "force").z();
    }
    const std::string text = printed({"scene", example.string()});
    EXPECT_TRUE(text.starts_with(scene["title"].GetString())) << name;
    const double weight = number_behind(text, "\nmass ") * 9.80665;
    EXPECT_NEAR(force, weight, 1e-3 * weight) << name;
    if (name == "board") {
      expect_stones_in_their_places(scene);
    } else if (name == "pile") {
      expect_stones_on_stones(scene);
    }
  }
}

TEST_F(CliScene, OneFileIsOneResult) {
  const std::string example = (folder() / "examples/handful.json").string();
  for (const Words& words : {Words{}, Words{"--format", "json"}}) {
    EXPECT_EQ(printed(Words{"scene", example} + words), printed(Words{"scene", example} + words));
  }
}

// --- text

TEST_F(CliScene, TextIsASummary) {
  const std::string text = printed({"scene", file(R"({
      "title": "Two stones", "stone": {"size": 33},
      "stones": [{"position": [0, 0, 0.0046]}, {"position": [0.3, 0, -0.1469]}],
      "actions": [{"at": 1, "remove": {"id": 1}}, {"at": 0.5, "gravity": [0, 1, -9.8]},
                  {"at": 0.7, "hold": {"id": 0, "duration": 0.2}}, {"at": 1, "release": {"id": 0}},
                  {"at": 1, "add": {"position": [0.3, 0, -0.1469]}},
                  {"at": 1, "impulse": {"id": 0, "impulse": [0, 0, -1e-9]}}],
      "end": {"rest_within": 5}})")});
  EXPECT_EQ(text.substr(0, text.find("Events: ")),
            "Two stones\n"
            "2 stones on the board, 19 lines\n"
            "2 × The white stone of size 33, sharp, 0.00518151 kg (density assumed)\n"
            "mass 0.010363 kg, gravity 9.80665 m/s²\n"
            "on the board: restitution 0.5 (chatterjee-ruina), dry friction 0.3\n"
            "rolling resistance 0.0001 m, pivot radius 5e-05 m\n"
            "of two stones: restitution 0.5, friction 0.3\n"
            "tolerance 1e-09, steps of 0.00208403 s; until 5 s, or all stones rest\n"
            "\n"
            "0.5 s: gravity (0, 1, -9.8) m/s²\n"
            "0.7 s: a hand moves stone 0\n"
            "1 s: stone 1 is removed\n"
            "1 s: stone 0 is let go\n"
            "1 s: a stone is added\n"
            "1 s: an impulse on stone 0\n"
            "\n"
            "At rest after 1.13104 s.\n"
            "Stones: 2 rest.\n"
            "Contacts: 1 with the board, 1 with the floor.\n"
            "Energy: -7.23073 mJ at the start, -7.22684 mJ at the end, 0.00389254 mJ gained.\n");
  EXPECT_NE(text.find("\nEvents: 3 start, "), std::string::npos) << text;
  EXPECT_NE(text.find("\nComputed: "), std::string::npos) << text;
}

TEST_F(CliScene, ATimeIsAnEnd) {
  const Result result = run({"scene", file_with(R"("stones": [{"position": [0, 0, 0.05]}], "end": {"time": 0.01})")});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("\nStill moving after 0.01 s: 1 of 1 stone.\nStones: 1 flight.\nContacts: nothing.\n"),
            std::string::npos);
}

TEST_F(CliScene, AHandThatStandsStillRests) {
  const std::string held = R"("stones": [{"position": [0, 0, 0.1]}], "actions": [{"at": 0, "hold":
      {"id": 0, "velocity": [0, 0, 0.1], "duration": 0.5}}], "end": )";
  for (const std::string end : {R"({"time": 0.6})", R"({"rest_within": 0.6})"}) {
    EXPECT_STREQ(played_with(held + end)["final"]["status"].GetString(), "rest") << end;
  }
  EXPECT_STREQ(played_with(held + R"({"time": 0.4})")["final"]["status"].GetString(), "moving");
  EXPECT_EQ(run({"scene", file_with(held + R"({"rest_within": 0.4})")}).status, 1);
}

TEST_F(CliScene, TheTextTellsOfPairsAndOfTheFloorBoard) {
  const std::string text = printed({"scene", file_with(R"("board": {"kind": "floor-board", "standard": "nihon-kiin"},
      "settings": {"gravity": [0, 0, 0], "step": 0.002, "impact_speed": 0.005}, "stones":
      [{"position": [-0.05, 0, 0.1], "velocity": [1, 0, 0]}, {"position": [0, 0, 0.1]}], "end": {"time": 0.1})")});
  EXPECT_NE(text.find("\n2 stones on the floor board, nihon-kiin, 19 lines\n"), std::string::npos) << text;
  EXPECT_NE(text.find("; 2 of these impacts are those of two stones, told of each.\n"), std::string::npos) << text;
}

TEST_F(CliScene, WhatDoesNotRestInTimeSaysSo) {
  const Words words = {"scene",
                       file_with(R"("groups": [{"points": "2x1", "from": 0.05}], "end": {"rest_within": 0.02})")};
  const Result text = run(words);
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.err, "goishi: error: still moving after 0.02 s: 2 of 2 stones\n");
  EXPECT_NE(text.out.find("\nStill moving after 0.02 s: 2 of 2 stones.\n"), std::string::npos);
  const Result json = run(words + Words{"--format", "json"});
  EXPECT_EQ(json.status, 1);
  EXPECT_STREQ(parsed(json.out)["final"]["status"].GetString(), "moving");
}

TEST_F(CliScene, ABoardWithoutStonesRests) {
  EXPECT_EQ(played(file(R"({"stone": {"size": 33}})"))["final"]["time"].GetDouble(), 0);
}

// --- the series

TEST_F(CliScene, ASeriesHasARowForEachStone) {
  const std::string scene = file_with(R"("title": "t", "groups": [{"points": "2x1", "from": 0.01, "random": {"seed": 1,
      "tilt_deg": 20}}], "actions": [{"at": 0.05, "hold": {"id": 1, "velocity": [0, 0, 0.1], "duration": 1}},
      {"at": 0.5, "remove": {"id": 0}}], "end": {"time": 0.6})");
  const std::string csv = (work() / "series.csv").string();
  const auto answer = parsed(printed({"scene", scene, "--format", "json", "--series", "7", "--csv", csv}));
  const std::vector<std::string> rows = csv_rows(contents(csv));
  EXPECT_EQ(rows[0],
            "time_s,stone,position_x_m,position_y_m,position_z_m,attitude_w,attitude_x,attitude_y,attitude_z,"
            "velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,spin_body_x_rad_s,spin_body_y_rad_s,spin_body_z_rad_s,"
            "height_m,tilt_deg,energy_J,mode");
  std::vector<std::vector<std::string>> cells;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::istringstream row(rows[i]);
    cells.emplace_back();
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.back().push_back(cell);
    }
    ASSERT_EQ(cells.back().size(), 19U);
  }
  // Two at 0 … 0.4, one at 0.5, when the other is gone, and at 0.6.
  ASSERT_EQ(cells.size(), 2U * 5 + 2);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t time = i < 10 ? i / 2 : i - 5;
    EXPECT_NEAR(std::stod(cells[i][0]), 0.1 * static_cast<double>(time), 1e-15);
    EXPECT_EQ(cells[i][1], i < 10 && i % 2 == 0 ? "0" : "1");
    EXPECT_EQ(cells[i][18] == "held", cells[i][1] == "1" && 0 < time) << i;
  }
  EXPECT_EQ(cells[0][18], "flight");
  std::size_t column = 2;
  for (const char* key : {"position", "attitude", "velocity", "spin_body"}) {
    for (const Value& number : answer["final"]["stones"][0][key].GetArray()) {
      EXPECT_EQ(std::stod(cells.back()[column++]), number.GetDouble()) << key;
    }
  }
  const std::string first = contents(csv);
  EXPECT_EQ(run({"scene", scene, "--series", "7", "--csv", csv}).status, 0);
  EXPECT_EQ(contents(csv), first);
}

// --- help and schema

TEST_F(CliScene, TheSchemaIsTheFile) {
  EXPECT_EQ(printed({"scene", "--schema"}), contents(folder() / "scene.schema.json"));
}

TEST_F(CliScene, HelpIsTrue) {
  const std::string help = printed({"scene", "--help"});
  for (const char* part : {"--format", "--series", "--csv", "--schema", "Exit status: 0 done, 1 "}) {
    EXPECT_NE(help.find(part), std::string::npos) << part;
  }
  EXPECT_NE(printed({"--help"}).find("\n  goishi scene board.json\n"), std::string::npos);
  int commands = 0;
  fs::copy(folder() / "examples/hand.json", work() / "board.json");
  for (const std::string& row : csv_rows(help)) {
    if (row.starts_with("  goishi scene")) {
      const Words words = words_of(row.substr(std::string("  goishi ").size()));
      EXPECT_EQ(run(words, "cd '" + work().string() + "' && ").status, 0) << row;
      ++commands;
    }
  }
  EXPECT_EQ(commands, 4);
  const std::size_t begin = help.find("\n  {\n"), end = help.find("\n  }\n", begin);
  EXPECT_NE(printed({"scene", file(help.substr(begin, end + 4 - begin))}).find("\nStones: 361 rest.\n"),
            std::string::npos);
}

}  // namespace

}  // namespace goishi::cli_test
