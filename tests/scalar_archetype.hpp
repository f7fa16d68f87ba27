#pragma once
/// \file
/// The least that a formula may ask of its scalar: made from int only, `double` and `<` deleted. What compiles with it is
/// a formula; what runs with it has no branch on a value. And a list of the numbers that formulas gave.

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <goishi/motion/state.hpp>
#include <goishi/rotation.hpp>
#include <goishi/scalar.hpp>
#include <limits>
#include <vector>

namespace goishi::archetype_test {

/// Nothing but + − × ÷ and whole numbers, and elementary functions if asked for. Eigen itself needs a little more: room
/// for a value (here NaN until it is set), and += to add up.
template <bool elementary, bool in_eigen = false>
class ArchetypeScalar {
 public:
  ArchetypeScalar() requires in_eigen = default;
  explicit ArchetypeScalar(int n) : value_(n) {}
  explicit ArchetypeScalar(std::same_as<double> auto) = delete;
  explicit ArchetypeScalar(std::same_as<float> auto) = delete;
  bool operator<(const ArchetypeScalar&) const = delete;
  bool operator==(const ArchetypeScalar&) const = delete;
  [[nodiscard]] double value() const { return value_; }

  using Self = ArchetypeScalar;
  friend Self operator+(const Self& x, const Self& y) { return of(x.value_ + y.value_); }
  friend Self operator-(const Self& x, const Self& y) { return of(x.value_ - y.value_); }
  friend Self operator*(const Self& x, const Self& y) { return of(x.value_ * y.value_); }
  friend Self operator/(const Self& x, const Self& y) { return of(x.value_ / y.value_); }
  friend Self operator-(const Self& x) { return of(-x.value_); }
  friend Self& operator+=(Self& x, const Self& y) requires in_eigen { return x = x + y; }
  friend Self sqrt(const Self& x) requires elementary { return of(std::sqrt(x.value_)); }
  friend Self sin(const Self& x) requires elementary { return of(std::sin(x.value_)); }
  friend Self cos(const Self& x) requires elementary { return of(std::cos(x.value_)); }
  friend Self atan2(const Self& y, const Self& x) requires elementary { return of(std::atan2(y.value_, x.value_)); }

 private:
  static Self of(double value) {
    Self result(0);
    result.value_ = value;
    return result;
  }
  double value_ = std::numeric_limits<double>::quiet_NaN();
};

using Archetype = ArchetypeScalar<false>;
using ElementaryArchetype = ArchetypeScalar<true>;
using VectorArchetype = ArchetypeScalar<false, true>;
using ElementaryVectorArchetype = ArchetypeScalar<true, true>;

}  // namespace goishi::archetype_test

/// As for a symbol: no order, no precision.
template <bool elementary>
struct Eigen::NumTraits<goishi::archetype_test::ArchetypeScalar<elementary, true>> {
  using Real = goishi::archetype_test::ArchetypeScalar<elementary, true>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

namespace goishi::archetype_test {

inline double value_of(double x) {
  return x;
}
template <bool elementary>
double value_of(const ArchetypeScalar<elementary, true>& x) {
  return x.value();
}

/// The numbers that formulas gave.
class Numbers {
 public:
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) {
      values.push_back(value_of(matrix.derived().coeff(i % matrix.rows(), i / matrix.rows())));
    }
  }
  template <class T>
  void add(const Quat<T>& q) {
    add(q.coeffs());
  }
  template <class T>
  void add(const goishi::State<T>& state) {
    add(state.p_WB);
    add(state.q_WB);
    add(state.v_WB);
    add(state.L_W);
  }
  void add(const goishi::Field auto& scalar) { values.push_back(value_of(scalar)); }

  std::vector<double> values;
};

/// 4 ulp: Eigen may add up the doubles in another order.
inline void expect_same(const Numbers& archetype, const Numbers& expected) {
  ASSERT_EQ(archetype.values.size(), expected.values.size());
  for (std::size_t i = 0; i < expected.values.size(); ++i) {
    EXPECT_DOUBLE_EQ(archetype.values[i], expected.values[i]) << "number " << i;
  }
}

}  // namespace goishi::archetype_test
