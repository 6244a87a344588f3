// SPDX-License-Identifier: MIT
// The nearest individual of the species to which the body goes reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule: the parent is the closest living individual of the species to which the body goes, at any distance; there is none if no
/// other member is alive. If the rules do not fix that species, it is the dying individual's. After senescence the body stays
/// with its species.   Reads: positions, species.   Random draws: 0.
struct NearestConspecific {
  static constexpr std::string_view name = "nearest_conspecific";
  static constexpr std::string_view source = "not in the paper";
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&) const {
    const Species successor = vacancy.successor.value_or(view.robots[vacancy.body].species);
    const auto closest = view.closest(vacancy.body, [&](const Individual& other) { return other.species == successor; },
                                      {.among = marks_of(successor)});
    if (!closest) return std::nullopt;
    return view.robots[*closest].as_ancestor();
  }
};
static_assert(Parent<NearestConspecific>);

}  // namespace trophic::reproduction::parent
