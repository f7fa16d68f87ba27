/// The program `goishi drop`: text, exit status, series, help.

#include <cmath>
#include <numbers>
#include <regex>

#include "tests/cli_drop_test.hpp"

namespace goishi::cli_test {

namespace {

// --- text

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// Characters, not bytes.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xC0') != '\x80'; }));
}

TEST_F(CliDrop, TextIsALineForEachEvent) {
  const Words words = {"--from", "1m", "--until", "3-impacts"};
  EXPECT_EQ(printed(with(words)),
            "The white stone of size 33, sharp, dropped on the board\n"
            "mass 0.00518151 kg (density assumed), gravity 9.80665 m/s²\n"
            "restitution 0.5 (chatterjee-ruina), dry friction 0.3\n"
            "rolling resistance 0.0001 m, pivot radius 5e-05 m; tolerance 1e-09; until 3 impacts, at most 60 s\n"
            "\n"
            "time [s]  event   what touches what   height [mm]  tilt [°]  speed [m/s]  spin [rad/s]  energy [µJ]\n"
            "0.000000  start                           1000.00     0.000       0.0000         0.000      50813.3\n"
            "0.450561  impact  lower cap on board         4.60     0.000       2.2092         0.000      12878.6\n"
            "0.901122  impact  lower cap on board         4.60     0.000       1.1046         0.000       3395.0\n"
            "1.126402  impact  lower cap on board         4.60     0.000       0.5523         0.000       1024.0\n"
            "1.126402  end                                4.60     0.000       0.5523         0.000       1024.0\n"
            "\n"
            "Still moving after 1.1264 s.\n"
            "Computed: 3 impacts, 10 root steps, 5 separations.\n");
  Words format = words;
  format.insert(format.end(), {"--format", "text"});
  EXPECT_EQ(printed(with(format)), printed(with(words)));
}

TEST_F(CliDrop, TextKeepsItsColumns) {
  const Words words = {"--bevel", "1mm",        "--from", "3cm",        "--tilt",
                       "30",      "--position", "0.21,0", "--velocity", "0.2,0,0"};
  const std::vector<std::string> lines = lines_of(printed(with(words)));
  const auto answer = json(words);
  const Value& events = answer["events"];
  ASSERT_EQ(lines.size(), 6 + events.Size() + 3);  // header, titles; the end and its cost
  const auto titles = lines[5];
  bool side = false, floor = false;
  for (rapidjson::SizeType i = 0; i < events.Size(); ++i) {
    const std::string& line = lines[6 + i];
    EXPECT_EQ(length(line), length(titles)) << line;
    EXPECT_EQ(line.find(events[i]["kind"].GetString()), titles.find("event")) << line;
    EXPECT_EQ(std::round(std::stod(line) * 1e6), std::round(events[i]["time"].GetDouble() * 1e6)) << line;
    side = side || line.find(" on board's side ") != std::string::npos;
    floor = floor || line.find(" on floor ") != std::string::npos;
  }
  EXPECT_TRUE(side && floor);
  EXPECT_TRUE(lines[lines.size() - 2].starts_with("At rest on the floor after ")) << lines[lines.size() - 2];
  EXPECT_TRUE(lines.back().starts_with("Computed: ")) << lines.back();
}

TEST_F(CliDrop, TextSaysWhatIsSet) {
  const std::string text =
      printed(with({"--from", "5mm", "--gravity", "1,0,-9", "--friction-model", "slip-proportional",
                    "--slip-coefficient", "2", "--on", "plane", "--mass", "5g", "--until", "1ms"}));
  for (const auto* part : {", dropped on the plane z = 0\n", "mass 0.005 kg, gravity (1, 0, -9) m/s²\n",
                           "friction of impacts 0.3, of contacts slip-proportional, 2 s/m\n", "until 0.001 s\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
  EXPECT_NE(printed(with({"--from", "5mm", "--friction-model", "coulomb-contensou", "--until", "1ms"}))
                .find("coulomb-contensou friction 0.3 on a patch of 0.0001 m\n"),
            std::string::npos);
}

// --- the end

TEST_F(CliDrop, AStartInsideIsAnAnswer) {
  const Result text = run(with({"--from", "1mm"}));
  EXPECT_EQ(text.status, 3);
  EXPECT_EQ(text.err, "goishi: error: the start is 0.0036 m inside the board\n");
  EXPECT_NE(text.out.find("\nThe start is 0.0036 m inside the board.\nComputed: nothing.\n"), std::string::npos);
  const Result plane = run(with({"--from", "-1mm", "--on", "plane", "--format", "json"}));
  EXPECT_EQ(plane.status, 3);
  EXPECT_EQ(plane.err, "goishi: error: the start is 0.0056 m inside the plane\n");
  const auto answer = parsed(plane.out);
  EXPECT_STREQ(answer["final"]["status"].GetString(), "start inside");
  EXPECT_NEAR(answer["final"]["depth"].GetDouble(), 0.0056, 1e-17);
  const std::string file = (work() / "inside.csv").string();
  EXPECT_EQ(run(with({"--from", "1mm", "--series", "3", "--csv", file})).status, 3);
  EXPECT_EQ(lines_of(contents(file)).size(), 4U);
}

TEST_F(CliDrop, ADropThatIsGivenUpSaysSo) {
  const Result result = run(with({"--from", "1cm", "--restitution", "1", "--until", "1e9s"}));
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(std::regex_match(result.err, std::regex("goishi: error: given up after [0-9.]+ s: too many events\n")))
      << result.err;
  EXPECT_NE(result.out.find("\nGiven up after "), std::string::npos);
}

TEST_F(CliDrop, WhatDoesNotRestIsMoving) {
  // 60 s, unless a time is given.
  const Words words = {"--from", "1m", "--gravity", "0", "--velocity", "1,0,0"};
  EXPECT_EQ(json(words)["final"]["time"].GetDouble(), 60.0);
  EXPECT_EQ(json(words + Words{"--until", "100"})["final"]["time"].GetDouble(), 100.0);
  EXPECT_NE(printed(with(words)).find("\nStill moving after 60 s.\n"), std::string::npos);
  EXPECT_NE(printed(with({"--from", "1m", "--gravity", "0"})).find("\nAt rest, touching nothing, after 0 s.\n"),
            std::string::npos);
}

// --- the series

TEST_F(CliDrop, ASeriesGoesEvenlyFromStartToEnd) {
  const Words words = {"--bevel", "1mm", "--from", "5cm", "--tilt", "20", "--spin", "3,2,10"};
  const auto answer = json(words);
  for (const int count : {2, 101}) {
    const std::vector<Row> rows = series(words, count);
    const double end = answer["final"]["time"].GetDouble();
    for (int i = 0; i < count; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      EXPECT_NEAR(row[0], end * i / (count - 1), 1e-15);
      EXPECT_EQ(row[height], row[z]);
      EXPECT_NEAR(row[q_w] * row[q_w] + row[5] * row[5] + row[6] * row[6] + row[7] * row[7], 1, 1e-14);
      EXPECT_NEAR(row[tilt], std::acos(1 - 2 * (row[5] * row[5] + row[6] * row[6])) * 180 / std::numbers::pi, 1e-5);
    }
    // In every digit.
    EXPECT_EQ(Row(rows.front().begin(), rows.front().begin() + 14), row_of(answer["events"][0]));
    EXPECT_EQ(Row(rows.back().begin(), rows.back().begin() + 14), row_of(answer["final"]));
    EXPECT_EQ(rows.back()[energy], answer["final"]["energy"].GetDouble());
    EXPECT_EQ(rows.front()[tilt], 20.0);
  }
}

std::string text_of(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

/// Each row beside a drop until its time.
TEST_F(CliDrop, ASeriesIsWhatEachTimeGivesAlone) {
  const auto expect_same = [this](const Words& words, const std::string& end, int count) {
    const auto until = [&](const std::string& time) {
      Words more = words;
      more.insert(more.end(), {"--until", time});
      return more;
    };
    const std::vector<Row> rows = series(until(end), count);
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
      const auto there = json(until(text_of(rows[i][0])));
      // Spins are the worst of the numbers: 1.4e-7 rad/s at most (measured 2026-11-22).
      EXPECT_LT(greatest_difference(row_of(there["final"]), rows[i]), 1e-6) << i << testing::PrintToString(words);
    }
  };
  expect_same({"--bevel", "1mm", "--from", "5cm", "--tilt", "20", "--spin", "3,2,10"}, "rest", 41);
  expect_same({"--bevel", "1mm", "--from", "5cm", "--tilt", "70", "--friction-model", "coulomb-contensou"}, "1s", 21);
  // Over the edge, by micro-impacts.
  expect_same({"--bevel", "1mm", "--from", "1cm", "--tilt", "30", "--position", "0.2118,0", "--restitution", "0"},
              "rest", 41);
}

TEST_F(CliDrop, ASeriesFollowsTheBouncesThatTheDropSums) {
  // From the last impact on, bounce by bounce.
  const Words words = {"--from", "6mm", "--restitution", "0.8", "--gravity", "10"};
  const auto answer = json(words);
  const Value& events = answer["events"];
  const Value& last = events[events.Size() - 3];
  EXPECT_STREQ(events[events.Size() - 2]["kind"].GetString(), "bounces close");
  const double from = last["time"].GetDouble(), v = vector_of(last, "velocity").z();
  int seen = 0;
  for (const Row& row : series(words, 1001)) {
    if (row[0] <= from || answer["final"]["time"].GetDouble() <= row[0]) {
      continue;
    }
    double up = v, past = row[0] - from;
    while (2 * up / 10 < past && 1e-9 < up) {
      past -= 2 * up / 10;
      up *= 0.8;
    }
    EXPECT_NEAR(row[z], 0.0046 + past * (up - 5 * past), 1e-12);
    if (1e-9 < up) {
      EXPECT_NEAR(std::abs(row[v_z]), std::abs(up - 10 * past), 1e-10) << row[0];
    }
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST_F(CliDrop, ASeriesLeavesNoHalfFile) {
  const std::string file = (work() / "drop.csv").string();
  put(file, "as it was");
  const Result result = run(with({"--from", "5cm", "--series", "100", "--csv", file}), "ulimit -f 1; ");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "goishi: error: csv = " + file + ": cannot be written: File too large\n");
  EXPECT_EQ(contents(file), "as it was");
  EXPECT_EQ(files().size(), 1U);
}

}  // namespace
}  // namespace goishi::cli_test
