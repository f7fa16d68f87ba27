/// DOMAIN: boards of any size and any number of lines, their regions, and rays from anywhere. The witness is the definition
/// in 50 digits.

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <goishi/board/ray.hpp>
#include <set>
#include <string>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/domain.hpp"
#include "verify/suite/ulps.hpp"

namespace goishi::verify {

namespace {

using Digits3 = Vec3<Digits50>;

template <class T>
Digits50 most() {
  return Digits50(std::numeric_limits<T>::max());
}

int mode_of(int i) {
  return rounding_modes[static_cast<std::size_t>(i / 7) % rounding_modes.size()];
}

template <class T>
BoardDimensions<T> draw_dimensions(Context& context, int i) {
  constexpr std::array lines = {1, 2, 3, 9, 13, 19, INT_MAX - 1, INT_MAX};
  const double reach = size_reach<T>;
  const auto size = [&](bool may_vanish) {
    return may_vanish && context.uniform(0.0, 1.0) < 0.3 ? T(0) : any_size<T>(context.random(), reach);
  };
  BoardDimensions<T> d{.lines = lines[static_cast<std::size_t>(i) % lines.size()],
                       .spacing_x = size(false),
                       .spacing_y = size(false),
                       .border_x = size(true),
                       .border_y = size(true),
                       .thickness = size(false),
                       .legs = size(true)};
  if (i % 9 == 4) {
    d.spacing_x = d.spacing_y = std::numeric_limits<T>::denorm_min() * T(3);
  }
  const T huge = std::numeric_limits<T>::max() * static_cast<T>(context.uniform(0.1, 1.0));
  if (i % 40 == 7) {
    d.thickness = d.legs = huge;
  } else if (i % 40 == 17) {
    d.spacing_y = huge;
  } else if (i % 40 == 27) {
    d.border_x = huge;
  }
  return d;
}

template <class T>
std::string describe_board(const BoardDimensions<T>& d, int mode) {
  return fmt::format("{} lines of {:a} × {:a}, borders {:a}, {:a}, thickness {:a}, legs {:a}, mode {}", d.lines,
                     d.spacing_x, d.spacing_y, d.border_x, d.border_y, d.thickness, d.legs, mode);
}

/// As go players list them, a … s.
std::set<std::pair<int, int>> listed_stars(int lines) {
  const std::string list = lines == 19   ? "dd dj dp jd jj jp pd pj pp"
                           : lines == 13 ? "dd dj gg jd jj"
                           : lines == 9  ? "cc cg ee gc gg"
                                         : "";
  std::set<std::pair<int, int>> all;
  for (std::size_t k = 0; k < list.size(); k += 3) {
    all.emplace(list[k] - 'a', list[k + 1] - 'a');
  }
  if (list.empty() && lines % 2 == 1) {
    all.emplace(lines / 2, lines / 2);
  }
  return all;
}

/// The regions' names, put together.
std::string region_at(int x, int y) {
  const std::string across = x < 0 ? "left" : "right", along = y < 0 ? "bottom" : "top";
  return x == 0 && y == 0 ? "primary"
         : x == 0         ? along + " side"
         : y == 0         ? across + " side"
                          : along + "-" + across + " corner";
}

template <class T>
void see_regions(Context& context, Checks& checks, const Board<T>& board, int i) {
  const T reach = i % 5 == 0   ? T(0)
                  : i % 5 == 1 ? board.half_width
                               : any_size<T>(context.random(), i % 2 == 0 ? 1.0 : size_reach<T>) * board.half_width;
  const int mode = mode_of(i);
  const auto place = [&](const T& half, int kind) {
    const T sign = context.uniform(-1.0, 1.0) < 0.0 ? T(-1) : T(1);
    const std::array<T, 7> all = {T(0),
                                  half,
                                  half + reach,
                                  half - reach,
                                  half * static_cast<T>(context.uniform(0.0, 1.0)),
                                  half + reach * static_cast<T>(context.uniform(-1.1, 1.1)),
                                  any_size<T>(context.random(), size_reach<T>)};
    return T(sign * all[static_cast<std::size_t>(kind) % all.size()]);
  };
  const Vec3<T> p(place(board.half_width, i), place(board.half_length, i / 7),
                  i % 4 == 0 ? reach : place(reach, i / 3));
  const auto describe_it = [&] {
    return fmt::format("board {:a} × {:a}, p = ({:a}, {:a}, {:a}), reach {:a}, mode {}", board.half_width,
                       board.half_length, p.x(), p.y(), p.z(), reach, mode);
  };
  const T sum = p.x() + p.y() + p.z();
  const auto answer = answer_of(mode, [&] { return region_of(board, p, reach); });
  if (!std::isfinite(reach) || !std::isfinite(sum)) {
    see_choice(checks["refusals"], !(answer && mode == FE_TONEAREST), [&] { return "taken: " + describe_it(); });
    return;
  }
  bool close = false, beyond = p.z() > reach;
  const auto side = [&](const T& at, const T& half) {
    const Digits50 x = abs(Digits50(at)), h(half), r(reach);
    const Digits50 round_off = 2 * Digits50(epsilon_of<T>) * (h + r) + Digits50(std::numeric_limits<T>::denorm_min());
    close = close || abs(x - (h + r)) <= round_off || abs(x - (h - r)) <= round_off;
    beyond = beyond || x > h + r;
    return x > h - r ? (at < T(0) ? -1 : 1) : 0;
  };
  const int x = side(p.x(), board.half_width), y = side(p.y(), board.half_length);
  const std::string expected = beyond ? "out of reach" : region_at(x, y);
  see_choice(checks["regions"], answer && (close || to_string(*answer) == expected),
             [&] { return fmt::format("not {}: {}", expected, describe_it()); });
}

template <class T>
void see_boards(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const BoardDimensions<T> d = draw_dimensions<T>(context, i);
    const int mode = mode_of(i);
    const auto describe_it = [&] { return describe_board(d, mode); };
    const Digits50 width = Digits50(d.lines - 1) * Digits50(d.spacing_x),
                   length = Digits50(d.lines - 1) * Digits50(d.spacing_y);
    const Digits50 half_width = width / 2 + Digits50(d.border_x), half_length = length / 2 + Digits50(d.border_y);
    const Digits50 height = Digits50(d.thickness) + Digits50(d.legs);
    const auto board = answer_of(FE_TONEAREST, [&] { return make_board(d); });
    const auto rounded = answer_of(mode, [&] { return make_board(d); });
    const Digits50 greatest = std::max({width, length, half_width, half_length, height});
    const bool one_line = d.lines == 1 && (!(T(0) < d.border_x) || !(T(0) < d.border_y));
    if (!board || !rounded || one_line || !(half_width < most<T>()) || !(half_length < most<T>()) ||
        !(height < most<T>())) {
      see_choice(checks["refusals"], !board && (one_line || greatest > most<T>() * Digits50(0.999)),
                 [&] { return (board ? "taken: " : "refused: ") + describe_it(); });
      continue;
    }
    checks["sides"].see(ulps<T>(context.produced(rounded->half_width), half_width), describe_it);
    checks["sides"].see(ulps<T>(context.produced(rounded->half_length), half_length), describe_it);
    checks["sides"].see(ulps<T>(context.produced(rounded->floor), Digits50(-height)), describe_it);
    // The ends, the middle, any.
    const std::array<int, 4> places = {0, d.lines - 1, (d.lines - 1) / 2,
                                       static_cast<int>(context.uniform(0.0, 0.999) * d.lines)};
    const int k = places[static_cast<std::size_t>(i) % 4], m = places[static_cast<std::size_t>(i / 4) % 4];
    const auto at = answer_of(mode, [&] { return intersection(*board, k, m); });
    const auto see_place = [&](const T& computed, int line, const T& spacing) {
      const Digits50 exact = (Digits50(line) - Digits50(d.lines - 1) / 2) * Digits50(spacing);
      checks["intersections"].see(ulps<T>(context.produced(computed), exact),
                                  [&] { return fmt::format("line {}: {}", line, describe_it()); });
    };
    see_place(at ? at->x() : T(NAN), k, d.spacing_x);
    see_place(at ? at->y() : T(NAN), m, d.spacing_y);
    checks["intersections"].see(at && !(T(0) < at->z()) && !(at->z() < T(0)) ? 0.0 : NAN, describe_it);
    const auto no_line = answer_of(mode, [&] { return intersection(*board, k, i % 2 == 0 ? -1 : d.lines); });
    see_choice(checks["refusals"], !no_line, [&] { return "a line that is none: " + describe_it(); });
    const auto stars = star_points(*board);
    const bool right = std::set<std::pair<int, int>>(stars.begin(), stars.end()) == listed_stars(d.lines) &&
                       stars.size() == listed_stars(d.lines).size();
    see_choice(checks["star points"], right, describe_it);
    see_regions(context, checks, *board, i);
  }
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity();
  const Board<T> board = make_board<T>(), unset;
  const Vec3<T> here(T(0), T(0), T(0));
  const auto refused = [&](const char* name, const Board<T>& of, const Vec3<T>& p, const T& reach) {
    see_choice(checks["refusals"], !answer_of(FE_TONEAREST, [&] { return region_of(of, p, reach); }),
               [&] { return std::string("taken: ") + name; });
  };
  refused("no position", board, Vec3<T>(nan, T(0), T(0)), T(1));
  refused("no height", board, Vec3<T>(T(0), T(0), nan), T(1));
  refused("infinitely far", board, Vec3<T>(T(0), -infinite, T(0)), T(1));
  refused("no reach", board, here, nan);
  refused("a negative reach", board, here, T(-1));
  refused("no board", unset, here, T(1));
}

// --- rays

/// Of any size, and as oblong as it comes; one in eight nearly as great as T holds.
template <class T>
Board<T> draw_any_board(Context& context, int i) {
  const T size = i % 8 == 5   ? std::numeric_limits<T>::max() / T(16)
                 : i % 8 == 6 ? std::numeric_limits<T>::denorm_min() * T(1000)
                              : any_size<T>(context.random(), size_reach<T>);
  const auto part = [&] { return T(size * any_size<T>(context.random(), i % 3 == 0 && i % 8 != 5 ? 2.0 : 0.5)); };
  return make_board<T>({.lines = 2,
                        .spacing_x = size,
                        .spacing_y = size,
                        .border_x = part(),
                        .border_y = part(),
                        .thickness = std::max(part(), size / T(64)),
                        .legs = T(0)});
}

/// Where the line meets the six faces, exactly: entry > exit where it passes.
struct Slab {
  Digits50 entry, exit;
};

template <class T>
Slab exact_slab(const Digits3& low, const Digits3& high, const Vec3<T>& p, const Vec3<T>& u) {
  const Digits50 never = pow(Digits50(10), 1000);
  Slab slab{-never, never};
  for (int k = 0; k < 3; ++k) {
    const Digits50 at(p[k]), along(u[k]);
    if (along == 0) {
      if (at < low[k] || at > high[k]) {
        return {Digits50(1), Digits50(-1)};
      }
      continue;
    }
    const Digits50 one = (low[k] - at) / along, other = (high[k] - at) / along;
    slab.entry = std::max(slab.entry, std::min(one, other));
    slab.exit = std::min(slab.exit, std::max(one, other));
  }
  return slab;
}

template <class T>
Digits50 ulp_at(const Digits50& x) {
  return std::max(Digits50(abs(x) * Digits50(epsilon_of<T>)), Digits50(std::numeric_limits<T>::denorm_min()));
}

/// Whether an answer says what its entry and exit do: the first ahead, the face's normal, a place on the face.
template <class T>
bool is_consistent(const BoardRayHit<T>& hit, const Digits3& low, const Digits3& high) {
  if (hit.forward != !(hit.exit < T(0))) {
    return false;
  }
  if (!hit.forward) {
    return true;
  }
  const T t = hit.entry < T(0) ? hit.exit : hit.entry;
  const int face = static_cast<int>(hit.face), axis = face < 2 ? 2 : (face - 2) / 2;
  const bool upper = face == 0 || face == 3 || face == 5;
  const Vec3<T> n = T(upper ? 1 : -1) * Vec3<T>::Unit(axis);
  return hit.first <= t && t <= hit.first && hit.n_W == n &&
         Digits50(hit.p_W[axis]) == (upper ? high[axis] : low[axis]);
}

/// Where the ray goes in and out, and where it hits, in ulps.
template <class T, class Describe>
void see_hit(const Context& context, Checks& checks, const BoardRayHit<T>& hit, const Slab& slab, const Vec3<T>& p,
             const Vec3<T>& u, Describe&& describe) {
  const auto off = [&](const T& computed, const Digits50& exact, const Digits50& unit) {
    return static_cast<double>(Digits50(abs(Digits50(context.produced(computed)) - exact) / unit));
  };
  checks["ends"].see(off(hit.entry, slab.entry, ulp_at<T>(slab.entry)), describe);
  checks["ends"].see(off(hit.exit, slab.exit, ulp_at<T>(slab.exit)), describe);
  for (int k = 0; hit.forward && k < 3; ++k) {
    const Digits50 way = Digits50(hit.first) * Digits50(u[k]), from(p[k]);
    checks["hit point"].see(off(hit.p_W[k], Digits50(from + way), ulp_at<T>(Digits50(abs(from) + abs(way)))), describe);
  }
}

template <class T>
void see_board_rays(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const Board<T> board = draw_any_board<T>(context, i);
    const Vec3<T> size(board.half_width, board.half_length, board.thickness);
    const Vec3<T> u = draw_defective_direction<T>(context, i / 2);
    const auto part = [&](double lowest, double highest) {
      return i % 3 == 0 ? static_cast<T>(std::round(context.uniform(lowest, highest)))  // on a face, to the bit
                        : static_cast<T>(context.uniform(1.2 * lowest, 1.2 * highest));
    };
    const Vec3<T> near(size.x() * part(-1.0, 1.0), size.y() * part(-1.0, 1.0), size.z() * part(-1.0, 0.0));
    const T away = i % 5 == 0   ? T(0)
                   : i % 5 == 1 ? any_size<T>(context.random(), size_reach<T>)
                                : size.x() * any_size<T>(context.random(), 2.0);
    const Vec3<T> p = near - away * (i % 7 == 0 ? Vec3<T>(-u) : u);
    const int mode = mode_of(i);
    const auto describe_it = [&] {
      return fmt::format("board {:a} × {:a} × {:a}, p = ({:a}, {:a}, {:a}), u = ({:a}, {:a}, {:a}), mode {}", size.x(),
                         size.y(), size.z(), p.x(), p.y(), p.z(), u.x(), u.y(), u.z(), mode);
    };
    const auto answer = answer_of(mode, [&] { return cast_ray(board, p, u); });
    const Digits3 low(Digits50(-size.x()), Digits50(-size.y()), Digits50(-size.z())),
        high(Digits50(size.x()), Digits50(size.y()), Digits50(0));
    const T sum = p.x() + p.y() + p.z();
    const Slab slab = exact_slab<T>(low, high, p, u);
    const Digits50 farthest = std::max(abs(slab.entry), abs(slab.exit));
    const bool meets = slab.entry <= slab.exit;
    const auto choose = [&](const char* check, bool right, const char* what) {
      see_choice(checks[check], right, [&] { return what + describe_it(); });
    };
    if (!std::isfinite(sum) || farthest > most<T>() * Digits50(0.999)) {
      const bool wrong = answer && answer->hit && mode == FE_TONEAREST && (!std::isfinite(sum) || farthest > most<T>());
      choose("refusals", !wrong, "taken: ");
    } else if (!answer) {
      choose("refusals", false, "refused: ");
    } else if (answer->hit != meets) {
      choose("choices", abs(slab.exit - slab.entry) <= 4 * ulp_at<T>(farthest), meets ? "passes: " : "meets: ");
    } else if (meets) {
      choose("choices", is_consistent(*answer, low, high), "it says what is not so: ");
      see_hit(context, checks, *answer, slab, p, u, describe_it);
    } else {
      choose("choices", true, "");
    }
  }
  const Vec3<T> above(T(0), T(0), T(1)), down(T(0), T(0), T(-1));
  see_choice(checks["refusals"], !answer_of(FE_TONEAREST, [&] { return cast_ray(Board<T>{}, above, down); }),
             [] { return "taken: no board"; });
  const T huge = std::numeric_limits<T>::max() * T(0.9);
  const Board<T> wide = make_board<T>({.lines = 1, .border_x = huge});
  const auto across = [&] { return cast_ray(wide, Vec3<T>(-huge, T(0), T(0)), Vec3<T>(T(1), T(0), T(0))); };
  see_choice(checks["refusals"], !answer_of(FE_TONEAREST, across), [] { return "taken: an exit that overflows"; });
}

}  // namespace

