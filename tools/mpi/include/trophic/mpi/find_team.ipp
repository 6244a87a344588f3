// SPDX-License-Identifier: MIT
// Definitions of find_team.hpp: the ranks of an MPI job share the runs of a plan; rank 0 assigns them, the others make
// them.
#pragma once

#include <mpi.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <tools/sweep/claim.hpp>
#include <tools/sweep/team.hpp>
#include <tools/sweep/work_through.hpp>
#include <trophic/mpi/find_team.hpp>
#include <utility>
#include <vector>

namespace trophic::mpi {

namespace detail {

inline constexpr int to_leader = 1;
inline constexpr int to_worker = 2;
inline constexpr long no_run = -1;  ///< from a worker: it has done no run yet; to a worker: no run is left
inline constexpr long bye = -2;     ///< from a worker: it has received no_run; to a worker: so have all others

/// Time that the leader waits for the workers' bye at the end.
inline constexpr std::chrono::seconds patience{10};

/// Looks for a message every few milliseconds, as MPI's own waiting takes a whole core.
inline constexpr std::chrono::milliseconds pause{2};

/// A worker's message: the result of a run, and that the worker is free.
struct Report {
  long run = no_run;
  int ended = 0;
  std::string text;

  [[nodiscard]] std::string bytes() const { return std::to_string(run) + " " + std::to_string(ended) + " " + text; }
  [[nodiscard]] static Report of(const std::string& bytes) {
    Report report;
    char* rest = nullptr;
    report.run = std::strtol(bytes.c_str(), &rest, 10);
    report.ended = static_cast<int>(std::strtol(rest, &rest, 10));
    if (*rest == ' ') report.text = rest + 1;
    return report;
  }
};

/// The leader's state of the runs and of its workers.
class Leader {
 public:
  Leader(const std::vector<sweep::PlannedRun>& plan, std::filesystem::path sweep, double lease_s, std::size_t workers)
      : plan_{plan},
        sweep_{std::move(sweep)},
        lease_s_{lease_s},
        workers_{workers},
        results_(plan.size(), {sweep::Ended::elsewhere, sweep::not_begun}) {
    for (const std::size_t run : sweep::longest_first(plan)) pending_.push_back(run);
  }

  /// Until every run is complete or has failed, a signal has come and all workers have stopped, or no worker is left.
  [[nodiscard]] sweep::Tally lead(const std::function<bool()>& keep_running) {
    while (!pending_.empty() || !given_.empty() || !later_.empty()) {
      const bool received = listen();
      if (!keep_running()) stop_assigning();
      assign_runs();
      if (received) continue;
      check_lost_workers();
      if (lost_.size() == workers_) break;
      std::this_thread::sleep_for(pause);
    }
    dismiss();
    return sweep::tally_of(plan_, {}, results_);
  }

  /// Whether a worker died: then there is no MPI_Finalize, in which all ranks take part.
  [[nodiscard]] bool has_lost_workers() const { return !lost_.empty(); }

 private:
  using Clock = std::chrono::steady_clock;

  struct Given {
    std::size_t run = 0;
    Clock::time_point since;
  };

  static void send(int worker, long run) { MPI_Send(&run, 1, MPI_LONG, worker, to_worker, MPI_COMM_WORLD); }

  /// Sends no_run to all workers, and to those that answer whether all did. A worker that died while idle is noticed
  /// only here.
  void dismiss() {
    for (int worker = 1; worker <= static_cast<int>(workers_); ++worker) {
      if (lost_.contains(worker)) continue;
      leaving_.insert(worker);
      send(worker, no_run);
    }
    const std::set<int> told = leaving_;
    const Clock::time_point end = Clock::now() + patience;
    while (!leaving_.empty() && Clock::now() < end) {
      if (!listen()) std::this_thread::sleep_for(pause);
    }
    lost_.insert(leaving_.begin(), leaving_.end());
    for (const int worker : told) {
      if (!leaving_.contains(worker)) send(worker, lost_.empty() ? bye : no_run);
    }
  }

