// SPDX-License-Identifier: MIT
// The distance between body plans, and the diversity of plans.
#pragma once

#include <cstddef>
#include <span>
#include <trophic/habitat/body/module.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::body {

/// The tree edit distance of two plans: the smallest number of inserted, deleted or changed modules that turns one plan into the
/// other, each at cost 1. A deleted module's children become its parent's; a change replaces type, face and quarter turns at
/// once. Trees are ordered by face. It is a metric: 0 only for equal plans. Computed as in [zhang1989], in time at most
/// proportional to the squared product of the numbers of modules.
[[nodiscard]] std::size_t edit_distance(const ModuleTree& a, const ModuleTree& b);

/// The Shannon number of kinds, given the number of individuals of each: exp(-sum p ln p), Hill's number of order 1 [hill1973].
/// It equals the number of kinds if all are equally frequent, and is 0 without individuals.
[[nodiscard]] double shannon_number(std::span<const std::size_t> individuals);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/distance.ipp>
#endif
