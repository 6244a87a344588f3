// SPDX-License-Identifier: MIT
// The command line of an experiment, whatever its rule tables and backends are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <trophic/checkpoint/go_on.hpp>
#include <trophic/command/pairing.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/observe/manifest.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/population/view.hpp>
#include <trophic/replicates/plan.hpp>
#include <trophic/replicates/sweep/team.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::command {

/// Reads the manifest of the run that --from names. Throws std::invalid_argument for a folder that is none, or without a moment.
[[nodiscard]] OriginRun read_origin(const ExperimentOptions& options);

/// Where a run that begins from another one stands: at its own last checkpoint or, with `begins`, at the moment of the other, for
/// which its folder was made.
struct Beginning : checkpoint::Standing {
  bool begins = false;
};
[[nodiscard]] Beginning standing_after(const OriginRun& origin, const std::filesystem::path& folder,
                                       const observe::RunDescription& run);

/// What a manifest says of that.
[[nodiscard]] observe::Provenance text_of(const OriginRun& origin, double at_s);

/// The processes that MPI started this program as; null for one that was started alone.
using FindTeam = std::unique_ptr<sweep::Team> (*)();

/// What --seed, --duration, --robots and --robot say.
void apply(const ExperimentOptions& options, std::uint64_t& seed, EcologyParams& ecology);

/// The numbers of a table on a backend as a configuration file.
[[nodiscard]] int print_config(const std::string& table, const std::string& backend, const NamedParams& named_params);

/// What --replicates, --jobs and --resume say, with the master seed.
[[nodiscard]] replicates::Plan plan_of(const ExperimentOptions& options, std::uint64_t master_seed);

/// What --replay-hz, --agents-every, --senses and --states say.
[[nodiscard]] observe::Extent extent_of(const ExperimentOptions& options);

/// Tells of replicates that are not complete, a sentence each, and returns the exit code.
[[nodiscard]] int report_unfinished(const ExperimentOptions& options, const std::vector<std::string>& unfinished);

/// Tells how a run ended that left its files in a folder, and returns the exit code.
[[nodiscard]] int report_run(observe::RunFolder& folder, const observe::Progress& progress, const View& view, double until_s);

/// Reads the command line of a program with these tables on these backends, each table on each backend; runs what it says and
/// returns the exit code. The first table is the default; the default backend is `default_backend`, linked or not. `find_team`:
/// null for a program without MPI.
[[nodiscard]] int experiment_program(int argc, const char* const* argv, const std::vector<Pairing>& pairings,
                                     const std::string& backend_versions, FindTeam find_team = nullptr);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/experiment_program.ipp>
#endif
