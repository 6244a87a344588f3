// SPDX-License-Identifier: MIT
// The contract of a slot: who can perceive whom.
#pragma once

#include <concepts>
#include <trophic/population/individual.hpp>

#define TROPHIC_SENTENCE_Visibility \
  "bool perceives(const Individual& self, const Individual& other) const; see trophic/perception/visibility/contract.hpp"

namespace trophic::perception {

/// `perceives(self, other)`: whether self can perceive other, whatever the distance. Species are checked elsewhere.
template <class P>
concept Visibility = requires(const P policy, const Individual& self, const Individual& other) {
  { policy.perceives(self, other) } -> std::same_as<bool>;
};

}  // namespace trophic::perception
