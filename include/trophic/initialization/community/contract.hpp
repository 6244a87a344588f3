// SPDX-License-Identifier: MIT
// The contract of a slot: the species, and the species of the founder in each body.
#pragma once

#include <concepts>
#include <trophic/population/food_web.hpp>

#define TROPHIC_SENTENCE_Community                                                        \
  "FoodWeb web() const and std::vector<Species> founders(std::size_t robots) const; see " \
  "trophic/initialization/community/contract.hpp"

namespace trophic::initialization {

/// `web()`: returns the species and their feeding links. `founders(robots)`: returns the species of the first individual in
/// each of `robots` bodies; throws std::invalid_argument naming field, value and bound if its parameters do not fit.
template <class P>
concept Community = requires(const P policy, std::size_t robots) {
  { policy.web() } -> std::same_as<FoodWeb>;
  { policy.founders(robots) } -> std::same_as<std::vector<Species>>;
};

}  // namespace trophic::initialization
