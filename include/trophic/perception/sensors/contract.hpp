// SPDX-License-Identifier: MIT
// The contract of a slot: what the brain is told.
#pragma once

#include <concepts>
#include <trophic/perception/adversary.hpp>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_SightingInput \
  "double input(const Sighting&, const View&) const; see trophic/perception/sensors/contract.hpp"
#define TROPHIC_SENTENCE_PopulationInput "double input(const View&) const; see trophic/perception/sensors/contract.hpp"

namespace trophic::perception {

/// `input(sighting, view)`: one of the inputs that describe the adversary.
template <class P>
concept SightingInput = requires(const P policy, const Sighting& sighting, const View& view) {
  { policy.input(sighting, view) } -> std::same_as<double>;
};

/// `input(view)`: the input that describes the population.
template <class P>
concept PopulationInput = requires(const P policy, const View& view) {
  { policy.input(view) } -> std::same_as<double>;
};

}  // namespace trophic::perception
