// SPDX-License-Identifier: MIT
// The null of lineages: the same births, deaths and mutations with parents by chance.
#pragma once

#include <tools/reading/lineages.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::analysis {

/// The forest in which the parents of each individual that has any are drawn among those of its species that are alive just
/// before its birth and after its tick's deaths; if these are fewer than its parents, it keeps them. Genomes of roots are
/// permuted among the founders of a species, and among its later roots. Each offspring's weights are the mean of its new parents'
/// plus the mutation, with two parents also the crossover, of another offspring of its species, also permuted. So births, deaths
/// and the numbers of newcomers are the run's, and no genome lives longer or has more offspring for what it does.
[[nodiscard]] Forest drift_of(const Forest& forest, Rng& rng);

}  // namespace trophic::analysis
