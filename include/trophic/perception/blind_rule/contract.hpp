// SPDX-License-Identifier: MIT
// The contract of a slot: whether who perceives no adversary decides.
#pragma once

#include <concepts>

#define TROPHIC_SENTENCE_BlindRule "bool decides() const; see trophic/perception/blind_rule/contract.hpp"

namespace trophic::perception {

/// `decides()`: whether the brain is run while no adversary is perceivable; if not, its last decision stays. What sensors say
/// then is each sensor's own.
template <class P>
concept BlindRule = requires(const P policy) {
  { policy.decides() } -> std::same_as<bool>;
};

}  // namespace trophic::perception
