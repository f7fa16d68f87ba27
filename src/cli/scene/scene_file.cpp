#include "scene/scene_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <goishi/mass/inertia.hpp>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <tuple>
#include <utility>

#include "catalogue.hpp"
#include "quantity.hpp"
#include "scene/schema.hpp"
#include "scene_schema.hpp"

namespace goishi::cli {

namespace {

using rapidjson::SizeType;
using rapidjson::Value;

const Value* find(const Value& object, const char* key) {
  const auto member = object.FindMember(key);
  return member == object.MemberEnd() ? nullptr : &member->value;
}

/// As it would be typed, digit for digit; nothing where it is not given.
std::optional<std::string> typed(const Value& object, const char* key) {
  const Value* value = find(object, key);
  if (value == nullptr) {
    return std::nullopt;
  }
  return value->IsString() ? value->GetString() : shown(*value);
}

double number_in(const Value& object, const char* key, double otherwise) {
  const Value* value = find(object, key);
  return value == nullptr ? otherwise : value->GetDouble();
}

void set_number(std::optional<double>& setting, const Value& object, const char* key) {
  if (const Value* value = find(object, key)) {
    setting = value->GetDouble();
  }
}

Vec3<double> vector_in(const Value& object, const char* key) {
  const Value* value = find(object, key);
  return value == nullptr ? Vec3<double>(0, 0, 0)
                          : Vec3<double>((*value)[0].GetDouble(), (*value)[1].GetDouble(), (*value)[2].GetDouble());
}

std::pair<double, double> pair_in(const Value& object, const char* key, std::pair<double, double> otherwise) {
  const Value* value = find(object, key);
  return value == nullptr ? otherwise : std::pair{(*value)[0].GetDouble(), (*value)[1].GetDouble()};
}

StoneId id_in(const Value& object) {
  return StoneId(object["id"].GetUint());
}

/// Numbers from -1 to 1, the same for a seed on every machine.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  double next() { return static_cast<double>(random_() >> 11U) * 0x1p-52 - 1; }
  Vec3<double> vector() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }

 private:
  std::mt19937_64 random_;
};

constexpr int most_stones = 100'000;  // of a group

class SceneReader {
 public:
  SceneReader(const std::string& file, const Value& root) : root_(root) {
    scene_.name = file;
    scene_.title = typed(root, "title").value_or(file);
  }

  SceneFile read() {
    static const Value nothing(rapidjson::kObjectType);
    const auto part = [&](const char* key) -> const Value& {
      const Value* value = find(root_, key);
      return value == nullptr ? nothing : *value;
    };
    read_board(part("board"));
    read_settings(part("settings"));
    static_cast<void>(solid(root_, "", 0));  // refused though no stone may have it
    each(root_, "stones",
         [&](const Value& value, const std::string& path) { scene_.stones.push_back(entry(value, path)); });
    each(root_, "groups", [&](const Value& value, const std::string& path) { add_group(value, path); });
    each(root_, "actions", [&](const Value& value, const std::string& path) { add_action(value, path); });
    std::ranges::stable_sort(scene_.actions, {}, &SceneAction::time);
    read_end(part("end"));
    return std::move(scene_);
  }

 private:
  template <class F>
  static void each(const Value& object, const char* key, const F& call) {
    if (const Value* list = find(object, key)) {
      for (SizeType i = 0; i < list->Size(); ++i) {
        call((*list)[i], fmt::format("/{}/{}", key, i));
      }
    }
  }

  void read_board(const Value& board) {
    const Standard standard = parse_standard(typed(board, "standard"));
    const Value* lines = find(board, "lines");
    BoardDimensions<double> dimensions = board_dimensions<double>(standard, lines == nullptr ? 19 : lines->GetInt());
    const bool on_legs = typed(board, "kind") == "floor-board";
    if (on_legs) {
      dimensions = floor_board(dimensions);
    }
    std::tie(dimensions.spacing_x, dimensions.spacing_y) =
        pair_in(board, "spacing", {dimensions.spacing_x, dimensions.spacing_y});
    std::tie(dimensions.border_x, dimensions.border_y) =
        pair_in(board, "border", {dimensions.border_x, dimensions.border_y});
    dimensions.thickness = number_in(board, "thickness", dimensions.thickness);
    dimensions.legs = number_in(board, "legs", dimensions.legs);
    scene_.board = in_file(scene_.name, "/board", [&] { return make_board(dimensions); });
    scene_.ground =
        fmt::format("{}{}, {} lines", on_legs ? "floor board" : "board", named_unless_talk(standard), dimensions.lines);
    spacing_ = {dimensions.spacing_x, dimensions.spacing_y};
  }

