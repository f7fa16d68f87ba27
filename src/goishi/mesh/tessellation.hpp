#pragma once
/// \file
/// A stone as triangles, their corners on its surface.

#include <cmath>
#include <cstdint>
#include <goishi/error.hpp>
#include <goishi/mesh/mesh.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>
#include <goishi/shape/surface.hpp>
#include <string_view>

namespace goishi {

/// How a cap is cut. `subdivision`: a pentagon with a vertex in its centre, each edge divided into equal parts, so that all
/// triangles are near equilateral. `rings`: by longitude and latitude, as a globe is; long triangles at the pole.
enum class Tessellation { subdivision, rings };

[[nodiscard]] constexpr std::string_view to_string(Tessellation method) {
  return method == Tessellation::subdivision ? "subdivision" : "rings";
}

/// How finely. Around the rim there are five times `segments`; where they are more than the rings, the last ring takes them
/// up.
struct Fineness {
  int rings = 1;     // n, of triangles from the middle of a cap to its rim
  int rows = 0;      // m, of triangles across the bevel's band; 0: sharp
  int segments = 1;  // N, of a fifth of the rim; by subdivision at least n

  [[nodiscard]] bool operator==(const Fineness&) const = default;
};

constexpr int finest_level = 8;   // 2⁸ rings
constexpr int most_rings = 1024;  // and rows, and segments

/// How many triangles a mesh has: 10 n² by subdivision and 10 (N − n) to a finer rim, 10 N (2n − 1) by rings; 10 N m of the band.
[[nodiscard]] inline std::size_t triangle_count(Tessellation method, const Fineness& fineness) {
  const auto n = static_cast<std::size_t>(fineness.rings), m = static_cast<std::size_t>(fineness.rows);
  const auto N = static_cast<std::size_t>(fineness.segments);
  return 10 * (method == Tessellation::subdivision ? n * n + N - n : N * (2 * n - 1)) + 10 * N * m;
}

namespace detail {

/// A band, flat, as its curvatures measure it where it is widest: a length along the meridian counts √(1/r₂), around
/// √(1/(r₁ + r₂)). A triangle with the circumradius R is R²/2 off.
template <class T>
struct BandMetric {
  T across;  // from joint to joint   [√m]
  T around;  // a fifth of the rim
};

template <Ordered T>
[[nodiscard]] BandMetric<T> band_metric(const Stone<T>& stone) {
  return {T(T(2) * scalar::atan2(stone.joint_sine, stone.joint_cosine) * scalar::sqrt(stone.bevel_minor_radius)),
          T(T(2) * scalar::pi<T>() / T(5) * scalar::sqrt(T(outer_width(stone) / T(2))))};
}

/// Whether the corners of a row stand between those of the next: where the triangles between them are acute. Longer ones would
/// be the sides of a star.
template <Ordered T>
[[nodiscard]] bool staggers(const Stone<T>& stone, const Fineness& fineness) {
  const BandMetric<T> band = band_metric(stone);
  return band.around / static_cast<T>(2 * fineness.segments) * static_cast<T>(fineness.rows) < band.across;
}

/// The rows with which the triangles of a band are near equilateral, where it is widest.
template <Ordered T>
[[nodiscard]] int rows_for(const Stone<T>& stone, int segments) {
  if (!(T(0) < stone.bevel)) {
    return 0;
  }
  const BandMetric<T> band = band_metric(stone);
  const T rows = T(2) / scalar::sqrt(T(3)) * band.across / (band.around / static_cast<T>(segments));
  return rows < T(1) ? 1 : static_cast<int>(rows + T(1) / T(2));
}

}  // namespace detail

namespace formula {

/// Where the flat disc has the point j of 5k of ring k, of n, of `subdivision`: t = k/n, s its share of the way from
/// corner a to corner b of the pentagon, c the point of the circle as far around.
///
///     t (1 + κ (1 − t)) ((1 − t) ((1 − s) a + s b) + t c),   κ = sin α / 5
///
/// The middle is the regular pentagon, where all triangles are alike; the rim is the circle. κ, which makes up for
/// what the pentagon is smaller than the circle, was found by search: what it gives, MESH-5 measures.
/// Proof  derivations/mesh.cpp.
template <Field T>
[[nodiscard]] std::array<T, 2> pentagon_place(const T& t, const T& s, const std::array<T, 2>& a,
                                              const std::array<T, 2>& b, const std::array<T, 2>& c,
                                              const T& joint_sine) {
  const T u = T(1) - t;
  const T scale = t * (T(1) + joint_sine / T(5) * u);
  return {T(scale * (u * ((T(1) - s) * a[0] + s * b[0]) + t * c[0])),
          T(scale * (u * ((T(1) - s) * a[1] + s * b[1]) + t * c[1]))};
}

}  // namespace formula

namespace detail {

/// cos and sin of 2π i / count.
template <Ordered T>
[[nodiscard]] std::array<T, 2> around(int i, int count) {
  const T angle = T(2) * scalar::pi<T>() * static_cast<T>(i) / static_cast<T>(count);
  const auto [s, c] = scalar::sincos(angle);
  return {c, s};
}

/// Writes a stone's mesh, from the upper middle down.
template <class T>
class Tessellator {
 public:
  Tessellator(const Stone<T>& stone, Tessellation method, const Fineness& fineness)
      : stone_(stone),
        method_(method),
        n_(fineness.rings),
        m_(fineness.rows),
        segments_(fineness.segments),
        stagger_(method == Tessellation::subdivision && staggers(stone, fineness) ? 1 : 0),
        cap_angle_(scalar::atan2(stone.joint_cosine, stone.joint_sine)) {
    const auto n = static_cast<std::size_t>(n_), m = static_cast<std::size_t>(m_);
    const auto N = static_cast<std::size_t>(segments_);
    const std::size_t inner = method == Tessellation::subdivision ? 5 * n * (n - 1) / 2 : 5 * N * (n - 1);
    mesh_.points.reserve(2 * (1 + inner) + 5 * N * (m + 2));
    mesh_.normals.reserve(mesh_.points.capacity());
    mesh_.triangles.reserve(triangle_count(method, fineness));
  }

