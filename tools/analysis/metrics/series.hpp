// SPDX-License-Identifier: MIT
// Averages over windows of time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace trophic::analysis {

/// One point of a curve: the mean over a window; none where nothing could be averaged.
struct Point {
  double time_s = 0.0;  ///< end of the window
  std::optional<double> value;
};
using Series = std::vector<Point>;

/// The arithmetic mean; empty without values.
class Mean {
 public:
  void add(double value);
  void add(const std::optional<double>& value);
  [[nodiscard]] std::optional<double> value() const;

 private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

/// Means over the windows (k w, (k + 1) w], k = 0, 1, ...; time 0 belongs to the first. The paper's curves of velocity average
/// every 200 s: 30 points in 6000 s.
class WindowMean {
 public:
  /// Throws std::invalid_argument unless `window_s` > 0.
  explicit WindowMean(double window_s);

  void add(double time_s, const std::optional<double>& value);

  [[nodiscard]] Series series() const;
  /// The mean of all that was added, each value with the same weight.
  [[nodiscard]] std::optional<double> mean() const { return all_.value(); }
  /// The mean of the windows' means, each window with the same weight.
  [[nodiscard]] std::optional<double> mean_of_points() const;

 private:
  double window_s_;
  std::vector<Mean> windows_;
  Mean all_;
};

}  // namespace trophic::analysis
