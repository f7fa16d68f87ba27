#pragma once
/// \file
/// Free flight of many stones at once: an array of structures of SIMD batches, run through the same formula.

#include <algorithm>
#include <cstddef>
#include <experimental/simd>
#include <goishi/error.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <goishi/vector.hpp>
#include <vector>

/// What Eigen must know of a batch: it is a scalar without an order.
template <class T, class Abi>
struct Eigen::NumTraits<std::experimental::simd<T, Abi>> : Eigen::GenericNumTraits<std::experimental::simd<T, Abi>> {
  using Real = std::experimental::simd<T, Abi>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  // NOLINTBEGIN(readability-identifier-naming): Eigen's names
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  // NOLINTEND(readability-identifier-naming)
};

namespace goishi {

/// Flying stones of any sizes, stored in groups of as many as a SIMD register holds. What one stone's flight is, is
/// written once, in `formula::free_flight`; here it runs on a register of stones.
///
///     StoneBatch<double> stones(1000);
///     stones.set(0, state, moments);   // and so on; a place that was not set starts at rest at the origin
///     stones.fly(gravity_W<double>(), 0.1);
template <std::floating_point T>
class StoneBatch {
 public:
  using Lanes = std::experimental::native_simd<T>;
  static constexpr std::size_t lanes = Lanes::size();
  static constexpr std::size_t ahead = 4;  // groups that are fetched before it is their turn; more or less is slower

  struct Group {
    State<Lanes> state;
    Lanes transverse, axial;  // of `Mobility`
  };

  explicit StoneBatch(std::size_t count) : count_(count), groups_((count + lanes - 1) / lanes, resting_group()) {}

  [[nodiscard]] std::size_t size() const { return count_; }

  /// The stones i `lanes` … as they are stored, for what asks of all where they are; i below `size()` over `lanes`, rounded up.
  [[nodiscard]] const Group& group(std::size_t i) const { return groups_[i]; }

  /// Domain  as `free_flight`; index below `size()`; else InvalidArgument.
  void set(std::size_t index, const State<T>& state, const Moments<T>& moments) {
    require_index(index);
    require_state(state);
    const Mobility<T> mobility = make_mobility(moments);
    Group& group = groups_[index / lanes];
    const std::size_t lane = index % lanes;
    put(index, state);
    group.transverse[lane] = mobility.transverse;
    group.axial[lane] = mobility.axial;
    const T rate = mobility.transverse + scalar::abs(mobility.axial);
    fastest_ = std::max(
        fastest_, T(rate * (scalar::abs(state.L_W.x()) + scalar::abs(state.L_W.y()) + scalar::abs(state.L_W.z()))));
    greatest_rate_ = std::max(greatest_rate_, rate);
    reach_ = std::max(reach_, state.p_WB.template lpNorm<Eigen::Infinity>());
    speed_ = std::max(speed_, state.v_WB.template lpNorm<Eigen::Infinity>());
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
  /// Domain  gravity and t finite, and such that no stone could overflow: neither its t/I and the square of its angles, nor
  ///         its position, were it as far and as fast as any that was ever set; else InvalidArgument, and no stone has flown.
  /// Error   as `free_flight`, but for needles (4 I_a < I_t), which the scalar version treats with more digits (BATCH-1,
  ///         DOMAIN-7).
  /// Cost    everything inlined: a group's state then stays in registers, which halves the time. If a stone may turn
  ///         by 2³² rad, farther than the batch's sine counts, the stones fly one by one.
  void fly(const Vec3<T>& gravity, const T& t) {
    require(scalar::is_finite(gravity), "gravity", detail::length(gravity), "must be finite");
    require(scalar::is_finite(t), "time", t, "must be finite");
    const T time = scalar::abs(t), gain = time * gravity.template lpNorm<Eigen::Infinity>();
    const T speed = speed_ + gain, reach = reach_ + time * (speed_ + gain / T(2));
    const T angle = time * fastest_;
    require(scalar::is_finite(scalar::sq(angle)) && scalar::is_finite(T(time * greatest_rate_)) &&
                scalar::is_finite(T(T(3) * (reach + speed))),
            "time", t, "must not take a body farther than its arithmetic can count");
    reach_ = reach;
    speed_ = speed;
    if (angle < T(65536) * T(65536)) [[likely]] {
      fly_all(gravity, t);
    } else {
      for (std::size_t i = 0; i < count_; ++i) {
        const Group& group = groups_[i / lanes];
        const std::size_t lane = i % lanes;
        const Mobility<T> mobility{.linear = T(1), .transverse = group.transverse[lane], .axial = group.axial[lane]};
        put(i, free_flight(get(i), mobility, gravity, t));
      }
    }
  }

 private:
  [[gnu::flatten]] void fly_all(const Vec3<T>& gravity, const T& t) {
    const Vec3<Lanes> g(Lanes(gravity.x()), Lanes(gravity.y()), Lanes(gravity.z()));
    const Lanes time(t), one(T(1));
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      fetch(i + ahead);
      Group& group = groups_[i];
      const Mobility<Lanes> mobility{.linear = one, .transverse = group.transverse, .axial = group.axial};
      group.state = formula::free_flight(group.state, mobility, g, time);
    }
  }

  /// A group fills the processor's window, so that the loads of the next one would begin when it is done.
  void fetch([[maybe_unused]] std::size_t i) const {
#if defined(__GNUC__)
    constexpr std::size_t line = 64;
    if (i < groups_.size()) {
      const char* begin = reinterpret_cast<const char*>(&groups_[i]);
      for (std::size_t byte = 0; byte < sizeof(Group); byte += line) {
        __builtin_prefetch(begin + byte, 1);
      }
    }
#endif
  }

  void put(std::size_t index, const State<T>& state) {
    each_component(groups_[index / lanes].state, state, [&](Lanes& to, const T& from) { to[index % lanes] = from; });
  }

  static Group resting_group() {
    const Lanes zero(T(0)), one(T(1));
    const Vec3<Lanes> nothing(zero, zero, zero);
    return {.state = {.p_WB = nothing, .q_WB = {one, zero, zero, zero}, .v_WB = nothing, .L_W = nothing},
            .transverse = one,
            .axial = zero};
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
  // No stone that was ever set had more.
  T fastest_ = T(0);        // [rad/s] of turning, precession and spin added up
  T greatest_rate_ = T(1);  // of its inverse moments [1/(kg m²)]
  T reach_ = T(0);          // [m] of a coordinate
  T speed_ = T(0);          // [m/s]
};

}  // namespace goishi
