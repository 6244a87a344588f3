// SPDX-License-Identifier: MIT
// What a command line makes of the experiment that it names: one run, replicates, a run that another one begins from, a run of a
// sweep.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <trophic/command/config.hpp>
#include <trophic/command/experiment_options.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/command/watching.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/run/replicates/common_options.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::command {

/// Reads the manifest of the run that --from names. Throws std::invalid_argument for a folder that is none, or without a moment.
[[nodiscard]] OriginRun read_origin(const ExperimentOptions& options);

/// That run as this program makes it of its numbers.
[[nodiscard]] observe::RunDescription describe(const Selection& selection, const OriginRun& origin);

/// Makes in a folder what that run was at its moment, the same bytes, and tables of one's own. False if a signal came first.
[[nodiscard]] bool replay(const Selection& selection, const OriginRun& origin, const ExperimentOptions& options,
                          const std::filesystem::path& folder);

/// Does what the options say with a selection and returns the exit code.
[[nodiscard]] int run_experiment(const Selection& selection, const ExperimentOptions& options, const Config& config,
                                 const std::optional<OriginRun>& origin, OpenWindow open_window);

/// What a plan says of a run: what it is, and how much.
struct PlannedFacts {
  observe::RunDescription description;
  double work = 0.0;  ///< robots times steps of the engine
};

/// Of the numbers of a configuration file, or of the table's neutral shadow with them.
[[nodiscard]] PlannedFacts facts(const Selection& selection, const Config& config, bool shadow);

/// Runs that, or goes on with it, in a folder.
void run_planned(const Selection& selection, const Config& config, bool shadow, std::uint64_t seed,
                 const std::filesystem::path& folder, const replicates::CommonOptions& common,
                 observe::JointProgress::Part progress, const observe::StopOnSignal& stop);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/run_experiment.ipp>
#endif
