// SPDX-License-Identifier: MIT
// No individual reproduces: the newcomer is random.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule: there is no parent, so the genome is random. The paper is silent about the genome of a predator that replaces a
/// sacrificed prey; `rules::Paper` uses this.   Reads: nothing.   Random draws: 0.
struct NoParent {
  static constexpr std::string_view name = "no_parent";
  static constexpr std::string_view source = "paper: silent";
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy&, const View&, Rng&) const { return std::nullopt; }
};
static_assert(Parent<NoParent>);

}  // namespace trophic::reproduction::parent
