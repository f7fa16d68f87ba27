#pragma once
/// \file
/// Fractions and symbols as a scalar for shipped algorithms that have constants and compare nothing.

#include <concepts>
#include <stdexcept>
#include <vector>

#include "algebra.hpp"

namespace derivation {

/// An exact fraction, also at compile time, or a symbolic expression.
class Exact {
 public:
  constexpr Exact() = default;
  template <std::integral Integer>
  constexpr Exact(Integer n) : over_(n) {}
  explicit Exact(const ex& symbolic) : place_(static_cast<int>(table().size())) { table().push_back(symbolic); }

  [[nodiscard]] ex value() const {
    return place_ < 0 ? ex(static_cast<long>(over_)) / static_cast<long>(under_)
                      : table().at(static_cast<std::size_t>(place_));
  }

  friend constexpr Exact operator-(const Exact& a) {
    return a.place_ < 0 ? Exact(-a.over_, a.under_) : Exact(-a.value());
  }
  friend constexpr Exact operator/(const Exact& a, const Exact& b) {
    return a.is_integer() && b.is_integer() ? Exact(a.over_, b.over_) : Exact(a.value() / b.value());
  }
  friend Exact operator+(const Exact& a, const Exact& b) { return Exact(a.value() + b.value()); }
  friend Exact operator-(const Exact& a, const Exact& b) { return Exact(a.value() - b.value()); }
  friend Exact operator*(const Exact& a, const Exact& b) { return Exact(a.value() * b.value()); }

  // What `Ordered` asks for, and no formula here uses.
  friend Exact sqrt(const Exact& /*x*/) { throw std::logic_error("Exact: no root"); }
  friend Exact sin(const Exact& /*x*/) { throw std::logic_error("Exact: no sine"); }
  friend Exact cos(const Exact& /*x*/) { throw std::logic_error("Exact: no cosine"); }
  friend Exact atan2(const Exact& /*y*/, const Exact& /*x*/) { throw std::logic_error("Exact: no angle"); }
  friend bool operator<(const Exact& /*a*/, const Exact& /*b*/) { throw std::logic_error("Exact: no order"); }

 private:
  constexpr Exact(long long over, long long under) : over_(over), under_(under) {}
  [[nodiscard]] constexpr bool is_integer() const { return place_ < 0 && under_ == 1; }
  static std::vector<ex>& table() {
    static std::vector<ex> symbolic;
    return symbolic;
  }

  long long over_ = 0, under_ = 1;
  int place_ = -1;  // in the table, of what is symbolic
};

}  // namespace derivation
