#include "verify/reference/bracket.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace goishi::verify::reference {

namespace {

using Number = OrderedBall;
using Vector = Vec3<Number>;

/// The number itself, without a radius.
Number exactly(const Digits100& x) {
  const Ball rounded = Ball::from_decimal(x.str(100, std::ios_base::scientific));
  Ball middle;
  arb_get_mid_arb(middle.get(), rounded.get());
  return Number(middle);
}
Number exactly(double x) {
  return Number(x);
}

/// A number next to it.
Digits100 near(const Number& x) {
  char* text = arb_get_str(x.ball().get(), 90, ARB_STR_NO_RADIUS);
  const Digits100 result(text);
  flint_free(text);
  return result;
}

/// A unit vector next to n, whose zeros it keeps.
template <class T>
Vector unit_along(const Vec3<T>& n) {
  const Vector v(exactly(n.x()), exactly(n.y()), exactly(n.z()));
  const Number length = scalar::sqrt(Number(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()));
  return {Number(v.x() / length), Number(v.y() / length), Number(v.z() / length)};
}

Number upper_end(const Number& x) {
  Ball end;
  arb_get_ubound_arf(arb_midref(end.get()), x.ball().get(), Ball::precision);
  return Number(end);
}

/// x ± radius.
Number widened(const Number& x, const Number& radius) {
  Ball result = x.ball();
  arb_add_error(result.get(), radius.ball().get());
  return Number(result);
}

Number hull(const Number& x, const Number& y) {
  Ball result;
  arb_union(result.get(), x.ball().get(), y.ball().get(), Ball::precision);
  return Number(result);
}

bool is_zero(const Number& x) {
  return arb_is_zero(x.ball().get()) != 0;
}

Number norm_of(const Vector& v) {
  return scalar::sqrt(Number(formula::dot(v, v)));
}

void require_proof(bool proved, const char* what) {
  if (!proved) {
    throw std::runtime_error(std::string("not proved: ") + what);
  }
}

/// The point of a placed stone's core that is met along the unit normal n from outside, which leads out of the stone.
Vector core_point(const detail::Placed<Number>& placed, const Vector& n) {
  const Vector x = detail::support_point(placed.stone, placed.u_W, detail::see<Number>(placed.u_W, n)).x_W;
  return formula::plus(formula::plus(placed.p_W, x), Number(-placed.stone.bevel_minor_radius), n);
}

/// The point of the board that is met along n from a point: where n has no part, straight below.
Vector board_point(const Board<Number>& board, const Vector& n, const Vector& from) {
  const auto side = [](const Number& half, const Number& part, const Number& place) {
    if (!is_zero(part)) {
      return part.ball().is_positive() ? half : Number(-half);
    }
    require_proof(place <= half && -half <= place, "a point over the board");
    return place;
  };
  require_proof(is_zero(n.z()) || n.z().ball().is_positive(), "a normal of the board");
  require_proof(!is_zero(n.z()) || from.z() <= Number(0), "a point beside the board");
  return {side(board.half_width, n.x(), from.x()), side(board.half_length, n.y(), from.y()),
          is_zero(n.z()) ? from.z() : Number(0)};
}

/// The difference of the two points that are met along n, and how far the bodies reach beyond them.
struct Meeting {
  Vector w;
  Number beyond;
};

Meeting met_along(const World<Number>& world, const Number& time, const Vector& n) {
  const Vector opposite = formula::scaled(Number(-1), n);
  const Vector first = core_point(world.first.at(time), opposite);
  if (world.against == Against::board) {
    return {formula::minus(first, board_point(world.board, n, first)), world.first.stone.bevel_minor_radius};
  }
  const Vector other = core_point(world.other.at(time), n);
  return {formula::minus(first, other), world.first.stone.bevel_minor_radius + world.other.stone.bevel_minor_radius};
}

EnclosedGap::Contact contact_along(const World<Number>& world, const Number& time, const Vector& n, const Number& gap) {
  const detail::Placed<Number> placed = world.first.at(time);
  const detail::SupportPoint<Number> support =
      detail::support_point(placed.stone, placed.u_W, detail::see<Number>(placed.u_W, n));
  const Vector p = formula::minus(placed.p_W, support.x_W);
  return {.n_W = n, .p_stone = p, .p_other = formula::plus(p, Number(-gap), n)};
}

/// Whether the gap along what `choose` gives for a moment's middle is positive from one moment to another.
template <class Choose>
bool stays_positive(const Choose& choose, const Number& from, const Number& to, int depth) {
  const Number middle = (from + to) / Number(2), half = upper_end((to - from) / Number(2));
  bool positive = true;
  try {
    // The choices in making it are about bounds that are not asked for here.
    const detail::GapAlong<Number> gap = every_outcome([&] { return choose(middle); }).front();
    for (const auto& now : every_outcome([&] { return gap(middle).gap; })) {
      for (const auto& rate : every_outcome([&] { return gap(widened(middle, half)).rate; })) {
        positive = positive && (now - abs(rate) * half).ball().is_positive();
      }
    }
  } catch (const std::runtime_error&) {  // too much is left open
    positive = false;
  }
  return positive || (0 < depth && stays_positive(choose, from, middle, depth - 1) &&
                      stays_positive(choose, middle, to, depth - 1));
}

bool stays_falling(const detail::GapAlong<Number>& gap, const Number& from, const Number& to) {
  const Number middle = (from + to) / Number(2), half = upper_end((to - from) / Number(2));
  bool falls = true;
  try {
    for (const auto& rate : every_outcome([&] { return gap(widened(middle, half)).rate; })) {
      falls = falls && rate.ball().is_negative();
    }
  } catch (const std::runtime_error&) {
    falls = false;
  }
  return falls;
}

/// By Newton's method, from what double found.
struct Found {
  Digits100 time;
  Vec3<Digits100> n;
};

Found refined(const World<Digits100>& world, double guess) {
  constexpr int steps = 9;  // 16 digits, doubled at each; two more
  Digits100 time(guess);
  Separation<Digits100> contact = world.separation_at(time);
  for (int i = 0; i < steps; ++i) {
    time = time - contact.gap / world.gap_along(contact.n_W)(time).rate;
    contact = world.separation_at(time);
  }
  return {time, contact.n_W};
}

constexpr int most_halvings = 40;

/// Of a second: what the time is enclosed to. The normal then is known to half as many digits.
const Number& time_radius() {
  static const Number radius = Number(Ball::from_decimal("1e-68"));
  return radius;
}

}  // namespace

