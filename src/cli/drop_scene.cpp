#include "drop_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "quantity.hpp"

namespace goishi::cli {

namespace {

using Text = std::optional<std::string>;

double in_drop(const char* argument, const Number& value, std::string_view unit) {
  const Number size = abs(value);
  require(value == 0 || (Number(1 / largest_magnitude) <= size && size <= Number(largest_magnitude)), argument, value,
          "must be 0 or from 1e-20 to 1e20", unit.empty() ? "" : " ", unit, ", in magnitude");
  return value.convert_to<double>();
}

Vec3<double> in_drop(const char* argument, const Vec3<Number>& v, std::string_view unit) {
  return {in_drop(argument, v.x(), unit), in_drop(argument, v.y(), unit), in_drop(argument, v.z(), unit)};
}

void set_length(const char* argument, const Text& text, std::optional<double>& length) {
  if (text) {
    length = in_drop(argument, parse_length(argument, *text), "m");
  }
}

/// A number without a unit.
double ratio_or(const char* argument, const Text& text, double otherwise) {
  if (!text) {
    return otherwise;
  }
  std::vector<Number> numbers;
  try {
    numbers = parse_list(argument, *text, 1);
  } catch (const InvalidArgument&) {
    throw InvalidArgument(argument, *text, "must be a decimal number");
  }
  return in_drop(argument, numbers.front(), "");
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

/// 0 <= μ; "inf" lets nothing slip.
double parse_friction(const Text& text, double otherwise) {
  return text == "inf" ? std::numeric_limits<double>::infinity() : ratio_or("friction", text, otherwise);
}

Vec3<double> parse_gravity(const Text& text) {
  if (!text) {
    return gravity_W<double>();
  }
  const bool vector = text->find(',') != std::string::npos;
  std::vector<Number> g;
  try {
    g = parse_list("gravity", *text, vector ? 3 : 1);
  } catch (const InvalidArgument&) {
    throw InvalidArgument("gravity", *text, "must be a decimal number, downwards, or x,y,z, in m/s²");
  }
  return vector ? in_drop("gravity", Vec3<Number>(g[0], g[1], g[2]), "m/s²")
                : gravity_W(in_drop("gravity", g.front(), "m/s²"));
}

/// Sets when the drop ends; says it for people.
std::string parse_until(const Text& text, DropSettings<double>& settings) {
  settings.horizon = longest_drop;
  if (!text || *text == "rest") {
    return fmt::format("rest, at most {} s", longest_drop);
  }
  const std::size_t mark = text->find("-impact");
  if (mark != std::string::npos) {
    const char* end = text->data() + mark;
    const std::string_view unit = std::string_view(*text).substr(mark);
    int count = 0;
    const auto result = std::from_chars(text->data(), end, count);
    if (result.ec == std::errc() && result.ptr == end && 0 < count && (unit == "-impacts" || *text == "1-impact")) {
      settings.maximum_impacts = count;
      return fmt::format("{} impact{}, at most {} s", count, count == 1 ? "" : "s", longest_drop);
    }
  } else if (text->find_first_of("0123456789") < std::min<std::size_t>(text->size(), 3)) {
    const Number time = parse_time("until", *text);
    require_positive("until", time);
    settings.horizon = in_drop("until", time, "s");
    return fmt::format("{:.6g} s", *settings.horizon);
  }
  throw InvalidArgument("until", *text, "must be rest, a time such as 500ms, or a count such as 5-impacts");
}

/// The tilt, in degrees, about an axis in the surface or any other.
Quat<double> parse_attitude_of(const Text& tilt, const Text& tilt_axis) {
  const Number degrees = tilt ? parse_bare("tilt", *tilt, "degrees") : Number(0);
  require(abs(degrees) <= 360, "tilt", degrees, "must be from -360 to 360 degrees");
  Vec3<Number> axis(0, 1, 0);
  if (tilt_axis) {
    axis = parse_vector("tilt-axis", *tilt_axis);
    const Number size = axis.norm();
    if (!(0 < size)) {
      throw InvalidArgument("tilt-axis", *tilt_axis, "must not be zero");
    }
    axis /= size;
  }
  static const Number right_angle = 2 * atan(Number(1));
  const Number half = degrees / 180 * right_angle;
  // 90 and 180 degrees are typed for their exact cosines.
  const Number c = abs(degrees) == 180 ? Number(0) : Number(cos(half));
  const Vec3<Number> s = sin(half) * axis;
  return {c.convert_to<double>(), s.x().convert_to<double>(), s.y().convert_to<double>(), s.z().convert_to<double>()};
}

void check_combination(const DropOptions& options) {
  const StoneOptions& stone = options.stone;
  check_stone(stone);
  if (!stone.size && !stone.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  require_with("color", stone.color, "size", stone.size);
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

DropSettings<double> settings_of(const DropOptions& options, const Stone<double>& stone, std::string& until) {
  DropSettings<double> settings;
  settings.restitution = ratio_or("restitution", options.restitution, settings.restitution);
  settings.friction = parse_friction(options.friction, settings.friction);
  settings.gravity = parse_gravity(options.gravity);
  set_length("rolling-resistance", options.rolling_resistance, settings.rolling_resistance);
  set_length("pivot-radius", options.pivot_radius, settings.pivot_radius);
  settings.friction_model = parse_friction_model(options.friction_model);
  if (options.slip_coefficient) {
    settings.slip_coefficient =
        in_drop("slip-coefficient", parse_bare("slip-coefficient", *options.slip_coefficient, "s/m"), "s/m");
  }
  set_length("patch-radius", options.patch_radius, settings.patch_radius);
  settings.law = parse_law(options.law);
  settings.tolerance = ratio_or("tolerance", options.tolerance, settings.tolerance);
  until = parse_until(options.until, settings);
  try {
    require_settings(settings, stone);
  } catch (const InvalidArgument& error) {
    // The user knows them with hyphens.
    std::string argument = error.argument();
    std::ranges::replace(argument, '_', '-');
    throw InvalidArgument(argument, error.value(), error.rule());
  }
  return settings;
}

State<double> start_of(const DropOptions& options, const RigidBody<double>& body) {
  const Vec3<double> nothing(0.0, 0.0, 0.0);
  Vec3<Number> p_WB(0, 0, parse_length("from", *options.from));
  if (options.position) {
    const std::vector<Number> place = parse_list("position", *options.position, 2);
    p_WB.head<2>() << place[0], place[1];
  }
  static_cast<void>(in_drop("from", p_WB.z(), "m"));
  const Quat<double> q_WB = parse_attitude_of(options.tilt, options.tilt_axis);
  const Vec3<double> w_WB_B = options.spin ? in_drop("spin", parse_vector("spin", *options.spin), "rad/s") : nothing;
  return {.p_WB = in_drop("position", p_WB, "m"),
          .q_WB = q_WB,
          .v_WB = options.velocity ? in_drop("velocity", parse_vector("velocity", *options.velocity), "m/s") : nothing,
          .L_W = formula::angular_momentum_W(q_WB, body, w_WB_B)};
}

}  // namespace

std::string name_of(ImpactLaw law) {
  std::string name(to_string(law));
  std::ranges::replace(name, '_', '-');
  return name;
}

DropScene scene_of(const DropOptions& options) {
  check_combination(options);
  enum class On { board, plane };
  constexpr On grounds[] = {On::board, On::plane};
  DropScene scene;
  if (named("on", options.on, grounds, [](On on) { return on == On::board ? "board" : "plane"; }) == On::board) {
    scene.board = make_board<double>();
  }
  const Subject subject = subject_of(options.stone);
  scene.title =
      subject.title + (subject.bevel == 0 ? ", sharp" : fmt::format(", bevel {} m", six_digits(subject.bevel)));
  const Stone<Number> stone = stone_of(subject);
  static_cast<void>(in_drop("width", stone.width, "m"));
  static_cast<void>(in_drop("height", stone.height, "m"));
  scene.stone = stone_cast<double>(stone);
  scene.settings = settings_of(options, scene.stone, scene.until);
  const MassProperties<Number> properties = properties_of(stone, options.stone, subject.assumed_density);
  const Moments<double> moments{.axial = to_double("axial moment", properties.moments.axial, "a drop"),
                                .transverse = to_double("transverse moment", properties.moments.transverse, "a drop")};
  scene.body = make_rigid_body(in_drop("mass", properties.mass, "kg"), moments);
  scene.density_assumed = assumes_density(options.stone);
  scene.start = start_of(options, scene.body);
  return scene;
}

}  // namespace goishi::cli
