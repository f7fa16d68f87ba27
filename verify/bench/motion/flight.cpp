#include <fmt/format.h>

#include <algorithm>
#include <goishi/motion/batch.hpp>
#include <goishi/shape/catalogue.hpp>

#include "verify/bench/motion/motion.hpp"
#include "verify/bench/native.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify::bench::motion {

namespace {

constexpr double flight_time = 0.125;  // [s], forth and back, so that nothing grows

using Thrown = std::vector<goishi_native_stone>;

/// Catalogue stones of all sizes, thrown at random.
Thrown draw_stones(std::size_t count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) -> Vec3<double> {
    return size * Vec3<double>(normal(random), normal(random), normal(random));
  };
  Thrown thrown;
  for (std::size_t i = 0; i < count; ++i) {
    const catalogue::Size& size = catalogue::sizes[i % catalogue::sizes.size()];
    const Stone<double> stone = make_stone<double>(catalogue_stone(size.number, StoneColor::white));
    const double momentum = 15 * mass_properties(stone, Density{2800.0}).moments.transverse;
    thrown.push_back(numbers_of(
        stone, {.p_WB = vector(0.1), .q_WB = draw_attitude(random), .v_WB = vector(1), .L_W = vector(momentum)}));
  }
  return thrown;
}

template <class T, class From>
State<T> cast(const State<From>& state) {
  const auto& [p, q, v, L] = state;
  return {.p_WB = p.template cast<T>(),
          .q_WB = q.template cast<T>().normalized(),
          .v_WB = v.template cast<T>(),
          .L_W = L.template cast<T>()};
}

template <class T>
Moments<T> cast(const Moments<double>& moments) {
  return {.axial = static_cast<T>(moments.axial), .transverse = static_cast<T>(moments.transverse)};
}

template <class T>
class OneByOne {
 public:
  explicit OneByOne(const Thrown& thrown) {
    for (const goishi_native_stone& one : thrown) {
      states_.push_back(cast<T>(state_of(one)));
      mobilities_.push_back(make_mobility(cast<T>(moments_of(one))));
    }
  }
  void fly(double time) {
    const Vec3<T> gravity = gravity_W<T>();
    for (std::size_t i = 0; i < states_.size(); ++i) {
      states_[i] = free_flight(states_[i], mobilities_[i], gravity, static_cast<T>(time));
    }
  }
  [[nodiscard]] State<double> get(std::size_t i) const { return cast<double>(states_[i]); }

 private:
  std::vector<State<T>> states_;
  std::vector<Mobility<T>> mobilities_;
};

/// Asked at other times of the same flights.
class Kept {
 public:
  explicit Kept(const Thrown& thrown) : states_(thrown.size()) {
    for (const goishi_native_stone& one : thrown) {
      flights_.emplace_back(state_of(one), make_mobility(moments_of(one)), gravity_W<double>());
    }
  }
  void fly(double time) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      states_[i] = flights_[i].at(time);
    }
  }
  [[nodiscard]] State<double> get(std::size_t i) const { return states_[i]; }

 private:
  std::vector<Flight<double>> flights_;
  std::vector<State<double>> states_;
};

/// Compiled as the rest of the program.
template <class T>
class Portable {
 public:
  explicit Portable(const Thrown& thrown) : stones_(thrown.size()) {
    for (std::size_t i = 0; i < thrown.size(); ++i) {
      stones_.set(i, cast<T>(state_of(thrown[i])), cast<T>(moments_of(thrown[i])));
    }
  }
  void fly(double time) { stones_.fly(gravity_W<T>(), static_cast<T>(time)); }
  [[nodiscard]] State<double> get(std::size_t i) const { return cast<double>(stones_.get(i)); }

 private:
  StoneBatch<T> stones_;
};

class Native {
 public:
  explicit Native(const Thrown& thrown)
      : stones_(goishi_native_make(thrown.size(), thrown.data()), goishi_native_free) {}
  void fly(double time) { goishi_native_fly(stones_.get(), standard_gravity<double>(), time); }
  [[nodiscard]] State<double> get(std::size_t i) const {
    goishi_native_stone stone;
    goishi_native_get(stones_.get(), i, &stone);
    return state_of(stone);
  }

 private:
  std::shared_ptr<goishi_native_stones> stones_;
};

/// Greatest differences from one by one in double, after the first flight.
template <class Stones>
std::vector<double> judge_first(const Stones& stones, const Thrown& thrown) {
  OneByOne<double> right(thrown);
  right.fly(flight_time);
  double place = 0, attitude = 0;
  for (std::size_t i = 0; i < thrown.size(); ++i) {
    const State<double> a = stones.get(i), b = right.get(i);
    place = std::max(place, (a.p_WB - b.p_WB).norm());
    attitude = std::max(attitude, 2 * (a.q_WB.coeffs() - b.q_WB.coeffs()).norm());
  }
  return {attitude, place};
}

template <class Stones>
Curve curve_of(std::string name, std::string label, bool can_run = true) {
  Curve curve{.who = {std::move(name), std::move(label), "ours", Kind::stones, {1024, 100'000}}, .enter = {}};
  if (can_run) {
    curve.enter = [](double count) {
      const Thrown thrown = draw_stones(static_cast<std::size_t>(count));
      const auto stones = std::make_shared<Stones>(thrown);
      return Entry{.run =
                       [stones, time = flight_time](std::size_t, std::size_t) mutable {
                         stones->fly(time);
                         time = -time;
                       },
                   .judge = [stones, thrown] { return judge_first(*stones, thrown); },
                   .items = count};
    };
  }
  return curve;
}

Race prepare(const Effort& /*any*/) {
  const std::string batch = can_run_native() ? fmt::format("has {} lanes", goishi_native_lanes())
                                             : "is not raced: this processor lacks what it was compiled for";
  return {.note = fmt::format("Stones of all catalogue sizes, thrown at random; their rates are kept. 1024 stay in the "
                              "cache. The batch for this machine {}.",
                              batch),
          .cost = "run time of a stone",
          .quantities = {{"greatest attitude difference", "rad", false}, {"greatest difference", "m", false}},
          .curves = {curve_of<OneByOne<double>>("one-by-one", "one by one"),
                     curve_of<Kept>("kept", "one by one, constants kept"),
                     curve_of<Native>("batch", "batch for this machine", can_run_native()),
                     curve_of<Portable<double>>("batch-portable", "batch as the program"),
                     curve_of<OneByOne<float>>("one-by-one-float", "one by one, float"),
                     curve_of<Portable<float>>("batch-portable-float", "batch as the program, float")}};
}

}  // namespace

Problem flight() {
  return {"flight", "Exact flight of many stones, one by one and in a batch", prepare};
}

}  // namespace goishi::verify::bench::motion
