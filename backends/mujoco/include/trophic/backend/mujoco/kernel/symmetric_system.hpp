// SPDX-License-Identifier: MIT
// Symmetric positive definite linear systems, most of whose entries are zero.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <trophic/backend/mujoco/kernel/four.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// Neighbouring entries of a column, worked on at once.
[[nodiscard]] TROPHIC_LANES_INLINE Four load_block(const double* from) {
  Four block;
  std::memcpy(&block, from, sizeof block);
  return block;
}
TROPHIC_LANES_INLINE void store_block(double* to, const Four& block) {
  std::memcpy(to, &block, sizeof block);
}

/// A x = b by elimination in the order of the unknowns (A = L D L'), skipping zeros: with leaves of a tree before their parents
/// no zero is lost.
class SymmetricSystem {
 public:
  /// All zero, of size n.
  void reset(std::size_t n) {
    n_ = n;
    stride_ = block_start(n + block);
    lower_.assign(n_ * stride_, 0.0);
  }

  /// A(i, j) = A(j, i).
  [[nodiscard]] double& operator()(std::size_t i, std::size_t j) { return i < j ? column(i)[j] : column(j)[i]; }

  /// The entries A(i, j) of column j, for i >= j only; before them and after the end any number may be written, up to a block.
  [[nodiscard]] double* column(std::size_t j) { return lower_.data() + j * stride_; }

  /// Replaces `b` by x; A is used up.
  void solve(std::span<double> b) {
    factor_.resize(n_ * stride_);
    solution_.resize(stride_);
    for (std::size_t p = 0; p < n_; ++p) {
      column(p)[n_] = b[p];  // one more row, so that it is eliminated as well
      store_block(factor(p) + block_start(p), Four{});
    }
    for (std::size_t p = 0; p < n_; ++p) {
      const double* const pivot = column(p);
      const double inverse = 1.0 / pivot[p];
      for (std::size_t k = p + 1; k < n_; ++k) {
        const double scale = pivot[k] * inverse;
        factor(k)[p] = scale;
        if (scale == 0.0) continue;
        double* const __restrict target = column(k);
        for (std::size_t i = block_start(k); i < stride_; i += block) {
          store_block(target + i, load_block(target + i) - scale * load_block(pivot + i));
        }
      }
      solution_[p] = pivot[n_] * inverse;
    }
    // Each unknown, once known, is eliminated from all others, so the next one waits for only one operation.
    for (std::size_t p = n_; p-- > 0;) {
      b[p] = solution_[p];
      for (std::size_t i = 0; i < p; i += block) {
        store_block(solution_.data() + i, load_block(solution_.data() + i) - b[p] * load_block(factor(p) + i));
      }
    }
  }

 private:
  /// Columns are worked on in blocks of this many entries: what a block holds above the diagonal, or after the end, means
  /// nothing.
  static constexpr std::size_t block = four;
  [[nodiscard]] static constexpr std::size_t block_start(std::size_t i) { return i / block * block; }
  /// Row k of L, left of the diagonal.
  [[nodiscard]] double* factor(std::size_t k) { return factor_.data() + k * stride_; }

  std::size_t n_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> lower_;
  std::vector<double> factor_;
  std::vector<double> solution_;
};

}  // namespace trophic::backend::kernel
