#pragma once
/// \file
/// A drop on its way: what its phases share.

#include <goishi/board/board.hpp>
#include <goishi/drop/events.hpp>
#include <goishi/drop/kinetics.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>

namespace goishi::detail {

/// The size of things for a stone in a gravity: what errors are measured by.
template <class T>
struct ContactScales {
  T length;     // [m] half the width
  T frequency;  // [1/s] √(g/length)
  T speed;      // [m/s] length · frequency
};

template <Ordered T>
[[nodiscard]] ContactScales<T> contact_scales(const Stone<T>& stone, const T& strength) {
  const T length = outer_width(stone) / T(2);
  const T frequency = scalar::sqrt(T(strength / length));
  return {.length = length, .frequency = frequency, .speed = T(frequency * length)};
}

/// What forces are measured by: |gravity|; without any, the acceleration that the first motion has on the stone's scale,
/// v²/w; where nothing moves either, any will do   [m/s²].
template <Ordered T>
[[nodiscard]] T strength_of(const Vec3<T>& gravity, const T& width, const T& speed) {
  const T g = scalar::sqrt(formula::dot(gravity, gravity));
  return T(0) < g ? g : T(0) < speed ? T(scalar::sq(speed) / width) : width;
}

template <Ordered T>
[[nodiscard]] ContactBody<T> contact_body(const Stone<T>& stone, const Moments<T>& per_mass,
                                          const DropSettings<T>& settings, const T& strength) {
  const T &delta = *settings.rolling_resistance, &kappa = *settings.pivot_radius, &patch_radius = *settings.patch_radius;
  // The law of the patch is Coulomb's where there is no patch; infinite friction lets nothing slip.
  const bool patch = T(0) < patch_radius && settings.friction < std::numeric_limits<T>::infinity();
  const bool dry = settings.friction_model == FrictionModel::coulomb_contensou && !patch;
  const T least_roll = kappa / T(100), least_pivot = delta / T(100);
  return {.stone = stone,
          .mobility = formula::mobility(T(1), per_mass),
          .gravity = settings.gravity,
          .strength = strength,
          .frequency = contact_scales(stone, strength).frequency,
          .friction = settings.friction,
          .rolling_resistance = delta < least_roll ? least_roll : delta,
          .pivot_radius = kappa < least_pivot ? least_pivot : kappa,
          .damping = settings.damping,
          .slip_coefficient = *settings.slip_coefficient,
          .contensou = T(8) * patch_radius / (T(3) * scalar::pi<T>()),
          .creep_square = scalar::sq(*settings.creep_speed),
          .model = dry ? FrictionModel::dry : settings.friction_model,
          .resists = T(0) < delta || T(0) < kappa};
}

/// The scene, the settings, and the state reached.
template <class T>
struct Run {
  const Stone<T>& stone;
  const RigidBody<T>& body;
  const Board<T>* board;  // or none: the plane z = 0
  DropSettings<T> settings;  // filled
  ContactScales<T> scales;
  TopRates<T> rates;
  Mobility<T> mobility;
  ContactBody<T> contact_body;
  T reach;  // greatest distance of a point of the stone from its centre

  State<T> state;
  T time = T(0);
  T level = T(0);                       // z of the plane that is touched: the surface, or the floor
  Vec3<T> contact_W = Vec3<T>::Zero();  // the contact point, while there is one
  Drop<T> result = {};

  [[nodiscard]] T energy() const { return formula::energy(state, body, settings.gravity); }

  /// Adds an event at the present time, after which the state is the present one.
  Event<T>& record(EventKind kind, const State<T>& before) {
    Event<T>& event = result.events.emplace_back();
    event.kind = kind;
    event.time = time;
    event.before = before;
    event.after = state;
    event.energy = energy();
    return event;
  }

  [[nodiscard]] bool has_room() const {
    return result.events.size() < static_cast<std::size_t>(settings.maximum_events);
  }

  /// Whether the budget of work allows another step, of any kind.
  [[nodiscard]] bool has_budget() const { return result.counters.work() < settings.maximum_steps; }

  [[nodiscard]] T left() const { return *settings.horizon - time; }
};

}  // namespace goishi::detail
