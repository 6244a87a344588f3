// SPDX-License-Identifier: MIT
// The program trophic: everything that does not depend on a rule table. `trophic --help` lists its commands.
#include <tools/command/backends.hpp>
#include <tools/command/provenance.hpp>
#include <tools/command/run_command.hpp>

#include "commands.hpp"
#include "shipped_offer.hpp"

namespace {

trophic::command::Command program() {
  using namespace trophic::command;
  return {.name = {},
          .about = "From plans to results: lists of runs, analyses, figures, pages and films; gaits for robots.",
          .options = {},
          .work = {},
          .subcommands = {plan(), analyze("trophic", shipped_offer()), contest_command(), plot(), cite(), show(), film(),
                          export_run(), ablation_table(), cross_check_engines(), evolve_gait(), measure_gait(), convert_body(),
                          help(&program)},
          .version = version_text(backend_versions(built_backends())),
          .examples = {"trophic analyze runs/study --out analysis", "trophic plot analysis", "trophic help slots"}};
}

}  // namespace

int main(int argc, char** argv) {
  return trophic::command::guarded(argv[0], [&] { return trophic::command::run_command(argc, argv, program()); });
}
