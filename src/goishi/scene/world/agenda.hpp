#pragma once
/// \file
/// What is due when.

#include <array>
#include <cstddef>
#include <cstdint>
#include <goishi/scene/cluster/row.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace goishi::detail {

/// In this order, if at one time.
enum class DueKind : std::uint8_t { stretch, look, pair, step };

template <class T>
struct Due {
  T time;
  DueKind kind;
  std::size_t id;
};

/// Of each kind and number at most one time; the earliest first, at one time in the order of kinds and numbers. A heap of
/// four branches, which knows where in it each is.
template <Ordered T>
class Agenda {
 public:
  /// In place of what it was due before; never, if `time` is not finite.
  void set(DueKind kind, std::size_t id, const T& time) {
    if (!(time < std::numeric_limits<T>::infinity())) {
      remove(kind, id);
      return;
    }
    const Entry entry{time, code_of(kind, id)};
    std::vector<std::size_t>& places = places_[static_cast<std::size_t>(kind)];
    if (places.size() <= id) {
      places.resize(id + 1, no_index);
    }
    std::size_t at = places[id];
    if (at == no_index) {
      at = heap_.size();
      heap_.push_back(entry);
      rise(at, entry);
    } else if (entry < heap_[at]) {
      rise(at, entry);
    } else {
      sink(at, entry);
    }
  }

  void remove(DueKind kind, std::size_t id) {
    const std::vector<std::size_t>& places = places_[static_cast<std::size_t>(kind)];
    if (id < places.size() && places[id] != no_index) {
      take_off(places[id]);
    }
  }

  /// The next that is due up to a time, taken off; or nothing.
  [[nodiscard]] std::optional<Due<T>> next(const T& until) {
    if (heap_.empty() || until < heap_.front().time) {
      return std::nullopt;
    }
    const Entry first = heap_.front();
    take_off(0);
    return Due<T>{first.time, static_cast<DueKind>(first.code >> shift), id_of(first.code)};
  }

 private:
  static constexpr unsigned shift = 56;
  static constexpr std::uint64_t one = 1;
  static constexpr std::size_t branches = 4;

  struct Entry {
    T time;
    std::uint64_t code;

    [[nodiscard]] friend bool operator<(const Entry& a, const Entry& b) {
      return a.time < b.time || (!(b.time < a.time) && a.code < b.code);
    }
  };

  [[nodiscard]] static std::uint64_t code_of(DueKind kind, std::size_t id) {
    return (static_cast<std::uint64_t>(kind) << shift) | id;
  }

  [[nodiscard]] static std::size_t id_of(std::uint64_t code) { return code & ((one << shift) - 1U); }

  [[nodiscard]] std::size_t& place_of(const Entry& entry) { return places_[entry.code >> shift][id_of(entry.code)]; }

  void put(std::size_t at, const Entry& entry) {
    heap_[at] = entry;
    place_of(entry) = at;
  }

  /// An entry that belongs at a place or above it.
  void rise(std::size_t at, const Entry& entry) {
    while (0 < at) {
      const std::size_t above = (at - 1) / branches;
      if (!(entry < heap_[above])) {
        break;
      }
      put(at, heap_[above]);
      at = above;
    }
    put(at, entry);
  }

  /// An entry that belongs at a place or below it.
  void sink(std::size_t at, const Entry& entry) {
    for (;;) {
      const std::size_t first = branches * at + 1;
      if (heap_.size() <= first) {
        break;
      }
      const std::size_t end = first + branches < heap_.size() ? first + branches : heap_.size();
      std::size_t least = first;
      for (std::size_t k = first + 1; k < end; ++k) {
        least = heap_[k] < heap_[least] ? k : least;
      }
      if (!(heap_[least] < entry)) {
        break;
      }
      put(at, heap_[least]);
      at = least;
    }
    put(at, entry);
  }

  void take_off(std::size_t at) {
    place_of(heap_[at]) = no_index;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (at == heap_.size()) {
      return;
    }
    if (0 < at && last < heap_[(at - 1) / branches]) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }

  std::vector<Entry> heap_;
  std::array<std::vector<std::size_t>, 4> places_;  // of each kind, by number
};

}  // namespace goishi::detail
