// SPDX-License-Identifier: MIT
// `trophic ablation-table`, what each swap of an ablation study changes: tables of all swaps and metrics by the Python module.
#include <memory>
#include <tools/command/run_python.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::ablation_table {

struct Options {
  std::string runs;
  std::uint64_t jobs = 1;
  std::string out = "swaps";
};

}  // namespace detail::ablation_table

/// Tables of all swaps of an ablation study.
Command ablation_table() {
  const auto options = std::make_shared<detail::ablation_table::Options>();
  Command command{
      .name = "ablation-table",
      .about =
          "Reads the sets of an ablation study and writes what each swap changes: ablations.csv (all) and ablations.md (the "
          "significant ones). Needs Python with pandas and scipy.",
      .options = {{"runs", &options->runs, "the OUT of the study", {}, 0, true},
                  {"--jobs", &options->jobs, "runs measured at a time (1); results do not depend on it"},
                  {"--out", &options->out, "new folder for the tables (swaps)"}},
      .work = {}};
  return python_command("trophic", std::move(command), [options](Json&) {
    if (options->jobs == 0) throw std::invalid_argument{"--jobs 0: must be >= 1"};
  });
}

}  // namespace trophic::command
