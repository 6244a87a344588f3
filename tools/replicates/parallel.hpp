// SPDX-License-Identifier: MIT
// Independent pieces of work on several threads; one that fails ends no other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <trophic/support/thread_pool.hpp>
#include <vector>

namespace trophic::replicates {

/// Result of one piece of work.
struct Attempt {
  bool started = false;
  std::string error;  ///< text of its exception; empty if none
};

/// Calls `work(i)` for i = 0 ... items - 1 on `jobs` threads, in this order as threads get free; `go_on()` is asked before each.
/// `work` and `go_on` are called from several threads at once.
template <class Work, class KeepRunning>
[[nodiscard]] std::vector<Attempt> in_parallel(std::size_t items, std::size_t jobs, Work&& work, KeepRunning&& keep_running) {
  std::vector<Attempt> attempts(items);
  ThreadPool{std::min(jobs, items)}.run(items, [&](std::size_t i, std::size_t) {
    if (!keep_running()) return;
    attempts[i].started = true;
    try {
      work(i);
    } catch (const std::exception& error) {
      attempts[i].error = error.what();
      if (attempts[i].error.empty()) attempts[i].error = "unknown error";
    }
  });
  return attempts;
}

}  // namespace trophic::replicates
