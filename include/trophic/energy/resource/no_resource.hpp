// SPDX-License-Identifier: MIT
// The world has no food of its own.
#pragma once

#include <trophic/energy/resource/contract.hpp>

namespace trophic::energy::resource {

/// Rule: nothing grows on the floor, as in the paper.   Reads: nothing.   Random draws: 0.
struct NoResource {
  static constexpr std::string_view name = "no_resource";
  static constexpr std::string_view source = "paper: no such rule";
  [[nodiscard]] ResourceField start(const Arena&, Rng&) const { return {}; }
  void grow(ResourceField&, const View&, Rng&) const {}
};
static_assert(Resource<NoResource>);

}  // namespace trophic::energy::resource
