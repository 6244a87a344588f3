// SPDX-License-Identifier: MIT
// Several processes that share the runs of a plan by messages.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/plan_file.hpp>
#include <tools/sweep/work_through.hpp>
#include <vector>

namespace trophic::sweep {

/// Interface to a message-passing library; trophic::mpi implements it. One process leads; the others work.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  virtual ~Team() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual bool leads() const = 0;

  /// The leader announces whether there is a plan to work on, the others receive it. Called by all, once.
  [[nodiscard]] virtual bool begin(bool there_is_a_plan) = 0;

  /// The leader assigns the runs of a plan, longest first, and reassigns those of workers that died; the workers make
  /// attempts at their runs until none is left. Called by all. The tally is the leader's.
  [[nodiscard]] virtual Tally distribute(const std::vector<PlannedRun>& plan, const std::filesystem::path& sweep, double lease_s,
                                         const std::function<Result(const PlannedRun&)>& attempt,
                                         const std::function<bool()>& keep_running) = 0;
};

}  // namespace trophic::sweep
