#include "drop_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "alignment.hpp"

namespace goishi::cli {

namespace {

/// A column of numbers, in the unit that people read.
struct Column {
  std::string_view name;
  double (*value)(const Sample&);
  double scale;
  int digits;  // significant, of the greatest
  int most;    // decimals, at most
};

constexpr std::array<Column, 6> columns = {{
    {"time [s]", [](const Sample& s) { return s.time; }, 1, 7, 9},
    {"height [mm]", [](const Sample& s) { return s.state.p_WB.z(); }, 1e3, 6, 9},
    {"tilt [°]", [](const Sample& s) { return s.tilt; }, 1, 6, 3},
    {"speed [m/s]", [](const Sample& s) { return s.state.v_WB.norm(); }, 1, 5, 5},
    {"spin [rad/s]", [](const Sample& s) { return s.w_WB_B.norm(); }, 1, 5, 3},
    {"energy [µJ]", [](const Sample& s) { return s.energy; }, 1e6, 6, 9},
}};

double value_of(const Column& column, const Sample& sample) {
  return column.scale * column.value(sample);
}

/// As many decimals for the whole column as show its greatest number with the digits asked for.
int decimals_of(const Column& column, const std::vector<Sample>& samples) {
  double greatest = 0;
  for (const Sample& sample : samples) {
    greatest = std::max(greatest, std::abs(value_of(column, sample)));
  }
  const int order = 0 < greatest ? static_cast<int>(std::floor(std::log10(greatest))) : 0;
  return std::clamp(column.digits - 1 - order, 0, column.most);
}

/// Without the sign of what is rounded to zero; what is too long for that, in six digits.
std::string fixed(double value, int decimals) {
  const double long_number = 1e9;
  if (long_number <= std::abs(value)) {
    return fmt::format("{:.5e}", value);
  }
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos && text.starts_with('-') ? text.substr(1) : text;
}

/// "lower cap on the board's top edge"
std::string touch_of(const DropScene& scene, const Event<double>& event) {
  const Touched touched = touched_at(scene, event);
  if (touched == Touched::nothing) {
    return "";
  }
  const bool surface = event.other_feature == OtherFeature::surface;
  return fmt::format("{} on {}{}", to_string(event.feature), to_string(touched),
                     surface ? "" : fmt::format("'s {}", to_string(event.other_feature)));
}

std::string friction_of(const DropSettings<double>& settings) {
  switch (settings.friction_model) {
    case FrictionModel::slip_proportional:
      return fmt::format("friction of impacts {:.6g}, of contacts slip-proportional, {:.6g} s/m", settings.friction,
                         *settings.slip_coefficient);
    case FrictionModel::coulomb_contensou:
      return fmt::format("coulomb-contensou friction {:.6g} on a patch of {:.6g} m", settings.friction,
                         *settings.patch_radius);
    case FrictionModel::dry:
      break;
  }
  return fmt::format("dry friction {:.6g}", settings.friction);
}

std::string header_of(const DropScene& scene) {
  const Vec3<double>& g = scene.settings.gravity;
  return fmt::format(
      "{}, dropped on the {}\n"
      "mass {:.6g} kg{}, gravity {} m/s²\n"
      "{}; tolerance {:.6g}; until {}\n\n",
      scene.solid.title, scene.ground, scene.solid.body.mass, scene.solid.density_assumed ? " (density assumed)" : "",
      text_of_gravity(g), text_of_laws(scene.settings, scene.solid.stone), scene.settings.tolerance, scene.until);
}

/// What was computed, but for what was not.
std::string cost_of(const DropCounters& counters) {
  return text_of_counts({{counters.impacts, "impact"},
                         {counters.root_steps, "root step"},
                         {counters.separations, "separation"},
                         {counters.contact_evaluations, "contact evaluation"},
                         {counters.steps_accepted, "step"},
                         {counters.steps_rejected, "rejected step"},
                         {counters.evaluations_located, "located evaluation"},
                         {counters.edge_impacts, "micro-impact"}});
}

}  // namespace

std::string text_of_gravity(const Vec3<double>& g) {
  return g.x() == 0 && g.y() == 0 && g.z() <= 0 ? fmt::format("{:.6g}", g.z() == 0 ? 0 : -g.z())
                                                : fmt::format("({:.6g}, {:.6g}, {:.6g})", g.x(), g.y(), g.z());
}

std::string text_of_laws(const DropSettings<double>& settings, const Stone<double>& stone) {
  const double g = settings.gravity.norm();
  // Without gravity the lengths, which are all that is shown of what is filled in, are the same.
  const DropSettings<double> s = filled(settings, stone, 0 < g ? g : 1);
  return fmt::format(
      "restitution {:.6g} ({}), {}\n"
      "rolling resistance {:.6g} m, pivot radius {:.6g} m",
      s.restitution, name_of(s.law), friction_of(s), *s.rolling_resistance, *s.pivot_radius);
}

std::string text_of_counts(const std::vector<std::pair<long long, std::string_view>>& counts, std::string_view plural) {
  std::vector<std::string> parts;
  for (const auto& [count, name] : counts) {
    if (0 < count) {
      parts.push_back(fmt::format("{} {}{}", count, name, count == 1 ? "" : plural));
    }
  }
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string end_of(const DropScene& scene, const DropResult<double>& drop) {
  const std::string when = fmt::format("{:.6g} s", drop.time);
  switch (drop.status) {
    case DropStatus::rest:
      return touched_last(scene, drop) == Touched::nothing
                 ? fmt::format("at rest, touching nothing, after {}", when)
                 : fmt::format("at rest on the {} after {}", to_string(touched_last(scene, drop)), when);
    case DropStatus::rest_leaning:
      return fmt::format("at rest, leaning, after {}", when);
    case DropStatus::moving:
      return fmt::format("still moving after {}", when);
    case DropStatus::flies_on:
      return fmt::format("touches nothing any more after {}", when);
    case DropStatus::start_inside:
      return fmt::format("the start is {:.6g} m inside the {}", drop.depth,
                         !scene.board                ? "plane"
                         : drop.state.p_WB.z() < 0.0 ? "board or the floor"
                                                     : "board");
    case DropStatus::too_many_events:
    case DropStatus::too_many_steps:
    case DropStatus::not_converged:
      break;
  }
  return fmt::format("given up after {}: {}", when, to_string(drop.status));
}

std::string to_block(const DropScene& scene, const DropResult<double>& drop, const std::optional<Sample>& asked) {
  std::vector<Sample> samples;
  std::vector<std::pair<std::string, std::string>> names;
  const auto add_asked = [&] {
    samples.push_back(*asked);
    names.emplace_back("(asked for)", "");
  };
  bool is_asked = asked.has_value();
  for (const Event<double>& event : drop.events) {
    if (is_asked && asked->time < event.time) {
      add_asked();
      is_asked = false;
    }
    samples.push_back(sample_of(scene, event.time, event.after));
    names.emplace_back(to_string(event.kind), touch_of(scene, event));
  }
  if (is_asked) {
    add_asked();
  }
  std::array<int, columns.size()> decimals{};
  std::ranges::transform(columns, decimals.begin(), [&](const Column& column) { return decimals_of(column, samples); });
  std::vector<Line> lines = {{std::string(columns[0].name), "event", "what touches what"}};
  for (std::size_t i = 1; i < columns.size(); ++i) {
    lines[0].emplace_back(columns[i].name);
  }
  for (std::size_t row = 0; row < samples.size(); ++row) {
    Line& line = lines.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      line.push_back(fixed(value_of(columns[i], samples[row]), decimals[i]));
      if (i == 0) {
        line.insert(line.end(), {names[row].first, names[row].second});
      }
    }
  }
  align(lines, {Align::number, Align::left, Align::left, Align::number, Align::number, Align::number, Align::number,
                Align::number});
  std::string text = header_of(scene);
  for (const Line& line : lines) {
    text += as_row(line);
  }
  std::string end = end_of(scene, drop);
  end.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(end.front())));
  text += fmt::format("\n{}{}.\n", end, drop.lower_order ? "; contacts at an edge, by the scheme of lower order" : "");
  return text + fmt::format("Computed: {}.\n", cost_of(drop.counters));
}

}  // namespace goishi::cli