std::vector<Claim> domain_board_claims() {
  return {
      {.id = "DOMAIN-9",
       .statement =
           "Boards of any size with 1 to 2³¹ − 1 lines, in each rounding mode: sides, floor and intersections are "
           "right, star points as listed, regions right but for round-off at their borders; what overflows or is "
           "no board, no place, no line is refused.",
       .function = "make_board, intersection, star_points, region_of",
       .family = OracleFamily::other_formula,
       .oracle = "the definitions in 50 digits; the star points as go players list them",
       .checks = {within("sides", 4.0, "ulp",
                         "a number of lines, a product and a sum, each rounded by less than one ulp", 0.5),
                  within("intersections", 4.0, "ulp",
                         "a number of lines and a product, each rounded by less than one ulp", 0.5),
                  none("regions", "regions that are not so"),
                  none("star points", "boards whose star points are not those listed"),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_both(see_boards<double>, see_boards<float>, 2000, 20'000)},
      {.id = "DOMAIN-10",
       .statement =
           "Rays at boards of any size, from any distance, along axes to the bit, with components next to nothing, "
           "with |u|² off by ± 60 ε, from faces, edges and corners, in each rounding mode: entry, exit and the hit "
           "are right, or refused where T cannot hold them.",
       .function = "cast_ray (board)",
       .family = OracleFamily::other_formula,
       .oracle = "entry and exit of the six faces in 50 digits",
       .checks = {within("ends", 4.0, "ulp",
                         "a difference and a quotient, each rounded by less than one ulp of what may be half as great",
                         1.0),
                  within("hit point", 4.0, "ulp of |p| + |t u|",
                         "a product and a sum, and the face's own coordinate, as far off as the ray's ends", 1.0),
                  none("choices", "rays that pass or meet by more than 4 ulp, and hits that are not so"),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_both(see_board_rays<double>, see_board_rays<float>, 3000, 30'000)},
  };
}

}  // namespace goishi::verify
