#pragma once
/// \file
/// What a drop answers: its events, its end, and what it cost.

#include <concepts>
#include <goishi/contact/contact.hpp>
#include <goishi/impact/material.hpp>
#include <goishi/motion/state.hpp>
#include <string_view>
#include <type_traits>
#include <vector>

namespace goishi {

enum class EventKind {
  start,
  impact,         // an impulse, and the flight goes on
  bounces_close,  // infinitely many bounces of a flat drop, summed: the time is when they end
  contact,        // the contact stays from here on
  stick,          // slip ends: the stone rolls
  slip,           // the stone begins to slip
  feature,        // the contact point passes between cap and bevel
  jam,            // no acceleration satisfies dry friction (Painlevé): an impulse stops the slip
  lift_off,       // the normal force would pull
  board_edge,     // the contact point leaves the playing surface
  side,           // the stone comes near the board's side while it touches the floor
  rest,
  woken,  // gravity, the board or a setting was changed
  push,   // an impulse was applied
  end     // of the run, moving
};

[[nodiscard]] constexpr std::string_view to_string(EventKind kind) {
  constexpr std::string_view names[] = {"start", "impact",  "bounces close", "contact",  "stick",
                                        "slip",  "feature", "jam",           "lift-off", "board edge",
                                        "side",  "rest",    "woken",         "push",     "end"};
  return names[static_cast<std::size_t>(kind)];
}

/// What is touched, or was last. `board` also stands for the plane of a scene without a board.
enum class Ground { none, board, floor };

[[nodiscard]] constexpr std::string_view to_string(Ground ground) {
  constexpr std::string_view names[] = {"none", "board", "floor"};
  return names[static_cast<std::size_t>(ground)];
}

template <class T>
struct Event {
  EventKind kind = EventKind::start;
  T time = scalar::unset<T>();  // [s]
  State<T> before;
  State<T> after;
  T energy = scalar::unset<T>();        // [J] after, in the drop's gravity, potential zero at the origin of W
  Vec3<T> impulse_W = Vec3<T>::Zero();  // [N s] on the stone
  Vec3<T> contact_W = Vec3<T>::Constant(scalar::unset<T>());  // [m] contact point, where there is one
  Vec3<T> normal_W = Vec3<T>::Constant(scalar::unset<T>());   // unit, out of what is touched
  Feature feature = Feature::rim;                             // of the stone
  OtherFeature other_feature = OtherFeature::surface;         // of what is touched
  ImpactOutcome outcome = ImpactOutcome::separating;          // of the impulse
};

enum class DropStatus {
  rest,
  rest_leaning,  // at rest on two contacts or an edge, come to by the scheme of lower order
  moving,        // the time, the horizon or `maximum_impacts` was reached first
  flies_on,      // nothing is ever touched again
  start_inside,  // the stone overlaps what it is dropped on: `depth`
  too_many_events,
  too_many_steps,
  not_converged
};

[[nodiscard]] constexpr std::string_view to_string(DropStatus status) {
  constexpr std::string_view names[] = {"rest",         "rest, leaning",   "moving",         "flies on",
                                        "start inside", "too many events", "too many steps", "not converged"};
  return names[static_cast<std::size_t>(status)];
}

/// Whether a drop that was left so could go on.
[[nodiscard]] constexpr bool is_under_way(DropStatus status) {
  return status == DropStatus::moving || status == DropStatus::too_many_events || status == DropStatus::too_many_steps;
}

/// What was computed, so that it can be seen what was not.
struct DropCounters {
  int impacts = 0;
  int root_steps = 0;           // of the searches for an impact, and of laws of impact that go step by step
  int separations = 0;          // normals those searches needed
  int contact_evaluations = 0;  // of the equations of the contact phase
  int steps_accepted = 0;
  int steps_rejected = 0;       // by the error control
  int evaluations_located = 0;  // along a step, to find the event in it, and there to find what begins
  int edge_impacts = 0;         // micro-impacts of the scheme of lower order
  int events = 0;

  /// All that is repeated, which `DropSettings::maximum_steps` bounds: a step of a search for an impact, and an evaluation
  /// in one for an event or for what begins at it, cost about a tenth of a step of the contact phase, and count so.
  [[nodiscard]] constexpr long long work() const {
    return 0LL + (root_steps + separations + evaluations_located) / 10 + steps_accepted + steps_rejected + edge_impacts;
  }
};

/// Where events go: nowhere, to the end of a vector, or to a callable. It refers to what it was made of, as long as a call
/// lasts.
template <class E>
class Sink {
 public:
  Sink() = default;
  Sink(std::vector<E>& events)  // NOLINT(google-explicit-constructor): an argument
      : to_(&events), call_([](void* to, const E& event) { static_cast<std::vector<E>*>(to)->push_back(event); }) {}
  template <std::invocable<const E&> F>
  requires(!std::same_as<std::remove_cvref_t<F>, Sink>)
      Sink(F&& function)  // NOLINT(google-explicit-constructor,bugprone-forwarding-reference-overload): likewise
      : to_(const_cast<void*>(static_cast<const void*>(&function))),
        call_([](void* to, const E& event) { (*static_cast<std::remove_reference_t<F>*>(to))(event); }) {}

  explicit operator bool() const { return call_ != nullptr; }
  void operator()(const E& event) const { call_(to_, event); }

 private:
  void* to_ = nullptr;
  void (*call_)(void*, const E&) = nullptr;
};

template <class T>
using EventSink = Sink<Event<T>>;

/// What a drop comes to, and how.
template <class T>
struct DropResult {
  DropStatus status = DropStatus::not_converged;
  Ground ground = Ground::none;  // touched last
  State<T> state;                // at the end
  T time = T(0);                 // [s]
  T depth = T(0);                // [m] of `start_inside`
  bool lower_order = false;      // a contact on an edge, a side or at two places was passed by micro-impacts
  std::vector<Event<T>> events;
  DropCounters counters;
};

}  // namespace goishi
