// SPDX-License-Identifier: MIT
// Symmetric positive definite linear systems, most of whose entries are zero.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <trophic/backend/mujoco/kernel/lanes.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// Neighbouring entries of a column, worked on at once.
[[nodiscard]] TROPHIC_LANES_INLINE Real load_block(const double* from) {
  Real block;
  std::memcpy(&block, from, sizeof block);
  return block;
}
TROPHIC_LANES_INLINE void store_block(double* to, const Real& block) {
  std::memcpy(to, &block, sizeof block);
}

/// A x = b by elimination in the order of the unknowns (A = L D L'), skipping zeros: with leaves of a tree before their parents
/// no zero is lost.
class SymmetricSystem {
 public:
  /// Columns are worked on in blocks of this many entries: what a block holds above the diagonal, or after the end, means
  /// nothing.
  static constexpr std::size_t block = lane_count;
  [[nodiscard]] static constexpr std::size_t block_start(std::size_t i) { return i / block * block; }

  /// All zero, of size n.
  void reset(std::size_t n) {
    n_ = n;
    column_size_ = block_start(n + block - 1);
    lower_.assign(n_ * column_size_, 0.0);
  }

  /// A(i, j) = A(j, i).
  [[nodiscard]] double& operator()(std::size_t i, std::size_t j) { return i < j ? column(i)[j] : column(j)[i]; }

  /// The entries A(i, j) of column j, to be used for i >= j only.
  [[nodiscard]] double* column(std::size_t j) { return lower_.data() + j * column_size_; }
  /// Entries of a column with those after the end.
  [[nodiscard]] std::size_t column_size() const { return column_size_; }

  /// Replaces `b` by x; A is used up.
  void solve(std::span<double> b) {
    for (std::size_t p = 0; p < n_; ++p) {
      const double* const pivot = column(p);
      const double inverse = 1.0 / pivot[p];
      for (std::size_t k = p + 1; k < n_; ++k) {
        if (pivot[k] == 0.0) continue;
        const double scale = pivot[k] * inverse;
        double* const __restrict target = column(k);
        for (std::size_t i = block_start(k); i < column_size_; i += block) {
          store_block(target + i, load_block(target + i) - scale * load_block(pivot + i));
        }
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
  std::size_t column_size_ = 0;
  std::vector<double> lower_;
};

}  // namespace trophic::backend::kernel
