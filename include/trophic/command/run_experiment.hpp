// SPDX-License-Identifier: MIT
// Runs the experiment that a command line names: one run, replicates, a run from which another one begins, a run of a
// sweep.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <trophic/command/config.hpp>
#include <trophic/command/experiment_options.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/run/replicates/common_options.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::command {

/// Reads the manifest of the run that --from names. Throws std::invalid_argument if the folder has no run, or no such moment.
[[nodiscard]] OriginRun read_origin(const ExperimentOptions& options);

/// That run as this program makes it from its numbers.
[[nodiscard]] observe::RunDescription describe(const Selection& selection, const OriginRun& origin);

/// Makes in a folder that run up to its moment, byte for byte, with one's own tables. Returns false if a signal came first.
[[nodiscard]] bool replay(const Selection& selection, const OriginRun& origin, const ExperimentOptions& options,
                          const std::filesystem::path& folder);

/// Does the work of the options with a selection and returns the exit code.
[[nodiscard]] int run_experiment(const Selection& selection, const ExperimentOptions& options, const Config& config,
                                 const std::optional<OriginRun>& origin);

/// A planned run: its description and its amount of work.
struct PlannedFacts {
  observe::RunDescription description;
  double work = 0.0;  ///< robots times steps of the engine
};

/// Facts of a run with the numbers of a configuration file, or of its neutral shadow.
[[nodiscard]] PlannedFacts facts(const Selection& selection, const Config& config, bool shadow);

/// Runs or resumes that run in a folder.
void run_planned(const Selection& selection, const Config& config, bool shadow, std::uint64_t seed,
                 const std::filesystem::path& folder, const replicates::CommonOptions& common,
                 observe::JointProgress::Part progress, const observe::StopOnSignal& stop);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/run_experiment.ipp>
#endif
