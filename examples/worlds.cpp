// SPDX-License-Identifier: MIT
// Living worlds, in which energy decides who lives and numbers change: docs/worlds.md.
#include <tools/tables/shipped_tables.hpp>
#include <trophic/experiment.hpp>

int main(int argc, char** argv) {
  return trophic::command::experiment_program(argc, argv,
                                              [] { return trophic::Offer{.rule_tables = trophic::command::world_tables()}; });
}
