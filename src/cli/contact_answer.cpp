#include "contact_answer.hpp"

#include <goishi/motion/invariants.hpp>
#include <string>

#include "quantity.hpp"

namespace goishi::cli {

namespace {

template <class T>
Board<T> board_of(const ContactQuestion& question) {
  return make_board(board_dimensions<T>(question.standard, question.lines));
}

Separation<Number> contact_of(const ContactQuestion& question) {
  const Stone<Number>& stone = question.stone;
  const Pose<Number>& pose = question.pose;
  switch (question.against) {
    case Against::board:
      return separation(stone, pose, board_of<Number>(question));
    case Against::plane:
      return separation(stone, pose, Plane<Number>{});
    case Against::stone:
      break;
  }
  return separation(stone, pose, stone, question.other);
}

/// What is only the round-off of numbers of this size becomes 0.
void settle(Number& value, const Number& size) {
  static const Number part{std::string(least_length)};
  if (abs(value) < part * size) {
    value = 0;
  }
}

Separation<Number> settled(Separation<Number> contact, const ContactQuestion& question) {
  Number size = outer_width(question.stone) + question.pose.p_WB.norm();
  if (question.against == Against::stone) {
    size += question.other.p_WB.norm();
  }
  settle(contact.gap, size);
  for (int i = 0; i < 3; ++i) {
    settle(contact.n_W[i], Number(1));
    settle(contact.p_stone[i], size);
    settle(contact.p_other[i], size);
  }
  if (contact.status == SeparationStatus::overlapping && contact.gap == 0) {
    contact.status = SeparationStatus::separated;
  }
  return contact;
}

double in_flight(const char* argument, const Number& value) {
  return to_double(argument, value, "the time of impact", flight_order);
}

Vec3<double> in_flight(const char* argument, const Vec3<Number>& v) {
  return {in_flight(argument, v.x()), in_flight(argument, v.y()), in_flight(argument, v.z())};
}

TimeOfImpact<double> impact_of(const ContactQuestion& question) {
  const Number momentum = question.L_W.norm();
  const Vec3<Number> still(0, 0, 1);
  const Vec3<Number> k_W = momentum == 0 ? still : Vec3<Number>(question.L_W / momentum);
  (void)in_flight("width", question.stone.width);
  (void)in_flight("height", question.stone.height);
  (void)in_flight("bevel", question.stone.bevel);
  (void)in_flight("spin", question.w_WB_B);
  const Stone<double> stone = stone_cast<double>(question.stone);
  const FlightPath<double> path{.p_W = in_flight("position", question.pose.p_WB),
                                .v_W = in_flight("velocity", question.v_WB),
                                .a_W = gravity_W(in_flight("gravity", question.gravity)),
                                .u_W = formula::symmetry_axis(question.pose.q_WB).cast<double>(),
                                .k_W = k_W.cast<double>(),
                                .rate = Number(momentum / question.transverse_moment).convert_to<double>()};
  const double horizon = in_flight("horizon", *question.horizon);
  switch (question.against) {
    case Against::board:
      return time_of_impact(stone, path, board_of<double>(question), horizon);
    case Against::plane:
      return time_of_impact(stone, path, Plane<double>{}, horizon);
    case Against::stone:
      break;
  }
  const Vec3<double> nothing(0.0, 0.0, 0.0);
  const FlightPath<double> other{.p_W = in_flight("other-position", question.other.p_WB),
                                 .v_W = nothing,
                                 .a_W = nothing,
                                 .u_W = formula::symmetry_axis(question.other.q_WB).cast<double>()};
  return time_of_impact(stone, path, stone, other, horizon);
}

}  // namespace

ContactAnswer answer_to(const ContactQuestion& question) {
  ContactAnswer answer{.contact = settled(contact_of(question), question), .region = {}, .impact = {}};
  if (question.against == Against::board) {
    answer.region = region_of(board_of<Number>(question), question.pose.p_WB, Number(outer_width(question.stone) / 2));
  }
  if (question.horizon) {
    answer.impact = impact_of(question);
  }
  return answer;
}

}  // namespace goishi::cli
