// SPDX-License-Identifier: MIT
// A program for rule tables: `int main(int argc, char** argv) { return trophic::experiment<MyRules>(argc, argv); }`. Link
// trophic::command, which has the definitions.
#pragma once

#include <functional>
#include <memory>
#include <trophic/experiment/offer.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/rules/table.hpp>
#include <utility>

namespace trophic {

namespace command {

/// Reads the command line of a program with these tables and backends, does its work and returns the exit code. Errors in `offer`
/// are reported like those of the work.
[[nodiscard]] int experiment_program(int argc, const char* const* argv, const std::function<Offer()>& offer);

}  // namespace command

/// The command line of an experiment with a choice of rule tables, the first of them the default: --help, --rules, --backend,
/// --config, --set, --replicates, --shadow, --resume, --plan and more. `offer`: the program's own tables, metrics and backends,
/// `experiment<MyRules>(argc, argv, {.backends = {MyBackend::Params{}}})`. Returns the exit code: 0; 1 if a run failed; 2 if the
/// arguments are wrong; 3 if a signal interrupted a run.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv, Offer offer = {}) {
  static_assert(sizeof...(Rules) > 0, "trophic::experiment needs at least one rule table");
  return command::experiment_program(argc, argv, [&offer] {
    offer.rule_tables = rule_tables<Rules...>();
    return std::move(offer);
  });
}

/// The same with only own tables: `experiment<MyRules>(argc, argv, io::own_tables<Distances>())`.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv, io::OwnTables tables) {
  return experiment<Rules...>(argc, argv, Offer{.tables = std::move(tables)});
}

}  // namespace trophic
