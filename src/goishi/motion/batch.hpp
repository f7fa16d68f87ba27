#pragma once
/// \file
/// Free flight of many stones at once: an array of structures of SIMD batches, run through the same formula.

#include <cstddef>
#include <experimental/simd>
#include <goishi/error.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <vector>

/// What Eigen must know of a batch: it is a scalar without an order.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  using Real = std::experimental::simd<T, Abi>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

namespace goishi {

/// Flying stones of any sizes, stored in groups of as many as a SIMD register holds. What one stone's flight is, is
/// written once, in `formula::free_flight`; here it runs on a register of stones.
///
///     StoneBatch<double> stones(1000);
///     stones.set(0, state, moments);   // and so on; a place that was not set stays at rest at the origin
///     stones.fly(gravity_W<double>(), 0.1);
template <std::floating_point T>
class StoneBatch {
 public:
  using Lanes = std::experimental::native_simd<T>;
  static constexpr std::size_t lanes = Lanes::size();

  struct Group {
    State<Lanes> state;
    TopRates<Lanes> rates;
  };

  explicit StoneBatch(std::size_t count) : count_(count), groups_((count + lanes - 1) / lanes, resting_group()) {}

  [[nodiscard]] std::size_t size() const { return count_; }

  /// Domain  as `free_flight`; index below `size()`; else InvalidArgument.
  void set(std::size_t index, const State<T>& state, const Moments<T>& moments) {
    require_index(index);
    require_state(state);
    const TopRates<T> rates = make_top_rates(moments);
    Group& group = groups_[index / lanes];
    const std::size_t lane = index % lanes;
    each_component(group.state, state, [&](Lanes& to, const T& from) { to[lane] = from; });
    group.rates.precession[lane] = rates.precession;
    group.rates.spin[lane] = rates.spin;
  }

  /// Domain  index below `size()`, else InvalidArgument.
  [[nodiscard]] State<T> get(std::size_t index) const {
    require_index(index);
    State<T> state;
    const std::size_t lane = index % lanes;
    each_component(state, groups_[index / lanes].state, [&](T& to, const Lanes& from) { to = from[lane]; });
    return state;
  }

  /// All stones fly for a time t.
  ///
  /// Domain  gravity and t finite, else InvalidArgument.
  /// Error   as `free_flight`, but for needles (4 I_a < I_t), which the scalar version treats with more digits (BATCH-1).
  /// Cost    everything inlined: a group's state then stays in registers, which halves the time.
  [[gnu::flatten]] void fly(const Vec3<T>& gravity, const T& t) {
    require(scalar::is_finite(T(gravity.sum())), "gravity", gravity.norm(), "must be finite");
    require(scalar::is_finite(t), "time", t, "must be finite");
    const Vec3<Lanes> g(Lanes(gravity.x()), Lanes(gravity.y()), Lanes(gravity.z()));
    const Lanes time(t);
    for (Group& group : groups_) {
      group.state = formula::free_flight(group.state, group.rates, g, time);
    }
  }

 private:
  static Group resting_group() {
    const Lanes zero(T(0)), one(T(1));
    const Vec3<Lanes> nothing(zero, zero, zero);
    return {.state = {.p_WB = nothing, .q_WB = {one, zero, zero, zero}, .v_WB = nothing, .L_W = nothing},
            .rates = {.precession = one, .spin = zero}};
  }

  void require_index(std::size_t index) const {
    require(index < count_, "index", index, "must be below the number of stones (", count_, ")");
  }

  template <class To, class From, class F>
  static void each_component(State<To>& to, const State<From>& from, F&& f) {
    for (int i = 0; i < 3; ++i) {
      f(to.p_WB[i], from.p_WB[i]);
      f(to.v_WB[i], from.v_WB[i]);
      f(to.L_W[i], from.L_W[i]);
    }
    for (int i = 0; i < 4; ++i) {
      f(to.q_WB.coeffs()[i], from.q_WB.coeffs()[i]);
    }
  }

  std::size_t count_;
  std::vector<Group> groups_;
};

}  // namespace goishi
