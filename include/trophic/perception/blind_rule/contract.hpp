// SPDX-License-Identifier: MIT
// The contract of a slot: what the brain is told when no adversary is perceivable.
#pragma once

#include <concepts>
#include <optional>
#include <trophic/perception/brain_inputs.hpp>

#define TROPHIC_SENTENCE_BlindRule \
  "std::optional<BrainInputs> inputs(double tag_ratio) const; see trophic/perception/blind_rule/contract.hpp"

namespace trophic::perception {

/// `inputs(tag_ratio)`: what the brain is told when no adversary is perceivable; nothing: the brain is not run and its last
/// decision stays.
template <class P>
concept BlindRule = requires(const P policy, double tag_ratio) {
  { policy.inputs(tag_ratio) } -> std::same_as<std::optional<BrainInputs>>;
};

}  // namespace trophic::perception
