// SPDX-License-Identifier: MIT
// `trophic cross-check`, what depends on the engine: the metrics of two sets of runs, by the Python module.
#include <memory>
#include <tools/command/run_python.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::cross_check {

struct Options {
  std::vector<std::string> runs;
  std::string out = "cross-check";
};

}  // namespace detail::cross_check

/// Two engines compared.
Command cross_check_engines() {
  const auto options = std::make_shared<detail::cross_check::Options>();
  Command command{
      .name = "cross-check",
      .about =
          "Compares two engines, or two settings of one: the metrics of two sets of runs of the same rules, as two cells of a "
          "sweep over engines, with two one-sided tests of equivalence each. Needs Python with pandas and scipy.",
      .options = {{"runs", &options->runs, "two folders of replicates, each on one engine", {}, 2, true},
                  {"--out", &options->out, "new folder for cross_check.csv (cross-check)"}},
      .work = {},
      .examples = {"trophic cross-check runs/engines/cell-000 runs/engines/cell-001 --out engines"}};
  return python_command("trophic", std::move(command), [options](Json& request) { request["runs"] = options->runs; });
}

}  // namespace trophic::command
