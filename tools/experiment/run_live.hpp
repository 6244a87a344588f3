// SPDX-License-Identifier: MIT
// Runs an experiment under a live page, and again as often as the page asks for it.
#pragma once

#include <memory>
#include <tools/command/config.hpp>
#include <tools/command/offers.hpp>
#include <tools/experiment/experiment_options.hpp>

namespace trophic::command {

/// Returns the exit code of the last run. The first run goes into the folder of the options, each further one into the next free
/// folder of that name. With the same rule table it has the parameters as they were changed last. Throws std::invalid_argument if
/// trophic was built without its page.
[[nodiscard]] int run_live(std::unique_ptr<AnyExperiment> chosen, ExperimentOptions options, Config config, const Offer& offer);

}  // namespace trophic::command