EnclosedGap enclosed_gap(const Encounter& encounter, const Number& time) {
  const World<Number> world(encounter);
  if (world.against == Against::plane) {
    const Separation<Number> found =
        detail::separation_along(world.first.at(time), world.plane.n_W, world.plane.offset);
    return {.gap = found.gap, .contact = contact_along(world, time, world.plane.n_W, found.gap)};
  }
  const World<Digits100> searched(encounter);
  const Vector n = unit_along(searched.separation_at(near(time)).n_W);
  const Meeting met = met_along(world, time, n);
  const Number low = formula::dot(met.w, n), high = norm_of(met.w);
  const Number core = hull(low, high);
  EnclosedGap result{.gap = core - met.beyond, .contact = {}};
  // The cosine of the angle to the right normal is at least low/high.
  if (!low.ball().is_positive()) {
    return result;
  }
  const Number radius = upper_end(scalar::sqrt(Number(Number(2) * (high - low) / high)));
  if (!(radius < Number(Ball::from_decimal("1e-31")))) {
    return result;
  }
  result.contact =
      contact_along(world, time, {widened(n.x(), radius), widened(n.y(), radius), widened(n.z(), radius)}, result.gap);
  return result;
}

std::optional<Number> enclosed_touch(const Encounter& encounter) {
  const World<Number> world(encounter);
  const World<double> rounded(encounter);
  const auto choose = [&](const Number& moment) {
    const Vec3<double> n = rounded.against == Against::plane
                               ? Vec3<double>(encounter.normal[0], encounter.normal[1], encounter.normal[2])
                               : rounded.separation_at(static_cast<double>(moment)).n_W;
    require_proof(rounded.against != Against::board || 0.0 <= n.z(), "a normal of the board");
    return world.gap_along(unit_along(n));
  };
  const TimeOfImpact<double> guess = rounded.first_touch(encounter.horizon);
  if (guess.status == ImpactStatus::none) {
    require_proof(stays_positive(choose, Number(0), Number(encounter.horizon), most_halvings), "nothing is touched");
    return std::nullopt;
  }
  require_proof(guess.status == ImpactStatus::hit && 0.0 < guess.time, "a touch");
  const Found found = refined(World<Digits100>(encounter), guess.time);
  const Vector n = world.against == Against::plane ? world.plane.n_W : unit_along(found.n);
  const detail::GapAlong<Number> gap = world.gap_along(n);
  const Number time = exactly(found.time), before = time - time_radius(), after = time + time_radius();
  // It falls from here on, so that it has one zero at most.
  Number falls = Number(0), rest = time;
  for (int i = 0; i < most_halvings && !stays_falling(gap, falls, after); ++i) {
    rest = rest / Number(2);
    falls = time - rest;
  }
  require_proof(stays_falling(gap, falls, after), "it comes nearer");
  require_proof(is_zero(falls) || stays_positive(choose, Number(0), falls, most_halvings), "nothing is touched before");
  for (const auto& now : every_outcome([&] { return gap(before).gap; })) {
    require_proof(now.ball().is_positive(), "nothing is touched just before");
  }
  if (world.against == Against::plane) {
    for (const auto& now : every_outcome([&] { return gap(after).gap; })) {
      require_proof(now.ball().is_negative(), "the plane is touched just after");
    }
  } else {
    const Meeting met = met_along(world, after, n);
    require_proof(norm_of(met.w) < met.beyond, "they touch just after");
  }
  return widened(time, time_radius());
}

}  // namespace goishi::verify::reference