  void read_settings(const Value& given) {
    SceneSettings<double>& settings = scene_.settings;
    static const Value nothing(rapidjson::kObjectType);
    const Value* on_board = find(given, "stone_board");
    const Value& board = on_board == nullptr ? nothing : *on_board;
    DropOptions options;
    options.restitution = typed(board, "restitution");
    options.friction = typed(board, "friction");
    options.friction_model = typed(board, "friction_model");
    options.slip_coefficient = typed(board, "slip_coefficient");
    options.patch_radius = typed(board, "patch_radius");
    options.rolling_resistance = typed(board, "rolling_resistance");
    options.pivot_radius = typed(board, "pivot_radius");
    options.law = typed(given, "law");
    options.tolerance = typed(given, "tolerance");
    settings.drop = drop_settings(options);
    if (find(given, "gravity") != nullptr) {
      settings.drop.gravity = vector_in(given, "gravity");
    }
    if (const Value* stones = find(given, "stone_stone")) {
      settings.restitution = number_in(*stones, "restitution", settings.restitution);
      settings.friction = number_in(*stones, "friction", settings.friction);
    }
    set_number(settings.step, given, "step");
    settings.solver_tolerance = number_in(given, "solver_tolerance", settings.solver_tolerance);
    set_number(settings.clearance, given, "clearance");
    set_number(settings.impact_speed, given, "impact_speed");
    set_number(settings.leaving_time, given, "leaving_time");
    in_file(scene_.name, "/settings", [&] { require_settings(settings); });
  }

  /// Of the entry, or else of the file; `turn` says which colour of both.
  std::size_t solid(const Value& owner, const std::string& path, std::optional<int> turn) {
    const Value* own = find(owner, "stone");
    const Value& shape = own == nullptr ? root_["stone"] : *own;
    return in_file(scene_.name, (own == nullptr ? "" : path) + "/stone", [&] {
      std::optional<std::string> color = typed(shape, "color");
      if (color == "both") {
        require(turn.has_value(), "color", *color, "must be white or black, but for a group");
        color = *turn % 2 == 0 ? "white" : "black";
      }
      const std::pair key(&shape, color == "black");
      if (const auto known = solids_.find(key); known != solids_.end()) {
        return known->second;
      }
      const Value* measured = find(shape, "measured");
      const SolidStone made = solid_stone({.size = typed(shape, "size"),
                                           .color = color,
                                           .standard = typed(shape, "standard"),
                                           .width = typed(shape, "width"),
                                           .height = typed(shape, "height"),
                                           .bevel = typed(shape, "bevel"),
                                           .mass = typed(shape, "mass"),
                                           .density = typed(shape, "density"),
                                           .measured = measured != nullptr && measured->GetBool()});
      in_file(scene_.name, "/settings/stone_board", [&] { require_settings(scene_.settings.drop, made.stone); });
      scene_.solids.push_back(made);
      return solids_[key] = scene_.solids.size() - 1;
    });
  }

  StoneEntry entry(const Value& value, const std::string& path) {
    StoneEntry made{.path = path, .solid = solid(value, path, {}), .start = {}};
    in_file(scene_.name, path, [&] {
      State<double>& start = made.start;
      start.p_WB = vector_in(value, "position");
      if (const Value* point = find(value, "point")) {
        start.p_WB = intersection(scene_.board, (*point)[0].GetInt(), (*point)[1].GetInt());
        start.p_WB.z() = value["from"].GetDouble();
      }
      start.q_WB = attitude(value);
      set_motion(made, vector_in(value, "velocity"), vector_in(value, "spin_body"));
    });
    return made;
  }

  Quat<double> attitude(const Value& value) {
    if (const Value* given = find(value, "attitude")) {
      std::string text;
      for (const Value& number : given->GetArray()) {
        text += fmt::format("{}{}", text.empty() ? "" : ",", number.GetDouble());
      }
      const Quat<Number> q = parse_attitude("attitude", text, scene_.notes);
      return Quat<double>(q.coeffs().unaryExpr([](const Number& x) { return x.convert_to<double>(); }));
    }
    Vec3<Number> axis(0, 1, 0);
    if (find(value, "tilt_axis") != nullptr) {
      const Vec3<double> given = vector_in(value, "tilt_axis");
      require(given != Vec3<double>::Zero(), "tilt_axis", given.transpose(), "must not be zero");
      axis = given.cast<Number>();
    }
    return turned(parse("tilt_deg", typed(value, "tilt_deg").value_or("0"), measure::angle), axis);
  }

  void set_motion(StoneEntry& made, const Vec3<double>& v_WB, const Vec3<double>& w_WB_B) const {
    made.start.v_WB = v_WB;
    made.start.L_W = formula::angular_momentum_W(made.start.q_WB, scene_.solids[made.solid].body, w_WB_B);
  }

