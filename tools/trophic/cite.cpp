// SPDX-License-Identifier: MIT
// `trophic cite`: how a paper cites a run, by the Python module.
#include <memory>
#include <tools/command/run_python.hpp>

#include "commands.hpp"

namespace trophic::command {

/// Prints how to cite a run.
Command cite() {
  const auto folder = std::make_shared<std::string>();
  Command command{
      .name = "cite",
      .about =
          "Prints how to cite a run or a set of replicates: a sentence with rule table, changed parameters, engine, version and "
          "seed from its manifest, and BibTeX entries. Needs Python with pandas.",
      .options = {{.name = "run", .target = folder.get(), .help = "folder of a run or of replicates", .required = true}},
      .work = {},
      .examples = {"trophic cite runs/paper"}};
  return python_command("trophic", std::move(command), [folder](Json&) {});
}

}  // namespace trophic::command
