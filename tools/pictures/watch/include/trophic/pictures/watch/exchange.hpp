// SPDX-License-Identifier: MIT
// Shared between the simulating and the showing thread: past events, and the moment up to which the run may continue.
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

/// Each member may be called from any thread.
class Exchange {
 public:
  /// Calls `use` with the footage while no other thread uses it.
  template <class Use>
  decltype(auto) with_footage(Use&& use) {
    const std::lock_guard lock{mutex_};
    return std::forward<Use>(use)(footage_);
  }

  /// The moment up to which the run need go until the next call, ecology seconds.
  void want_until(double time_s) {
    const std::lock_guard lock{mutex_};
    wanted_s_ = time_s;
    changed_.notify_all();
  }

  /// The window is closed: the run continues as fast as it can.
  void close() {
    const std::lock_guard lock{mutex_};
    is_open_ = false;
    changed_.notify_all();
  }
  [[nodiscard]] bool is_open() const { return is_open_; }

  /// Pauses the run between two ticks until the viewer wants to see more, the window is closed or a signal came.
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
