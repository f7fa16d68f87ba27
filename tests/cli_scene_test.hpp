#pragma once
/// \file
/// Runs `goishi scene` on a file, and reads its JSON.

#include "tests/cli_drop_test.hpp"

namespace goishi::cli_test {

class CliScene : public CliDrop {
 protected:
  /// The name of a file with this text.
  [[nodiscard]] std::string file(const std::string& text, const std::string& name = "scene.json") const {
    const fs::path path = work() / name;
    put(path, text);
    return path.string();
  }

  /// A file with stones of size 33, bevel 1 mm, and these members more.
  [[nodiscard]] std::string file_with(const std::string& members) const {
    return file(R"({"stone": {"size": 33, "bevel": 0.001}, )" + members + "}");
  }

  /// What a scene comes to.
  [[nodiscard]] rapidjson::Document played(const std::string& file) const {
    return parsed(printed({"scene", file, "--format", "json"}));
  }
  [[nodiscard]] rapidjson::Document played_with(const std::string& members) const { return played(file_with(members)); }

  static fs::path folder() { return fs::path(GOISHI_SCENE_FOLDER); }

  static std::vector<fs::path> examples() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder() / "examples")) {
      files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
  }
};

/// The state of a stone at the end.
inline const Value& final_of(const rapidjson::Document& scene, int stone) {
  for (const Value& one : scene["final"]["stones"].GetArray()) {
    if (one["stone"].GetInt() == stone) {
      return one;
    }
  }
  throw std::out_of_range("no such stone");
}

}  // namespace goishi::cli_test
