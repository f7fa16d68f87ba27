#include "verify/work_precision/native.hpp"

#include <goishi/contact/batch_plane.hpp>
#include <goishi/motion/batch.hpp>

struct goishi_native_flock {
  goishi::StoneBatch<double> stones;
};

struct goishi_native_resting {
  goishi::PlaneBatch<double> stones;
};

namespace {

using namespace goishi;

State<double> state_of(const double* x) {
  return {.p_WB = {x[0], x[1], x[2]},
          .q_WB = {x[3], x[4], x[5], x[6]},
          .v_WB = {x[7], x[8], x[9]},
          .L_W = {x[10], x[11], x[12]}};
}

}  // namespace

goishi_native_flock* goishi_native_make(std::size_t count, const double* states, const double* moments) {
  auto* flock = new goishi_native_flock{StoneBatch<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    flock->stones.set(i, state_of(states + 13 * i), {.axial = moments[2 * i], .transverse = moments[2 * i + 1]});
  }
  return flock;
}

void goishi_native_fly(goishi_native_flock* flock, double gravity, double time) {
  flock->stones.fly(gravity_W<double>(gravity), time);
}

void goishi_native_get(const goishi_native_flock* flock, double* states) {
  for (std::size_t i = 0; i < flock->stones.size(); ++i) {
    const State<double> state = flock->stones.get(i);
    const auto& [p, q, v, L] = state;
    for (const double value :
         {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), L.x(), L.y(), L.z()}) {
      *states++ = value;
    }
  }
}

void goishi_native_free(goishi_native_flock* flock) {
  delete flock;
}

std::size_t goishi_native_lanes() {
  return StoneBatch<double>::lanes;
}

goishi_native_resting* goishi_native_resting_make(std::size_t count, const double* stones) {
  auto* resting = new goishi_native_resting{PlaneBatch<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double* x = stones + 10 * i;
    resting->stones.set(i, make_stone(x[0], x[1], x[2]),
                        {.p_WB = {x[3], x[4], x[5]}, .q_WB = Quat<double>(x[6], x[7], x[8], x[9])});
  }
  return resting;
}

void goishi_native_resting_gaps(const goishi_native_resting* stones, double* gaps) {
  stones->stones.gaps(Plane<double>{}, std::span<double>(gaps, stones->stones.size()));
}

void goishi_native_resting_free(goishi_native_resting* stones) {
  delete stones;
}
