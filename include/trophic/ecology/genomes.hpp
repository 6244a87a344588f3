// SPDX-License-Identifier: MIT
// The genomes of newborns: drawn, inherited and mutated by the rules of a table or under a null.
#pragma once

#include <trophic/ecology/births.hpp>
#include <trophic/ecology/brain_genes.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/ecology/phenotypes.hpp>
#include <trophic/ecology/trait_genes.hpp>
#include <trophic/rules/rule_states.hpp>

namespace trophic {

/// Genomes under the rules Brain, InitialGenome, Heredity, Mutation, Traits, BodyPlan and Gait, and the phenotypes that they
/// express.
template <class Rules>
class Genomes {
 public:
  /// All arguments must outlive it. Throws std::invalid_argument for a one-sided world of a species that `web` lacks, or of its
  /// only one.
  Genomes(const Policies<Rules>& rules, const FoodWeb& web, std::uint64_t seed, const BirthSetting& setting)
      : rules_{rules},
        seed_{seed},
        null_{setting.null.kind},
        one_sided_{species_of(setting.null, web)},
        brains_{rules, seed},
        traits_{rules, seed},
        phenotypes_{rules, seed, setting.habitat, setting.nursery} {}

  [[nodiscard]] const Phenotypes<Rules>& phenotypes() const { return phenotypes_; }
  void add_spare() { phenotypes_.add_spare(); }
  /// Returns the requirement of a species' brain that a genome violates, such as "a genome of 15 weights"; empty if it fits.
  [[nodiscard]] std::optional<std::string> misfit(Species species, const Genome* genome) const {
    return brains_.misfit(species, genome);
  }

  /// Draws the genome of a newborn without parents.
  [[nodiscard]] std::shared_ptr<Genome> draw(const Individual& born, BodyIndex body) {
    auto genome = std::make_shared<Genome>(Genome{.id = next_id_++});
    const IndividualId as = null_ == Null::clones ? 0 : born.id;
    brains_.draw(*genome, born, as);
    traits_.draw_or_mutate(*genome, born, as);
    phenotypes_.develop(body, born, *genome, as);
    return genome;
  }

  /// Returns the genome that the Heredity rule makes from the parents'; a null pointer without parents or under a null model that
  /// draws it anew. Throws RuleError for a genome that is invalid for the species' brain.
  [[nodiscard]] std::shared_ptr<Genome> inherit(const Individual& born, std::span<const Ancestor> parents) const {
    if (parents.empty() || null_ == Null::shadow || null_ == Null::clones || one_sided_ == born.species) return nullptr;
    Rng rng{seed_, Stream::crossover, born.id};
    auto genome =
        reproduction::ask::inherit(for_species(rules_.heredity, born.species), parents, rng, structure_of(born.species, parents));
    if (const auto demand = genome && !genome->weights.empty() ? misfit(born.species, genome.get()) : std::nullopt)
      throw RuleError{"heredity", "a genome of " + std::to_string(genome->weights.size()) + " weights: must have " + *demand};
    return genome;
  }

  /// Sets origin, parents and genome of a newborn with parents. `genome` is the inherited one; it is mutated here, and its empty
  /// parts are drawn. If it is null, a genome is drawn. `own`: the newborn's state of the rule Mutation.
  template <class State>
  void descend(Individual& born, BodyIndex body, std::span<const Ancestor> parents, std::shared_ptr<Genome> genome, State& own) {
    born.origin = Origin::inherited;
    for (const Ancestor& parent : parents) born.parents.push_back(parent.id);
    if (!genome) {
      born.genome = draw(born, body);
    } else {
      const bool is_shared = std::ranges::any_of(parents, [&](const Ancestor& parent) { return parent.genome == genome; });
      if (!is_shared) genome->id = next_id_++;
      const std::vector<double> inherited = genome->weights;
      brains_.draw_or_mutate(*genome, own, born);
      if (!inherited.empty()) born.mutation_distance = brains_.distance(born.species, inherited, genome->weights);
      traits_.draw_or_mutate(*genome, born, born.id);
      phenotypes_.develop(body, born, *genome, born.id);
      born.genome = std::move(genome);
    }
  }

  /// Gives an individual of a contest its genome. Throws std::invalid_argument for a genome that is invalid for the brain or
  /// lacks a part of the table's genomes.
  void enlist(BodyIndex body, const Individual& one, const Contestant& contestant) {
    const Genome& given = contestant.genome;
    Genome& genome = *one.genome;
    if (const auto demand = misfit(contestant.species, &given)) {
      throw std::invalid_argument{"a contest of genomes of " + std::to_string(given.weights.size()) + " weights: must have " +
                                  *demand + ", as the table's brain needs"};
    }
    const auto is_in_one = [&](auto part) { return (genome.*part).empty() != (given.*part).empty(); };
    if (is_in_one(&Genome::gait_genes) || is_in_one(&Genome::body_genes) || genome.traits.size() != given.traits.size())
      throw std::invalid_argument{"a contest of genomes with missing parts: must have the table's gaits, bodies and traits"};
    genome = {genome.id, given.weights, given.gait_genes, given.body_genes, given.traits};
    phenotypes_.express(body, one, genome);
  }

  /// Whether a genome from an archive is valid under these rules.
  [[nodiscard]] bool fits(const Individual& one) const {
    return !misfit(one.species, one.genome.get()) && one.genome->traits.size() == TraitGenes<Rules>::names.size();
  }
  /// As TraitGenes::check_bounds.
  void check_bounds(std::span<const Individual> individuals, const FoodWeb& web) const { traits_.check_bounds(individuals, web); }
  /// The id of the next genome.
  [[nodiscard]] std::uint64_t& next_id() { return next_id_; }
  void persist(Archive& archive, std::size_t species) { phenotypes_.persist(archive, species); }

 private:
  /// The structure of the first of several parents, if the rule Heredity uses it.
  [[nodiscard]] reproduction::GenomeStructure structure_of(Species species, std::span<const Ancestor> parents) const {
    reproduction::GenomeStructure structure;
    if (!reproduction::HeredityByStructure<AnswersForSpecies<PolicyIn<Rules, RuleSlot::heredity>>> || parents.size() < 2)
      return structure;
    const Genome& first = *parents.front().genome;
    brains_.describe(structure, species, first.weights);
    phenotypes_.describe(structure, species, first);
    return structure;
  }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  Null::Kind null_;
  OneSpecies one_sided_;  ///< the species that inherits nothing while the others inherit; empty: no such species
  BrainGenes<Rules> brains_;
  TraitGenes<Rules> traits_;
  Phenotypes<Rules> phenotypes_;
  std::uint64_t next_id_ = 0;
};

}  // namespace trophic
