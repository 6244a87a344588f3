// SPDX-License-Identifier: MIT
// The contract of a part of starvation::Procedure: whom a starvation procedure kills.
#pragma once

#include <concepts>
#include <functional>
#include <trophic/population/individual.hpp>
#include <trophic/population/view.hpp>
#include <vector>

namespace trophic::death::starvation {

/// Whether a hunter is exempt, as a choice may ask it. Observers are given each hunter that was asked about and is.
using IsExempt = std::function<bool(BodyIndex hunter)>;

/// `victims(view, is_exempt)`: who starves in a procedure, in order, each once.
template <class P>
concept Choice = requires(const P policy, const View& view, const IsExempt& is_exempt) {
  { policy.victims(view, is_exempt) } -> std::same_as<std::vector<BodyIndex>>;
};

}  // namespace trophic::death::starvation
