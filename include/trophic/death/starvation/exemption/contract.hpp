// SPDX-License-Identifier: MIT
// The contract of a part of starvation::Procedure: which hunters are exempt from starvation.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::death::starvation {

/// `is_exempt(hunter, view, perceives)`: returns whether a hungry hunter escapes starvation at this tick. `perceives(self,
/// other)` is the run's Visibility rule.
template <class P>
concept Exemption = requires(const P policy, BodyIndex hunter, const View& view, const perception::Perceives& perceives) {
  { policy.is_exempt(hunter, view, perceives) } -> std::same_as<bool>;
}
|| requires(const P policy, BodyIndex hunter, const View& view, const perception::Perceives& perceives, const StateOf<P> own) {
  { policy.is_exempt(hunter, view, perceives, own) } -> std::same_as<bool>;
};

namespace ask {

template <class P>
[[nodiscard]] bool is_exempt(const P& policy, [[maybe_unused]] const StateOf<P>& own, BodyIndex hunter, const View& view,
                             const perception::Perceives& perceives) {
  const auto& rule = for_species(policy, view.robots[hunter].species);
  if constexpr (requires { rule.is_exempt(hunter, view, perceives, own); }) {
    return rule.is_exempt(hunter, view, perceives, own);
  } else {
    return rule.is_exempt(hunter, view, perceives);
  }
}

}  // namespace ask

}  // namespace trophic::death::starvation
