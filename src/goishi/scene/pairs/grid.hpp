#pragma once
/// \file
/// Which stones are near which, seen from above: a uniform grid, its cells in a table of lists.

#include <cmath>
#include <cstddef>
#include <goishi/scene/cluster/row.hpp>
#include <vector>

namespace goishi::detail {

/// Where a stone stands in the grid.
template <class T>
struct GridPlace {
  T x = T(0), y = T(0);  // [m] where it was last looked at
  long long column = 0, line = 0;
  std::size_t before = no_index, after = no_index;  // in its list
  bool linked = false;
};

/// The stones are told by their numbers; each has a place, kept by who asks.
template <Ordered T>
class Grid {
 public:
  /// Empty, with cells of a size   [m].
  void reset(const T& cell) {
    cell_ = cell;
    heads_.assign(heads_.empty() ? 64 : heads_.size(), no_index);
    count_ = 0;
  }

  /// Puts a stone where it is now. Its place is `places(i)`.
  template <class Places>
  void link(std::size_t i, const T& x, const T& y, Places&& places) {
    if (heads_.size() < 2 * ++count_) {
      grow(places);
    }
    GridPlace<T>& place = places(i);
    place.x = x;
    place.y = y;
    place.column = number_of(x);
    place.line = number_of(y);
    insert(i, places);
  }

  template <class Places>
  void unlink(std::size_t i, Places&& places) {
    GridPlace<T>& place = places(i);
    (place.before == no_index ? heads_[list_of(place.column, place.line)] : places(place.before).after) = place.after;
    if (place.after != no_index) {
      places(place.after).before = place.before;
    }
    place.linked = false;
    --count_;
  }

  /// All stones in the cell of another one and in the eight around it, that one included.
  template <class Places, class F>
  void near(std::size_t i, Places&& places, F&& f) const {
    around(places(i).column, places(i).line, places, f);
  }
  /// The same of a place.
  template <class Places, class F>
  void near(const T& x, const T& y, Places&& places, F&& f) const {
    around(number_of(x), number_of(y), places, f);
  }

 private:
  template <class Places, class F>
  void around(long long column, long long line, Places&& places, F&& f) const {
    if (count_ == 0) {
      return;
    }
    for (long long x = column - 1; x <= column + 1; ++x) {
      for (long long y = line - 1; y <= line + 1; ++y) {
        for (std::size_t k = heads_[list_of(x, y)]; k != no_index; k = places(k).after) {
          if (places(k).column == x && places(k).line == y) {
            f(k);
          }
        }
      }
    }
  }

  [[nodiscard]] long long number_of(const T& x) const {
    using std::floor;
    const T most(1e15);
    const T cell = floor(T(x / cell_));
    return static_cast<long long>(cell < -most ? T(-most) : most < cell ? most : cell);
  }

  [[nodiscard]] std::size_t list_of(long long x, long long y) const {
    const auto mix = static_cast<unsigned long long>(x) * 0x9E3779B97F4A7C15ULL +
                     static_cast<unsigned long long>(y) * 0xC2B2AE3D27D4EB4FULL;
    return static_cast<std::size_t>(mix >> 32U) & (heads_.size() - 1);
  }

  template <class Places>
  void insert(std::size_t i, Places&& places) {
    GridPlace<T>& place = places(i);
    std::size_t& head = heads_[list_of(place.column, place.line)];
    place.before = no_index;
    place.after = head;
    if (head != no_index) {
      places(head).before = i;
    }
    head = i;
    place.linked = true;
  }

  template <class Places>
  void grow(Places&& places) {
    std::vector<std::size_t> all;
    for (std::size_t head : heads_) {
      for (; head != no_index; head = places(head).after) {
        all.push_back(head);
      }
    }
    heads_.assign(2 * heads_.size(), no_index);
    for (const std::size_t i : all) {
      insert(i, places);
    }
  }

  T cell_ = T(1);
  std::vector<std::size_t> heads_;  // a power of two
  std::size_t count_ = 0;
};

}  // namespace goishi::detail
