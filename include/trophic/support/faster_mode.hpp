// SPDX-License-Identifier: MIT
// Chooses the faster of two modes. Reads the wall clock, and affects only speed.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// For each job, chooses one of two modes that give the same result, by recent durations. The other mode is tried from time to
/// time, less often the slower it was, so that trials cost about a thirtieth of the time. Starts with the first mode. A job
/// during which the machine slept or the program was paused counts as an ordinary slow one.
class FasterMode {
 public:
  /// One job, timed from construction to destruction.
  class Trial {
   public:
    Trial(FasterMode& modes, bool first, std::size_t size)
        : modes_{modes}, first_{first}, size_{static_cast<double>(size)}, began_{std::chrono::steady_clock::now()} {}
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    ~Trial() {
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began_;
      modes_.note(first_, took.count() / size_);
    }
    [[nodiscard]] bool first() const { return first_; }

   private:
    FasterMode& modes_;
    bool first_;
    double size_;
    std::chrono::steady_clock::time_point began_;
  };

  /// The mode for the next job, of this size.
  [[nodiscard]] Trial next(std::size_t size) {
    bool first = !(second_.seconds < first_.seconds && second_.known);
    if (++since_other_ >= until_other()) {
      since_other_ = 0;
      first = !first;
    }
    return {*this, first, std::max<std::size_t>(size, 1)};
  }

  /// Records a job in the first or the second mode, with its duration in seconds per unit of size.
  void note(bool first, double seconds) {
    seconds = std::max(seconds, shortest_s);
    Mode& mode = first ? first_ : second_;
    Mode& other = first ? second_ : first_;
    if (!mode.known) mode = {.seconds = seconds, .known = true};
    const double most = slowest * (other.known ? std::min(mode.seconds, other.seconds) : mode.seconds);
    mode.seconds = std::min(mode.seconds, most);
    other.seconds = std::min(other.seconds, most);
    mode.seconds += weight * (std::min(seconds, most) - mode.seconds);
  }

 private:
  struct Mode {
    double seconds = 0.0;  ///< recent duration of a job of size one
    bool known = false;
  };

  /// Number of jobs until the other mode is tried. An odd number, because kinds of jobs may alternate.
  [[nodiscard]] std::uint64_t until_other() const {
    if (!first_.known || !second_.known) return 31;
    const double slower = std::max(first_.seconds, second_.seconds) / std::min(first_.seconds, second_.seconds);
    return 31 + 2 * static_cast<std::uint64_t>(16.0 * (std::min(slower, slowest) - 1.0));
  }

  static constexpr double weight = 0.125;
  /// Lower bound for the duration of a job, because a clock may stand still or go backwards.
  static constexpr double shortest_s = 1e-12;
  /// Upper bound for the slower mode, as a multiple of the faster one, so that the effect of a pause fades within some thousand
  /// jobs.
  static constexpr double slowest = 64.0;

  Mode first_;
  Mode second_;
  std::uint64_t since_other_ = 0;
};

}  // namespace trophic
