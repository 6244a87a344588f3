// SPDX-License-Identifier: MIT
// Runs the experiment that a command line names: one run, replicates, a run from which another one begins, a run of a
// plan.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <tools/command/config.hpp>
#include <tools/experiment/experiment_options.hpp>
#include <tools/live/live_server.hpp>
#include <tools/replicates/common_options.hpp>
#include <tools/replicates/run_in_folder.hpp>
#include <trophic/experiment/any_experiment.hpp>
#include <trophic/observe/run_description.hpp>

namespace trophic::command {

/// Reads the manifest of the run that --from names. Throws std::invalid_argument if the folder has no run, or no such moment.
[[nodiscard]] OriginRun read_origin(const ExperimentOptions& options);

/// That run as this program makes it from its parameters.
[[nodiscard]] observe::RunDescription describe(const AnyExperiment& chosen, const OriginRun& origin);

/// Makes in a folder that run up to its moment, byte for byte, with one's own tables. Returns false if a signal came first.
[[nodiscard]] bool replay_origin(const AnyExperiment& chosen, const OriginRun& origin, const ExperimentOptions& options,
                                 const std::filesystem::path& folder);

/// Does the work of the options with an experiment of the chosen table and backend and returns the exit code.
[[nodiscard]] int run_experiment(const AnyExperiment& chosen, const ExperimentOptions& options, const Config& config,
                                 const std::optional<OriginRun>& origin);

namespace detail {

/// One run, shown by live pages; `live` may be null.
[[nodiscard]] int run_once(const ExperimentOptions& options, AnyExperiment& experiment, const MakeSimulation& make,
                           const std::optional<OriginRun>& origin, LiveServer* live);

}  // namespace detail

/// A planned run: its description, its amount of work and the species of its table.
struct PlannedFacts {
  observe::RunDescription description;
  double work = 0.0;  ///< robots times steps of the engine
  std::vector<std::string> species;
};

/// Facts of a run with the parameters of a configuration file, under a null.
[[nodiscard]] PlannedFacts facts(const AnyExperiment& chosen, const Config& config, const Null& null);

/// Runs or resumes that run in a folder. `history`: of the neutral null. Returns a remark about the folder, which may be empty.
std::string run_planned(const AnyExperiment& chosen, const Config& config, const Null& null, const HistoryOf& history,
                        std::uint64_t seed, const std::filesystem::path& folder, const replicates::CommonOptions& common,
                        replicates::Watch watch);

}  // namespace trophic::command
