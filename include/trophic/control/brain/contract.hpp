// SPDX-License-Identifier: MIT
// The contract of a slot: what a brain must offer.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <trophic/perception/brain_inputs.hpp>
#include <vector>

#define TROPHIC_SENTENCE_Brain                                                                                              \
  "std::size_t genome_size() const, std::vector<int> tags() const and Decision decide(const BrainInputs&, std::span<const " \
  "double> weights) const; see trophic/control/brain/contract.hpp"

namespace trophic::control {

/// What a brain decides at a tick.
struct Decision {
  double target_angle_rad = 0.0;  ///< where it wants to go: positive to the right
  int tag = 1;                    ///< which tag it wants to show: -1 or +1
};

/// `genome_size()`: number of weights; `tags()`: every tag that it may choose; `decide(inputs, weights)`: pure function of both.
template <class P>
concept Brain = requires(const P policy, const perception::BrainInputs& inputs, std::span<const double> weights) {
  { policy.genome_size() } -> std::same_as<std::size_t>;
  { policy.tags() } -> std::same_as<std::vector<int>>;
  { policy.decide(inputs, weights) } -> std::same_as<Decision>;
};

}  // namespace trophic::control
