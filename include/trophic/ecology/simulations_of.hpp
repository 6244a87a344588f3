// SPDX-License-Identifier: MIT
// The ecologies of one experiment, for those who run several of it.
#pragma once

#include <cstdint>
#include <memory>
#include <trophic/backend/contract.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <utility>

namespace trophic {

/// Makes ecologies of these numbers that differ in their seed alone. What it returns throws as the ecology's constructor does.
template <class Rules, Backend B>
[[nodiscard]] MakeSimulation simulations_of(const Experiment<Rules, B>& experiment) {
  return [experiment](std::uint64_t seed) {
    Experiment<Rules, B> own = experiment;
    own.seed = seed;
    return std::make_unique<Ecology<Rules, B>>(std::move(own));
  };
}

}  // namespace trophic
