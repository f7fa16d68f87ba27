#pragma once
/// \file
/// The gaps between many stones and a plane at once: groups of as many stones as a SIMD register holds, by the formulas
/// that one stone goes through.

#include <cstddef>
#include <experimental/simd>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/error.hpp>
#include <goishi/motion/batch.hpp>
#include <limits>
#include <span>
#include <vector>

namespace goishi {

/// The gaps of a register of stones: height over the plane, μ = u · n (of either sign), and n_r² = |n − μ u|². Both
/// formulas run, and each lane takes its own: a cap or the rim.
///
/// Domain  SIMD batches of float or double.
template <scalar::detail::SimdBatch Lanes>
[[nodiscard]] Lanes plane_gap(const Stone<Lanes>& stone, const Lanes& height, const Lanes& signed_axial,
                              const Lanes& radial_square) {
  using std::experimental::abs;
  const Lanes axial = abs(signed_axial);
  const Lanes radial = scalar::sqrt(radial_square);
  Lanes gap = formula::rim_gap(stone, height, radial);
  where(radial * stone.joint_sine <= axial * stone.joint_cosine, gap) =
      formula::cap_gap(stone, height, axial, radial_square);
  return gap;
}

/// Stones of any sizes, to be asked for their gaps to planes, in poses of their own or in those of a batch that flies.
///
///     PlaneBatch<double> stones(1000);
///     stones.set(0, stone, pose);      // and so on; a place that was not set has the gap NaN
///     std::vector<double> gaps(1000);
///     stones.gaps(Plane<double>{}, gaps);
///     stones.gaps(flying, Plane<double>{}, gaps);  // of a `StoneBatch`, where its stones are now; nothing is copied
template <std::floating_point T>
class PlaneBatch {
 public:
  using Lanes = std::experimental::native_simd<T>;
  static constexpr std::size_t lanes = Lanes::size();

  explicit PlaneBatch(std::size_t count) : count_(count), groups_((count + lanes - 1) / lanes) {}

  [[nodiscard]] std::size_t size() const { return count_; }

  /// Domain  a pose with a unit attitude, its |x| + |y| + |z| below a quarter of the greatest number; a stone of `make_stone`;
  ///         index below `size()`; else InvalidArgument.
  void set(std::size_t index, const Stone<T>& stone, const Pose<T>& pose) {
    require_index(index);
    const detail::Placed<T> placed = detail::place(stone, pose);
    const Vec3<T> size = placed.p_W.cwiseAbs();
    require(size.x() + size.y() + size.z() < most, "position", pose.p_WB.transpose(),
            "must not be so far that a gap is no number");
    set(index, stone);
    Group& group = groups_[index / lanes];
    const std::size_t lane = index % lanes;
    for (std::size_t i = 0; i < 3; ++i) {
      group.p_W[i][lane] = placed.p_W[static_cast<Eigen::Index>(i)];
      group.u_W[i][lane] = placed.u_W[static_cast<Eigen::Index>(i)];
    }
  }

  /// Only the stone, whose pose a batch that flies has.
  void set(std::size_t index, const Stone<T>& stone) {
    require_index(index);
    detail::require_stone(stone);
    Group& group = groups_[index / lanes];
    const std::size_t lane = index % lanes;
    group.stone.height[lane] = stone.height;
    group.stone.sphere_offset[lane] = stone.sphere_offset;
    group.stone.bevel_major_radius[lane] = stone.bevel_major_radius;
    group.stone.bevel_minor_radius[lane] = stone.bevel_minor_radius;
    group.stone.joint_cosine[lane] = stone.joint_cosine;
    group.stone.joint_sine[lane] = stone.joint_sine;
  }

  /// The gap of every stone   [m], as `separation` gives it.
  ///
  /// Domain  a unit normal, an offset below a quarter of the greatest number, room for `size()` gaps; else InvalidArgument.
  /// Error   as `separation`'s. The last bits differ: a batch adds up its three products in another order. Stones of any
  ///         sizes side by side (DOMAIN-13).
  void gaps(const Plane<T>& plane, std::span<T> gaps) const {
    ask(plane, gaps, [&](std::size_t i, const Lanes(&n)[3], const Lanes& offset) {
      return gap_of(groups_[i].stone, groups_[i].p_W, groups_[i].u_W, n, offset);
    });
  }

  /// The same where the stones of a batch are now.
  ///
  /// Domain  as above, and a batch of as many stones; else InvalidArgument.
  void gaps(const StoneBatch<T>& flying, const Plane<T>& plane, std::span<T> gaps) const {
    require(flying.size() == count_, "stones", flying.size(), "must be as many as the shapes (", count_, ")");
    ask(plane, gaps, [&](std::size_t i, const Lanes(&n)[3], const Lanes& offset) {
      const Vec3<Lanes>& p = flying.group(i).state.p_WB;
      const Vec3<Lanes> u = formula::unit_axis(flying.group(i).state.q_WB);
      return gap_of(groups_[i].stone, {p.x(), p.y(), p.z()}, {u.x(), u.y(), u.z()}, n, offset);
    });
  }

 private:
  static constexpr T most = std::numeric_limits<T>::max() / T(4);

  /// Only what a gap needs. Not on Eigen, which would have to know batches.
  struct Group {
    Stone<Lanes> stone;  // its other fields stay NaN
    Lanes p_W[3] = {unset(), unset(), unset()};
    Lanes u_W[3] = {unset(), unset(), unset()};

    static Lanes unset() { return scalar::unset<Lanes>(); }
  };

  void require_index(std::size_t index) const {
    require(index < count_, "index", index, "must be below the number of stones (", count_, ")");
  }

  static Lanes dot(const Lanes (&a)[3], const Lanes (&b)[3]) { return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]); }

  static Lanes gap_of(const Stone<Lanes>& stone, const Lanes (&p)[3], const Lanes (&u)[3], const Lanes (&n)[3],
                      const Lanes& offset) {
    const Lanes axial = dot(u, n);
    const Lanes radial[3] = {n[0] - axial * u[0], n[1] - axial * u[1], n[2] - axial * u[2]};
    return plane_gap(stone, Lanes(dot(n, p) - offset), axial, dot(radial, radial));
  }

  /// `gap(i, n, offset)` of every group.
  template <class Gap>
  void ask(const Plane<T>& plane, std::span<T> gaps, const Gap& gap) const {
    detail::require_direction(plane.n_W);
    require(-most < plane.offset && plane.offset < most, "offset", plane.offset,
            "must not be so far that a gap is no number");
    require(gaps.size() == count_, "gaps", gaps.size(), "must have room for each stone (", count_, ")");
    const Lanes n[3] = {plane.n_W.x(), plane.n_W.y(), plane.n_W.z()};
    const Lanes offset(plane.offset);
    const std::size_t whole = count_ / lanes;
    for (std::size_t i = 0; i < whole; ++i) {
      gap(i, n, offset).copy_to(gaps.data() + i * lanes, std::experimental::element_aligned);
    }
    if (whole < groups_.size()) {
      const Lanes last = gap(whole, n, offset);
      for (std::size_t i = whole * lanes; i < count_; ++i) {
        gaps[i] = last[i % lanes];
      }
    }
  }

  std::size_t count_;
  std::vector<Group> groups_;
};

}  // namespace goishi
