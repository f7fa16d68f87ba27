#pragma once
/// \file
/// What a scene is made of: stones, pairs of neighbours, clusters, and what is due when.

#include <algorithm>
#include <array>
#include <cstddef>
#include <goishi/drop/drop.hpp>
#include <goishi/impact/body.hpp>
#include <goishi/scene/cluster/row.hpp>
#include <goishi/scene/events.hpp>
#include <goishi/scene/pairs/grid.hpp>
#include <goishi/scene/pairs/moving.hpp>
#include <limits>
#include <vector>

namespace goishi::detail {

/// The greatest distance of a point of a stone from its centre   [m].
template <Ordered T>
[[nodiscard]] T greatest_reach(const Stone<T>& stone) {
  return scalar::max(T(outer_width(stone) / T(2)), T(stone.height / T(2)));
}

/// Who moves a stone.
enum class Keeper { removed, drop, cluster, rest, hand };

/// What a cluster remembers of a contact from its last step.
template <class T>
struct ContactMemory {
  bool listed = false;  // in that step
  T time = T(0);        // [s] of the step's begin
  T weight = T(0);      // [s] how long its impulse has to last
  T last_impact = -std::numeric_limits<T>::infinity();
  Vec3<T> p = Vec3<T>::Zero(), n = Vec3<T>::Zero(), ra = Vec3<T>::Zero(), rb = Vec3<T>::Zero();
  Vec3<T> impulse = Vec3<T>::Zero(), torque = Vec3<T>::Zero();  // on the first
};

template <class T>
struct Member {
  Stone<T> stone;
  RigidBody<T> body;
  Mobility<T> mobility;
  T reach;  // [m] greatest distance of a point from the centre
  T lever;  // of `speed_bounds`
  T rolling, pivot;

  Keeper keeper = Keeper::rest;
  std::size_t drop = no_index, cluster = no_index;
  bool fresh = false;  // its drop has just begun
  State<T> state;      // of a cluster, a rest, a hand: at `time`
  T time = T(0);
  T nominal = T(0);                                            // [s] of a cluster: the time that its velocity is of
  Vec3<T> v_rate = Vec3<T>::Zero(), L_rate = Vec3<T>::Zero();  // of a cluster: means of its step
  T last_touch = T(0);                                         // [s] of a cluster: when another stone pushed it
  Vec3<T> w_W = Vec3<T>::Zero();                               // of a hand
  T hand_end = T(0);                                           // likewise
  T work = T(0);                                               // [J] that the hand has done
  DropPast<T> past = {};
  DropStatus status = DropStatus::moving;

  SpeedBounds<T> bounds = {};
  GridPlace<T> place = {};
  std::vector<std::size_t> pairs = {};
  std::array<ContactMemory<T>, 2> ground = {};  // board, floor
  std::size_t local = no_index;                 // its number in the step at work
};

template <class T>
struct PairRecord {
  std::size_t first = no_index, second = no_index;  // first < second
  bool exact = false;                               // `due` holds for their present motions only
  bool touches = false;                             // when it is due
  bool of_centres = false;
  T speed = T(0);  // [m/s] else `due` holds for relative speeds, of the centres or of the surfaces, up to this
  T due = T(0);    // [s] when to look again
  Vec3<T> n_W = Vec3<T>::Zero();  // that separated most, last time; 0: not yet looked at
  ContactMemory<T> contact;
};

template <class T>
struct Cluster {
  std::vector<std::size_t> members;
  bool asleep = false;
  T end = T(0);                 // [s] of its step
  int wait = 0, next_wait = 1;  // steps until rest is tried again
};

/// Things in numbered slots, the free ones used again.
template <class V>
class Slots {
 public:
  [[nodiscard]] std::size_t add(V value) {
    if (free_.empty()) {
      all_.push_back(std::move(value));
      return all_.size() - 1;
    }
    const std::size_t i = free_.back();
    free_.pop_back();
    all_[i] = std::move(value);
    return i;
  }
  void remove(std::size_t i) { free_.push_back(i); }
  [[nodiscard]] V& operator[](std::size_t i) { return all_[i]; }
  [[nodiscard]] const V& operator[](std::size_t i) const { return all_[i]; }
  [[nodiscard]] std::size_t size() const { return all_.size(); }

 private:
  std::vector<V> all_;
  std::vector<std::size_t> free_;
};

}  // namespace goishi::detail
