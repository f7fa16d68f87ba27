#pragma once
/// \file
/// The stretches of a drop that are kept, so that its state can be told at any time of the past.

#include <algorithm>
#include <cstddef>
#include <goishi/drop/motion/stretch.hpp>
#include <vector>

namespace goishi {

/// Which side of an event that changes the state at once.
enum class Side { before, after };

namespace detail {

/// As many stretches as are wanted, the last ones, in the order of time.
template <class T>
class MotionLog {
 public:
  void keep(std::size_t most) {
    *this = {};
    most_ = most;
  }

  [[nodiscard]] bool keeps() const { return 0 < most_; }

  void add(const Stretch<T>& stretch) {
    if (stretches_.size() < most_) {
      stretches_.push_back(stretch);
      ends_.push_back(stretch.end);
      return;
    }
    stretches_[first_] = stretch;
    ends_[first_] = stretch.end;
    first_ = first_ + 1 == most_ ? 0 : first_ + 1;
  }

  [[nodiscard]] bool empty() const { return stretches_.empty(); }
  [[nodiscard]] std::size_t size() const { return stretches_.size(); }

  /// When the first one that is still there begins.
  [[nodiscard]] const T& begin() const { return stretches_[first_].begin; }

  /// The stretch of a time from `begin()` to the end of the last.
  [[nodiscard]] const Stretch<T>& at(const T& time, Side side) const {
    // The older ones stand from `first_` on, the newer ones before.
    const auto middle = ends_.begin() + static_cast<std::ptrdiff_t>(first_);
    const bool older = side == Side::after ? time < ends_.back() : time <= ends_.back();
    const auto from = older || first_ == 0 ? middle : ends_.begin();
    const auto to = older || first_ == 0 ? ends_.end() : middle;
    const auto found = side == Side::after ? std::upper_bound(from, to, time) : std::lower_bound(from, to, time);
    return stretches_[static_cast<std::size_t>((found == to ? found - 1 : found) - ends_.begin())];
  }

 private:
  std::vector<Stretch<T>> stretches_;
  std::vector<T> ends_;
  std::size_t first_ = 0, most_ = 0;
};

}  // namespace detail
}  // namespace goishi
