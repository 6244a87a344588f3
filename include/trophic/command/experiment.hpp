// SPDX-License-Identifier: MIT
// A program for rule tables: `int main(int argc, char** argv) { return trophic::command::experiment<MyRules>(argc, argv); }`.
#pragma once

#include <memory>
#include <string>
#include <trophic/command/any_experiment.hpp>
#include <trophic/command/backends.hpp>
#include <trophic/command/experiment_program.hpp>
#include <trophic/command/pairing.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/table_experiment.hpp>
#include <trophic/command/watching.hpp>
#include <trophic/rules/table.hpp>
#include <vector>
// Who links trophic::mpi or trophic::mpi_compiled has this definition.
#ifdef TROPHIC_WITH_MPI
#include <trophic/mpi/find_team.hpp>
#endif

namespace trophic::command {

namespace detail {

template <class Rules, class Backends>
void add_pairings(std::vector<Pairing>& pairings) {
  Backends::for_each([&]<class B>() {
    pairings.push_back({table_name<Rules>(), std::string{B::name},
                        []() -> std::unique_ptr<AnyExperiment> { return std::make_unique<TableExperiment<Rules, B>>(); }});
  });
}

}  // namespace detail

/// The command line of an experiment with rule tables to choose from, on backends of one's own choice: `BackendList<...>`.
template <class Backends, class... Rules>
[[nodiscard]] int experiment_on(int argc, const char* const* argv) {
  static_assert(sizeof...(Rules) > 0, "trophic::command::experiment needs at least one rule table");
  return guarded(argv[0], [&] {
    std::vector<Pairing> pairings;
    (detail::add_pairings<Rules, Backends>(pairings), ...);
    LinkedParts linked;
#ifdef TROPHIC_WITH_MPI
    linked.find_team = &mpi::find_team;
#endif
#ifdef TROPHIC_WITH_WATCH
    linked.open_window = &open_window;
#endif
    return experiment_program(argc, argv, pairings, backend_versions<Backends>(), linked);
  });
}

/// The command line of an experiment with rule tables to choose from, the first of them the default, on the kinematic backend and
/// every engine that the program is linked with: --help, --rules, --backend, --config, --set, --replicates, --shadow, --resume,
/// --sweep and more. Returns the exit code: 0, 1 for what went wrong in a run, 2 for what is wrong with the arguments, 3 for a
/// run that a signal stopped.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv) {
  return experiment_on<LinkedBackends, Rules...>(argc, argv);
}

}  // namespace trophic::command
