// SPDX-License-Identifier: MIT
// A fixed set of threads that process the items of one job at a time.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <trophic/support/faster_mode.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// `threads` workers in total, including the calling thread. Items are assigned in order, one at a time, so the longest should
/// come first. Must not be called from several threads at once. The assignment of items to threads, and the number of helpers,
/// affect only speed.
///
/// The caller does not wait for a helper that has not started: on a busy machine the caller may finish all items alone. If
/// helpers are often descheduled in the middle of an item, the caller processes most jobs alone, until helpers are worthwhile
/// again.
///
/// A job of the MuJoCo backend is one control step, 0.2 ms. That is too short for general libraries: oneTBB 2021.8 wakes its
/// threads too late and gains nothing over one thread; OpenMP spins long if cores are taken. Wall seconds for 60 s of 30 robots
/// with two threads on two free cores, and with eight other busy programs: oneTBB 0.91 and 2.4, OpenMP 0.51 and 16, a pool that
/// waits for helpers 0.50 and 4.9 (one thread: 0.78).
class ThreadPool {
 public:
  /// Starts fewer threads if the system refuses more.
  explicit ThreadPool(std::size_t threads) {
    try {
      for (std::size_t i = 1; i < threads; ++i) helpers_.emplace_back([this, i] { serve(i); });
    } catch (const std::system_error&) {  // fewer helpers suffice
    } catch (...) {
      dismiss();
      throw;
    }
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  ~ThreadPool() { dismiss(); }

  [[nodiscard]] std::size_t threads() const { return helpers_.size() + 1; }

  /// Calls `work(item, thread)` once for each item < `items`; returns when all are done. Rethrows the first exception.
  void run(std::size_t items, const std::function<void(std::size_t item, std::size_t thread)>& work) {
    if (items >= closed) throw std::invalid_argument{"items = " + std::to_string(items) + ": must be < 4294967295"};
    if (items == 1) return work(0, 0);
    if (items <= 1 || helpers_.empty()) {
      run_alone(items, work);
    } else {
      const FasterMode::Trial trial = modes_.next(items);
      trial.first() ? run_together(items, work) : run_alone(items, work);
    }
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

 private:
  /// About half a millisecond: enough to bridge the serial part between two jobs and the end of the longest item, without the
  /// tens of microseconds of waking a thread.
  static constexpr int spins = 20000;
  /// Marks the next item if there is none and the next job is not ready.
  static constexpr std::uint64_t closed = 0xffffffff;

  void dismiss() {
    stopping_ = true;
    place_.fetch_or(closed);
    items_.store(0);
    publish(closed);
    for (std::thread& helper : helpers_) helper.join();
  }

  /// Hints to the processor that this is a waiting loop.
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

  void run_together(std::size_t items, const std::function<void(std::size_t, std::size_t)>& work) {
    // A helper that still reads the last job must not find an item in it before the data of the next job are written.
    place_.fetch_or(closed);
    items_.store(items);
    work_.store(&work);
    unfinished_.store(items);
    publish(0);
    take_items(0);
    wait_while(unfinished_, [](std::size_t left) { return left != 0; });
  }

  void run_alone(std::size_t items, const std::function<void(std::size_t, std::size_t)>& work) {
    for (std::size_t item = 0; item < items; ++item) try_item(work, item, 0);
  }

  /// The next job begins at this item.
  void publish(std::uint64_t item) {
    const std::uint64_t job = (place_.load() >> 32U) + 1;
    place_.store(job << 32U | item);
    job_number_.store(static_cast<std::uint32_t>(job), std::memory_order_release);
    job_number_.notify_all();
  }

  void take_items(std::size_t thread) {
    std::uint64_t place = place_.load();
    for (;;) {
      const std::uint64_t item = place & closed;
      if (item >= items_.load()) return;
      const auto* work = work_.load();
      // Succeeds only in the job in which `place` was read; its data were read in between and belong to it.
      if (!place_.compare_exchange_weak(place, place + 1)) continue;
      try_item(*work, item, thread);
      if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
      place = place_.load();
    }
  }

  void try_item(const std::function<void(std::size_t, std::size_t)>& work, std::size_t item, std::size_t thread) {
    try {
      work(item, thread);
    } catch (...) {
      const std::lock_guard lock{failure_mutex_};
      if (!failure_) failure_ = std::current_exception();
    }
  }

  void serve(std::size_t thread) {
    std::uint32_t served = 0;
    for (;;) {
      wait_while(job_number_, [served](std::uint32_t number) { return number == served; });
      // In this order: a helper that reads the number of the end recognises it and does not wait for another.
      served = job_number_.load(std::memory_order_acquire);
      if (stopping_) return;
      take_items(thread);
    }
  }

  std::atomic<std::uint64_t> place_{closed};  ///< number of the job, and in the lower half its next item
  std::atomic<std::uint32_t> job_number_{0};
  std::atomic<std::size_t> items_{0};
  std::atomic<std::size_t> unfinished_{0};
  std::atomic<const std::function<void(std::size_t, std::size_t)>*> work_{nullptr};
  std::atomic<bool> stopping_{false};
  std::mutex failure_mutex_;
  std::exception_ptr failure_;
  FasterMode modes_;
  std::vector<std::thread> helpers_;
};

}  // namespace trophic
