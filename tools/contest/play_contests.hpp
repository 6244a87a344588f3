// SPDX-License-Identifier: MIT
// Plays contests across generations with a program's rule tables and backends.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <tools/command/offers.hpp>
#include <tools/contest/contest_plan.hpp>

namespace trophic::command {

/// Why an offer cannot play a plan: a sentence; empty if it can. `otherwise`: what helps if it lacks the rule table.
[[nodiscard]] std::string why_not_played(const contest::Plan& plan, const Offer& offer,
                                         const std::string& otherwise = "--program names the one that made the runs");

/// The experiment of a plan, with one thread for each contest. The offer must have its table and backend.
[[nodiscard]] std::unique_ptr<AnyExperiment> experiment_of(const contest::Plan& plan, const Offer& offer);

/// Plays the matches of the plan in a file, `jobs` at a time, and writes their outcomes into a new file, PLAN.outcomes; they do
/// not depend on `jobs`. With a rate `record_hz` it also writes each contest as a run, into PLAN.runs/0, 1, ... Returns the exit
/// code. Throws std::invalid_argument as `why_not_played`, and for genomes that the table's brain does not take.
[[nodiscard]] int play_contests(const std::filesystem::path& plan, std::size_t jobs, const Offer& offer);

}  // namespace trophic::command
