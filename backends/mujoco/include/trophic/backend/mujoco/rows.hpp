// SPDX-License-Identifier: MIT
// Numbers of robots whose bodies may differ.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trophic::backend::mujoco {

/// One row of numbers per robot; rows may differ in length.
class Rows {
 public:
  Rows(std::size_t rows, std::size_t width) : values_(rows * width), first_(rows + 1) {
    for (std::size_t i = 0; i <= rows; ++i) first_[i] = i * width;
  }

  [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
  [[nodiscard]] std::span<double> operator[](std::size_t i) { return {values_.data() + first_[i], first_[i + 1] - first_[i]}; }
  [[nodiscard]] std::span<const double> operator[](std::size_t i) const {
    return {values_.data() + first_[i], first_[i + 1] - first_[i]};
  }

  /// All rows, one after the other.
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  void set_values(const std::vector<double>& values) { values_ = values; }

  /// Replaces a row by zeros.
  void reset(std::size_t i, std::size_t width) {
    const auto row = values_.begin() + static_cast<std::ptrdiff_t>(first_[i]);
    const std::size_t old_width = first_[i + 1] - first_[i];
    values_.insert(values_.erase(row, row + static_cast<std::ptrdiff_t>(old_width)), width, 0.0);
    for (std::size_t k = i + 1; k < first_.size(); ++k) first_[k] = first_[k] - old_width + width;
  }

 private:
  std::vector<double> values_;
  std::vector<std::size_t> first_;
};

}  // namespace trophic::backend::mujoco
