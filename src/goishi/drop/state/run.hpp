#pragma once
/// \file
/// A drop on its way: what its phases share.

#include <goishi/board/board.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/events.hpp>
#include <goishi/drop/settings.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/state.hpp>
#include <optional>

namespace goishi::detail {

/// The size of things for a stone in a gravity: what errors are measured by.
template <class T>
struct ContactScales {
  T length;     // [m] half the width
  T frequency;  // [1/s] √(g/length)
  T speed;      // [m/s] length · frequency
  T thinness;   // what of these a thin stone's rocking has: 1 from a height of 2/5 of the width on
};

template <Ordered T>
[[nodiscard]] ContactScales<T> contact_scales(const Stone<T>& stone, const T& strength) {
  const T length = outer_width(stone) / T(2);
  const T frequency = scalar::sqrt(T(strength / length));
  const T thinness = T(5) * stone.height / (T(2) * stone.width);
  return {.length = length,
          .frequency = frequency,
          .speed = T(frequency * length),
          .thinness = thinness < T(1) ? thinness : T(1)};
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
  const T &delta = *settings.rolling_resistance, &kappa = *settings.pivot_radius,
          &patch_radius = *settings.patch_radius;
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

/// What of a drop does not change on its way, and the state that it has reached.
template <class T>
struct Run {
  Stone<T> stone;
  RigidBody<T> body;
  std::optional<Board<T>> board;  // or none: the plane z = 0
  DropSettings<T> settings;       // filled
  ContactScales<T> scales;
  Mobility<T> mobility;
  ContactBody<T> contact_body;
  T reach;  // greatest distance of a point of the stone from its centre

  State<T> state;
  T time = T(0);
  T level = T(0);                       // z of the plane that is touched: the surface, or the floor
  Vec3<T> contact_W = Vec3<T>::Zero();  // the contact point, while there is one
  DropStatus status = DropStatus::moving;
  Ground ground = Ground::none;  // touched last
  T depth = T(0);                // [m] of `start_inside`
  bool lower_order = false;      // a contact on an edge, a side or at two places was passed by micro-impacts
  DropCounters counters = {};
  EventSink<T> sink = {};  // of the present call

  [[nodiscard]] T energy() const { return formula::energy(state, body, settings.gravity); }

  /// Tells of an event at the present time, after which the state is the present one; `fill` adds what else is known.
  template <class Fill>
  void record(EventKind kind, const State<T>& before, Fill&& fill) {
    ++counters.events;
    if (!sink) {
      return;
    }
    Event<T> event;
    event.kind = kind;
    event.time = time;
    event.before = before;
    event.after = state;
    event.energy = energy();
    fill(event);
    sink(event);
  }

  void record(EventKind kind, const State<T>& before) {
    record(kind, before, [](Event<T>&) {});
  }
};

/// A drop that is to begin.
template <Ordered T>
[[nodiscard]] Run<T> make_run(const Stone<T>& stone, const RigidBody<T>& body, const std::optional<Board<T>>& board,
                              const State<T>& start, const DropSettings<T>& settings, const T& time) {
  require_settings(settings, stone);
  require_state(start);
  require_positive("mass", body.mass);
  const Moments<T> moments{.axial = body.moments.z(), .transverse = body.moments.x()};
  require_physical(moments);
  require(!(body.moments.x() < body.moments.y()) && !(body.moments.y() < body.moments.x()), "moments",
          body.moments.transpose(), "must be those of a body with symmetry axis Bz");
  const T reach =
      outer_width(stone) / T(2) < stone.height / T(2) ? T(stone.height / T(2)) : T(outer_width(stone) / T(2));
  const T motion = scalar::sqrt(formula::dot(start.v_WB, start.v_WB)) +
                   reach / body.moments.minCoeff() * scalar::sqrt(formula::dot(start.L_W, start.L_W));
  const T strength = strength_of(settings.gravity, stone.width, motion);
  const DropSettings<T> all = filled(settings, stone, strength);
  return {.stone = stone,
          .body = body,
          .board = board,
          .settings = all,
          .scales = contact_scales(stone, strength),
          .mobility = formula::mobility(body),
          .contact_body =
              contact_body(stone, Moments<T>{moments.axial / body.mass, moments.transverse / body.mass}, all, strength),
          .reach = reach,
          .state = start,
          .time = time};
}

}  // namespace goishi::detail
