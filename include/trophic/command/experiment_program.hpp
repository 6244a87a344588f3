// SPDX-License-Identifier: MIT
// The command line of an experiment, for any rule tables and backends.
#pragma once

#include <memory>
#include <string>
#include <trophic/command/live.hpp>
#include <trophic/command/option.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/io/own_metric.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::sweep {
class Team;
}  // namespace trophic::sweep

namespace trophic::command {

/// The MPI processes of this program; null if it was started alone.
using FindTeam = std::unique_ptr<sweep::Team> (*)();

/// The command `analyze` of a program with own metrics.
using MakeAnalyze = Command (*)(const std::string& program, const io::OwnMetrics& own_metrics, const Offer& offer);

/// Optional parts that a program is linked with, besides its backends; null for those that it lacks.
struct LinkedParts {
  FindTeam find_team = nullptr;
  OpenLive open_live = nullptr;
  MakeAnalyze make_analyze = nullptr;
  io::OwnTables own_tables = {};
  io::OwnMetrics own_metrics = {};
};

/// Reads the command line of a program that offers these tables and backends, does its work and returns the exit code.
[[nodiscard]] int experiment_program(int argc, const char* const* argv, const Offer& offer, const LinkedParts& linked = {});

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/experiment_program.ipp>
#endif
