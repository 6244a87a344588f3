// SPDX-License-Identifier: MIT
// The program trophic: everything that does not depend on a rule table. `trophic --help` lists its commands.
#include <trophic/command/backends.hpp>
#include <trophic/command/provenance.hpp>
#include <trophic/command/run_command.hpp>

#include "commands.hpp"

int main(int argc, char** argv) {
  using namespace trophic::command;
  return guarded(argv[0], [&] {
    return run_command(argc, argv,
                       {.name = {},
                        .about = "Gaits for robots, and results, pages and films from runs.",
                        .options = {},
                        .work = {},
                        .subcommands = {analyze(), ablation_table(), cross_check_engines(), evolve_gait(), measure_gait(), show(),
                                        film(), export_run()},
                        .version = version_text(backend_versions<LinkedBackends>())});
  });
}
