/// Calls every function of the C interface with random arguments, some good, most not, for some seconds. It is built with
/// the sanitizers by the preset `asan`: a call that reads or writes where it must not ends it there.
/// usage: goishi-web-fuzz [SECONDS [SEED]]

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/web/calls.hpp"

namespace {

using namespace goishi::web_test;

class Fuzz {
 public:
  explicit Fuzz(std::uint64_t seed) : random_(seed), calls_(all_calls()) {}

  void one() {
    const Call& call = calls_[below(calls_.size())];
    if (call.name == "goishi_drop_create" && below(2) == 0) {
      drop_life(call);
    } else if (call.name == "goishi_scene_create" && below(2) == 0) {
      scene_life(call);
    } else {
      make(call, spoilt(call));
    }
  }

  /// Says what was seen, and whether that was enough: each function has succeeded and has refused, and nothing was wrong.
  [[nodiscard]] bool report() const {
    bool good = wrong_ == 0;
    for (const Call& call : calls_) {
      const auto found = counts_.find(call.name);
      const std::array<long, 4> counts = found == counts_.end() ? std::array<long, 4>{} : found->second;
      const bool seen = 0 < counts[GOISHI_OK] && 0 < counts[GOISHI_INVALID_ARGUMENT] && counts[GOISHI_FAILURE] == 0;
      good = good && seen;
      std::printf("%-32s %8ld done, %8ld refused%s\n", call.name.c_str(), counts[GOISHI_OK],
                  counts[GOISHI_INVALID_ARGUMENT], seen ? "" : ": not as it must be");
    }
    std::printf("drops: %ld steps of their lives, %ld came to rest\n", steps_, rests_);
    std::printf("scenes: %ld steps of their lives, %ld came to rest\n", scene_steps_, scene_rests_);
    return good && 0 < rests_ && 0 < scene_rests_;
  }

 private:
  struct Arguments {
    std::vector<Array> arrays;
    std::vector<bool> null;
    std::vector<std::size_t> sizes;
    Wholes wholes;
    Scalars scalars;
  };

  [[nodiscard]] std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }

  [[nodiscard]] double number(double usual) {
    constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::min();
    constexpr std::array<double, 24> special = {
        0.0,          -0.0,         1.0,          -1.0,   2.0,    0.5,    std::numeric_limits<double>::infinity(),
        1e-9,         1e300,        1e-300,       1e154,  -1e154, 1e-154, -std::numeric_limits<double>::infinity(),
        most,         -most,        least,        -least, 5e-324, 1e20,   std::numeric_limits<double>::quiet_NaN(),
        2147483647.0, 2147483648.0, -2147483649.0};
    switch (below(4)) {
      case 0:
        return special[below(special.size())];
      case 1:
        return std::bit_cast<double>(random_());
      case 2:
        return usual * std::pow(10.0, static_cast<double>(below(400)) / 100.0 - 2.0);
      default:
        return usual * (1.0 + 1e-15 * static_cast<double>(below(16)));
    }
  }