  [[nodiscard]] Mesh<T> operator()() && {
    cap(true);
    band();
    cap(false);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::uint32_t add(const Vec3<T>& point, const Vec3<T>& normal) {
    mesh_.points.push_back(point);
    mesh_.normals.push_back(normal);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  /// How many vertices ring k of a cap has.
  [[nodiscard]] int around_ring(int k) const {
    return method_ == Tessellation::subdivision && k < n_ ? 5 * k : 5 * segments_;
  }

  /// The upper cap, or the lower: its mirror image, turned by what the rows of the band have gained on the way.
  void cap(bool upper) {
    const T sign = upper ? T(1) : T(-1);
    const std::array<T, 2> turn = upper ? std::array<T, 2>{T(1), T(0)} : around<T>(m_ * stagger_, 10 * segments_);
    const auto vertex = [&](const T& x, const T& y, const T& sine, const T& cosine) {
      // (x, y) is the unit direction from the axis; sine and cosine are those of the normal's angle with the axis.
      const Vec3<T> normal(T(sine * (x * turn[0] - y * turn[1])), T(sine * (x * turn[1] + y * turn[0])), cosine);
      const T height = formula::cap_support_height(stone_, cosine, scalar::sq(sine));
      return add(formula::support_point(stone_.sphere_radius, normal, T(sign * height)),
                 {normal.x(), normal.y(), T(sign * normal.z())});
    };
    std::uint32_t inner = vertex(T(1), T(0), T(0), T(1));  // where ring k begins
    for (int k = 1; k <= n_; ++k) {
      const std::uint32_t outer = k < n_ ? ring(k, vertex) : rim(upper);
      join(k, inner, outer, upper);
      inner = outer;
    }
  }

  template <class Vertex>
  [[nodiscard]] std::uint32_t ring(int k, Vertex&& vertex) {
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    const T t = static_cast<T>(k) / static_cast<T>(n_);
    const int count = around_ring(k);
    T angle = cap_angle_ * t;
    auto [sine, cosine] = scalar::sincos(angle);
    for (int j = 0; j < count; ++j) {
      std::array<T, 2> direction = around<T>(j, count);
      if (method_ == Tessellation::subdivision) {
        const int side = j / k;
        const std::array<T, 2> place =
            formula::pentagon_place(t, T(static_cast<T>(j % k) / static_cast<T>(k)), around<T>(side, 5),
                                    around<T>(side + 1, 5), direction, stone_.joint_sine);
        const T from_axis = scalar::sqrt(T(scalar::sq(place[0]) + scalar::sq(place[1])));
        direction = {T(place[0] / from_axis), T(place[1] / from_axis)};
        angle = cap_angle_ * from_axis;
        const auto [s, c] = scalar::sincos(angle);
        sine = s;
        cosine = c;
      }
      static_cast<void>(vertex(direction[0], direction[1], sine, cosine));
    }
    return first;
  }

  /// The last ring of a cap, which is the first row of the band or its last. At a sharp rim each cap has its own; a ball
  /// has no edge there, and both caps the same.
  [[nodiscard]] std::uint32_t rim(bool upper) {
    const bool known = !upper && (0 < m_ || !(T(0) < stone_.joint_sine));
    return known ? last_row_ : last_row_ = row(upper ? 0 : m_, upper);
  }

  /// Row i of the band: the normal's elevation goes from the joint's to minus that in equal steps.
  [[nodiscard]] std::uint32_t row(int i, bool upper) {
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    T cosine = stone_.joint_cosine, sine = stone_.joint_sine, radius = stone_.joint_radius,
      height = stone_.bevel / T(2);
    if (0 < i && i < m_) {
      const T angle =
          scalar::atan2(stone_.joint_sine, stone_.joint_cosine) * static_cast<T>(m_ - 2 * i) / static_cast<T>(m_);
      const auto [s, c] = scalar::sincos(angle);
      cosine = c;
      sine = s;
      radius = stone_.bevel_major_radius + stone_.bevel_minor_radius * cosine;
      height = stone_.bevel_minor_radius * sine;
    } else if (i == m_ && !upper) {
      sine = -sine;
      height = -height;
    }
    for (int j = 0; j < 5 * segments_; ++j) {
      const std::array<T, 2> direction = around<T>(2 * j + i * stagger_, 10 * segments_);
      static_cast<void>(add({T(radius * direction[0]), T(radius * direction[1]), height},
                            {T(cosine * direction[0]), T(cosine * direction[1]), sine}));
    }
    return first;
  }

  void band() {
    for (int i = 1; i <= m_; ++i) {
      const std::uint32_t above = last_row_;
      last_row_ = row(i, false);
      const auto count = static_cast<std::uint32_t>(5 * segments_);
      for (std::uint32_t j = 0; j < count; ++j) {
        const std::uint32_t next = j + 1 == count ? 0 : j + 1;
        mesh_.triangles.push_back({above + j, last_row_ + j, above + next});
        mesh_.triangles.push_back({above + next, last_row_ + j, last_row_ + next});
      }
    }
  }

  /// The triangles between ring k − 1 and ring k.
  void join(int k, std::uint32_t inner, std::uint32_t outer, bool upper) {
    const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh_.triangles.push_back(upper ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    const auto inside = static_cast<std::uint32_t>(k == 1 ? 1 : around_ring(k - 1));
    const auto outside = static_cast<std::uint32_t>(around_ring(k));
    const auto in = [&](std::uint32_t j) { return inner + j % inside; };
    const auto out = [&](std::uint32_t j) { return outer + j % outside; };
    if (method_ == Tessellation::rings) {
      for (std::uint32_t j = 0; j < outside; ++j) {
        put(in(j), out(j), out(j + 1));
        if (1 < k) {
          put(in(j), out(j + 1), in(j + 1));
        }
      }
      return;
    }
    // On each side from corner to corner: whichever of the two has less of the way behind it goes on.
    const std::uint32_t of_inner = k == 1 ? 0 : inside / 5, of_outer = outside / 5;
    for (std::uint32_t side = 0; side < 5; ++side) {
      for (std::uint32_t i = 0, o = 0; i < of_inner || o < of_outer;) {
        const std::uint32_t a = in(side * of_inner + i), b = out(side * of_outer + o);
        if ((2 * o + 1) * of_inner < (2 * i + 1) * of_outer) {
          put(a, b, out(side * of_outer + ++o));
        } else {
          put(a, b, in(side * of_inner + ++i));
        }
      }
    }
  }

  const Stone<T>& stone_;
  Tessellation method_;
  int n_, m_, segments_;
  int stagger_;  // half segments from row to row
  T cap_angle_;
  std::uint32_t last_row_ = 0;
  Mesh<T> mesh_;
};

}  // namespace detail

/// That of a level: 2^level rings.
/// Domain  level from 0 to 8, else InvalidArgument.
template <Ordered T>
[[nodiscard]] Fineness fineness_of_level(const Stone<T>& stone, int level) {
  require(0 <= level && level <= finest_level, "level", level, "must be 0 … ", finest_level);
  return {.rings = 1 << level, .rows = detail::rows_for(stone, 1 << level), .segments = 1 << level};
}

/// A closed mesh of a stone, in B: its corners on the surface, each with the surface's normal there. Caps and band share
/// their vertices; at a sharp rim each cap has its own, at the same points (`weld`).
///
/// Domain  a stone of `make_stone`; 1 <= n, N <= 1024, n <= N by subdivision, 1 <= m <= 1024 of a bevelled stone and 0 of
///         a sharp one; else InvalidArgument.
/// Error   points within 2e-15 of the width from the surface, and no farther from the plane across their normal that
///         touches the stone (MESH-1). How far the triangles are: `deviation`.
template <Ordered T>
[[nodiscard]] Mesh<T> tessellate(const Stone<T>& stone, Tessellation method, const Fineness& fineness) {
  require(T(0) < stone.height, "stone", stone.height, "must be one of make_stone (its height is shown)");
  require(1 <= fineness.rings && fineness.rings <= most_rings, "rings", fineness.rings, "must be 1 … ", most_rings);
  const int least = method == Tessellation::subdivision ? fineness.rings : 1;
  require(least <= fineness.segments && fineness.segments <= most_rings, "segments", fineness.segments, "must be ",
          least, " … ", most_rings);
  const bool sharp = !(T(0) < stone.bevel);
  const int fewest = sharp ? 0 : 1, most = sharp ? 0 : most_rings;
  require(fewest <= fineness.rows && fineness.rows <= most, "rows", fineness.rows, "must be ", fewest, " … ", most,
          sharp ? " of a sharp stone" : " of a bevelled stone");
  return detail::Tessellator<T>(stone, method, fineness)();
}

/// The same by its level.
template <Ordered T>
[[nodiscard]] Mesh<T> tessellate(const Stone<T>& stone, Tessellation method, int level) {
  return tessellate(stone, method, fineness_of_level(stone, level));
}

}  // namespace goishi
