#include "verify/work_precision/flight_speed.hpp"

#include <array>
#include <cmath>
#include <goishi/motion/free_flight.hpp>
#include <goishi/shape/catalogue.hpp>
#include <memory>
#include <stdexcept>
#include <vector>

#include "verify/samples/stone.hpp"
#include "verify/work_precision/native.hpp"

namespace goishi::verify::bench {

namespace {

constexpr double flight_time = 0.125;  // [s], forth and back, so that nothing grows

/// Catalogue stones of all sizes, thrown at random.
struct Stones {
  std::vector<State<double>> states;
  std::vector<Moments<double>> moments;
  std::vector<TopRates<double>> rates;
};

Stones draw_stones(std::size_t count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) -> Vec3<double> {
    return size * Vec3<double>(normal(random), normal(random), normal(random));
  };
  std::vector<Moments<double>> sizes;
  for (const catalogue::Size& size : catalogue::sizes) {
    sizes.push_back(
        mass_properties(make_stone<double>(catalogue_stone(size.number, StoneColor::white)), Density{2800.0}).moments);
  }
  Stones stones;
  for (std::size_t i = 0; i < count; ++i) {
    const Moments<double>& moments = sizes[i % sizes.size()];
    stones.moments.push_back(moments);
    stones.rates.push_back(make_top_rates(moments));
    stones.states.push_back({.p_WB = vector(0.1),
                             .q_WB = draw_attitude(random),
                             .v_WB = vector(1),
                             .L_W = vector(15 * moments.transverse)});
  }
  return stones;
}

std::array<double, 13> numbers(const State<double>& state) {
  const auto& [p, q, v, L] = state;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), L.x(), L.y(), L.z()};
}

class Flock {
 public:
  explicit Flock(const Stones& stones) : count_(stones.states.size()) {
    std::vector<double> states;
    std::vector<double> moments;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto state = numbers(stones.states[i]);
      states.insert(states.end(), state.begin(), state.end());
      moments.insert(moments.end(), {stones.moments[i].axial, stones.moments[i].transverse});
    }
    flock_.reset(goishi_native_make(count_, states.data(), moments.data()));
  }

  void fly(double time) { goishi_native_fly(flock_.get(), standard_gravity<double>(), time); }

  [[nodiscard]] std::vector<double> states() const {
    std::vector<double> result(13 * count_);
    goishi_native_get(flock_.get(), result.data());
    return result;
  }

 private:
  struct Free {
    void operator()(goishi_native_flock* flock) const { goishi_native_free(flock); }
  };
  std::size_t count_;
  std::unique_ptr<goishi_native_flock, Free> flock_;
};

void fly(Stones& stones, double time) {
  const Vec3<double> gravity = gravity_W<double>();
  for (std::size_t i = 0; i < stones.states.size(); ++i) {
    stones.states[i] = free_flight(stones.states[i], stones.rates[i], gravity, time);
  }
}

void require_agreement(Stones stones) {
  Flock flock(stones);
  fly(stones, flight_time);
  flock.fly(flight_time);
  const std::vector<double> found = flock.states();
  for (std::size_t i = 0; i < stones.states.size(); ++i) {
    const auto right = numbers(stones.states[i]);
    for (std::size_t k = 0; k < right.size(); ++k) {
      if (!(std::abs(found[13 * i + k] - right[k]) <= 1e-13)) {  // round-off of numbers of size 1, and of 5 rad
        throw std::runtime_error("batch and scalar flight do not agree");
      }
    }
  }
}

template <class F>
Timing per_stone(std::size_t count, const Effort& effort, F&& fly_all) {
  double time = flight_time;
  return time_of(
             [&](std::size_t calls) {
               for (std::size_t i = 0; i < calls; ++i) {
                 fly_all(time);
                 time = -time;
               }
             },
             effort)
      .per(static_cast<double>(count));
}

Timing scalar_time(std::size_t count, const Effort& effort) {
  Stones stones = draw_stones(count);
  return per_stone(count, effort, [&](double time) { fly(stones, time); });
}

Timing batch_time(std::size_t count, const Effort& effort) {
  Flock flock(draw_stones(count));
  return per_stone(count, effort, [&](double time) { flock.fly(time); });
}

}  // namespace

FlightSpeed measure_flight_speed(const Effort& effort) {
  FlightSpeed speed{.scalar_few = scalar_time(few_stones, effort),
                    .scalar_many = scalar_time(many_stones, effort),
                    .batch_few = {},
                    .batch_many = {}};
  if (can_run_native()) {
    require_agreement(draw_stones(few_stones));
    speed.lanes = goishi_native_lanes();
    speed.batch_few = batch_time(few_stones, effort);
    speed.batch_many = batch_time(many_stones, effort);
  }
  return speed;
}

}  // namespace goishi::verify::bench
