#include "verify/bench/native.hpp"

#include <goishi/contact/batch_plane.hpp>
#include <goishi/motion/batch.hpp>

using namespace goishi;

struct goishi_native_stones {
  StoneBatch<double> flying;
  PlaneBatch<double> standing;
};

goishi_native_stones* goishi_native_make(std::size_t count, const goishi_native_stone* stones) {
  auto* all = new goishi_native_stones{StoneBatch<double>(count), PlaneBatch<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const goishi_native_stone& one = stones[i];
    const State<double> state = verify::bench::state_of(one);
    all->flying.set(i, state, verify::bench::moments_of(one));
    all->standing.set(i, make_stone(one.width, one.height, one.bevel), {.p_WB = state.p_WB, .q_WB = state.q_WB});
  }
  return all;
}

void goishi_native_free(goishi_native_stones* stones) {
  delete stones;
}

void goishi_native_fly(goishi_native_stones* stones, double gravity, double time) {
  stones->flying.fly(gravity_W<double>(gravity), time);
}

void goishi_native_get(const goishi_native_stones* stones, std::size_t i, goishi_native_stone* stone) {
  *stone = verify::bench::numbers_of({}, stones->flying.get(i));
}

void goishi_native_gaps(const goishi_native_stones* stones, double* gaps) {
  stones->standing.gaps(Plane<double>{}, std::span<double>(gaps, stones->standing.size()));
}

std::size_t goishi_native_lanes() {
  return StoneBatch<double>::lanes;
}
