// SPDX-License-Identifier: MIT
// Definitions of drift.hpp.
#include <map>
#include <tools/reading/drift.hpp>
#include <tuple>

namespace trophic::analysis {

Forest drift_of(const Forest& forest, Rng& rng) {
  Forest drifted = forest;
  std::map<std::tuple<Species, bool, bool>, std::vector<std::size_t>> alike;  // founders, later roots and offspring of a species
  for (std::size_t place = 0; place < forest.size(); ++place) {
    const Taxon& born = forest[place];
    alike[{born.species, born.parent.has_value(), born.birth_s == forest.front().birth_s}].push_back(place);
    for (std::size_t i = 0; born.parent && i < born.weights.size(); ++i) {
      drifted[place].weights[i] -= forest[*born.parent].weights[i];
    }
  }
  for (const auto& [_, places] : alike) {
    for (std::size_t left = places.size(); left > 1; --left) {
      std::swap(drifted[places[left - 1]].weights, drifted[places[rng.index(left)]].weights);
    }
  }
  std::vector<std::size_t> living;  // of any species, by place; those that have died are removed when met
  std::vector<std::size_t> candidates;
  for (std::size_t place = 0; place < forest.size(); ++place) {
    const Taxon& born = forest[place];
    std::erase_if(living, [&](std::size_t one) { return forest[one].death_s <= born.birth_s; });
    if (born.parent) {
      candidates.clear();
      for (const std::size_t one : living) {
        if (forest[one].species == born.species && forest[one].birth_s < born.birth_s) candidates.push_back(one);
      }
      const std::size_t parent = candidates.empty() ? *born.parent : candidates[rng.index(candidates.size())];
      drifted[place].parent = parent;
      for (std::size_t i = 0; i < born.weights.size(); ++i) drifted[place].weights[i] += drifted[parent].weights[i];
    }
    living.push_back(place);
  }
  return drifted;
}

}  // namespace trophic::analysis
