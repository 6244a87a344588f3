// SPDX-License-Identifier: MIT
// Symmetric positive definite linear systems, most of whose entries are zero.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trophic::backend::kernel {

/// A x = b by elimination in the order of the unknowns (A = L D L'), skipping zeros: with leaves of a tree before their parents
/// no zero is lost.
class SymmetricSystem {
 public:
  /// All zero, of size n.
  void reset(std::size_t n) {
    n_ = n;
    lower_.assign(n * n, 0.0);
  }

  /// A(i, j) = A(j, i).
  [[nodiscard]] double& operator()(std::size_t i, std::size_t j) { return i < j ? lower_[i * n_ + j] : lower_[j * n_ + i]; }

  /// The entries A(i, j) of column j, to be used for i >= j only.
  [[nodiscard]] double* column(std::size_t j) { return lower_.data() + j * n_; }

  /// Replaces `b` by x; A is used up.
  void solve(std::span<double> b) {
    for (std::size_t p = 0; p < n_; ++p) {
      const double* const pivot = column(p);
      const double inverse = 1.0 / pivot[p];
      for (std::size_t k = p + 1; k < n_; ++k) {
        if (pivot[k] == 0.0) continue;
        const double scale = pivot[k] * inverse;
        double* const __restrict target = column(k);
        for (std::size_t i = k; i < n_; ++i) target[i] -= scale * pivot[i];
        b[k] -= scale * b[p];
      }
    }
    for (std::size_t p = n_; p-- > 0;) {
      const double* const pivot = column(p);
      double sum = b[p];
      for (std::size_t i = p + 1; i < n_; ++i) sum -= pivot[i] * b[i];
      b[p] = sum / pivot[p];
    }
  }

 private:
  std::size_t n_ = 0;
  std::vector<double> lower_;  ///< column j, from its diagonal down, starts at j (n + 1)
};

}  // namespace trophic::backend::kernel
