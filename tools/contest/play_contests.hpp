// SPDX-License-Identifier: MIT
// Plays contests across generations with a program's rule tables and backends.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tools/command/offers.hpp>
#include <tools/contest/contest_plan.hpp>
#include <vector>

namespace trophic::command {

/// Why an offer cannot play a plan: a sentence; empty if it can. `otherwise`: what helps if it lacks the rule table.
[[nodiscard]] std::string why_not_played(const contest::Plan& plan, const Offer& offer,
                                         const std::string& otherwise = "--program names the one that made the runs");

/// The experiment of a plan, with one thread for each contest. The offer must have its table and backend.
[[nodiscard]] std::unique_ptr<AnyExperiment> experiment_of(const contest::Plan& plan, const Offer& offer);

/// Outcomes by match; none of one that was not played.
using Outcomes = std::vector<std::optional<contest::Outcome>>;

/// Plays the matches of a plan whose outcomes are not known, `jobs` at a time; outcomes do not depend on it. `on_match` is called
/// after each, by any thread. After a signal no more are played.
/// Throws std::invalid_argument as `why_not_played`, and for genomes that the table's brain does not take.
[[nodiscard]] Outcomes play(const contest::Plan& plan, const Offer& offer, std::size_t jobs, Outcomes known = {},
                            const std::function<void(std::size_t, const contest::Outcome&)>& on_match = {});

/// Plays the plan in a file and writes the outcomes into a new one, PLAN.outcomes. Returns the exit code.
[[nodiscard]] int play_contests(const std::filesystem::path& plan, std::size_t jobs, const Offer& offer);

/// The file that play_contests writes.
[[nodiscard]] std::filesystem::path outcomes_of(const std::filesystem::path& plan);

}  // namespace trophic::command
