#pragma once
/// \file
/// The separation of a stone and an edge of the board whose cores overlap: the greatest value over a quarter circle of
/// normals, certified by branch and bound.
///
/// Along an arc f(t) = p · n − S(n) has f'' + f = −ρ, ρ the radius of curvature of the stone's outline. With ρ >= ρ₀ between
/// two normals, f + ρ₀ is nowhere there above either of the lines w · n, w = (f + ρ₀, f') at the one and at the other. Where
/// the two meet bounds all between: an interval whose bound is not above the best value found has been searched.

#include <goishi/contact/arc.hpp>

namespace goishi::detail {

template <Ordered T>
class ArcSearch {
 public:
  /// `known`: a separation that has been found elsewhere; only what is above it counts.
  ArcSearch(const Stone<T>& stone, const Arc<T>& arc, const T& known) : stone_(stone), arc_(arc) {
    best_.value = known;
    // Above the round-off of a value and of a bound, below what is promised of the gap.
    small_ =
        T(16) * std::numeric_limits<T>::epsilon() *
        (T(2) * (stone.bevel_major_radius + stone.bevel_minor_radius) + scalar::abs(arc.p_a) + scalar::abs(arc.p_b));
    ArcPoint<T> from = at(T(1), T(0));
    const ArcPoint<T> last = at(T(0), T(1));
    accept(from);
    accept(last);
    // The caps' maxima are known in closed form; they divide the arc.
    T a[2], b[2];
    bool has[2];
    for (int i = 0; i < 2; ++i) {
      T reach;
      has[i] = has_cap_maximum(stone, arc, T(1 - 2 * i), a[i], b[i], reach);
    }
    const int one = has[0] && has[1] && b[0] > b[1] ? 1 : 0;
    for (const int i : {one, 1 - one}) {
      if (has[i]) {
        ArcPoint<T> crest = at(a[i], b[i]);
        crest.slope = T(0);
        accept(crest);
        search(from, crest, 0);
        from = crest;
      }
    }
    search(from, last, 0);
  }

  [[nodiscard]] const ArcPoint<T>& best() const { return best_; }
  [[nodiscard]] bool certified() const { return certified_; }

 private:
  [[nodiscard]] ArcPoint<T> at(const T& a, const T& b) const { return arc_point(stone_, arc_, a, b); }

  void accept(const ArcPoint<T>& point) {
    if (best_.value < point.value) {
      best_ = point;
    }
  }

  /// An upper bound of the separation between two normals, and the normal where their two lines meet.
  [[nodiscard]] T bound(const ArcPoint<T>& low, const ArcPoint<T>& high, T& a, T& b) const {
    const T rho = least_curvature(low, high);
    const T low_a = formula::arc_line_a(low, rho), low_b = formula::arc_line_b(low, rho);
    const T high_a = formula::arc_line_a(high, rho), high_b = formula::arc_line_b(high, rho);
    const T out = low_a - high_a, up = low_b - high_b;  // low is the lower line where out · n < 0
    a = low.a + high.a;
    b = low.b + high.b;
    T greatest = low.value < high.value ? high.value : low.value;
    const bool crosses = T(0) < (out * high.a + up * high.b) && (out * low.a + up * low.b) < T(0);
    if (crosses) {
      a = T(0) < up ? up : T(-up);
      b = T(0) < up ? T(-out) : out;
    }
    const T over = T(1) / scalar::sqrt(T(scalar::sq(a) + scalar::sq(b)));
    a = a * over;
    b = b * over;
    const auto lower_line = [&](const T& n_a, const T& n_b) {
      const T one = formula::arc_line(low, rho, n_a, n_b), other = formula::arc_line(high, rho, n_a, n_b);
      return one < other ? one : other;
    };
    const T middle = lower_line(a, b);
    greatest = greatest < middle ? middle : greatest;
    // A line's own crest, if it lies between.
    const auto crest = [&](const T& w_a, const T& w_b) {
      if (T(0) <= low.a * w_b - low.b * w_a && T(0) <= w_a * high.b - w_b * high.a) {
        const T size = scalar::sqrt(T(scalar::sq(w_a) + scalar::sq(w_b)));
        if (T(0) < size) {
          const T value = lower_line(T(w_a / size), T(w_b / size));
          greatest = greatest < value ? value : greatest;
        }
      }
    };
    crest(low_a, low_b);
    crest(high_a, high_b);
    return greatest;
  }

  /// A lower bound of the outline's radius of curvature between two normals: r on a cap; r₁ u_out²/(1 − m²)^{3/2} + r₂ on
  /// the rim, least where m is.
  [[nodiscard]] T least_curvature(const ArcPoint<T>& low, const ArcPoint<T>& high) const {
    const T low2 = scalar::sq(low.axial), high2 = scalar::sq(high.axial);
    const T least2 = low.axial * high.axial < T(0) ? T(0) : low2 < high2 ? low2 : high2;
    if (scalar::sq(stone_.joint_sine) <= least2) {
      return stone_.sphere_radius;
    }
    const T square = T(1) - least2;
    const T rim = formula::arc_rim_radius(stone_, arc_.u_out, square, scalar::sqrt(square));
    return rim < stone_.sphere_radius ? rim : stone_.sphere_radius;
  }

  void search(const ArcPoint<T>& low, const ArcPoint<T>& high, int depth) {
    constexpr int deepest = 40, most = 2000;
    T a, b;
    if (bound(low, high, a, b) <= best_.value + small_) {
      return;
    }
    if (depth == deepest || count_ == most) {
      certified_ = false;
      return;
    }
    ++count_;
    const ArcPoint<T> middle = T(0) < low.slope && high.slope < T(0) ? bracketed(stone_, arc_, low, high) : at(a, b);
    accept(middle);
    search(low, middle, depth + 1);
    search(middle, high, depth + 1);
  }

  const Stone<T>& stone_;
  const Arc<T>& arc_;
  ArcPoint<T> best_ = {};
  T small_;
  int count_ = 0;
  bool certified_ = true;
};

}  // namespace goishi::detail
