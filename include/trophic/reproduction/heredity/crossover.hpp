// SPDX-License-Identifier: MIT
// Offspring of two parents.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/reproduction/heredity/contract.hpp>

namespace trophic::reproduction::heredity {

/// The genes that are inherited from one parent together.
enum class CrossoverUnit { weight, run };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(CrossoverUnit) {
  return {"weight", "run"};
}

/// Rule: each weight of the brain and each number of the gait is that of one of the parents, at random: every gene alone (uniform
/// crossover [syswerda1989]), or runs of `length` genes, such as the weights of one neuron. The body is the first parent's, and
/// so is a part in which parents differ in length. For brains of one size. The offspring of one parent has a copy.   Reads:
/// parents' genomes.   Random draws: one for each gene or run, if there are several parents.
struct Crossover {
  static constexpr std::string_view name = "crossover";
  static constexpr std::string_view source = "not in the paper; [syswerda1989]";

  struct Params {
    CrossoverUnit unit = CrossoverUnit::weight;
    std::size_t length = 3;
    static constexpr auto fields() {
      return std::tuple{field("unit", &Params::unit, "weight: every gene alone; run: `length` genes together"),
                        field("length", &Params::length, at_least(1), "genes of a run")};
    }
  };
  Params params;

  [[nodiscard]] std::shared_ptr<Genome> inherit(std::span<const Ancestor> parents, Rng& rng) const {
    auto child = std::make_shared<Genome>(*parents.front().genome);
    if (parents.size() == 1) return child;
    cross(parents, &Genome::weights, *child, rng);
    cross(parents, &Genome::gait_genes, *child, rng);
    return child;
  }

 private:
  void cross(std::span<const Ancestor> parents, std::vector<double> Genome::*part, Genome& child, Rng& rng) const {
    std::vector<double>& genes = child.*part;
    for (const Ancestor& parent : parents) {
      if (((*parent.genome).*part).size() != genes.size()) return;
    }
    const std::size_t unit = params.unit == CrossoverUnit::weight ? 1 : params.length;
    const Ancestor* from = nullptr;
    for (std::size_t gene = 0; gene < genes.size(); ++gene) {
      if (gene % unit == 0) from = &parents[rng.index(parents.size())];
      genes[gene] = ((*from->genome).*part)[gene];
    }
  }
};
static_assert(Heredity<Crossover>);

}  // namespace trophic::reproduction::heredity
