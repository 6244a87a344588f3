// SPDX-License-Identifier: MIT
// Between the thread that simulates and the one that shows: what has happened, and how far ahead of the eye the run may go.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/pictures/watch/live_footage.hpp>
#include <utility>

namespace trophic::watch {

/// Each call is for any thread.
class Exchange {
 public:
  /// Calls `use` with the footage while nobody else has it.
  template <class Use>
  decltype(auto) with_footage(Use&& use) {
    const std::lock_guard lock{mutex_};
    return std::forward<Use>(use)(footage_);
  }

  /// The run need not go further than this until it is told otherwise, ecology seconds.
  void want_until(double time_s) {
    const std::lock_guard lock{mutex_};
    wanted_s_ = time_s;
    changed_.notify_all();
  }

  /// Nobody looks any more: the run goes on as fast as it can.
  void close() {
    const std::lock_guard lock{mutex_};
    is_open_ = false;
    changed_.notify_all();
  }
  [[nodiscard]] bool is_open() const { return is_open_; }

  /// Holds the run up between two ticks until somebody wants to see more, nobody looks or a signal came.
  void wait_until_wanted() {
    std::unique_lock lock{mutex_};
    while (is_open_ && footage_.newest_s() >= wanted_s_ && observe::StopOnSignal::caught() == 0) {
      changed_.wait_for(lock, std::chrono::milliseconds{50});  // a signal handler may not notify
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  LiveFootage footage_;
  double wanted_s_ = -std::numeric_limits<double>::infinity();
  std::atomic<bool> is_open_ = true;
};

}  // namespace trophic::watch
