// SPDX-License-Identifier: MIT
// The ecologies of one experiment that differ only in their seed.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>

namespace trophic {

/// Makes ecologies of these parameters that differ only in their seed and, for a neutral null, in the history that they repeat.
/// `installed`: the folder of installed models, which must outlive the result. The result throws as the ecology's constructor and
/// `history` do.
template <class Rules>
[[nodiscard]] MakeSimulation simulations_of(const Experiment<Rules>& experiment, const BackendChoice& backend,
                                            const HistoryOf& history = {}, std::string_view installed = TROPHIC_MODEL_DIR) {
  return [experiment, backend, history, installed](std::uint64_t seed) {
    Experiment<Rules> own = experiment;
    own.seed = seed;
    if (history) own.history = history(seed);
    return make_dynamics<Rules>(std::move(own), backend, installed);
  };
}

}  // namespace trophic