  void add_group(const Value& group, const std::string& path) {
    const std::string points = group["points"].GetString();
    const int columns = std::stoi(points), rows = std::stoi(points.substr(points.find('x') + 1));
    const Value* given_layers = find(group, "layers");
    const int layers = given_layers == nullptr ? 1 : given_layers->GetInt();
    in_file(scene_.name, path, [&] {
      require(1.0 * columns * rows * layers <= most_stones, "points", points, "must, with the layers, be no more than ",
              most_stones, " stones");
    });
    const auto [spacing_x, spacing_y] = pair_in(group, "spacing", spacing_);
    const auto [middle_x, middle_y] = pair_in(group, "middle", {0, 0});
    const double from = group["from"].GetDouble(), up = number_in(group, "layer_spacing", 0);
    const Vec3<double> v_WB = vector_in(group, "velocity"), w_WB_B = vector_in(group, "spin_body");
    static const Value nothing(rapidjson::kObjectType);
    const Value* given_random = find(group, "random");
    const Value& random = given_random == nullptr ? nothing : *given_random;
    const double tilt = number_in(random, "tilt_deg", 0) / 180 * std::numbers::pi;
    const double off = number_in(random, "position", 0), faster = number_in(random, "velocity", 0),
                 more_spin = number_in(random, "spin_body", 0);
    Draws draws(given_random == nullptr ? 0 : random["seed"].GetUint64());
    const auto along = [](int i, int count, double spacing) { return (2 * i - (count - 1)) / 2.0 * spacing; };
    for (int k = 0; k < layers; ++k) {
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
          StoneEntry made{.path = path, .solid = solid(group, path, i + j + k), .start = {}};
          // All are drawn, whatever is asked for: what is asked for besides changes nothing else.
          const double angle = tilt * (draws.next() + 1) / 2, side = draws.next() * std::numbers::pi;
          const auto [sine, cosine] = scalar::sincos(side);
          made.start.q_WB = formula::rotation_exp<double>({angle * cosine, angle * sine, 0});
          made.start.p_WB = Vec3<double>(middle_x + along(i, columns, spacing_x), middle_y + along(j, rows, spacing_y),
                                         from + k * up) +
                            off * draws.vector();
          const Vec3<double> v = v_WB + faster * draws.vector(), w = w_WB_B + more_spin * draws.vector();
          set_motion(made, v, w);
          scene_.stones.push_back(made);
        }
      }
    }
  }

  void add_action(const Value& value, const std::string& at) {
    SceneAction action{.time = value["at"].GetDouble(), .path = {}, .what = RemoveAction{}};
    for (const auto& [key, what] : value.GetObject()) {
      const std::string name = key.GetString();
      if (name == "at") {
        continue;
      }
      action.path = fmt::format("{}/{}", at, name);
      if (name == "impulse") {
        action.what = ImpulseAction{id_in(what), vector_in(what, "impulse"), vector_in(what, "offset")};
      } else if (name == "hold") {
        action.what = HoldAction{id_in(what), vector_in(what, "velocity"), vector_in(what, "spin_world"),
                                 what["duration"].GetDouble()};
      } else if (name == "release") {
        action.what = ReleaseAction{id_in(what)};
      } else if (name == "gravity") {
        action.path = at;
        action.what = GravityAction{vector_in(value, "gravity")};
      } else if (name == "add") {
        action.what = AddAction{entry(what, action.path)};
      } else {
        action.what = RemoveAction{id_in(what)};
      }
    }
    scene_.actions.push_back(std::move(action));
  }

  void read_end(const Value& end) {
    scene_.to_rest = find(end, "time") == nullptr;
    scene_.end = number_in(end, scene_.to_rest ? "rest_within" : "time", longest_drop);
    for (const SceneAction& action : scene_.actions) {
      in_file(scene_.name, action.path.substr(0, action.path.find('/', std::string_view("/actions/").size())), [&] {
        require(scene_.to_rest ? action.time < scene_.end : action.time <= scene_.end, "at", action.time,
                "is not before the end, ", scene_.end, " s");
      });
    }
  }

  const Value& root_;
  SceneFile scene_;
  std::pair<double, double> spacing_;
  std::map<std::pair<const Value*, bool>, std::size_t> solids_;
};

}  // namespace

std::string_view scene_schema() {
  return scene_schema_text;
}

std::runtime_error told_in_file(std::string_view file, std::string_view path, const InvalidArgument& error) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"outer_width", "width"}, {"spacing_x", "spacing"}, {"spacing_y", "spacing"}, {"border_x", "border"},
      {"border_y", "border"},   {"i", "point"},           {"j", "point"},           {"v_WB", "velocity"},
      {"w_WB", "spin_world"},   {"P_W", "impulse"},       {"p_W", "offset"},        {"time", "at"}};
  std::string argument = error.argument();
  for (const auto& [ours, in_file] : names) {
    argument = argument == ours ? in_file : argument;
  }
  // A row of numbers is in columns.
  std::istringstream words(error.value());
  const std::vector<std::string> value{std::istream_iterator<std::string>(words), {}};
  return std::runtime_error(
      fmt::format("{}: {}/{} = {}: {}", file, path, argument, fmt::join(value, " "), error.rule()));
}

SceneFile read_scene(const std::string& file, std::string_view text) {
  const rapidjson::Document document = read_json(file, text, scene_schema());
  return SceneReader(file, document).read();
}

}  // namespace goishi::cli
