// SPDX-License-Identifier: MIT
// Definitions of work_through.hpp.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tools/sweep/work_through.hpp>
#include <trophic/observe/progress.hpp>
#include <utility>

namespace trophic::sweep {

Shard shard_of(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool has_slash = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
  const auto count = has_slash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!has_slash || count.ec != std::errc{} || count.ptr != end || shard.index < 1 || shard.index > shard.count) {
    throw std::invalid_argument{text + ": must be I/N with 1 <= I <= N, e.g. 1/4"};
  }
  return shard;
}

std::vector<std::size_t> longest_first(const std::vector<PlannedRun>& plan, const Shard& shard) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (shard.holds(i)) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return plan[a].work > plan[b].work; });
  return order;
}

namespace detail {

/// The runs that are still to be tried, for several threads.
class Queue {
 public:
  explicit Queue(std::vector<std::size_t> runs) : runs_{std::move(runs)} {}

  /// The next run; none if all have been given out. Those that are tried elsewhere come again, after a pause.
  [[nodiscard]] std::optional<std::size_t> next(const std::function<bool()>& keep_running) {
    while (keep_running()) {
      {
        const std::scoped_lock lock{mutex_};
        if (next_ < runs_.size()) return runs_[next_++];
        if (elsewhere_.empty()) return std::nullopt;
        if (watch_.elapsed_s() >= again_s_) {
          runs_ = std::exchange(elsewhere_, {});
          next_ = 1;
          return runs_.front();
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{100});
    }
    return std::nullopt;
  }

  void again(std::size_t run) {
    const std::scoped_lock lock{mutex_};
    elsewhere_.push_back(run);
    again_s_ = watch_.elapsed_s() + 1.0;
  }

 private:
  std::mutex mutex_;
  std::vector<std::size_t> runs_;
  std::size_t next_ = 0;
  std::vector<std::size_t> elsewhere_;
  observe::Stopwatch watch_;
  double again_s_ = 0.0;  ///< by the watch
};

}  // namespace detail

Tally tally_of(const std::vector<PlannedRun>& plan, const Shard& shard, const std::vector<Result>& results) {
  Tally tally;
  for (std::size_t run = 0; run < plan.size(); ++run) {
    const Result& result = results[run];
    if (!shard.holds(run)) continue;
    if (result.ended == Ended::was_complete) {
      ++tally.kept;
    } else if (result.ended == Ended::complete) {
      ++tally.complete;
    } else {
      const std::string at_work = result.ended == Ended::elsewhere && result.text != not_begun ? "at work elsewhere: " : "";
      tally.unfinished.push_back(plan[run].folder.string() + ": " + at_work + result.text);
    }
  }
  return tally;
}

Tally work_through(const std::vector<PlannedRun>& plan, const Shard& shard, std::size_t jobs,
                   const std::function<Result(const PlannedRun&)>& attempt, const std::function<bool()>& keep_running) {
  const std::vector<std::size_t> order = longest_first(plan, shard);
  std::vector<Result> results(plan.size(), Result{Ended::elsewhere, not_begun});
  detail::Queue queue{order};
  const auto work = [&] {
    while (const auto run = queue.next(keep_running)) {
      results[*run] = attempt(plan[*run]);
      if (results[*run].ended == Ended::elsewhere) queue.again(*run);
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(jobs, order.size()); ++i) helpers.emplace_back(work);
    work();
  }
  return tally_of(plan, shard, results);
}

}  // namespace trophic::sweep
