/// Times drops, and measures where they come to rest, at tolerances from 1e-3 to 1e-11. It is compiled against the headers
/// of any commit that has `drop`, so that schemes of different times run on the same drops: see `measure`.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <goishi/drop/drop.hpp>
#include <goishi/mass/inertia.hpp>
#include <random>
#include <vector>

namespace {

using goishi::DropSettings;
using goishi::Quat;
using goishi::State;
using goishi::Vec3;

constexpr std::size_t count = 128;
constexpr double finest = 1e-12;  // of the runs that errors are taken against

double seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// What the schemes have other defaults of is set.
DropSettings<double> at_tolerance(double tolerance) {
  DropSettings<double> settings;
  settings.tolerance = tolerance;
  settings.rolling_resistance = 1e-4;
  settings.pivot_radius = 5e-5;
  settings.contact_speed = 1e-6;
  settings.closing_speed = 1e-2;
  settings.horizon = 60.0;
  return settings;
}

/// Of size 33, bevel 1 mm.
struct Stones {
  goishi::Stone<double> stone = goishi::make_stone(0.022, 0.0092, 0.001);
  goishi::RigidBody<double> body = make_rigid_body(mass_properties(stone, goishi::Density<double>{2800.0}));
  std::vector<State<double>> starts;

  [[nodiscard]] Vec3<double> rest(std::size_t i, double tolerance) const {
    return goishi::drop(stone, body, starts[i], at_tolerance(tolerance)).state.p_WB;
  }
};

class Dice {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3<double> direction() {
    std::normal_distribution<double> normal;
    const double x = normal(random_), y = normal(random_);
    return Vec3<double>(x, y, normal(random_)).normalized();
  }
  Quat<double> attitude() {
    std::normal_distribution<double> normal;
    const double w = normal(random_), x = normal(random_), y = normal(random_);
    return Quat<double>(w, x, y, normal(random_)).normalized();
  }

 private:
  std::mt19937_64 random_{1};
};

/// Let go at 5 cm in any attitude, with a spin of up to 30 rad/s.
Stones thrown() {
  Stones stones;
  Dice dice;
  for (std::size_t i = 0; i < count; ++i) {
    const Quat<double> q = dice.attitude();
    const Vec3<double> w_B = dice.uniform(0.0, 30.0) * dice.direction();
    stones.starts.push_back({{0.0, 0.0, 0.05}, q, {0.0, 0.0, 0.0}, {}});
    stones.starts.back().L_W = goishi::formula::angular_momentum_W(q, stones.body, w_B);
  }
  return stones;
}

/// Set down: let go 1 mm over the board, tilted by up to 5°, moving by up to 1 cm/s, without spin.
Stones set_down() {
  Stones stones;
  Dice dice;
  for (std::size_t i = 0; i < count; ++i) {
    const double half = dice.uniform(0.0, 5.0) / 360.0 * 3.141592653589793;
    const Vec3<double> v = dice.uniform(0.0, 0.01) * dice.direction();
    const double height = 0.0046 + 0.001 + 0.011 * std::sin(2.0 * half);
    stones.starts.push_back(
        {{0.0, 0.0, height}, Quat<double>(std::cos(half), std::sin(half), 0.0, 0.0), v, {0.0, 0.0, 0.0}});
  }
  return stones;
}

void measure(const char* name, const Stones& stones) {
  std::vector<Vec3<double>> right;
  for (std::size_t i = 0; i < count; ++i) {
    right.push_back(stones.rest(i, finest));
  }
  for (int exponent = -3; exponent >= -11; --exponent) {
    const double tolerance = std::pow(10.0, exponent);
    std::vector<double> times, errors;
    for (std::size_t i = 0; i < count; ++i) {
      const double start = seconds();
      const Vec3<double> place = stones.rest(i, tolerance);
      times.push_back(1e9 * (seconds() - start));
      errors.push_back((place - right[i]).norm());
    }
    std::printf("%s,1e%d,%.5g,%.5g,%.5g,%.5g\n", name, exponent, quantile(times, 0.5), quantile(times, 0.9),
                quantile(errors, 0.5), quantile(errors, 0.9));
  }
}

}  // namespace

int main() {
  measure("thrown", thrown());
  measure("set-down", set_down());
}
