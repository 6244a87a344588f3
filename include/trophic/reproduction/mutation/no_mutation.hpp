// SPDX-License-Identifier: MIT
// Genomes are passed on unchanged.
#pragma once

#include <trophic/reproduction/mutation/contract.hpp>

namespace trophic::reproduction::mutation {

/// Rule: no weight changes, so selection acts only among founders and newcomers.   Reads: nothing.   Random draws: 0.
struct NoMutation {
  static constexpr std::string_view name = "no_mutation";
  static constexpr std::string_view source = "control";
  void mutate(std::span<double>, const Individual&, Rng&) const {}
};
static_assert(Mutation<NoMutation>);

}  // namespace trophic::reproduction::mutation
