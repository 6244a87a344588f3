// SPDX-License-Identifier: MIT
// Several processes that share out the runs of a plan by messages.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <trophic/run/sweep/attempt.hpp>
#include <trophic/run/sweep/plan_file.hpp>
#include <trophic/run/sweep/work_through.hpp>
#include <vector>

namespace trophic::sweep {

/// What a program needs of a message-passing library; trophic::mpi has one. One process leads; the others work.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  virtual ~Team() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual bool leads() const = 0;

  /// The leader tells the others whether there is a plan to work on, the others hear it. Called by all, once.
  [[nodiscard]] virtual bool begin(bool there_is_a_plan) = 0;

  /// The leader hands out the runs of a plan, longest first, and gives those of workers that died to others; the workers make
  /// attempts at what they are given until the leader has nothing left. Called by all. The tally is the leader's.
  [[nodiscard]] virtual Tally distribute(const std::vector<PlannedRun>& plan, const std::filesystem::path& sweep, double lease_s,
                                         const std::function<Result(const PlannedRun&)>& attempt,
                                         const std::function<bool()>& keep_running) = 0;
};

}  // namespace trophic::sweep
