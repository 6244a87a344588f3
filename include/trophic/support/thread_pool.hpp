// SPDX-License-Identifier: MIT
// A fixed set of threads that share out the items of one job at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace trophic {

/// `threads` workers in all, the calling thread being one of them. Items are handed out in their order, one at a time, so the
/// longest should come first. Not for calls from several threads at once.
///
/// Why no library: a job of the MuJoCo backend is the 0.2 ms of a control step. Wall seconds of 60 s of 30 robots on two threads
/// of a machine with two cores (g++ 12, oneTBB 2021.8; medians of three runs that went before all others, of five to seven beside
/// them; one thread: 0.78):
///
///                                      this pool   oneTBB   OpenMP
///   alone on both cores                   0.50      0.91     0.51
///   beside eight other busy programs      4.9       2.4     16
///
/// oneTBB wakes its threads too late for such jobs and gains nothing over one thread; OpenMP's spin long where cores are taken.
class ThreadPool {
 public:
  explicit ThreadPool(std::size_t threads) {
    for (std::size_t i = 1; i < threads; ++i) helpers_.emplace_back([this, i] { serve(i); });
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  ~ThreadPool() {
    stopping_ = true;
    job_number_.fetch_add(1, std::memory_order_release);
    job_number_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }

  [[nodiscard]] std::size_t threads() const { return helpers_.size() + 1; }

  /// Calls `work(item, thread)` once for each item < `items`; returns when all are done. The first exception is thrown on.
  void run(std::size_t items, const std::function<void(std::size_t item, std::size_t thread)>& work) {
    if (items == 1) return work(0, 0);
    work_ = &work;
    items_ = items;
    next_item_.store(0, std::memory_order_relaxed);
    busy_helpers_.store(helpers_.size(), std::memory_order_relaxed);
    job_number_.fetch_add(1, std::memory_order_release);
    job_number_.notify_all();
    take_items(0);
    wait_while(busy_helpers_, [](std::size_t busy) { return busy != 0; });
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

 private:
  /// About half a millisecond: long enough to bridge the serial part between two jobs and the end of the longest item, without
  /// the tens of microseconds that waking a thread takes.
  static constexpr int spins = 20000;

  /// Tells the processor that this is a waiting loop.
  static void relax() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }

  template <class T, class Predicate>
  static void wait_while(std::atomic<T>& value, Predicate waiting) {
    T seen = value.load(std::memory_order_acquire);
    for (int i = 0; i < spins && waiting(seen); ++i) {
      relax();
      seen = value.load(std::memory_order_acquire);
    }
    while (waiting(seen)) {
      value.wait(seen, std::memory_order_acquire);
      seen = value.load(std::memory_order_acquire);
    }
  }

  void take_items(std::size_t thread) {
    for (std::size_t i = next_item_.fetch_add(1, std::memory_order_relaxed); i < items_;
         i = next_item_.fetch_add(1, std::memory_order_relaxed)) {
      try {
        (*work_)(i, thread);
      } catch (...) {
        const std::lock_guard lock{failure_mutex_};
        if (!failure_) failure_ = std::current_exception();
      }
    }
  }

  void serve(std::size_t thread) {
    for (std::uint32_t served = 0;; ++served) {
      wait_while(job_number_, [served](std::uint32_t number) { return number == served; });
      if (stopping_) return;
      take_items(thread);
      if (busy_helpers_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_helpers_.notify_one();
    }
  }

  std::atomic<std::uint32_t> job_number_{0};
  std::atomic<std::size_t> next_item_{0};
  std::atomic<std::size_t> busy_helpers_{0};
  std::size_t items_ = 0;
  const std::function<void(std::size_t, std::size_t)>* work_ = nullptr;
  bool stopping_ = false;
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> helpers_;
};

}  // namespace trophic
