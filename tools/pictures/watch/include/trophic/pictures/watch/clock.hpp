// SPDX-License-Identifier: MIT
// The shown moment of a run: pause, step and speed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <trophic/params/params.hpp>

namespace trophic::watch {

/// Advances over the ecology's clock as the viewer's real time passes. Never ahead of the run.
class Clock {
 public:
  /// Ecology seconds per second of real time; the last one: as fast as the run.
  static constexpr std::array<double, 13> speeds{
      0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, std::numeric_limits<double>::infinity()};

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] double speed() const { return speeds[speed_]; }
  /// Ecology seconds that pass in a second of real time; as fast as the run: of the last half second.
  [[nodiscard]] double pace() const { return std::isinf(speed()) ? pace_ : speed(); }
  [[nodiscard]] bool is_paused() const { return is_paused_; }

  void set(double time_s) { time_s_ = time_s; }
  void faster() { speed_ = std::min(speed_ + 1, speeds.size() - 1); }
  void slower() { speed_ = std::max<std::size_t>(speed_, 1) - 1; }
  void set_paused(bool is_paused) {
    is_paused_ = is_paused;
    step_to_s_.reset();
  }
  void pause_or_continue() {
    is_paused_ = !is_paused_;
    step_to_s_.reset();
  }
  /// Continues to the next moment at which rules decide, and pauses there.
  void step(double tick_s) {
    const double from_s = step_to_s_.value_or(time_s_);
    step_to_s_ = (std::floor(from_s / tick_s + 1e-6) + 1.0) * tick_s;
    is_paused_ = true;
  }

  /// `elapsed_s` of real time have passed; the run is known up to `newest_s`.
  void advance(double elapsed_s, double newest_s) {
    if (step_to_s_) {
      time_s_ = std::max(time_s_, std::min(*step_to_s_, newest_s));
      if (time_s_ >= *step_to_s_) step_to_s_.reset();
    } else if (!is_paused_) {
      const double next_s = std::isinf(speed()) ? newest_s : time_s_ + elapsed_s * speed();
      const double before_s = time_s_;
      time_s_ = std::max(time_s_, std::min(next_s, newest_s));
      if (elapsed_s > 0.0) pace_ += std::min(1.0, elapsed_s / 0.5) * ((time_s_ - before_s) / elapsed_s - pace_);
    }
  }

  /// The moment that the run should have reached, so that the viewer need not wait.
  [[nodiscard]] double wanted_until_s(double tick_s) const {
    if (is_paused_) return step_to_s_.value_or(time_s_ + tick_s);
    return time_s_ + std::max(tick_s, speed());
  }

  /// "60.0 s, 10x", "60.0 s, paused".
  [[nodiscard]] std::string text() const {
    const std::string pace = is_paused_ ? "paused" : std::isinf(speed()) ? "as fast as possible" : number_text(speed()) + "x";
    return time_text() + ", " + pace;
  }
  /// "60.0 s".
  [[nodiscard]] std::string time_text() const {
    const double tenths = std::round(10.0 * time_s_);
    return number_text(std::floor(tenths / 10.0)) + "." + number_text(tenths - 10.0 * std::floor(tenths / 10.0)) + " s";
  }

 private:
  double time_s_ = 0.0;
  double pace_ = 0.0;
  std::size_t speed_ = 6;
  bool is_paused_ = false;
  std::optional<double> step_to_s_;
};

}  // namespace trophic::watch
