// SPDX-License-Identifier: MIT
// The shape of the descent of those who live at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <tools/reading/lineages.hpp>
#include <vector>

namespace trophic::analysis {

/// Descent of the living members of a species at a time. Random newcomers make it a forest, so nothing here needs one tree.
struct Descent {
  double roots = 0.0;                            ///< roots with a living descendant, living roots included
  double largest_clade = 0.0;                    ///< share of the living that descend from the root with the most of them
  double mean_depth = 0.0;                       ///< mean number of births between a living individual and its root
  double greatest_depth = 0.0;                   ///< the greatest such number
  std::optional<double> related_pairs = {};      ///< share of pairs of the living with a common ancestor; none for one individual
  std::optional<double> common_ancestor_s = {};  ///< mean age of the most recent one of these pairs; none without such a pair
  double diversity_s = 0.0;  ///< phylogenetic diversity: length of all branches that lead to the living, per living individual
};

/// Empty if no member of the species is alive. An individual that lives is its own descendant: with its offspring it is a pair
/// whose common ancestor is itself. A branch is an individual's life from its birth to that of its last offspring with living
/// descendants, or to `time_s` if it lives itself.
[[nodiscard]] std::optional<Descent> descent_of(const Forest& forest, Species species, double time_s);

/// The number of births between each individual and its root.
[[nodiscard]] std::vector<std::size_t> depths_of(const Forest& forest);

}  // namespace trophic::analysis
