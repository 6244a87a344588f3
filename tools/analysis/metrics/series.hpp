// SPDX-License-Identifier: MIT
// Averages over windows of time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::analysis {

/// One point of a curve: the mean over a window; none where nothing could be averaged.
struct Point {
  double time_s = 0.0;  ///< end of the window
  std::optional<double> value;
};
using Series = std::vector<Point>;

/// The plain mean; none of nothing.
class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  void add(const std::optional<double>& value) {
    if (value) add(*value);
  }
  [[nodiscard]] std::optional<double> value() const {
    return count_ == 0 ? std::nullopt : std::optional{sum_ / static_cast<double>(count_)};
  }

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

/// Means over the windows (k w, (k + 1) w], k = 0, 1, ...; time 0 belongs to the first. The paper's curves of velocity average
/// every 200 s: 30 points in 6000 s.
class WindowMean {
 public:
  /// Throws std::invalid_argument unless `window_s` > 0.
  explicit WindowMean(double window_s) : window_s_{window_s} {
    if (!(window_s > 0.0)) throw std::invalid_argument{"window_s = " + number_text(window_s) + ": must be > 0"};
  }

  void add(double time_s, const std::optional<double>& value) {
    const auto window = static_cast<std::size_t>(std::max(0.0, std::ceil(time_s / window_s_) - 1.0));
    if (window >= windows_.size()) windows_.resize(window + 1);
    windows_[window].add(value);
    all_.add(value);
  }

  [[nodiscard]] Series series() const {
    Series points;
    for (std::size_t k = 0; k < windows_.size(); ++k) {
      points.push_back({static_cast<double>(k + 1) * window_s_, windows_[k].value()});
    }
    return points;
  }
  /// The mean of all that was added, each value with the same weight.
  [[nodiscard]] std::optional<double> mean() const { return all_.value(); }
  /// The mean of the windows' means, each window with the same weight.
  [[nodiscard]] std::optional<double> mean_of_points() const {
    Mean mean;
    for (const Mean& window : windows_) mean.add(window.value());
    return mean.value();
  }

 private:
  double window_s_;
  std::vector<Mean> windows_;
  Mean all_;
};

}  // namespace trophic::analysis