  /// Of some calls nothing is changed, of most one or two numbers, of a few everything.
  [[nodiscard]] Arguments spoilt(const Call& call) {
    Arguments result{.arrays = call.arrays, .null = {}, .sizes = {}, .wholes = {}, .scalars = {}};
    const std::size_t much = below(8) == 0 ? 1 : 40;
    for (Array& array : result.arrays) {
      for (double& value : array.values) {
        if (!array.output && below(much) == 0) {
          // Whole numbers of a fineness, so small that a mesh is soon made.
          value = array.kind == Kind::ints ? static_cast<double>(below(14)) - 1.0 : number(value);
        }
      }
      result.null.push_back(below(60) == 0);
      std::size_t size = array.values.size();
      if (array.has_size() && below(40) == 0) {
        const std::size_t other = below(2) == 0 ? below(3 * size) : static_cast<std::size_t>(random_());
        // Where more than one size is right, a greater one would be the caller's lie.
        size = array.rows || array.name == "ground" ? below(size + 1) : other;
      }
      result.sizes.push_back(size);
    }
    for (const Whole& whole : call.wholes) {
      long long value = whole.value;
      if (below(4) == 0) {
        const std::size_t i = below(2 * whole.bad.size() + 2);
        value = i < whole.bad.size() && whole.bad[i] != 100'000'000 ? whole.bad[i] : static_cast<long long>(below(12));
      }
      result.wholes.push_back(value);
    }
    for (const Scalar& scalar : call.scalars) {
      const double value = below(4) == 0 ? number(scalar.value) : scalar.value;
      // A scene has no budget: it goes on for as long as it is told to.
      result.scalars.push_back(call.name.starts_with("goishi_scene_") ? std::fmin(value, 1.0) : value);
    }
    return result;
  }

  void make(const Call& call, const Arguments& arguments) {
    std::vector<Memory> memory;
    Views views;
    for (std::size_t i = 0; i < arguments.arrays.size(); ++i) {
      memory.emplace_back(arguments.arrays[i]);
      views.push_back(memory.back().view());
      views.back().size = arguments.sizes[i];
      if (arguments.null[i]) {
        views.back().pointer = nullptr;
      }
    }
    count(call.name, call.run(views, arguments.wholes, arguments.scalars));
  }

  void count(const std::string& name, int status) {
    const std::size_t length = std::strlen(goishi_message());
    if (status < GOISHI_OK || GOISHI_FAILURE < status || (status == GOISHI_OK) != (length == 0) || 511 < length) {
      std::printf("%s: status %d, message '%s'\n", name.c_str(), status, goishi_message());
      ++wrong_;
      return;
    }
    ++counts_[name][static_cast<std::size_t>(status)];
  }

  /// The arrays in `memory`, which are to live as long as what is made with them.
  Views created(const Call& create, const Arguments& arguments, std::vector<Memory>& memory) {
    Views views;
    for (const Array& array : arguments.arrays) {
      memory.emplace_back(array);
      views.push_back(memory.back().view());
    }
    count(create.name, create.run(views, arguments.wholes, arguments.scalars));
    return views;
  }

  /// A drop from an odd start, and what can be done to it, in any order.
  void drop_life(const Call& create) {
    Arguments arguments = spoilt(create);
    std::vector<double>& settings = arguments.arrays[3].values;
    settings[GOISHI_MAXIMUM_STEPS] = std::fmin(settings[GOISHI_MAXIMUM_STEPS], 3000.0);  // so that it is soon over
    settings[GOISHI_TOLERANCE] = below(2) == 0 ? settings[GOISHI_TOLERANCE] : 1e-4;
    std::vector<Memory> memory;
    const Views views = created(create, arguments, memory);
    goishi_drop* drop = *views.back().new_drop();
    const View of_settings = views[3];
    for (std::size_t i = below(12); drop != nullptr && 0 < i; --i) {
      ++steps_;
      step(drop, of_settings);
    }
  }

