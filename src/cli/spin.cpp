#include "spin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/error.hpp>
#include <stdexcept>
#include <vector>

#include "alignment.hpp"
#include "file.hpp"
#include "json.hpp"
#include "quantity.hpp"
#include "report.hpp"
#include "spin_motion.hpp"

namespace goishi::cli {

namespace {

/// What turns, and what is said about it.
struct Body {
  std::string title;
  Moments<Number> moments;
  bool density_assumed = false;
};

void check_combination(const SpinOptions& options) {
  const StoneOptions& stone = options.stone;
  refuse_together("axial", options.axial, "size", stone.size);
  refuse_together("transverse", options.transverse, "size", stone.size);
  require_with("axial", options.axial, "transverse", options.transverse);
  require_with("transverse", options.transverse, "axial", options.axial);
  if (!stone.size && !options.axial) {
    throw std::runtime_error("a body is needed: --size, or --axial and --transverse");
  }
  check_catalogue(stone);
  require_with("bevel", stone.bevel, "size", stone.size);
  require_with("mass", stone.mass, "size", stone.size);
  require_with("density", stone.density, "size", stone.size);
  check_stone(stone);
  if (!options.spin) {
    throw std::runtime_error("a spin is needed: --spin, such as --spin 0,5,60");
  }
  if (!options.time) {
    throw std::runtime_error("a time is needed: --time, such as --time 2.5");
  }
  if (options.format && *options.format != "text" && *options.format != "json") {
    throw InvalidArgument("format", *options.format, "must be text or json");
  }
  refuse_together("format", options.format, "series", options.series);
}

Body body_of(const SpinOptions& options) {
  if (options.axial) {
    const Moments<Number> moments{.axial = parse("axial", *options.axial, measure::moment),
                                  .transverse = parse("transverse", *options.transverse, measure::moment)};
    require_physical(moments);
    return {.title = "A body with the given moments", .moments = moments};
  }
  const Subject subject = subject_of(options.stone);
  const Stone<Number> stone = stone_of(subject);
  return {.title = described(subject),
          .moments = properties_of(stone, options.stone, subject.assumed_density).moments,
          .density_assumed = assumes_density(options.stone)};
}

SpinStart start_of(const SpinOptions& options, const Body& body, std::vector<std::string>& notes) {
  return {.moments = body.moments,
          .q_WB = options.attitude ? parse_attitude("attitude", *options.attitude, notes) : Quat<Number>(1, 0, 0, 0),
          .w_WB_B = parse_vector("spin", *options.spin, measure::spin)};
}

Scheme parse_method(const std::string& text) {
  const std::optional<Scheme> scheme = scheme_named(text);
  if (!scheme) {
    std::vector<std::string_view> names;
    std::ranges::transform(schemes, std::back_inserter(names), &SchemeInfo::name);
    throw InvalidArgument("method", text, fmt::format("must be one of {}", fmt::join(names, " ")));
  }
  return *scheme;
}

/// The times that are printed.
std::vector<Number> times_of(const SpinOptions& options) {
  const Number end = parse("time", *options.time, measure::time);
  if (!options.series) {
    return {end};
  }
  const int rows = parse_whole("series", *options.series, 2, most_rows);
  std::vector<Number> times;
  times.reserve(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    times.emplace_back(end * row / (rows - 1));
  }
  return times;
}

SpinMotion motion_of(const SpinOptions& options, const Body& body, Scheme scheme, std::vector<std::string>& notes) {
  const SpinStart start = start_of(options, body, notes);
  const std::vector<Number> times = times_of(options);
  if (scheme == Scheme::exact) {
    if (options.step) {
      throw InvalidArgument("step", *options.step, "needs a --method that takes steps; 'exact' takes none");
    }
    return turn_exactly(start, times);
  }
  if (!options.step) {
    throw InvalidArgument("method", options.method, "needs --step too");
  }
  return turn_in_steps(start, times, scheme, parse("step", *options.step, measure::time));
}

std::string to_csv(const SpinMotion& motion) {
  std::string text = "time_s";
  for (const SpinQuantity& quantity : spin_quantities) {
    text += fmt::format(",{}", quantity.key);
    for (const std::string_view part : {quantity.component, quantity.unit_key}) {
      text += part.empty() ? "" : fmt::format("_{}", part);
    }
  }
  for (const SpinSample& sample : motion.samples) {
    text += "\n" + seventeen_digits(sample.time);
    for (const Number& value : sample.values) {
      text += "," + seventeen_digits(value);
    }
  }
  return text + "\n";
}

std::string to_json(const SpinMotion& motion) {
  rapidjson::StringBuffer buffer;
  JsonWriter writer(buffer);
  writer.SetIndent(' ', 2);
  writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
  writer.StartObject();
  const SpinSample& last = motion.samples.back();
  std::string_view key;
  bool in_array = false;
  const auto end_array = [&] {
    if (in_array) {
      writer.EndArray();
    }
  };
  for (std::size_t i = 0; i < spin_quantities.size(); ++i) {
    if (key != spin_quantities[i].key) {
      end_array();
      key = spin_quantities[i].key;
      write_key(writer, key);
      in_array = !spin_quantities[i].component.empty();
      if (in_array) {
        writer.StartArray();
      }
    }
    write_number(writer, last.values[i]);
  }
  end_array();
  if (motion.status != StepStatus::completed) {
    write_key(writer, "status");
    write_string(writer, to_string(motion.status));
    write_key(writer, "time");
    write_number(writer, last.time);
  }
  writer.EndObject();
  return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

std::string to_block(const SpinMotion& motion, const Body& body, Scheme scheme) {
  std::vector<Line> lines;
  const auto add = [&lines](std::string_view name, std::string_view symbol, const Number& value, std::string_view unit,
                            bool assumed = false) {
    lines.push_back({std::string(name), std::string(symbol), six_digits(value), std::string(unit),
                     assumed ? "(density assumed)" : ""});
  };
  const SpinSample& last = motion.samples.back();
  add("axial moment", "I_a", body.moments.axial, "kg m²", body.density_assumed);
  add("transverse moment", "I_t", body.moments.transverse, "kg m²", body.density_assumed);
  if (scheme != Scheme::exact) {
    add("step", "", motion.step, "s");
  }
  add("time", "t", last.time, "s");
  for (std::size_t i = 0; i < spin_quantities.size(); ++i) {
    const SpinQuantity& quantity = spin_quantities[i];
    add(quantity.name, quantity.symbol, last.values[i], quantity.unit);
  }
  if (motion.status != StepStatus::completed) {
    lines.push_back({"status", "", std::string(to_string(motion.status)), "", ""});
  }
  align(lines, {Align::left, Align::left, Align::number, Align::left, Align::left});
  std::string text =
      fmt::format("{}, turning freely\nMethod {}: {}.\n\n", body.title, info(scheme).name, info(scheme).what);
  for (const Line& line : lines) {
    text += as_row(line);
  }
  return text;
}

}  // namespace

int run_spin(const SpinOptions& options) {
  check_combination(options);
  const Scheme scheme = parse_method(options.method);
  const Body body = body_of(options);
  std::vector<std::string> notes;
  const SpinMotion motion = motion_of(options, body, scheme, notes);
  report_notes(notes);
  if (options.series) {
    write_standard_output(to_csv(motion));
  } else {
    write_standard_output(options.format == "json" ? to_json(motion) : to_block(motion, body, scheme));
  }
  if (motion.status == StepStatus::completed) {
    return 0;
  }
  report(fmt::format(
      "error: step = {}: is too long for --method {}, which {} after {} s; the last good state is printed",
      *options.step, options.method, motion.status == StepStatus::diverged ? "diverged" : "did not converge",
      six_digits(motion.samples.back().time)));
  return 1;
}

}  // namespace goishi::cli
