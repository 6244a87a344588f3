// SPDX-License-Identifier: MIT
// Definitions of drift.hpp.
#include <map>
#include <tools/reading/drift.hpp>
#include <tuple>

namespace trophic::analysis {

namespace {

/// Adds `factor` times the mean of its parents' weights to an individual's.
void add_parents(Taxon& born, const Forest& forest, double factor) {
  std::vector<std::size_t> parents = born.others;
  if (born.parent) parents.push_back(*born.parent);
  for (const std::size_t parent : parents) {
    const double share = factor / static_cast<double>(parents.size());
    for (std::size_t i = 0; i < born.weights.size(); ++i) born.weights[i] += share * forest[parent].weights[i];
  }
}

}  // namespace

Forest drift_of(const Forest& forest, Rng& rng) {
  Forest drifted = forest;
  std::map<std::tuple<Species, bool, bool>, std::vector<std::size_t>> alike;  // founders, later roots and offspring of a species
  for (std::size_t place = 0; place < forest.size(); ++place) {
    const Taxon& born = forest[place];
    alike[{born.species, born.parent.has_value(), born.birth_s == forest.front().birth_s}].push_back(place);
    add_parents(drifted[place], forest, -1.0);
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
      for (const std::size_t one : living)
        if (forest[one].species == born.species && forest[one].birth_s < born.birth_s) candidates.push_back(one);
      const auto draw = [&](std::size_t& parent) {
        std::swap(candidates[rng.index(candidates.size())], candidates.back());
        parent = candidates.back();
        candidates.pop_back();
      };
      if (candidates.size() > born.others.size()) {
        draw(*drifted[place].parent);
        for (std::size_t& other : drifted[place].others) draw(other);
      }
      add_parents(drifted[place], drifted, 1.0);
    }
    living.push_back(place);
  }
  return drifted;
}

}  // namespace trophic::analysis
