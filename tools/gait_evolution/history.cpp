// SPDX-License-Identifier: MIT
// Definitions of history.hpp.
#include <tools/gait_evolution/history.hpp>

#include <cmath>
#include <functional>
#include <span>
#include <trophic/io/csv.hpp>
#include <trophic/params/params.hpp>

namespace trophic::gait_evolution {

std::vector<double> fitness_after(const Lineage& lineage, std::size_t generation) {
  std::vector<double> fitness;
  for (const Individual& individual : lineage.individuals) {
    if (individual.survived(generation)) fitness.push_back(individual.fitness);
  }
  std::ranges::sort(fitness, std::greater{});
  return fitness;
}

double median(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

std::string generations_csv(const Lineage& lineage) {
  std::vector<GenerationRow> rows;
  for (std::size_t generation = 0; generation < lineage.generations; ++generation) {
    const auto count = [&](auto&& counts) {
      return static_cast<std::size_t>(std::ranges::count_if(lineage.individuals, counts));
    };
    const std::vector<double> fitness = fitness_after(lineage, generation);
    rows.push_back(
        {.generation = generation,
         .evaluations = count([=](const Individual& one) { return one.born <= generation; }),
         .best = fitness.front(),
         .median = median(fitness),
         .worst = fitness.back(),
         .diverged = count([=](const Individual& one) { return one.born == generation && !std::isfinite(one.fitness); })});
  }
  return io::table_text(std::span<const GenerationRow>{rows});
}

std::string phylogeny_csv(const Lineage& lineage) {
  std::vector<TaxonRow> rows;
  for (std::size_t id = 0; id < lineage.individuals.size(); ++id) {
    const Individual& one = lineage.individuals[id];
    std::string ancestors;
    for (const std::size_t parent : one.parents) ancestors += (ancestors.empty() ? "" : ",") + number_text(parent);
    rows.push_back({.id = id,
                    .ancestor_list = "[" + (ancestors.empty() ? std::string{"none"} : ancestors) + "]",
                    .origin_time = one.born,
                    .destruction_time = one.died,
                    .fitness = one.fitness,
                    .hidden_nodes = one.genome.nodes.size() - 1,
                    .enabled_links = static_cast<std::size_t>(std::ranges::count_if(one.genome.links, &LinkGene::enabled))});
  }
  return io::table_text(std::span<const TaxonRow>{rows});
}

}  // namespace trophic::gait_evolution
