// SPDX-License-Identifier: MIT
// A fixed set of threads that share out the items of one job at a time.
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

/// `threads` workers in all, the calling thread being one of them. Items are handed out in their order, one at a time, so the
/// longest should come first. Not for calls from several threads at once. Which thread does what, and how many help, decides
/// nothing but speed.
///
/// Nobody waits for a helper that has not begun: on a machine with other programs it may come when the caller has done everything
/// itself. Where helping does not pay, because helpers are often taken off their processor in the middle of an item, most jobs
/// are done by the caller alone, until it pays again.
///
/// Why no library: a job of the MuJoCo backend is the 0.2 ms of a control step. oneTBB 2021.8 wakes its threads too late for such
/// jobs and gains nothing over one thread; OpenMP's spin long where cores are taken. Wall seconds of 60 s of 30 robots on two
/// threads of two free cores, and beside eight busy programs: oneTBB 0.91 and 2.4, OpenMP 0.51 and 16, this pool before it knew
/// of helpers that have not begun 0.50 and 4.9 (one thread: 0.78).
class ThreadPool {
 public:
  /// Fewer where the system gives no more threads.
  explicit ThreadPool(std::size_t threads) {
    try {
      for (std::size_t i = 1; i < threads; ++i) helpers_.emplace_back([this, i] { serve(i); });
    } catch (const std::system_error&) {  // the helpers that there are will do
    } catch (...) {
      dismiss();
      throw;
    }
  }

  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  ~ThreadPool() { dismiss(); }

  [[nodiscard]] std::size_t threads() const { return helpers_.size() + 1; }

  /// Calls `work(item, thread)` once for each item < `items`; returns when all are done. The first exception is thrown on.
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
  /// About half a millisecond: long enough to bridge the serial part between two jobs and the end of the longest item, without
  /// the tens of microseconds that waking a thread takes.
  static constexpr int spins = 20000;
  /// As the next item: there is none, and the next job is not ready.
  static constexpr std::uint64_t closed = 0xffffffff;

  void dismiss() {
    stopping_ = true;
    place_.fetch_or(closed);
    items_.store(0);
    publish(closed);
    for (std::thread& helper : helpers_) helper.join();
  }

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

  void run_together(std::size_t items, const std::function<void(std::size_t, std::size_t)>& work) {
    // Whoever still looks at the last job must find nothing in it before the numbers of the next are written.
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
      // Succeeds only in the job that `place` was read in: its numbers were read in between and so are its own.
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
      // In this order: who reads the number of the end sees that it is one, and does not wait for another.
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
