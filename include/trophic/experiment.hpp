// SPDX-License-Identifier: MIT
// A program for rule tables: `int main(int argc, char** argv) { return trophic::experiment<MyRules>(argc, argv); }`.
#pragma once

#include <memory>
#include <string>
#include <trophic/command/analyze.hpp>
#include <trophic/command/any_experiment.hpp>
#include <trophic/command/backends.hpp>
#include <trophic/command/experiment_program.hpp>
#include <trophic/command/live.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/command/table_experiment.hpp>
#include <trophic/io/own_metric.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/rules/table.hpp>
#include <utility>
// Defined in programs that link trophic::mpi or trophic::mpi_compiled.
#ifdef TROPHIC_WITH_MPI
#include <trophic/mpi/find_team.hpp>
#endif

namespace trophic {

/// User-defined backends for `experiment_on`; the first is the default.
using command::BackendList;

/// Additions of a program to its experiments: tables that every run writes, including shadows and runs of sweeps, and metrics of
/// its command `analyze` (trophic_add_experiment(... ANALYZE)).
struct Own {
  io::OwnTables tables = {};
  io::OwnMetrics metrics = {};
};

/// The command line of an experiment with a choice of rule tables, on user-defined backends:
/// `experiment_on<BackendList<MyBackend>, MyRules>(argc, argv)`. `own`: see `experiment`.
template <class Backends, class... Rules>
[[nodiscard]] int experiment_on(int argc, const char* const* argv, Own own = {}) {
  static_assert(sizeof...(Rules) > 0, "trophic::experiment needs at least one rule table");
  return command::guarded(argv[0], [&] {
    const command::Offer offer{
        .tables = {command::OfferedTable{table_name<Rules>(),
                                         [](const command::LinkedBackend& backend) -> std::unique_ptr<command::AnyExperiment> {
                                           return std::make_unique<command::TableExperiment<Rules>>(backend);
                                         }}...},
        .backends = command::linked_backends<Backends>(),
        .default_backend = std::string{Backends::default_backend}};
    command::LinkedParts linked{.own_tables = std::move(own.tables), .own_metrics = std::move(own.metrics)};
#ifdef TROPHIC_WITH_MPI
    linked.find_team = &mpi::find_team;
#endif
#ifdef TROPHIC_WITH_ANALYSIS
    linked.make_analyze = &command::analyze;
#endif
#ifdef TROPHIC_WITH_LIVE
    linked.open_live = &live::open;
#endif
    return command::experiment_program(argc, argv, offer, linked);
  });
}

/// The command line of an experiment with a choice of rule tables, the first of them the default, on the kinematic backend and
/// every engine that the program links: --help, --rules, --backend, --config, --set, --replicates, --shadow, --resume, --sweep
/// and more. `own`: the program's own tables and metrics, `experiment<MyRules>(argc, argv, {.tables =
/// io::own_tables<Distances>()})`. Returns the exit code: 0; 1 if a run failed; 2 if the arguments are wrong; 3 if a signal
/// stopped a run.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv, Own own = {}) {
  return experiment_on<command::LinkedBackends, Rules...>(argc, argv, std::move(own));
}

/// The same with own tables alone: `experiment<MyRules>(argc, argv, io::own_tables<Distances>())`.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv, io::OwnTables own_tables) {
  return experiment<Rules...>(argc, argv, Own{.tables = std::move(own_tables)});
}

}  // namespace trophic
