// SPDX-License-Identifier: MIT
// The program trophic: everything that does not depend on a rule table. `trophic --help` lists its commands.
#include <algorithm>
#include <tools/command/backends.hpp>
#include <tools/command/provenance.hpp>
#include <tools/command/run_command.hpp>

#include "commands.hpp"
#include "found_programs.hpp"

namespace {

trophic::command::Command program() {
  using namespace trophic::command;
  return {.name = {},
          .about = "Plans sweeps, analyses runs, and makes their figures, pages and films; evolves gaits for robots.",
          .options = {},
          .work = {},
          .subcommands = {show(), film(), export_run(), evolve_gait(), measure_gait(), convert_body()},
          .version = version_text(backend_versions(built_backends())),
          .examples = {"trophic analyze runs/study --out analysis", "trophic plot analysis", "trophic help slots"}};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::command;
  return guarded(argv[0], [&] {
    Command command = program();
    const std::string asked = argc > 1 ? argv[1] : "";
    const bool is_own = std::ranges::find(command.subcommands, asked, &Command::name) != command.subcommands.end();
    const bool is_name = !asked.empty() && asked.find('/') == std::string::npos && !asked.starts_with('-');
    if (!is_own && is_name) {
      if (const auto other = found_program(asked); !other.empty()) become(other, argv);
    }
    if (!is_own) {
      for (const auto& [name, _] : found_programs()) command.elsewhere.push_back(name);
    }
    return run_command(argc, argv, command);
  });
}
