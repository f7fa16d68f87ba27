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
[[nodiscard]] ContactScales<T> contact_scales(const Stone<T>& stone, const T& gravity) {
  const T length = outer_width(stone) / T(2);
  const T frequency = scalar::sqrt(T(gravity / length));
  return {.length = length, .frequency = frequency, .speed = T(frequency * length)};
}

template <Ordered T>
[[nodiscard]] ContactBody<T> contact_body(const Stone<T>& stone, const Moments<T>& per_mass,
                                          const DropSettings<T>& settings) {
  const T g = scalar::sqrt(formula::dot(settings.gravity, settings.gravity));
  // The law of the patch is Coulomb's where there is no patch; infinite friction lets nothing slip.
  const bool patch = T(0) < settings.patch_radius && settings.friction < std::numeric_limits<T>::infinity();
  const bool dry = settings.friction_model == FrictionModel::coulomb_contensou && !patch;
  const T least_roll = settings.pivot_radius / T(100), least_pivot = settings.rolling_resistance / T(100);
  return {.stone = stone,
          .mobility = formula::mobility(T(1), per_mass),
          .gravity = settings.gravity,
          .strength = T(0) < g ? g : T(1),
          .friction = settings.friction,
          .rolling_resistance = settings.rolling_resistance < least_roll ? least_roll : settings.rolling_resistance,
          .pivot_radius = settings.pivot_radius < least_pivot ? least_pivot : settings.pivot_radius,
          .damping = settings.damping,
          .slip_coefficient = settings.slip_coefficient,
          .contensou = T(8) * settings.patch_radius / (T(3) * scalar::pi<T>()),
          .creep_square = scalar::sq(settings.creep_speed),
          .model = dry ? FrictionModel::dry : settings.friction_model,
          .resists = T(0) < settings.rolling_resistance || T(0) < settings.pivot_radius};
}

/// The scene, the settings, and the state reached.
template <class T>
struct Run {
  const Stone<T>& stone;
  const RigidBody<T>& body;
  const Board<T>* board;  // or none: the plane z = 0
  const DropSettings<T>& settings;
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
};

}  // namespace goishi::detail
