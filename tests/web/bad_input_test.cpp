/// The C interface: errors of the caller, of every argument of every function.

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/web/calls.hpp"

namespace goishi::web_test {

namespace {

/// A call that is about to be made, and whose arguments can be spoilt.
class Attempt {
 public:
  explicit Attempt(const Call& call) : call_(call) {
    for (const Array& array : call.arrays) {
      memory_.emplace_back(array);
      views_.push_back(memory_.back().view());
    }
    for (const Whole& whole : call.wholes) {
      wholes.push_back(whole.value);
    }
    for (const Scalar& scalar : call.scalars) {
      scalars.push_back(scalar.value);
    }
  }

  [[nodiscard]] View& view(std::size_t i) { return views_[i]; }

  void expect_good() {
    EXPECT_EQ(run(), GOISHI_OK) << call_.name << ": " << goishi_message();
    EXPECT_STREQ(goishi_message(), "") << call_.name;
  }

  /// It is refused, the message begins so, and nothing is written.
  void expect_refused(const std::string& beginning) {
    std::vector<std::vector<unsigned char>> before;
    for (const Memory& memory : memory_) {
      before.push_back(memory.bytes());
    }
    EXPECT_EQ(run(), GOISHI_INVALID_ARGUMENT) << call_.name << ", " << beginning;
    const std::string_view message = goishi_message();
    EXPECT_TRUE(message.starts_with(beginning)) << call_.name << ": '" << message << "', not '" << beginning << "'";
    for (std::size_t i = 0; i < memory_.size(); ++i) {
      EXPECT_EQ(memory_[i].bytes(), before[i]) << call_.name << " has written " << call_.arrays[i].name;
    }
  }

  Wholes wholes;
  Scalars scalars;

 private:
  [[nodiscard]] int run() { return call_.run(views_, wholes, scalars); }

