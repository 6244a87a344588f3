// SPDX-License-Identifier: MIT
// Offspring have their own genome.
#pragma once

#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// Rule: the offspring's genome is a copy; its mutation leaves the parent's unchanged.   Reads: parent's genome.   Random
/// draws: 0.
struct OwnCopy {
  static constexpr std::string_view name = "own_copy";
  static constexpr std::string_view source = "paper, Sec. \"Reproduction\"";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const {
    return std::make_shared<Genome>(*parent);
  }
};
static_assert(Heredity<OwnCopy>);

}  // namespace trophic::reproduction::heredity