  void step(goishi_drop* drop, const View& settings) {
    std::vector<double> info(GOISHI_DROP_SIZE);
    count("goishi_drop_info", goishi_drop_info(drop, info.data(), info.size()));
    rests_ += static_cast<int>(info[GOISHI_DROP_STATUS]) == GOISHI_REST ? 1 : 0;
    std::array<double, 3> point{}, impulse{};
    switch (below(7)) {
      case 0:
        count("goishi_drop_advance", goishi_drop_advance(drop, number(0.05)));
        break;
      case 1:
        count("goishi_drop_advance", goishi_drop_advance(drop, std::numeric_limits<double>::infinity()));
        break;
      case 2:
        for (double& value : point) {
          value = below(3) == 0 ? number(0.01) : 0.01;
        }
        for (double& value : impulse) {
          value = below(3) == 0 ? number(1e-3) : 1e-4;
        }
        count("goishi_drop_push", goishi_drop_push(drop, point.data(), point.size(), impulse.data(), impulse.size()));
        break;
      case 3: {
        double& value = settings.numbers()[below(settings.size)];
        value = number(value);
        settings.numbers()[GOISHI_MAXIMUM_STEPS] = std::fmin(settings.numbers()[GOISHI_MAXIMUM_STEPS], 3000.0);
        count("goishi_drop_change", goishi_drop_change(drop, settings.numbers(), settings.size));
        break;
      }
      case 4: {
        const std::size_t events = static_cast<std::size_t>(info[GOISHI_DROP_EVENTS]), some = 1 + below(events + 1);
        std::vector<double> rows(some * GOISHI_EVENT_SIZE);
        count("goishi_drop_events", goishi_drop_events(drop, below(events + 2), rows.data(), rows.size()));
        break;
      }
      case 5: {
        const double begin = info[GOISHI_DROP_MOTION_BEGIN], length = info[GOISHI_DROP_TIME] - begin;
        const std::array<double, 3> times = {begin + length * static_cast<double>(below(101)) / 100.0,
                                             below(4) == 0 ? number(begin) : begin, info[GOISHI_DROP_TIME]};
        std::vector<double> motions(3 * GOISHI_MOTION_SIZE);
        count("goishi_drop_motions", goishi_drop_motions(drop, times.data(), times.size(), static_cast<int>(below(2)),
                                                         motions.data(), motions.size()));
        break;
      }
      default: {
        goishi_drop* copy = nullptr;
        count("goishi_drop_copy", goishi_drop_copy(drop, &copy));
        count("goishi_drop_advance", goishi_drop_advance(copy, 0.01));
        goishi_drop_free(copy);
        break;
      }
    }
  }

  /// A scene of some stones, and what can be done to it, in any order. Of its settings those are not spoilt that say how much
  /// is computed, for it has no budget.
  void scene_life(const Call& create) {
    Arguments arguments = spoilt(create);
    std::vector<double>& settings = arguments.arrays[1].values;
    const std::vector<double> good = create.arrays[1].values;
    for (std::size_t k = 0; k < good.size(); ++k) {
      settings[k] = k < GOISHI_FRICTION_MODEL || k == GOISHI_STONES_RESTITUTION || k == GOISHI_STONES_FRICTION
                        ? settings[k]
                        : good[k];
    }
    for (const std::size_t k : {0, 1, 2}) {
      settings[GOISHI_GRAVITY + k] = good[GOISHI_GRAVITY + k];
    }
    settings[GOISHI_TOLERANCE] = 1e-4;
    std::vector<Memory> memory;
    const Views views = created(create, arguments, memory);
    goishi_scene* scene = *views.back().new_scene();
    for (std::size_t i = below(12); scene != nullptr && 0 < i; --i) {
      ++scene_steps_;
      step(scene, views[1]);
    }
  }