  /// Takes one report, if there is one.
  bool listen() {
    int there = 0;
    MPI_Status status;
    if (MPI_Iprobe(MPI_ANY_SOURCE, to_leader, MPI_COMM_WORLD, &there, &status) != MPI_SUCCESS || there == 0) return false;
    int length = 0;
    MPI_Get_count(&status, MPI_CHAR, &length);
    std::string bytes(static_cast<std::size_t>(length), '\0');
    MPI_Recv(bytes.data(), length, MPI_CHAR, status.MPI_SOURCE, to_leader, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    receive(status.MPI_SOURCE, Report::of(bytes));
    return true;
  }

  void receive(int worker, const Report& report) {
    given_.erase(worker);
    suspects_.erase(worker);
    lost_.erase(worker);
    if (report.run == bye) {
      leaving_.erase(worker);
      return;
    }
    free_.push_back(worker);
    if (report.run == no_run) return;
    const auto run = static_cast<std::size_t>(report.run);
    results_[run] = {static_cast<sweep::Ended>(report.ended), report.text};
    if (results_[run].ended == sweep::Ended::elsewhere) later_.emplace_back(run, Clock::now() + std::chrono::seconds{1});
  }

  void stop_assigning() {
    pending_.clear();
    later_.clear();
  }

  void assign_runs() {
    while (!later_.empty() && later_.front().second <= Clock::now()) {
      pending_.push_back(later_.front().first);
      later_.pop_front();
    }
    while (!free_.empty() && !pending_.empty()) {
      const int worker = free_.front();
      const std::size_t run = pending_.front();
      free_.pop_front();
      pending_.pop_front();
      given_[worker] = {run, Clock::now()};
      send(worker, static_cast<long>(run));
    }
  }

  /// Once a second: a run that was given to a worker some time ago, that is incomplete and unclaimed, is to be given
  /// to another one.
  void check_lost_workers() {
    if (Clock::now() < next_look_) return;
    next_look_ = Clock::now() + std::chrono::seconds{1};
    std::vector<int> silent;
    for (const auto& [worker, given] : given_) {
      if (Clock::now() - given.since < std::chrono::seconds{3}) continue;
      const sweep::PlannedRun& run = plan_[given.run];
      if (!sweep::claimant_of(sweep_ / sweep::claims_name, run.index, lease_s_).empty()) {
        suspects_.erase(worker);
      } else if (!suspects_.insert(worker).second) {
        silent.push_back(worker);
      }
    }
    for (const int worker : silent) {
      const std::size_t run = given_[worker].run;
      if (sweep::is_complete(sweep_, plan_[run])) {
        results_[run] = {sweep::Ended::complete};
      } else {
        pending_.push_front(run);
        std::cerr << "rank " << worker << " has stopped answering: " << plan_[run].folder.string() << " is given to another\n";
      }
      given_.erase(worker);
      suspects_.erase(worker);
      lost_.insert(worker);
    }
  }

  const std::vector<sweep::PlannedRun>& plan_;
  std::filesystem::path sweep_;
  double lease_s_;
  std::size_t workers_;
  std::vector<sweep::Result> results_;
  std::deque<std::size_t> pending_;
  std::deque<std::pair<std::size_t, Clock::time_point>> later_;  ///< runs on which programs of another job work
  std::deque<int> free_;
  std::map<int, Given> given_;
  std::set<int> suspects_;  ///< workers whose run was unclaimed at the last look
  std::set<int> lost_;
  std::set<int> leaving_;  ///< at the end, workers without a bye
  Clock::time_point next_look_;
};

}  // namespace detail

/// The ranks of MPI_COMM_WORLD. One at a time in a program, which must not call MPI_Init itself.
class Team final : public sweep::Team {
 public:
  Team() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    // A rank that dies must not end the others: its run is given to another one.
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  ~Team() override {
    if (has_lost_workers_) {
      // All ranks take part in MPI_Finalize, and one has died.
      std::cout.flush();
      std::cerr.flush();
      return;
    }
    MPI_Finalize();
  }

  [[nodiscard]] std::size_t size() const override { return static_cast<std::size_t>(size_); }
  [[nodiscard]] bool leads() const override { return rank_ == 0; }

  [[nodiscard]] bool begin(bool there_is_a_plan) override {
    int flag = there_is_a_plan ? 1 : 0;
    MPI_Bcast(&flag, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return flag == 1;
  }

  [[nodiscard]] sweep::Tally distribute(const std::vector<sweep::PlannedRun>& plan, const std::filesystem::path& sweep,
                                        double lease_s, const std::function<sweep::Result(const sweep::PlannedRun&)>& attempt,
                                        const std::function<bool()>& keep_running) override {
    has_lost_workers_ = true;  // until all workers have said bye; stays true if an error ends the work earlier
    if (!leads()) {
      work(plan, attempt);
      report({detail::bye, 0, {}});
      has_lost_workers_ = next() != detail::bye;
      return {};
    }
    detail::Leader leader{plan, sweep, lease_s, size() - 1};
    sweep::Tally tally = leader.lead(keep_running);
    has_lost_workers_ = leader.has_lost_workers();
    return tally;
  }

 private:
  static void report(const detail::Report& report) {
    const std::string bytes = report.bytes();
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_CHAR, 0, detail::to_leader, MPI_COMM_WORLD);
  }

  /// The leader's next message.
  [[nodiscard]] static long next() {
    int there = 0;
    while (MPI_Iprobe(0, detail::to_worker, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE) == MPI_SUCCESS && there == 0) {
      std::this_thread::sleep_for(detail::pause);
    }
    long said = detail::no_run;
    if (there != 0) MPI_Recv(&said, 1, MPI_LONG, 0, detail::to_worker, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return said;
  }

  static void work(const std::vector<sweep::PlannedRun>& plan,
                   const std::function<sweep::Result(const sweep::PlannedRun&)>& attempt) {
    report({});
    for (long run = next(); run != detail::no_run; run = next()) {
      const sweep::Result result = attempt(plan[static_cast<std::size_t>(run)]);
      report({run, static_cast<int>(result.ended), result.text});
    }
  }

  int rank_ = 0;
  int size_ = 1;
  bool has_lost_workers_ = false;
};

TROPHIC_INLINE std::unique_ptr<sweep::Team> find_team() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"}) {
    if (std::getenv(variable) != nullptr) return std::make_unique<Team>();
  }
  return nullptr;
}

}  // namespace trophic::mpi
