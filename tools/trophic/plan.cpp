// SPDX-License-Identifier: MIT
// `trophic plan`: the list of runs that a sweep file describes, by the Python module.
#include <memory>
#include <tools/command/run_python.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::plan {

struct Options {
  std::string sweep;
  std::string program = "trophic-predator-prey";
  std::optional<std::string> out;
  bool dry_run = false;
  std::optional<std::uint64_t> sbatch;
};

}  // namespace detail::plan

/// Plans of runs.
Command plan() {
  const auto options = std::make_shared<detail::plan::Options>();
  Command command{
      .name = "plan",
      .about =
          "Writes the list of runs that a sweep file describes: settings by [grid], [zip] and [[runs]], with replicates and "
          "shadows. PROGRAM --plan FOLDER/plan.jsonl makes the runs. Needs Python with numpy and pandas.",
      .options = {{"sweep", &options->sweep, "TOML file; docs/how-to/a-sweep.md describes it", {}, 0, true},
                  {"--program", &options->program, "the experiment program that makes the runs (trophic-predator-prey)"},
                  {"--out", &options->out, "folder for the plan and its runs; one that has a plan gets more runs"},
                  {"--dry-run", &options->dry_run, "print the cells and how long they take by short runs; write nothing"},
                  {"--sbatch", &options->sbatch,
                   "print a Slurm script with N array tasks: time by short runs, memory, output, signal"}},
      .work = {},
      .examples = {"trophic plan sweep.toml --out runs/sweep", "trophic plan sweep.toml --dry-run"}};
  return python_command("trophic", std::move(command), [options](Json& request) { request["experiment"] = options->program; });
}

}  // namespace trophic::command