  void step(goishi_scene* scene, const View& settings) {
    std::array<double, GOISHI_SCENE_SIZE> info{};
    count("goishi_scene_info", goishi_scene_info(scene, info.data(), info.size()));
    scene_rests_ += 0.0 < info[GOISHI_SCENE_STONES] && info[GOISHI_SCENE_MOVING] == 0.0 ? 1 : 0;
    const std::size_t stones = static_cast<std::size_t>(info[GOISHI_SCENE_STONES]), id = below(stones + 1);
    const auto odd = [&](double usual) {
      return below(12) != 0 ? usual : below(2) == 0 ? 8.0 * usual : std::numeric_limits<double>::quiet_NaN();
    };
    const std::array<double, 3> point = {odd(0.01), odd(0.0), odd(0.005)};
    switch (below(9)) {
      case 0: {
        count("goishi_scene_advance", goishi_scene_advance(scene, 0.05));
        break;
      }
      case 1:
        count("goishi_scene_run_until_rest", goishi_scene_run_until_rest(scene, 3.0));
        break;
      case 2: {
        const std::array<double, 3> impulse = {odd(1e-4), odd(-1e-4), odd(1e-4)};
        count("goishi_scene_push", goishi_scene_push(scene, id, point.data(), 3, impulse.data(), 3));
        break;
      }
      case 3: {
        const std::array<double, 3> velocity = {odd(0.05), odd(0.0), odd(0.05)}, spin = {0.0, odd(1.0), odd(1.0)};
        count("goishi_scene_hold", goishi_scene_hold(scene, id, velocity.data(), 3, spin.data(), 3, odd(0.1)));
        break;
      }
      case 4:
        count("goishi_scene_release", goishi_scene_release(scene, id));
        break;
      case 5:
        count("goishi_scene_remove", goishi_scene_remove(scene, id));
        break;
      case 6: {
        settings.numbers()[GOISHI_GRAVITY] = 0.1 * static_cast<double>(below(20));
        count("goishi_scene_change", goishi_scene_change(scene, settings.numbers(), settings.size));
        break;
      }
      case 7: {
        goishi_scene* copy = nullptr;
        count("goishi_scene_copy", goishi_scene_copy(scene, &copy));
        count("goishi_scene_advance", goishi_scene_advance(copy, 0.01));
        std::vector<double> rows((stones + 1) * GOISHI_SCENE_STONE_SIZE);
        std::size_t contacts = 0;
        count("goishi_scene_contacts", goishi_scene_contacts(copy, rows.data(), GOISHI_SCENE_CONTACT_SIZE, &contacts));
        count("goishi_scene_stones", goishi_scene_stones(copy, below(2), rows.data(), rows.size()));
        goishi_scene_free(copy);
        break;
      }
      default: {
        const double tilt = 0.1 * static_cast<double>(below(7));
        const std::array<double, GOISHI_STONE_SIZE> stone = {0.022, 0.0092, 0.001, 0.0, 2800.0, 0.0};
        const std::array<double, GOISHI_STATE_SIZE> state = {0.01 * static_cast<double>(below(8)),
                                                             odd(0.0),
                                                             0.012 + 0.01 * static_cast<double>(below(8)),
                                                             std::sqrt(1.0 - tilt * tilt),
                                                             tilt,
                                                             0.0,
                                                             0.0,
                                                             odd(0.1),
                                                             0.0,
                                                             odd(-0.1),
                                                             odd(1e-6),
                                                             0.0,
                                                             0.0};
        std::size_t added = 0;
        count("goishi_scene_add",
              goishi_scene_add(scene, stone.data(), stone.size(), state.data(), state.size(), &added));
        break;
      }
    }
  }

  std::mt19937_64 random_;
  std::vector<Call> calls_;
  std::map<std::string, std::array<long, 4>> counts_;
  long wrong_ = 0, steps_ = 0, rests_ = 0, scene_steps_ = 0, scene_rests_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const double seconds = 1 < argc ? std::atof(argv[1]) : 3.0;
  const std::uint64_t seed = 2 < argc ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::printf("%g s, seed %llu\n", seconds, static_cast<unsigned long long>(seed));
  std::fflush(stdout);
  Fuzz fuzz(seed);
  const auto begin = std::chrono::steady_clock::now();
  long count = 0, slowest = 0;
  double longest = 0.0;
  // At least so many that each function has had good arguments and bad ones.
  while (count < 20000 || std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds) {
    const auto start = std::chrono::steady_clock::now();
    fuzz.one();
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slowest = longest < took ? count : slowest;
    longest = std::max(longest, took);
    ++count;
  }
  std::printf("%ld calls; the longest, number %ld, took %.2g s\n", count, slowest, longest);
  return fuzz.report() ? 0 : 1;
}
