// SPDX-License-Identifier: MIT
// Which of two ways to do the same is faster at present. Reads the wall clock, and decides nothing but speed.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace trophic {

/// Chooses for each job one of two ways that give the same result, by how long jobs took lately, and tries the other one again
/// from time to time: the more rarely, the slower it was, so that trying costs about a thirtieth. Begins with the first. A job in
/// which the machine slept, or the program was stopped, counts as any slow one.
class FasterMode {
 public:
  /// One job, from when it was made to its end.
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

  /// The way for the next job, of this size.
  [[nodiscard]] Trial next(std::size_t size) {
    bool first = !(second_.seconds < first_.seconds && second_.known);
    if (++since_other_ >= until_other()) {
      since_other_ = 0;
      first = !first;
    }
    return {*this, first, std::max<std::size_t>(size, 1)};
  }

  /// A job was done the first or the second way, in so many seconds for one of its size.
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
    double seconds = 0.0;  ///< of late, for a job of size one
    bool known = false;
  };

  /// How many jobs pass until the other way is tried. An odd number, as kinds of jobs may alternate.
  [[nodiscard]] std::uint64_t until_other() const {
    if (!first_.known || !second_.known) return 31;
    const double slower = std::max(first_.seconds, second_.seconds) / std::min(first_.seconds, second_.seconds);
    return 31 + 2 * static_cast<std::uint64_t>(16.0 * (std::min(slower, slowest) - 1.0));
  }

  static constexpr double weight = 0.125;
  /// What a job takes at least, as a clock may stand still or go back.
  static constexpr double shortest_s = 1e-12;
  /// Times the faster way, beyond which nothing counts as slower, so that a pause is made up for in some thousand jobs.
  static constexpr double slowest = 64.0;

  Mode first_;
  Mode second_;
  std::uint64_t since_other_ = 0;
};

}  // namespace trophic
