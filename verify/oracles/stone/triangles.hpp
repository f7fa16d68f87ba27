#pragma once
/// \file
/// Distance of a point from a heap of triangles, one by one.

#include <array>
#include <vector>

namespace goishi::verify {

using Point3 = std::array<double, 3>;

class Triangles {
 public:
  void add(const Point3& a, const Point3& b, const Point3& c);
  /// The least distance of p from any of them.
  [[nodiscard]] double distance(const Point3& p) const;

 private:
  struct One {
    Point3 a, b, c;
    Point3 centre;
    double reach;  // of its corners from the centre
  };
  std::vector<One> all_;
};

/// Of one triangle: over its inside the distance from its plane, else that of the nearest edge.
[[nodiscard]] double triangle_distance(const Point3& p, const Point3& a, const Point3& b, const Point3& c);

}  // namespace goishi::verify
