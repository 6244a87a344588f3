// SPDX-License-Identifier: MIT
// Definitions of descent.hpp.
#include <tools/analysis/metrics/descent.hpp>

#include <algorithm>

namespace trophic::analysis {

std::vector<std::size_t> depths_of(const Forest& forest) {
  std::vector<std::size_t> depths(forest.size(), 0);
  for (std::size_t place = 0; place < forest.size(); ++place) {
    if (forest[place].parent) depths[place] = depths[*forest[place].parent] + 1;
  }
  return depths;
}

std::optional<Descent> descent_of(const Forest& forest, Species species, double time_s) {
  const auto pairs_of = [](double members) { return 0.5 * members * (members - 1.0); };
  const std::vector<std::size_t> depths = depths_of(forest);
  std::vector<double> living(forest.size(), 0.0);        // in the clade of each individual
  std::vector<double> pairs_below(forest.size(), 0.0);   // of which both are in the clade of one offspring
  std::vector<double> branch_end_s(forest.size(), 0.0);  // of those with living descendants
  Descent descent;
  double all = 0.0;
  double related = 0.0;
  double ages_s = 0.0;
  for (std::size_t place = forest.size(); place-- > 0;) {
    const Taxon& taxon = forest[place];
    if (taxon.species == species && taxon.lives_at(time_s)) {
      all += 1.0;
      living[place] += 1.0;
      branch_end_s[place] = time_s;
      const auto depth = static_cast<double>(depths[place]);
      descent.mean_depth += depth;
      descent.greatest_depth = std::max(descent.greatest_depth, depth);
    }
    if (living[place] == 0.0) continue;
    descent.diversity_s += branch_end_s[place] - taxon.birth_s;
    const double pairs = pairs_of(living[place]) - pairs_below[place];
    related += pairs;
    ages_s += pairs * (time_s - taxon.birth_s);
    if (taxon.parent) {
      living[*taxon.parent] += living[place];
      pairs_below[*taxon.parent] += pairs_of(living[place]);
      branch_end_s[*taxon.parent] = std::max(branch_end_s[*taxon.parent], taxon.birth_s);
    } else {
      descent.roots += 1.0;
      descent.largest_clade = std::max(descent.largest_clade, living[place]);
    }
  }
  if (all == 0.0) return std::nullopt;
  descent.largest_clade /= all;
  descent.mean_depth /= all;
  descent.diversity_s /= all;
  if (all > 1.0) descent.related_pairs = related / pairs_of(all);
  if (related > 0.0) descent.common_ancestor_s = ages_s / related;
  return descent;
}

}  // namespace trophic::analysis
