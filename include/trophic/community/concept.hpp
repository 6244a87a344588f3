// SPDX-License-Identifier: MIT
// The contract of a community: which species there are and who lives where at the start.
#pragma once

#include <concepts>
#include <cstddef>
#include <trophic/food_web.hpp>
#include <vector>

namespace trophic::community {

/// `web()`: the species and who eats whom. `founders(robots)`: the species of the first individual in each of `robots`
/// bodies; throws std::invalid_argument naming field, value and bound if its numbers do not fit.
template <class P>
concept Community = requires(const P policy, std::size_t robots) {
  { policy.web() } -> std::same_as<FoodWeb>;
  { policy.founders(robots) } -> std::same_as<std::vector<Species>>;
};

}  // namespace trophic::community
