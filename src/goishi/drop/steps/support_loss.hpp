#pragma once
/// \file
/// Whether a stone in contact loses its support within a step whose ends are both clear: on a bent way it may leave the
/// surface and come back, and on the floor the board may stand between.

#include <goishi/drop/schemes/runge_kutta.hpp>
#include <goishi/drop/state/contact_state.hpp>
#include <optional>

namespace goishi::detail {

/// Searches the polynomial along a step, whose components `x` and `y` are the centre's and those from `axis` on, if any, the
/// symmetry axis'. What it calls clear is so, down to a share of 2^-depth of the step: there what has both ends clear counts.
template <Ordered T, std::size_t N, class PlaceAt>
class SupportLoss {
 public:
  SupportLoss(const Run<T>& run, const ContactState<T>& contact, const Interpolant<T, N>& along, std::size_t x,
              std::optional<std::size_t> axis, PlaceAt place_at)
      : run_(run), contact_(contact), along_(along), x_(x), axis_(axis), place_at_(place_at) {}

  /// A share at which the support is lost, before which it is not, but for the one that is told first; if there is one.
  [[nodiscard]] std::optional<T> operator()() { return within(view(T(0)), view(T(1)), axis_ ? 10 : 40); }

  [[nodiscard]] int views() const { return views_; }

 private:
  struct View {
    T share, x, y;
    ContactPlace<T> place;
    SupportLeft<T> left;
  };

  [[nodiscard]] View view(const T& share) {
    ++views_;
    const Array<T, N> y = along_(share);
    const ContactPlace<T> place = place_at_(y);
    return {share, y[x_], y[x_ + 1], place, contact_.support_left(run_, place, y[x_], y[x_ + 1])};
  }

  [[nodiscard]] std::optional<T> within(const View& from, const View& to, int depth) {
    if (depth == 0 || is_clear(from, to.share) || is_clear(to, from.share)) {
      return std::nullopt;
    }
    const View middle = view(T((from.share + to.share) / T(2)));
    if (!(T(0) < middle.left.gap)) {
      return middle.share;
    }
    const std::optional<T> first = within(from, middle, depth - 1);
    return first ? first : within(middle, to, depth - 1);
  }

  /// Whether the support lasts from what is seen to a share, by what it may change at most.
  [[nodiscard]] bool is_clear(const View& from, const T& to) const {
    const std::array<T, 5> x = along_.changes(x_, from.share, to), y = along_.changes(x_ + 1, from.share, to);
    T turn(0);  // of the axis
    if (axis_) {
      for (std::size_t i = 0; i < 3; ++i) {
        turn = turn + sum_of_sizes(along_.changes(*axis_ + i, from.share, to));
      }
    }
    if (!(contact_.level < T(0))) {
      const T swing = swing_of_contact(from, turn);
      const auto stays = [&](const T& place, const std::array<T, 5>& changes, const T& half) {
        T up = swing, down = -swing;
        for (const T& change : changes) {
          (T(0) < change ? up : down) = (T(0) < change ? up : down) + change;
        }
        return place + up < half && -half < place + down;
      };
      return stays(T(from.x + from.place.r.x()), x, run_.board->half_width) &&
             stays(T(from.y + from.place.r.y()), y, run_.board->half_length);
    }
    T nearer(0);  // along the normal, which goes on being one that separates
    for (std::size_t k = 0; k < x.size(); ++k) {
      nearer = nearer + scalar::max(T(0), T(-(from.left.n_x * x[k] + from.left.n_y * y[k])));
    }
    return nearer + T(4) * run_.reach * turn < from.left.gap;  // a point of the stone, and its height
  }

  /// By how much the contact point may move in the stone, seen from above, where the axis turns.
  [[nodiscard]] T swing_of_contact(const View& from, const T& turn) const {
    if (contact_.feature != Feature::rim) {
      return run_.stone.sphere_offset * turn;
    }
    const Vec3<T>& u = from.place.u;
    const T across = scalar::sqrt(T(scalar::sq(u.x()) + scalar::sq(u.y())));
    return T(2) * run_.reach * (T(2) * turn < across ? T(T(2) * turn / across) : T(1));
  }

  [[nodiscard]] static T sum_of_sizes(const std::array<T, 5>& changes) {
    T sum(0);
    for (const T& change : changes) {
      sum = sum + scalar::abs(change);
    }
    return sum;
  }

  const Run<T>& run_;
  const ContactState<T>& contact_;
  const Interpolant<T, N>& along_;
  std::size_t x_;
  std::optional<std::size_t> axis_;
  PlaceAt place_at_;
  int views_ = 0;
};

/// Whether a stone that at the ends of a step of length h is off losing its support, by `clear` [m] together, may lose it in
/// between: the step goes nowhere near as far as four times what its rates there say.
template <Ordered T>
[[nodiscard]] bool may_lose_support(const Run<T>& run, const Variables<T>& rate, const Variables<T>& other, const T& h,
                                    const T& clear) {
  const auto speed = [&](const Variables<T>& k) {
    return ContactState<T>::size_of(k[at::x], k[at::y]) +
           T(4) * run.reach * (scalar::abs(k[at::u]) + scalar::abs(k[at::u + 1]) + scalar::abs(k[at::u + 2]));
  };
  return !(T(4) * h * (speed(rate) + speed(other)) < clear);
}

}  // namespace goishi::detail