  const Call& call_;
  std::vector<Memory> memory_;
  Views views_;
};

TEST(BadCall, TheArgumentsAreGoodThatAreSpoilt) {
  for (const Call& call : all_calls()) {
    Attempt(call).expect_good();
  }
}

TEST(BadCall, NullIsRefused) {
  for (const Call& call : all_calls()) {
    for (std::size_t i = 0; i < call.arrays.size(); ++i) {
      Attempt attempt(call);
      attempt.view(i).pointer = nullptr;
      attempt.expect_refused(call.arrays[i].name + " = null: must point to something");
    }
  }
  goishi_drop_free(nullptr);
  goishi_scene_free(nullptr);
}

TEST(BadCall, WrongSizesAreRefused) {
  for (const Call& call : all_calls()) {
    for (std::size_t i = 0; i < call.arrays.size(); ++i) {
      const Array& array = call.arrays[i];
      if (!array.has_size()) {
        continue;
      }
      const std::size_t size = array.values.size(), most = std::numeric_limits<std::size_t>::max();
      for (const std::size_t bad : {std::size_t{0}, size - 1, size + 1, most - 8}) {
        if (array.rows && bad == most - 8) {
          continue;  // there may be so many rows
        }
        Attempt attempt(call);
        attempt.view(i).size = bad;
        // Of two that belong together, the other may be named.
        attempt.expect_refused(array.name == "times" ? "times_size = " : array.name + "_size = ");
      }
    }
  }
}

TEST(BadCall, NanIsRefused) {
  for (const Call& call : all_calls()) {
    for (std::size_t i = 0; i < call.arrays.size(); ++i) {
      const Array& array = call.arrays[i];
      if (array.output || array.kind != Kind::numbers) {
        continue;
      }
      for (std::size_t k = 0; k < array.values.size(); ++k) {
        Attempt attempt(call);
        attempt.view(i).numbers()[k] = std::numeric_limits<double>::quiet_NaN();
        SCOPED_TRACE(call.name + ", " + array.name + " " + std::to_string(k));
        attempt.expect_refused("");
      }
    }
  }
}

TEST(BadCall, BadNumbersAreRefused) {
  for (const Call& call : all_calls()) {
    for (std::size_t i = 0; i < call.wholes.size(); ++i) {
      for (const long long bad : call.wholes[i].bad) {
        Attempt attempt(call);
        attempt.wholes[i] = bad;
        attempt.expect_refused(call.wholes[i].name + " = ");
      }
    }
    for (std::size_t i = 0; i < call.scalars.size(); ++i) {
      for (const double bad : call.scalars[i].bad) {
        Attempt attempt(call);
        attempt.scalars[i] = bad;
        attempt.expect_refused(call.scalars[i].name + " = ");
      }
    }
  }
}

/// With one number of an input changed, of those that have the size `of` where that matters.
void expect_refused(std::string_view name, std::string_view array, std::size_t place, double bad,
                    const std::string& beginning, std::size_t of = 0) {
  int found = 0;
  for (const Call& call : all_calls()) {
    for (std::size_t i = 0; i < call.arrays.size() && call.name == name; ++i) {
      const std::size_t size = call.arrays[i].values.size();
      if (call.arrays[i].name == array && (of == 0 || size == of)) {
        ++found;
        Attempt attempt(call);
        attempt.view(i).numbers()[place] = bad;
        attempt.expect_refused(beginning);
      }
    }
  }
  EXPECT_LT(0, found) << name << ", " << array;
}

TEST(BadCall, TheRulesOfWhatArraysStandFor) {
  const double infinity = std::numeric_limits<double>::infinity();
  expect_refused("goishi_measures", "stone", GOISHI_HEIGHT, 0.03, "height = 0.03: must not exceed the width (0.022)");
  expect_refused("goishi_measures", "stone", GOISHI_BEVEL, 0.0092, "bevel = 0.0092: ");
  expect_refused("goishi_measures", "stone", GOISHI_MEASURED, 0.5,
                 "measured = 0.5: must be a whole number from 0 to 1");
  expect_refused("goishi_measures", "stone", GOISHI_MEASURED, 2.0, "measured = 2: ");
  expect_refused("goishi_measures", "stone", GOISHI_DENSITY, -1.0, "density = -1: ");
  expect_refused("goishi_measures", "stone", GOISHI_DENSITY, 0.0, "density = 0: ");
  expect_refused("goishi_measures", "stone", GOISHI_MASS, 0.005, "density = 2800: must be 0 where the mass is given");
  expect_refused("goishi_published_measures", "stone", GOISHI_WIDTH, 0.11, "width = 0.11: must be at most 0.1");
  expect_refused("goishi_tensor", "pose", GOISHI_ATTITUDE, 0.81, "attitude = ");
  expect_refused("goishi_free_rotation", "moments", GOISHI_MOMENT_AXIAL, 3e-7, "axial = 3e-07: ");
  expect_refused("goishi_free_rotation", "attitude", 0, 0.81, "attitude = ");
  expect_refused("goishi_free_flight", "state", GOISHI_ATTITUDE, 0.81, "attitude = ");
  expect_refused("goishi_free_flight", "state", GOISHI_VELOCITY, infinity, "velocity = inf: ");
  expect_refused("goishi_separation", "ground", 2, 1.1, "normal = 1.1: ", GOISHI_PLANE_SIZE);
  expect_refused("goishi_time_of_impact", "ground", GOISHI_BOARD_LEGS, -1.0, "legs = -1: ", GOISHI_BOARD_SIZE);
  expect_refused("goishi_drop_create", "ground", GOISHI_PLANE_OFFSET, 1e-300, "ground = 0 0 1: must be a board",
                 GOISHI_PLANE_SIZE);
  expect_refused("goishi_impact", "normal", 0, 0.1, "normal = ");
  expect_refused("goishi_drop_create", "settings", GOISHI_MAXIMUM_STEPS, 2147483648.0, "maximum_steps = 2147483648: ");
  expect_refused("goishi_drop_create", "settings", GOISHI_LAW, 3.0, "law = 3: ");
  expect_refused("goishi_drop_create", "settings", GOISHI_FRICTION_MODEL, 1.5, "friction_model = 1.5: ");
  expect_refused("goishi_drop_create", "settings", GOISHI_ROLLING_RESISTANCE, -2.0, "rolling_resistance = -2: ");
  expect_refused("goishi_drop_change", "settings", GOISHI_TOLERANCE, 0.0, "tolerance = 0: ");
  expect_refused("goishi_drop_motions", "times", 0, 0.2, "time = 0.2: is after what has been computed");
  expect_refused("goishi_scene_create", "board", GOISHI_BOARD_LINES, 0.5, "lines = 0.5: ");
  expect_refused("goishi_scene_create", "settings", GOISHI_TOLERANCE, 0.0, "tolerance = 0: ");
  expect_refused("goishi_scene_create", "settings", GOISHI_STONES_RESTITUTION, 1.5, "restitution = 1.5: ");
  expect_refused("goishi_scene_create", "settings", GOISHI_STONES_FRICTION, -1.0, "friction = -1: ");
  expect_refused("goishi_scene_create", "settings", GOISHI_STEP, 0.0, "step = 0: ");
  expect_refused("goishi_scene_create", "settings", GOISHI_CLEARANCE, -2.0, "clearance = -2: ");
  expect_refused("goishi_scene_change", "settings", GOISHI_SOLVER_TOLERANCE, 2.0, "solver_tolerance = 2: ");
  expect_refused("goishi_scene_change", "settings", GOISHI_IMPACT_SPEED, 0.0, "impact_speed = 0: ");
  expect_refused("goishi_scene_change", "settings", GOISHI_LEAVING_TIME, infinity, "leaving_time = inf: ");
  expect_refused("goishi_scene_change", "settings", GOISHI_ROLLING_RESISTANCE, 0.1, "rolling_resistance = 0.1: ");
  expect_refused("goishi_scene_add", "state", 2, 0.001, "position = ");
  expect_refused("goishi_scene_hold", "velocity", 2, -0.1, "v_WB = ");
  expect_refused("goishi_drop_motions", "times", 1, -0.1, "time = -0.1: is before the motion that is kept");
}

TEST(BadCall, ABoardHasAWholeNumberOfLines) {
  std::vector<double> board(GOISHI_BOARD_SIZE), separation(GOISHI_SEPARATION_SIZE);
  ASSERT_EQ(goishi_board(board.data(), board.size()), GOISHI_OK);
  const std::vector<double> stone = {0.022, 0.0092, 0.001, 0.0, 2800.0, 0.0}, pose = {0, 0, 0.05, 1, 0, 0, 0};
  for (const double bad : {0.0, 18.5, -19.0, 1e300}) {
    board[GOISHI_BOARD_LINES] = bad;
    EXPECT_EQ(goishi_separation(stone.data(), stone.size(), pose.data(), pose.size(), board.data(), board.size(),
                                separation.data(), separation.size()),
              GOISHI_INVALID_ARGUMENT);
    EXPECT_TRUE(std::string_view(goishi_message()).starts_with("lines = ")) << goishi_message();
  }
}

TEST(BadCall, AnAttitudeOfNoLengthIsRefused) {
  const std::vector<double> stone = {0.022, 0.0092, 0.001, 0.0, 2800.0, 0.0}, zero(3, 0.0);
  std::vector<double> pose(GOISHI_POSE_SIZE, 0.0), state(GOISHI_STATE_SIZE);
  const auto made = [&] {
    return goishi_state(stone.data(), stone.size(), pose.data(), pose.size(), zero.data(), zero.size(), zero.data(),
                        zero.size(), state.data(), state.size());
  };
  EXPECT_EQ(made(), GOISHI_INVALID_ARGUMENT);
  EXPECT_STREQ(goishi_message(), "attitude = 0: must have a length that is not 0");
  pose[GOISHI_ATTITUDE] = 1e-310;
  EXPECT_EQ(made(), GOISHI_OK) << goishi_message();
  EXPECT_EQ(state[GOISHI_ATTITUDE], 1.0);
}

TEST(BadCall, MoreMemoryThanThereIs) {
  std::vector<double> rows(GOISHI_PROFILE_SIZE);
  const std::vector<double> stone = {0.022, 0.0092, 0.0, 0.0, 2800.0, 0.0};
  // 2⁵⁸ points are not written anywhere: their list is not made.
  const std::size_t steps = (std::size_t{1} << 57U) - 1;
  const int status =
      goishi_profile(stone.data(), stone.size(), steps, rows.data(), 2 * (steps + 1) * GOISHI_PROFILE_SIZE);
  EXPECT_EQ(status, GOISHI_OUT_OF_MEMORY);
  EXPECT_STREQ(goishi_message(), "out of memory");
}

TEST(Message, IsTheThreadsOwn) {
  std::vector<double> few(1);
  ASSERT_EQ(goishi_settings(few.data(), few.size()), GOISHI_INVALID_ARGUMENT);
  const std::string mine = goishi_message();
  EXPECT_EQ(mine, "settings_size = 1: must be 22");
  std::string before, after;
  std::thread([&] {
    before = goishi_message();
    static_cast<void>(goishi_board(nullptr, 0));
    after = goishi_message();
  }).join();
  EXPECT_EQ(before, "");
  EXPECT_EQ(after, "board = null: must point to something");
  EXPECT_EQ(goishi_message(), mine);
}

}  // namespace

}  // namespace goishi::web_test
