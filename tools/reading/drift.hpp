// SPDX-License-Identifier: MIT
// The null of lineages: the same births, deaths and mutations with parents by chance.
#pragma once

#include <tools/reading/lineages.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::analysis {

/// The forest in which the parent of each individual that has one is drawn among those of its species that are alive just before
/// its birth and after its tick's deaths; if there are none, it keeps its parent. Each offspring's weights are those of its new
/// parent plus the same mutation: the difference between its weights and its parent's. Roots keep their weights. So births,
/// deaths, random newcomers and mutations are the run's, and no genome has more offspring for what it does.
[[nodiscard]] Forest drift_of(const Forest& forest, Rng& rng);

}  // namespace trophic::analysis
