// SPDX-License-Identifier: MIT
// The released code's shallow copy: a lineage shares one genome.
#pragma once

#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// Rule (released code): parent and offspring hold the same genome object, so that parent, offspring and every descendant
/// receive each mutation. A lineage is one genome on a random walk, without heritable variation inside it.   Reads: parent's
/// genome.   Random draws: 0.
struct SharedCopy {
  static constexpr std::string_view name = "shared_copy";
  static constexpr std::string_view source = "released code";
  [[nodiscard]] std::shared_ptr<Genome> inherit(const std::shared_ptr<Genome>& parent) const { return parent; }
};
static_assert(Heredity<SharedCopy>);

}  // namespace trophic::reproduction::heredity
