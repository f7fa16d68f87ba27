/// DOMAIN: the gaps of many stones of any sizes, side by side in a register, to a plane. The witness is the definition in
/// 50 digits: the height of the centre less the support.

#include <fmt/format.h>

#include <algorithm>
#include <goishi/contact/batch_plane.hpp>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/samples/domain.hpp"

namespace goishi::verify {

namespace {

using Digits3 = Vec3<Digits50>;

template <class T>
struct Row {
  std::vector<Stone<T>> stones;
  std::vector<Pose<T>> poses;
  Plane<T> plane;
};

/// Lying flat, standing, as the plane's normal or any; at the origin, touching or far. Up to three registers of them.
template <class T>
Row<T> draw_row(Context& context, int i) {
  Row<T> row;
  row.plane = {draw_defective_direction<T>(context, i),
               i % 3 == 0 ? T(0) : any_size<T>(context.random(), size_reach<T>) * (i % 2 == 0 ? T(1) : T(-1))};
  const std::size_t count = static_cast<std::size_t>(i) % (3 * PlaneBatch<T>::lanes + 1);
  for (int k = 0; row.stones.size() < count; ++k) {
    const ShapeSample<T> shape = draw_any_shape<T>(context, i + k);
    const auto stone = answer_of(FE_TONEAREST, [&] { return make_stone(shape.width, shape.height, shape.bevel); });
    if (!stone) {
      continue;
    }
    const T away = any_size<T>(context.random(), size_reach<T>);
    const std::array<Vec3<T>, 4> places = {Vec3<T>(T(0), T(0), T(0)), Vec3<T>(row.plane.offset * row.plane.n_W),
                                           Vec3<T>(stone->width * row.plane.n_W), Vec3<T>(away, -away, T(0))};
    const std::size_t which = static_cast<std::size_t>(context.uniform(0.0, 3.999));
    row.stones.push_back(*stone);
    row.poses.push_back({.p_WB = places[which], .q_WB = draw_defective<T>(context, i + 3 * k)});
  }
  return row;
}

template <class T>
void see_rows(Context& context, Checks& checks, int count) {
  for (int i = 0; i < count; ++i) {
    const Row<T> row = draw_row<T>(context, i);
    const std::size_t size = row.stones.size();
    const int mode = rounding_modes[static_cast<std::size_t>(i / 5) % rounding_modes.size()];
    const auto gaps = answer_of(mode, [&] {
      PlaneBatch<T> batch(size);
      for (std::size_t k = 0; k < size; ++k) {
        batch.set(k, row.stones[k], row.poses[k]);
      }
      std::vector<T> result(size);
      batch.gaps(row.plane, result);
      return result;
    });
    const Digits3 n = row.plane.n_W.template cast<Digits50>();
    const double defect = std::fabs(static_cast<double>(Digits50(n.squaredNorm() - 1))) / epsilon_of<T>;
    for (std::size_t k = 0; k < size; ++k) {
      const Stone<Digits50> stone = stone_cast<Digits50>(row.stones[k]);
      const Digits3 p = row.poses[k].p_WB.template cast<Digits50>(), unit = n.normalized();
      const auto q = row.poses[k].q_WB.template cast<Digits50>().normalized();
      const Digits50 exact =
          unit.dot(p) - Digits50(row.plane.offset) - support(stone, Digits3((q.conjugate() * unit).normalized())).value;
      const Digits50 scale = p.cwiseAbs().sum() + abs(Digits50(row.plane.offset)) + stone.width;
      const T gap = gaps ? (*gaps)[k] : std::numeric_limits<T>::quiet_NaN();
      const double off = std::isfinite(gap)
                             ? static_cast<double>(Digits50(abs(Digits50(context.produced(gap)) - exact) / scale))
                             : NAN;
      checks["gaps"].see(off, epsilon_of<T> * (1.0 + defect), [&] {
        const Pose<T>& at = row.poses[k];
        return fmt::format(
            "stone {} of {}: w = {:a}, h = {:a}, p = ({:a}, {:a}, {:a}), q = ({:a}, {:a}, {:a}, {:a}), n = "
            "({:a}, {:a}, {:a}), offset {:a}, mode {}",
            k, size, row.stones[k].width, row.stones[k].height, at.p_WB.x(), at.p_WB.y(), at.p_WB.z(), at.q_WB.w(),
            at.q_WB.x(), at.q_WB.y(), at.q_WB.z(), row.plane.n_W.x(), row.plane.n_W.y(), row.plane.n_W.z(),
            row.plane.offset, mode);
      });
    }
  }
}

/// A batch answers with numbers or refuses; what it was refused leaves it as it was.
template <class T>
void see_refusals(Checks& checks) {
  const T huge = std::numeric_limits<T>::max() * T(0.9), nan = std::numeric_limits<T>::quiet_NaN();
  const T infinite = std::numeric_limits<T>::infinity(), root = std::sqrt(T(0.5));
  const Stone<T> stone = make_stone(T(0.022), T(0.009), T(0.001));
  const Pose<T> here{.p_WB = Vec3<T>(T(0), T(0), T(1)), .q_WB = Quat<T>::Identity()};
  PlaneBatch<T> batch(1);
  batch.set(0, stone, here);
  const auto refused = [&](const char* name, auto&& call) {
    see_choice(checks["refusals"], !answer_of(FE_TONEAREST, [&] { return call(), 0; }),
               [&] { return std::string("taken: ") + name; });
  };
  const auto put = [&](const Vec3<T>& p, const Quat<T>& q) { batch.set(0, stone, {.p_WB = p, .q_WB = q}); };
  const Quat<T> q = Quat<T>::Identity();
  refused("a sum of products that overflows", [&] { put({huge, -huge, T(0)}, q); });
  refused("a place that is far", [&] { put({T(0), T(0), huge}, q); });
  refused("no place", [&] { put({T(0), nan, T(0)}, q); });
  refused("no attitude", [&] { put(here.p_WB, Quat<T>(nan, T(0), T(0), T(0))); });
  refused("an attitude that is none", [&] { put(here.p_WB, Quat<T>(T(1), T(0.01), T(0), T(0))); });
  refused("no stone", [&] { batch.set(0, Stone<T>{}, here); });
  refused("no index", [&] { batch.set(1, stone, here); });
  std::vector<T> gaps(1), two(2);
  const Vec3<T> up(T(0), T(0), T(1));
  const auto ask = [&](const Vec3<T>& n, const T& offset, std::vector<T>& into) { batch.gaps({n, offset}, into); };
  refused("an offset that is far", [&] { ask(up, -huge, gaps); });
  refused("an infinite offset", [&] { ask(up, infinite, gaps); });
  refused("no offset", [&] { ask(up, nan, gaps); });
  refused("no normal", [&] { ask(Vec3<T>(root, root, T(0.01)), T(0), gaps); });
  refused("no room", [&] { ask(up, T(0), two); });
  batch.gaps({}, gaps);
  see_choice(checks["refusals"], std::fabs(gaps[0] - (T(1) - T(0.0045))) < T(1e-6), [] { return "not as it was"; });
}

Measurement measure_rows(Context& context) {
  Checks checks;
  see_rows<double>(context, checks, context.samples(300, 3000));
  see_rows<float>(context, checks, context.samples(300, 3000));
  see_refusals<double>(checks);
  see_refusals<float>(checks);
  return checks.measurement();
}

}  // namespace

std::vector<Claim> domain_batch_claims() {
  return {
      {.id = "DOMAIN-13",
       .statement =
           "Gaps of a batch to a plane, stones of any sizes side by side in a register, at the origin, touching, "
           "far away, lying, standing, with |q|² and |n|² off by ± 60 ε, in each rounding mode: right, or refused "
           "where a gap would be no number.",
       .function = "PlaneBatch",
       .family = OracleFamily::other_formula,
       .oracle = "height less support, in 50 digits, at q/|q| and n/|n|",
       .checks = {within("gaps", 12.0, "ε of width, distance and offset; as much more as |n|² is off",
                         "some six roundings, twice as large where they are not to the nearest", 0.5),
                  none("refusals", "what is taken or refused and should not be")},
       .measure = measure_rows},
  };
}

}  // namespace goishi::verify
