// SPDX-License-Identifier: MIT
// Definitions of series.hpp.
#include <tools/analysis/metrics/series.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

void Mean::add(double value) {
  sum_ += value;
  ++count_;
}

void Mean::add(const std::optional<double>& value) {
  if (value) add(*value);
}

std::optional<double> Mean::value() const {
  return count_ == 0 ? std::nullopt : std::optional{sum_ / static_cast<double>(count_)};
}

WindowMean::WindowMean(double window_s) : window_s_{window_s} {
  if (!(window_s > 0.0)) throw std::invalid_argument{"window_s = " + number_text(window_s) + ": must be > 0"};
}

void WindowMean::add(double time_s, const std::optional<double>& value) {
  const auto window = static_cast<std::size_t>(std::max(0.0, std::ceil(time_s / window_s_) - 1.0));
  if (window >= windows_.size()) windows_.resize(window + 1);
  windows_[window].add(value);
  all_.add(value);
}

Series WindowMean::series() const {
  Series points;
  for (std::size_t k = 0; k < windows_.size(); ++k) {
    points.push_back({static_cast<double>(k + 1) * window_s_, windows_[k].value()});
  }
  return points;
}

std::optional<double> WindowMean::mean_of_points() const {
  Mean mean;
  for (const Mean& window : windows_) mean.add(window.value());
  return mean.value();
}

}  // namespace trophic::analysis
