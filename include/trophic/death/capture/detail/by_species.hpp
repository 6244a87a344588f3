// SPDX-License-Identifier: MIT
// The catches of a rule whose parameters differ by species.
#pragma once

#include <algorithm>
#include <iterator>
#include <trophic/death/capture/contract.hpp>

namespace trophic::death::detail {

/// Returns the catches by one species' hunters.
template <class P>
[[nodiscard]] std::vector<Capture> captures_of(Species species, const P& policy, std::span<const StateOf<P>> states,
                                               const View& view, Rng& rng) {
  std::vector<Capture> all;
  if constexpr (requires { policy.captures(view, rng, states, std::optional{species}); }) {
    all = policy.captures(view, rng, states, std::optional{species});
  } else if constexpr (requires { policy.captures(view, rng, std::optional{species}); }) {
    all = policy.captures(view, rng, std::optional{species});
  } else {
    all = ask::captures(policy, states, view, rng);
  }
  std::erase_if(all, [&](const Capture& one) { return view.robots[one.hunter].species != species; });
  return all;
}

/// Returns the catches of each species' hunters under its own policy, ordered by distance. A victim of several hunters is caught
/// by the closest.
template <class P>
[[nodiscard]] std::vector<Capture> captures_by_species(const P& policy, std::span<const StateOf<P>> states, const View& view,
                                                       Rng& rng) {
  std::vector<Capture> all;
  for (Species species = 0; species < view.web.size(); ++species) {
    if (!view.web.hunts(species)) continue;
    std::ranges::copy(captures_of(species, policy.of(species), states, view, rng), std::back_inserter(all));
  }
  std::ranges::sort(all, {}, [&](const Capture& one) {
    return std::tuple{view.distance_m(one.hunter, one.victim), one.hunter, one.victim};
  });
  std::vector<Capture> first;
  for (const Capture& one : all) {
    if (std::ranges::count(first, one.victim, &Capture::victim) == 0) first.push_back(one);
  }
  return first;
}

}  // namespace trophic::death::detail
