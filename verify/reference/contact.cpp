/// contact.json: gaps and times of impact: stone and plane, stone and board, two stones.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "verify/reference/bracket.hpp"
#include "verify/reference/encounters.hpp"
#include "verify/reference/sections.hpp"

namespace goishi::verify::reference {

namespace {

/// The lengths that are added and taken off where a gap is found.
double size_of(const Encounter& of) {
  const double first = of.first.shape.width + length_of(of.first.position);
  switch (of.against) {
    case Against::plane:
      return first + std::fabs(of.offset);
    case Against::board:
      return first + board_half_length;
    case Against::stone:
      break;
  }
  return first + of.other.shape.width + length_of(of.other.position);
}

double bevels_of(const Encounter& of) {
  const double first = stone_of<double>(of.first.shape).bevel_minor_radius;
  return of.against == Against::stone ? first + stone_of<double>(of.other.shape).bevel_minor_radius : first;
}

/// How far apart the cores are, and the radii of the spheres that face each other across the gap: round-off of a length turns
/// the normal by so much of that.
double lever_of(const Encounter& of, const Separation<double>& met, double time) {
  if (of.against == Against::plane) {
    return std::numeric_limits<double>::infinity();
  }
  const World<double> world(of);
  const auto radius = [&](const Flyer<double>& flyer) {
    const detail::SeenNormal<double> seen = detail::see<double>(flyer.at(time).u_W, met.n_W);
    return detail::meets_cap(flyer.stone, seen.direction) ? flyer.stone.core_sphere_radius : 0.0;
  };
  return std::fmax(met.gap, 0.0) + bevels_of(of) + radius(world.first) +
         (of.against == Against::stone ? radius(world.other) : 0.0);
}

template <class T>
void add_contact(Answers<T>& answers, double size, double lever, const Vec3<T>& n, const Vec3<T>& p_stone) {
  answers.push_back(answer("normal", n, scale_of(1.0 + size / lever)));
  answers.push_back(answer("point", p_stone, scale_of(size + size * size / lever)));
}

/// Whether a gap has a normal and points that a double tells: not where the cores all but touch.
bool has_contact(const Encounter& of, double gap) {
  return of.against == Against::plane || 1e-6 * size_of(of) < gap + bevels_of(of);
}

Answers<double> computed_gap(const Encounter& of) {
  const Separation<double> found = separation_of(of);
  Answers<double> answers = {answer("gap", found.gap)};
  if (has_contact(of, found.gap)) {
    add_contact(answers, 1.0, 1.0, found.n_W, found.p_stone);
    answers.push_back(answer("other_point", found.p_other, 1.0));
  }
  return answers;
}

Answers<OrderedBall> enclosed_gap_answers(const Encounter& of) {
  const EnclosedGap found = enclosed_gap(of, OrderedBall(0));
  const double size = size_of(of);
  Answers<OrderedBall> answers = {answer("gap", found.gap, scale_of(size))};
  if (has_contact(of, static_cast<double>(found.gap))) {
    const EnclosedGap::Contact& contact = found.contact.value();
    add_contact(answers, size, lever_of(of, separation_of(of), 0.0), contact.n_W, contact.p_stone);
    answers.push_back(answer("other_point", contact.p_other, answers.back().scale));
  }
  return answers;
}

/// How fast they come nearer at the touch.
double closing_speed(const Encounter& of, const TimeOfImpact<double>& hit) {
  return std::fabs(World<double>(of).gap_along(hit.contact.n_W)(hit.time).rate);
}

Answers<double> computed_touch(const Encounter& of) {
  const TimeOfImpact<double> hit = World<double>(of).first_touch(of.horizon);
  Answers<double> answers = {word<double>("status", to_string(hit.status))};
  if (hit.status == ImpactStatus::hit) {
    answers.push_back(answer("time", hit.time));
    add_contact(answers, 1.0, 1.0, hit.contact.n_W, hit.contact.p_stone);
  }
  return answers;
}

Answers<OrderedBall> enclosed_touch_answers(const Encounter& of) {
  const std::optional<OrderedBall> time = enclosed_touch(of);
  Answers<OrderedBall> answers = {
      word<OrderedBall>("status", to_string(time ? ImpactStatus::hit : ImpactStatus::none))};
  if (!time) {
    return answers;
  }
  const TimeOfImpact<double> hit = World<double>(of).first_touch(of.horizon);
  // How far the bodies go, and what round-off of that is as a time; then the speeds bring it back into lengths.
  const double t = static_cast<double>(*time), speed = closing_speed(of, hit);
  const auto way_of = [&](const Mover& mover) {
    return length_of(mover.velocity) * t + length_of(of.gravity) * t * t / 2.0;
  };
  const double turned = length_of(of.first.spin) * t * of.first.shape.width;
  const double size = size_of(of) + way_of(of.first) + (of.against == Against::stone ? way_of(of.other) : 0.0) + turned;
  answers.push_back(answer("time", *time, scale_of(std::fmax(t, size / speed))));
  const EnclosedGap::Contact contact = enclosed_gap(of, *time).contact.value();
  const double fastest =
      length_of(of.first.velocity) + length_of(of.gravity) * t + length_of(of.first.spin) * of.first.shape.width;
  // The time's own round-off moves what flies.
  add_contact(answers, size * (1.0 + fastest / speed), lever_of(of, hit.contact, hit.time), contact.n_W,
              contact.p_stone);
  return answers;
}

void add_mover_inputs(std::vector<Input>& inputs, const std::string& prefix, const Mover& mover, bool moves) {
  for (Input& shape : inputs_of(mover.shape)) {
    shape.name = prefix + shape.name;
    inputs.push_back(std::move(shape));
  }
  inputs.push_back(input(prefix + "position", mover.position));
  inputs.push_back(input(prefix + "attitude", mover.attitude));
  if (moves) {
    inputs.push_back(input(prefix + "velocity", mover.velocity));
    inputs.push_back(input(prefix + "spin", mover.spin));
  }
}

std::vector<Input> inputs_of(const Encounter& of, bool moves) {
  constexpr const char* names[] = {"plane", "board", "stone"};
  std::vector<Input> inputs = {input("against", std::string(names[static_cast<std::size_t>(of.against)]))};
  add_mover_inputs(inputs, "", of.first, moves);
  switch (of.against) {
    case Against::plane:
      inputs.push_back(input("plane_normal", of.normal));
      inputs.push_back(input("plane_offset", of.offset));
      break;
    case Against::board:
      inputs.push_back(input("half_width", board_half_width));
      inputs.push_back(input("half_length", board_half_length));
      break;
    case Against::stone:
      add_mover_inputs(inputs, "other_", of.other, moves);
      break;
  }
  if (moves) {
    inputs.push_back(input("gravity", of.gravity));
    inputs.push_back(input("horizon", of.horizon));
  }
  return inputs;
}

}  // namespace

Section contact_section() {
  Section section{
      .name = "contact",
      .about = "Gaps, and when stones that fly freely first touch: a plane, the board, another stone",
      .inputs = shape_inputs(),
      .quantities =
          {{.name = "gap",
            .unit = "m",
            .proof = Proof::bracket,
            .about = "greatest separation over all normals; negative: minus the depth"},
           {.name = "normal",
            .unit = "",
            .components = 3,
            .proof = Proof::bracket,
            .about = "unit, out of the other body towards the stone, at the gap or at the touch"},
           {.name = "point",
            .unit = "m",
            .components = 3,
            .proof = Proof::bracket,
            .about = "on the stone, in the world"},
           {.name = "other_point", .unit = "m", .components = 3, .proof = Proof::bracket, .about = "on the other body"},
           {.name = "status",
            .unit = "",
            .components = 1,
            .proof = Proof::word,
            .about = "hit, or none until the horizon"},
           {.name = "time", .unit = "s", .proof = Proof::root, .about = "of the first touch"}},
      .problems = {}};
  section.inputs.push_back({"position", "m", "of the centre, in the world; at the start where it flies"});
  section.inputs.push_back({"attitude", "", "w, x, y, z of a quaternion of any length: normalise it; body to world"});
  section.inputs.push_back({"velocity", "m/s", "of the centre at the start; cases without it ask for a gap"});
  section.inputs.push_back({"spin", "rad/s", "angular velocity at the start, in the body's axes; density is uniform"});
  const std::vector<InputKind> first = section.inputs;
  for (const InputKind& kind : first) {
    section.inputs.push_back({"other_" + kind.name, kind.unit, "the same of the other stone"});
  }
  section.inputs.push_back({"against", "", "plane, board or stone"});
  section.inputs.push_back(
      {"plane_normal", "", "of any length: normalise it; the solid is where normal . x <= offset"});
  section.inputs.push_back({"plane_offset", "m", ""});
  section.inputs.push_back(
      {"half_width", "m", "the board is |x| <= half_width, |y| <= half_length, z <= 0, infinitely deep"});
  section.inputs.push_back({"half_length", "m", ""});
  section.inputs.push_back({"gravity", "m/s^2", "of all that flies"});
  section.inputs.push_back({"horizon", "s", "until when a touch is asked for"});
  const auto add = [&](const Encounter& of, bool moves, Answers<OrderedBall> (*enclose)(const Encounter&),
                       Answers<double> (*compute)(const Encounter&)) {
    section.problems.push_back({.id = numbered("contact", section.problems.size() + 1),
                                .about = of.about,
                                .inputs = inputs_of(of, moves),
                                .enclose = [=] { return common(every_outcome([&] { return enclose(of); })); },
                                .compute = [=] { return compute(of); }});
  };
  for (const Encounter& of : gap_encounters()) {
    add(of, false, enclosed_gap_answers, computed_gap);
  }
  for (const Encounter& of : touch_encounters()) {
    add(of, true, enclosed_touch_answers, computed_touch);
  }
  return section;
}

}  // namespace goishi::verify::reference
