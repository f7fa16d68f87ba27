#include "verify/work_precision/contact/speed.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "verify/work_precision/contact/contestant.hpp"
#include "verify/work_precision/native.hpp"

namespace goishi::verify::bench::contact {

namespace {

constexpr std::size_t stone_count = 1024;  // a power of two; more than a branch predictor learns by heart

Loop loop_over(Asker& asker) {
  return [&asker](std::size_t calls) { asker.ask(0, calls); };
}

Timing region_time(const Stone<double>& stone, const Effort& effort) {
  const Board<double> board = make_board<double>();
  const double reach = outer_width(stone) / 2;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3<double>> places(stone_count);
  for (Vec3<double>& p : places) {
    p = {1.1 * board.half_width * unit(random), 1.1 * board.half_length * unit(random),
         reach * (0.75 + 1.25 * unit(random))};
  }
  const auto asker =
      make_asker(stone_count, [=](std::size_t i) { return static_cast<double>(region_of(board, places[i], reach)); });
  return time_of(loop_over(*asker), effort);
}

/// The scene's stones, in a batch compiled for this machine.
class Batch {
 public:
  explicit Batch(const Scene& scene) : gaps_(scene.poses.size()) {
    const auto& [width, height, bevel] = scene.problem->shape;
    std::vector<double> numbers;
    for (const Pose<double>& pose : scene.poses) {
      const auto& [p, q] = pose;
      numbers.insert(numbers.end(), {width, height, bevel, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
    }
    stones_.reset(goishi_native_resting_make(scene.poses.size(), numbers.data()));
  }

  void ask() { goishi_native_resting_gaps(stones_.get(), gaps_.data()); }
  [[nodiscard]] const std::vector<double>& gaps() const { return gaps_; }

 private:
  struct Free {
    void operator()(goishi_native_resting* stones) const { goishi_native_resting_free(stones); }
  };
  std::unique_ptr<goishi_native_resting, Free> stones_;
  std::vector<double> gaps_;
};

Timing batch_time(const Scene& scene, const Effort& effort) {
  Batch batch(scene);
  batch.ask();
  for (std::size_t i = 0; i < stone_count; ++i) {
    if (!(std::fabs(batch.gaps()[i] - scene.right[i]) <= 1e-17)) {  // round-off of lengths of 1 cm
      throw std::runtime_error("the batch of gaps is wrong");
    }
  }
  const Loop loop = [&](std::size_t calls) {
    for (std::size_t i = 0; i < calls; ++i) {
      batch.ask();
    }
  };
  return time_of(loop, effort).per(static_cast<double>(stone_count));
}

}  // namespace

Speed measure_speed(const Effort& effort) {
  const Scene scene = make_scene(problems().front(), stone_count);  // stone and plane
  const auto& [width, height, bevel] = scene.problem->shape;
  const Stone<double> stone = make_stone(width, height, bevel);
  const auto gap =
      make_asker(stone_count, [=, poses = scene.poses](std::size_t i) { return surface_gap(stone, poses[i]); });
  Speed speed;
  speed.stones = stone_count;
  speed.region = region_time(stone, effort);
  speed.gap = time_of(loop_over(*gap), effort);
  if (can_run_native()) {
    speed.batch = batch_time(scene, effort);
    speed.lanes = goishi_native_lanes();
  }
  return speed;
}

}  // namespace goishi::verify::bench::contact
