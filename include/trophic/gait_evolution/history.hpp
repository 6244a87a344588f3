// SPDX-License-Identifier: MIT
// A pre-experiment's history as CSV tables.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <trophic/gait_evolution/lineage.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// The fitness of those who survived a generation, highest first.
[[nodiscard]] inline std::vector<double> fitness_after(const Lineage& lineage, std::size_t generation) {
  std::vector<double> fitness;
  for (const Individual& individual : lineage.individuals) {
    const bool alive = individual.born <= generation && (!individual.died || *individual.died > generation);
    if (alive) fitness.push_back(individual.fitness);
  }
  std::ranges::sort(fitness, std::greater{});
  return fitness;
}

/// The middle of sorted numbers, or the mean of the two middle ones. At least one number.
[[nodiscard]] inline double median(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

/// One row a generation, the founders' is 0: tries so far, and best, median and worst fitness of the survivors, how many of the
/// newborn diverged (their fitness is -inf).
[[nodiscard]] inline std::string generations_csv(const Lineage& lineage) {
  std::string text = "generation,evaluations,best,median,worst,diverged\n";
  for (std::size_t generation = 0; generation < lineage.generations; ++generation) {
    const auto& all = lineage.individuals;
    const auto evaluations = std::ranges::count_if(all, [=](const Individual& one) { return one.born <= generation; });
    const auto diverged =
        std::ranges::count_if(all, [=](const Individual& one) { return one.born == generation && !std::isfinite(one.fitness); });
    const std::vector<double> fitness = fitness_after(lineage, generation);
    text += number_text(generation) + "," + number_text(evaluations) + "," + number_text(fitness.front()) + "," +
            number_text(median(fitness)) + "," + number_text(fitness.back()) + "," + number_text(diverged) + "\n";
  }
  return text;
}

/// phylogeny.csv in the ALife data standard, time in generations. Standard columns: id, ancestor_list ("[none]", "[3]" or
/// "[3,9]"), origin_time, destruction_time (inf: alive); ancestor_id is the first ancestor (a root's: its own id). Ours: fitness,
/// hidden_nodes, enabled_links.
[[nodiscard]] inline std::string phylogeny_csv(const Lineage& lineage) {
  std::string text = "id,ancestor_list,ancestor_id,origin_time,destruction_time,fitness,hidden_nodes,enabled_links\n";
  for (std::size_t id = 0; id < lineage.individuals.size(); ++id) {
    const Individual& one = lineage.individuals[id];
    std::string ancestors = "[none]";
    if (one.parents.size() == 1) ancestors = "[" + number_text(one.parents[0]) + "]";
    if (one.parents.size() == 2) ancestors = "\"[" + number_text(one.parents[0]) + "," + number_text(one.parents[1]) + "]\"";
    text += number_text(id) + "," + ancestors + "," + number_text(one.parents.empty() ? id : one.parents[0]) + "," +
            number_text(one.born) + "," + (one.died ? number_text(*one.died) : "inf") + "," + number_text(one.fitness) + "," +
            number_text(one.genome.nodes.size() - 1) + "," +
            number_text(std::ranges::count_if(one.genome.links, &LinkGene::enabled)) + "\n";
  }
  return text;
}

}  // namespace trophic::gait_evolution
