#include "contact.hpp"

#include <fmt/format.h>

#include <goishi/error.hpp>
#include <goishi/mass/inertia.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/motion/state.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "alignment.hpp"
#include "catalogue.hpp"
#include "contact_answer.hpp"
#include "file.hpp"
#include "json.hpp"
#include "quantity.hpp"
#include "report.hpp"

namespace goishi::cli {

namespace {

Against parse_against(const std::optional<std::string>& text) {
  constexpr std::pair<std::string_view, Against> names[] = {
      {"board", Against::board}, {"plane", Against::plane}, {"stone", Against::stone}};
  if (!text) {
    return Against::board;
  }
  for (const auto& [name, against] : names) {
    if (*text == name) {
      return against;
    }
  }
  throw InvalidArgument("against", *text, "must be board, plane or stone");
}

void check_combination(const ContactOptions& options, Against against) {
  const StoneOptions& stone = options.stone;
  check_stone(stone);
  if (!stone.size && !stone.width) {
    throw std::runtime_error("a stone is needed: --size, or --width and --height");
  }
  check_catalogue(stone, against == Against::board);
  if (!options.position) {
    throw std::runtime_error("a position is needed: --position, such as --position 0,0,0.01");
  }
  const auto only_against = [](bool holds, const char* argument, const std::optional<std::string>& value,
                               const char* what) {
    if (value && !holds) {
      throw InvalidArgument(argument, *value, fmt::format("needs --against {}", what));
    }
  };
  only_against(against == Against::stone, "other-position", options.other_position, "stone");
  only_against(against == Against::stone, "other-attitude", options.other_attitude, "stone");
  only_against(against == Against::board, "lines", options.lines, "board");
  if (against == Against::stone && !options.other_position) {
    throw InvalidArgument("against", *options.against, "needs --other-position too");
  }
  require_with("velocity", options.velocity, "horizon", options.horizon);
  require_with("spin", options.spin, "horizon", options.horizon);
  require_with("gravity", options.gravity, "horizon", options.horizon);
  if (options.horizon && !options.velocity && !options.spin) {
    throw InvalidArgument("horizon", *options.horizon, "needs --velocity or --spin too");
  }
  if (options.format && *options.format != "text" && *options.format != "json") {
    throw InvalidArgument("format", *options.format, "must be text or json");
  }
}

Pose<Number> parse_pose(const char* position, const std::string& position_text, const char* attitude,
                        const std::optional<std::string>& attitude_text, std::vector<std::string>& notes) {
  return {.p_WB = parse_vector(position, position_text, measure::length),
          .q_WB = attitude_text ? parse_attitude(attitude, *attitude_text, notes) : Quat<Number>(1, 0, 0, 0)};
}

ContactQuestion question_of(const ContactOptions& options) {
  ContactQuestion question;
  question.against = parse_against(options.against);
  check_combination(options, question.against);
  question.subject = subject_of(options.stone);
  question.stone = stone_of(question.subject);
  question.pose = parse_pose("position", *options.position, "attitude", options.attitude, question.notes);
  question.standard = parse_standard(options.stone.standard);
  if (options.lines) {
    question.lines = parse_whole("lines", *options.lines, 1, std::numeric_limits<int>::max());
  }
  if (question.against == Against::stone) {
    question.other =
        parse_pose("other-position", *options.other_position, "other-attitude", options.other_attitude, question.notes);
  }
  if (options.horizon) {
    const Vec3<Number> nothing(0, 0, 0);
    question.v_WB = options.velocity ? parse_vector("velocity", *options.velocity, measure::velocity) : nothing;
    question.w_WB_B = options.spin ? parse_vector("spin", *options.spin, measure::spin) : nothing;
    const RigidBody<Number> body = make_rigid_body(mass_properties(question.stone, Density{Number(1)}));
    question.L_W = formula::angular_momentum_W(question.pose.q_WB, body, question.w_WB_B);
    question.transverse_moment = body.moments.x();
    question.gravity =
        options.gravity ? parse("gravity", *options.gravity, measure::acceleration) : standard_gravity<Number>();
    question.horizon = parse("horizon", *options.horizon, measure::time);
    require_positive("horizon", *question.horizon);
  }
  return question;
}

std::string to_json(const ContactAnswer& answer) {
  rapidjson::StringBuffer buffer;
  JsonWriter writer(buffer);
  writer.SetIndent(' ', 2);
  writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
  writer.StartObject();
  const auto write_vector = [&writer](std::string_view key, const Vec3<Number>& v) {
    write_key(writer, key);
    writer.StartArray();
    for (const Number& component : v) {
      write_number(writer, component);
    }
    writer.EndArray();
  };
  write_key(writer, "status");
  write_string(writer, to_string(answer.contact.status));
  write_key(writer, "gap");
  write_number(writer, answer.contact.gap);
  write_vector("normal", answer.contact.n_W);
  write_vector("point_on_stone", answer.contact.p_stone);
  write_vector("point_on_other", answer.contact.p_other);
  write_key(writer, "feature");
  write_string(writer, to_string(answer.contact.feature));
  write_key(writer, "region");
  if (answer.region) {
    write_string(writer, to_string(*answer.region));
  } else {
    writer.Null();
  }
  if (answer.impact) {
    write_key(writer, "time_of_impact");
    if (answer.impact->status == ImpactStatus::hit) {
      write_number(writer, Number(answer.impact->time));
    } else {
      writer.Null();
    }
    write_key(writer, "impact_status");
    write_string(writer, to_string(answer.impact->status));
  }
  writer.EndObject();
  return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

std::string title_of(const ContactQuestion& question) {
  const std::string stone = described(question.subject);
  switch (question.against) {
    case Against::board:
      return fmt::format("{}, against the board with {} {}{}", stone, question.lines,
                         question.lines == 1 ? "line" : "lines", named_unless_talk(question.standard));
    case Against::plane:
      return stone + ", against the plane z = 0";
    case Against::stone:
      break;
  }
  return stone + ", against another of its size";
}

std::string to_block(const ContactQuestion& question, const ContactAnswer& answer) {
  const Separation<Number>& contact = answer.contact;
  std::vector<Line> lines;
  const auto add = [&lines](std::string_view name, std::string_view symbol, std::string_view value,
                            std::string_view unit = "", std::string_view note = "") {
    lines.push_back({std::string(name), std::string(symbol), std::string(value), std::string(unit), std::string(note)});
  };
  const auto add_vector = [&add](std::string_view name, std::string_view letter, const Vec3<Number>& v,
                                 std::string_view unit) {
    constexpr std::string_view axes[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      add(i == 0 ? name : "", fmt::format("{}_{}", letter, axes[i]), six_digits(v[i]), unit);
    }
  };
  add("status", "", to_string(contact.status));
  add("gap", "", six_digits(contact.gap), "m", contact.certified ? "" : "(not certified: a lower bound)");
  add_vector("normal, out of the other", "n", contact.n_W, "");
  add_vector("point on the stone", "p", contact.p_stone, "m");
  add_vector("point on the other", "p", contact.p_other, "m");
  add("touching, of the stone", "", to_string(contact.feature));
  add("touching, of the other", "", to_string(contact.other_feature));
  if (answer.region) {
    add("region", "", to_string(*answer.region));
  }
  if (answer.impact) {
    add("impact", "", to_string(answer.impact->status));
    if (answer.impact->status == ImpactStatus::hit) {
      add("time of impact", "t", six_digits(Number(answer.impact->time)), "s");
    }
  }
  align(lines, {Align::left, Align::left, Align::number, Align::left, Align::left});
  std::string text = title_of(question) + "\n\n";
  for (const Line& line : lines) {
    text += as_row(line);
  }
  return text;
}

}  // namespace

int run_contact(const ContactOptions& options) {
  const ContactQuestion question = question_of(options);
  const ContactAnswer answer = answer_to(question);
  report_notes(question.notes);
  write_standard_output(options.format == "json" ? to_json(answer) : to_block(question, answer));
  if (answer.contact.status == SeparationStatus::not_converged) {
    report("error: the search for the normal did not converge; the gap printed is a lower bound");
    return 1;
  }
  if (answer.impact && answer.impact->status == ImpactStatus::not_converged) {
    report("error: the search for the time of impact did not converge");
    return 1;
  }
  return 0;
}

}  // namespace goishi::cli
