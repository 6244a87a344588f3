// SPDX-License-Identifier: MIT
// The contract of a slot: whether robots decide together or in turn.
#pragma once

#include <concepts>

#define TROPHIC_SENTENCE_DecisionOrder "bool in_turn() const; see trophic/control/decision_order/contract.hpp"

namespace trophic::control {

/// `in_turn()`: whether robots decide one after the other, by body, each seeing the tags that earlier ones have taken at this
/// tick; otherwise all perceive the same moment.
template <class P>
concept DecisionOrder = requires(const P policy) {
  { policy.in_turn() } -> std::same_as<bool>;
};

}  // namespace trophic::control
