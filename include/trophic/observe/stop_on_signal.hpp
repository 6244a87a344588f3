// SPDX-License-Identifier: MIT
// Ctrl-C ends a run cleanly.
#pragma once

#include <csignal>

namespace trophic::observe {

/// From the first one made on, SIGINT and SIGTERM no longer kill the program: runs that this observer watches end after the tick
/// at hand, with complete files. A second signal kills as usual.
class StopOnSignal {
 public:
  StopOnSignal() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
  }

  [[nodiscard]] bool keep_running() const { return caught() == 0; }

  /// The signal that came, 0 for none.
  [[nodiscard]] static int caught() { return signal_; }

 private:
  static void remember(int signal) {
    signal_ = signal;
    std::signal(signal, SIG_DFL);
  }

  inline static volatile std::sig_atomic_t signal_ = 0;
};

}  // namespace trophic::observe
