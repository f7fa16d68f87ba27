#pragma once
/// \file
/// Runs `goishi drop`, and reads its JSON and its CSV.

#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <goishi/rotation.hpp>
#include <sstream>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

using rapidjson::Value;
using Row = std::vector<double>;

/// Where a CSV row has what.
constexpr std::size_t z = 3, q_w = 4, v_z = 10, height = 14, tilt = 15, energy = 16;

class CliDrop : public Cli {
 protected:
  /// A good command with more words.
  static Words with(const Words& more) { return Words{"drop", "--size", "33"} + more; }

  [[nodiscard]] rapidjson::Document json(const Words& more) const {
    return parsed(printed(with(more) + Words{"--format", "json"}));
  }

  static rapidjson::Document parsed(const std::string& text) {
    rapidjson::Document document;
    // Every digit: the fast way may be an ulp off.
    document.Parse<rapidjson::kParseFullPrecisionFlag>(text.c_str());
    EXPECT_FALSE(document.HasParseError()) << text;
    return document;
  }

  /// The rows of a series; its header is checked.
  [[nodiscard]] std::vector<Row> series(const Words& more, int rows) const {
    const std::string file = (work() / "drop.csv").string();
    Words words = with(more);
    words.insert(words.end(), {"--series", std::to_string(rows), "--csv", file});
    EXPECT_FALSE(printed(words).empty());
    std::istringstream lines(contents(file));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line,
              "time_s,position_x_m,position_y_m,position_z_m,attitude_w,attitude_x,attitude_y,attitude_z,"
              "velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,spin_body_x_rad_s,spin_body_y_rad_s,spin_body_z_rad_s,"
              "height_m,tilt_deg,energy_J");
    std::vector<Row> result;
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      result.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) {
        result.back().push_back(std::strtod(cell.c_str(), nullptr));
      }
      EXPECT_EQ(result.back().size(), 17U) << line;
    }
    EXPECT_EQ(result.size(), static_cast<std::size_t>(rows));
    return result;
  }
};

inline Vec3<double> vector_of(const Value& object, const char* key) {
  const Value& array = object[key];
  EXPECT_EQ(array.Size(), 3U);
  return {array[0].GetDouble(), array[1].GetDouble(), array[2].GetDouble()};
}

/// The numbers of a state, in the order of a CSV row.
inline Row row_of(const Value& state) {
  Row row = {state["time"].GetDouble()};
  for (const char* key : {"position", "attitude", "velocity", "spin_body"}) {
    for (const Value& number : state[key].GetArray()) {
      row.push_back(number.GetDouble());
    }
  }
  return row;
}

inline double greatest_difference(const Row& a, const Row& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    greatest = std::max(greatest, std::abs(a[i] - b[i]));
  }
  return greatest;
}

}  // namespace goishi::cli_test
