// SPDX-License-Identifier: MIT
// Ctrl-C ends a run cleanly.
#pragma once

#include <unistd.h>
#include <trophic/support/cpp20.hpp>

#include <atomic>
#include <csignal>
#include <string_view>

namespace trophic::replicates {

/// From the first one made on, SIGINT, SIGTERM, the signals by which batch systems announce an end (SIGXCPU, SIGUSR1, SIGUSR2)
/// and (unless it was ignored, as nohup does) SIGHUP do not kill the program: runs that this observer watches end with complete
/// files, after the last whole tick. The one in hand is given up where it may take long. A second signal changes nothing; a third
/// one kills as usual. A pipe whose reader is gone and a file above the system's limit do not kill it either: writing to them
/// fails.
class StopOnSignal {
 public:
  StopOnSignal() {
    listen(SIGINT);
    listen(SIGTERM);
    listen(SIGXCPU);
    listen(SIGUSR1);
    listen(SIGUSR2);
    struct sigaction before {};
    if (::sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) listen(SIGHUP);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
  }

  [[nodiscard]] bool keep_running() const { return caught() == 0; }
  [[nodiscard]] bool cancels_tick() const { return caught() != 0; }

  /// The first signal, 0 for none.
  [[nodiscard]] static int caught() { return signal_; }

 private:
  static constexpr int ignored = 1;  ///< signals after the first

  static void listen(int signal) {
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }

  /// Async-signal-safe.
  static void remember(int signal) {
    const int before = count_++;
    if (before == 0) {
      signal_ = signal;
      constexpr std::string_view text = "\nstopping; finished work is kept\n";
      [[maybe_unused]] const auto ignore = ::write(STDERR_FILENO, text.data(), text.size());
    } else if (before > ignored) {
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  }

  static_assert(std::atomic<int>::is_always_lock_free);
  inline static std::atomic<int> signal_ = 0;
  inline static std::atomic<int> count_ = 0;
};

}  // namespace trophic::replicates
