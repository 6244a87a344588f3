// SPDX-License-Identifier: MIT
// Runs an experiment under a live page, and again as often as the page asks for it.
#pragma once

#include <trophic/command/config.hpp>
#include <trophic/command/experiment_options.hpp>
#include <trophic/command/live.hpp>
#include <trophic/command/selection.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::command {

/// Returns the exit code of the last run. The first run goes into the folder of the options, each further one into the next free
/// folder of that name. With the same rule table it has the numbers as they were changed last. Throws std::invalid_argument if
/// `open_live` is null.
[[nodiscard]] int run_live(Selection selection, ExperimentOptions options, Config config, const Offer& offer, OpenLive open_live);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/run_live.ipp>
#endif
