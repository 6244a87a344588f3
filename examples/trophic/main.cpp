// SPDX-License-Identifier: MIT
// The program trophic: everything that does not depend on a rule table. `trophic --help` lists its commands.
#include <trophic/command/backends.hpp>
#include <trophic/command/provenance.hpp>
#include <trophic/command/run_command.hpp>

#include "commands.hpp"

int main(int argc, char** argv) {
  using namespace trophic::command;
  return guarded(argv[0], [&] {
    return run_command(
        argc, argv,
        {.name = {},
         .about = "Gaits for robots, and results, pages and films from runs.",
         .options = {},
         .work = {},
         .subcommands = {commands::analyze(), commands::flip_table(), commands::cross_check(), commands::evolve_gait(),
                         commands::measure_gait(), commands::show(), commands::film(), commands::export_run()},
         .version = version_text(backend_versions<LinkedBackends>())});
  });
}
