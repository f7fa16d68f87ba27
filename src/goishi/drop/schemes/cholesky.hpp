#pragma once
/// \file
/// Small symmetric systems of equations, of a size that changes.

#include <array>
#include <cstddef>
#include <goishi/scalar.hpp>
#include <limits>

namespace goishi::detail {

/// A = C Cᵀ of a symmetric positive definite matrix of at most N rows, from its lower half.
template <Ordered T, std::size_t N>
class Cholesky {
 public:
  using Matrix = std::array<std::array<T, N>, N>;

  /// False where what a row adds to those before is round-off of it.
  [[nodiscard]] bool factor(const Matrix& a, std::size_t size) {
    size_ = size;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        T sum = a[i][j];
        for (std::size_t k = 0; k < j; ++k) {
          sum = sum - c_[i][k] * c_[j][k];
        }
        if (i != j) {
          c_[i][j] = sum / c_[j][j];
          continue;
        }
        if (!(std::numeric_limits<T>::epsilon() * a[i][i] < sum)) {
          return false;
        }
        c_[i][i] = scalar::sqrt(sum);
      }
    }
    return true;
  }

  /// x of A x = b, in place of b.
  void solve(std::array<T, N>& x) const {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        x[i] = x[i] - c_[i][k] * x[k];
      }
      x[i] = x[i] / c_[i][i];
    }
    for (std::size_t i = size_; i-- > 0;) {
      for (std::size_t k = i + 1; k < size_; ++k) {
        x[i] = x[i] - c_[k][i] * x[k];
      }
      x[i] = x[i] / c_[i][i];
    }
  }

 private:
  Matrix c_ = {};
  std::size_t size_ = 0;
};

}  // namespace goishi::detail
