#pragma once
/// \file
/// The best of the board's normals in one octant, which is all that one corner of the board has: the surface, two sides,
/// three edges and the corner.

#include <goishi/contact/arc.hpp>
#include <goishi/contact/arc_search.hpp>
#include <goishi/contact/contact.hpp>
#include <goishi/vector.hpp>
#include <limits>

namespace goishi::detail {

/// What of the board a stone needs to be asked about, besides the surface.
struct Needs {
  bool side_x, side_y;
};

template <class T>
struct OctantMaximum {
  T value = -std::numeric_limits<T>::infinity();
  Vec3<T> n = Vec3<T>::Zero();
  bool certified = true;
};

/// All vectors have the signs of the octant taken off: the board's corner is at the origin and fills x, y, z < 0.
template <Ordered T>
class Octant {
 public:
  Octant(const Stone<T>& stone, const Vec3<T>& p, const Vec3<T>& u) : stone_(stone), p_(p), u_(u) {}

  /// The greatest separation. Mostly the cores are apart, and the first normal that meets the conditions of a maximum is
  /// the only one; else all are searched.
  [[nodiscard]] OctantMaximum<T> maximum(Needs needs) const {
    OctantMaximum<T> best;
    const bool found = needs.side_x && needs.side_y ? find_apart_at_corner(best)
                                                    : find_apart_on_edge(2, needs.side_x ? 0 : 1, false, best);
    if (!found) {
      search(needs, best);
    }
    return best;
  }

 private:
  [[nodiscard]] Arc<T> arc(int i, int j) const { return {p_[i], p_[j], u_[i], u_[j], u_[3 - i - j]}; }

  /// Of a length that normals are compared by.
  [[nodiscard]] T round_off() const {
    return T(16) * std::numeric_limits<T>::epsilon() * (outer_width(stone_) + scalar::sqrt(formula::dot(p_, p_)));
  }

  static void accept(int i, int j, const ArcPoint<T>& point, OctantMaximum<T>& best) {
    if (best.value < point.value) {
      best.value = point.value;
      best.n[i] = point.a;
      best.n[j] = point.b;
      best.n[3 - i - j] = T(0);
    }
  }

  static void accept(const T& value, const Vec3<T>& n, OctantMaximum<T>& best) {
    if (best.value < value) {
      best.value = value;
      best.n = n;
    }
  }

  /// `bounded`: the normal may also turn towards the third face, so that it must not gain there.
  [[nodiscard]] bool find_apart_on_edge(int i, int j, bool bounded, OctantMaximum<T>& best) const {
    const Arc<T> edge = arc(i, j);
    ArcPoint<T> found;
    const bool apart = find_apart(stone_, edge, found);
    accept(i, j, found, best);
    if (!apart || !bounded) {
      return apart;
    }
    const int k = 3 - i - j;
    return p_[k] + arc_point(stone_, edge, found.a, found.b).lever * u_[k] <= round_off();
  }

  /// The corner seen from the nearest point of the core's rim: where a sharp rim all but touches it, any digits that
  /// are left are a normal.
  [[nodiscard]] FromRim<T> corner_from_rim() const { return formula::from_rim<T>(p_, u_, stone_.bevel_major_radius); }

  [[nodiscard]] bool find_apart_at_corner(OctantMaximum<T>& best) const {
    const ArcPoint<T> surface = arc_point(stone_, arc(2, 0), T(1), T(0));
    if (!(T(0) < surface.slope) && !(T(0) < p_.y() + surface.lever * u_.y()) && is_apart(stone_, surface)) {
      accept(2, 0, surface, best);
      return true;
    }
    // The corner's distance from the core: from a cap's sphere, or from the rim.
    const FromRim<T> rim = corner_from_rim();
    const T upwards = rim.height < T(0) ? T(-1) : T(1);
    const bool cap = rim.beyond * stone_.sphere_offset <= stone_.bevel_major_radius * upwards * rim.height;
    const Vec3<T> away = cap ? formula::plus(p_, T(upwards * stone_.sphere_offset), u_) : rim.away;
    const T reach = scalar::sqrt(formula::dot(away, away));
    const T core = cap ? formula::core_sphere_distance(stone_, T(rim.beyond + stone_.bevel_major_radius),
                                                       T(upwards * rim.height), reach)
                       : reach;
    Vec3<T> n;
    if (is_inside(away) && T(0) < core && find_unit(away, n)) {
      try_normal(n, best);
      // Primal and dual: of a distance that is round-off, the direction is, too.
      if (core - stone_.bevel_minor_radius - best.value <= round_off()) {
        return true;
      }
    }
    // The edges, that first which lies across what is most wrong of it.
    int order[3] = {0, 1, 2};
    const auto sort = [&](int& a, int& b) {
      if (away[b] < away[a]) {
        std::swap(a, b);
      }
    };
    sort(order[0], order[1]);
    sort(order[1], order[2]);
    sort(order[0], order[1]);
    for (const int k : order) {
      if (find_apart_on_edge(k == 2 ? 0 : 2, k == 2 || k == 0 ? 1 : 0, true, best)) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] static bool is_inside(const Vec3<T>& n) { return T(0) < n.x() && T(0) < n.y() && T(0) < n.z(); }

  void search(Needs needs, OctantMaximum<T>& best) const {
    try_normal({T(0), T(0), T(1)}, best);
    if (needs.side_x) {
      search_edge(2, 0, best);
    }
    if (needs.side_y) {
      search_edge(2, 1, best);
    }
    if (needs.side_x && needs.side_y) {
      search_corner(best);
      search_edge(0, 1, best);
    }
  }

  /// From the normal of face i to that of face j, both included.
  void search_edge(int i, int j, OctantMaximum<T>& best) const {
    const Arc<T> edge = arc(i, j);
    const ArcSearch<T> search(stone_, edge, best.value);
    best.certified = best.certified && search.certified();
    accept(i, j, search.best(), best);
  }

  /// Normals inside the octant: those of the corner and a cap, or the corner and the rim.
  void search_corner(OctantMaximum<T>& best) const {
    const T& d = stone_.sphere_offset;
    for (const T& sign : {T(1), T(-1)}) {
      const Vec3<T> along = formula::plus(p_, T(sign * d), u_);
      if (is_inside(along)) {
        const Vec3<T> n = detail::unit(along);
        // To round-off: at the joint, neither cap nor rim would be met.
        if (-T(64) * std::numeric_limits<T>::epsilon() < sign * formula::dot(u_, n) - stone_.joint_sine) {
          try_normal(n, best);
        }
      }
    }
    const FromRim<T> rim = corner_from_rim();
    if (T(0) < rim.beyond && is_inside(rim.away)) {
      try_normal(detail::unit(rim.away), best);
    }
  }

  void try_normal(const Vec3<T>& n, OctantMaximum<T>& best) const {
    accept(T(formula::dot(n, p_) - support_value(stone_, see<T>(u_, n).direction)), n, best);
  }

  const Stone<T>& stone_;
  const Vec3<T>& p_;
  const Vec3<T>& u_;
};

}  // namespace goishi::detail
