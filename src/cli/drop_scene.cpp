#include "drop_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "catalogue.hpp"
#include "quantity.hpp"

namespace goishi::cli {

namespace {

using Text = std::optional<std::string>;

double in_drop(const char* argument, const Number& value) {
  return to_double(argument, value, "a drop", drop_order);
}

Vec3<double> in_drop(const char* argument, const Vec3<Number>& v) {
  return {in_drop(argument, v.x()), in_drop(argument, v.y()), in_drop(argument, v.z())};
}

/// Sets what was typed.
template <class Setting>
void set(Setting& setting, const char* argument, const Text& text, const Measure& measure) {
  if (text) {
    setting = in_drop(argument, parse(argument, *text, measure));
  }
}

/// The value whose name was typed; the first when none was.
template <class Value, std::size_t count, class Name>
Value named(const char* argument, const Text& text, const Value (&values)[count], const Name& name) {
  if (!text) {
    return values[0];
  }
  std::string names;
  for (std::size_t i = 0; i < count; ++i) {
    if (*text == name(values[i])) {
      return values[i];
    }
    names += fmt::format("{}{}", i == 0 ? "" : i + 1 == count ? " or " : ", ", name(values[i]));
  }
  throw InvalidArgument(argument, *text, "must be " + names);
}

ImpactLaw parse_law(const Text& text) {
  constexpr ImpactLaw laws[] = {ImpactLaw::chatterjee_ruina, ImpactLaw::published, ImpactLaw::stronge};
  return named("law", text, laws, name_of);
}

FrictionModel parse_friction_model(const Text& text) {
  constexpr FrictionModel models[] = {FrictionModel::dry, FrictionModel::slip_proportional,
                                      FrictionModel::coulomb_contensou};
  return named("friction-model", text, models, [](FrictionModel model) { return to_string(model); });
}

Vec3<double> parse_gravity(const Text& text) {
  if (!text) {
    return gravity_W<double>();
  }
  return text->find(',') == std::string::npos
             ? gravity_W(in_drop("gravity", parse("gravity", *text, measure::acceleration)))
             : in_drop("gravity", parse_vector("gravity", *text, measure::acceleration));
}

/// Sets when the drop ends; says it for people.
std::string parse_until(const Text& text, DropSettings<double>& settings) {
  settings.horizon = longest_drop;
  const std::string_view typed = text ? trimmed(*text) : "rest";
  if (typed == "rest") {
    return fmt::format("rest, at most {} s", longest_drop);
  }
  const std::size_t mark = std::min(typed.find("-impact"), typed.size());
  std::string_view number = typed;
  if (mark < typed.size()) {
    const int count = whole_number(typed.substr(0, mark)).value_or(0);
    const std::string_view unit = typed.substr(mark);
    if (0 < count && (unit == "-impacts" || (count == 1 && unit == "-impact"))) {
      settings.maximum_impacts = count;
      return fmt::format("{} impact{}, at most {} s", count, count == 1 ? "" : "s", longest_drop);
    }
  } else if (take_decimal(number)) {
    const Number time = parse("until", *text, measure::time);
    require_positive("until", time);
    settings.horizon = in_drop("until", time);
    return fmt::format("{:.6g} s", *settings.horizon);
  }
  throw InvalidArgument("until", *text, "must be rest, a time such as 500ms, or a count such as 5-impacts");
}

/// The tilt, in degrees, about an axis in the surface or any other.
Quat<double> parse_attitude_of(const Text& tilt, const Text& tilt_axis) {
  const Number degrees = tilt ? parse("tilt", *tilt, measure::angle) : Number(0);
  require(abs(degrees) <= 360, "tilt", degrees, "must be from -360 to 360 degrees");
  Vec3<Number> axis(0, 1, 0);
  if (tilt_axis) {
    axis = parse_vector("tilt-axis", *tilt_axis, measure::ratio);
    if (axis == Vec3<Number>::Zero()) {
      throw InvalidArgument("tilt-axis", *tilt_axis, "must not be zero");
    }
  }
  return turned(degrees, axis);
}

enum class On { board, floor_board, plane };

On parse_on(const Text& text) {
  constexpr On grounds[] = {On::board, On::floor_board, On::plane};
  return named("on", text, grounds, [](On on) {
    return on == On::board ? "board" : on == On::floor_board ? "floor-board" : "plane";
  });
}

void set_ground(DropScene& scene, On on, Standard standard) {
  if (on == On::plane) {
    scene.ground = "plane z = 0";
    return;
  }
  const BoardDimensions<double> dimensions = board_dimensions<double>(standard);
  scene.board = make_board(on == On::board ? dimensions : floor_board(dimensions));
  scene.ground = (on == On::board ? "board" : "floor board") + named_unless_talk(standard);
}

void check_combination(const DropOptions& options, On on) {
  const StoneOptions& stone = options.stone;
  check_stone(stone);
  if (!stone.size && !stone.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  check_catalogue(stone, on != On::plane);
  if (!options.from) {
    throw std::runtime_error("a height is needed: --from, such as --from 5cm");
  }
  require_with("tilt-axis", options.tilt_axis, "tilt", options.tilt);
  require_with("series", options.series, "csv", options.csv);
  require_with("csv", options.csv, "series", options.series);
  if (options.format && *options.format != "text" && *options.format != "json") {
    throw InvalidArgument("format", *options.format, "must be text or json");
  }
  const auto only_for = [&](const char* argument, const Text& value, FrictionModel model) {
    if (value && parse_friction_model(options.friction_model) != model) {
      throw InvalidArgument(argument, *value, fmt::format("needs --friction-model {}", to_string(model)));
    }
  };
  only_for("slip-coefficient", options.slip_coefficient, FrictionModel::slip_proportional);
  only_for("patch-radius", options.patch_radius, FrictionModel::coulomb_contensou);
}

}  // namespace

DropSettings<double> drop_settings(const DropOptions& options) {
  DropSettings<double> settings;
  set(settings.restitution, "restitution", options.restitution, measure::ratio);
  if (options.friction && trimmed(*options.friction) == "inf") {  // nothing slips
    settings.friction = std::numeric_limits<double>::infinity();
  } else {
    set(settings.friction, "friction", options.friction, measure::ratio);
  }
  settings.gravity = parse_gravity(options.gravity);
  set(settings.rolling_resistance, "rolling-resistance", options.rolling_resistance, measure::length);
  set(settings.pivot_radius, "pivot-radius", options.pivot_radius, measure::length);
  settings.friction_model = parse_friction_model(options.friction_model);
  set(settings.slip_coefficient, "slip-coefficient", options.slip_coefficient, measure::slip_coefficient);
  set(settings.patch_radius, "patch-radius", options.patch_radius, measure::length);
  settings.law = parse_law(options.law);
  set(settings.tolerance, "tolerance", options.tolerance, measure::ratio);
  return settings;
}

namespace {

State<double> start_of(const DropOptions& options, const RigidBody<double>& body) {
  const Vec3<double> nothing(0.0, 0.0, 0.0);
  Vec3<Number> p_WB(0, 0, parse("from", *options.from, measure::length));
  if (options.position) {
    const std::vector<Number> place = parse_list("position", *options.position, measure::length, 2);
    p_WB.head<2>() << place[0], place[1];
  }
  static_cast<void>(in_drop("from", p_WB.z()));
  const Quat<double> q_WB = parse_attitude_of(options.tilt, options.tilt_axis);
  const Vec3<double> w_WB_B =
      options.spin ? in_drop("spin", parse_vector("spin", *options.spin, measure::spin)) : nothing;
  return {.p_WB = in_drop("position", p_WB),
          .q_WB = q_WB,
          .v_WB = options.velocity ? in_drop("velocity", parse_vector("velocity", *options.velocity, measure::velocity))
                                   : nothing,
          .L_W = formula::angular_momentum_W(q_WB, body, w_WB_B)};
}

}  // namespace

std::string name_of(ImpactLaw law) {
  std::string name(to_string(law));
  std::ranges::replace(name, '_', '-');
  return name;
}

Quat<double> turned(const Number& degrees, const Vec3<Number>& axis) {
  static const Number right_angle = 2 * atan(Number(1));
  const Number half = degrees / 180 * right_angle;
  // 90 and 180 degrees are typed for their exact cosines.
  const Number c = abs(degrees) == 180 ? Number(0) : Number(cos(half));
  const Vec3<Number> s = sin(half) / axis.norm() * axis;
  return {c.convert_to<double>(), s.x().convert_to<double>(), s.y().convert_to<double>(), s.z().convert_to<double>()};
}

SolidStone solid_stone(const StoneOptions& options) {
  const Subject subject = subject_of(options);
  const Stone<Number> stone = stone_of(subject);
  static_cast<void>(in_drop("width", stone.width));
  static_cast<void>(in_drop("height", stone.height));
  static_cast<void>(in_drop("bevel", stone.bevel));
  const MassProperties<Number> properties = properties_of(stone, options, subject.assumed_density);
  if (options.density) {
    static_cast<void>(in_drop("density", properties.density));
  }
  const Moments<double> moments{
      .axial = to_double("axial moment", properties.moments.axial, "a drop", 5 * drop_order),
      .transverse = to_double("transverse moment", properties.moments.transverse, "a drop", 5 * drop_order)};
  return {.title = described(subject),
          .density_assumed = assumes_density(options),
          .stone = stone_cast<double>(stone),
          .body = make_rigid_body(in_drop("mass", properties.mass), moments)};
}

DropScene scene_of(const DropOptions& options) {
  const On on = parse_on(options.on);
  check_combination(options, on);
  DropScene scene;
  set_ground(scene, on, parse_standard(options.stone.standard));
  scene.solid = solid_stone(options.stone);
  scene.settings = drop_settings(options);
  scene.until = parse_until(options.until, scene.settings);
  require_settings(scene.settings, scene.solid.stone);
  scene.start = start_of(options, scene.solid.body);
  return scene;
}

}  // namespace goishi::cli
