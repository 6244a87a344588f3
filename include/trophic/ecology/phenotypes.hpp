// SPDX-License-Identifier: MIT
// The body and the gait of each robot, as genes and expressed.
#pragma once

#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/gait_genes.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/reproduction/viability/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// The species and the genes with which an individual was born. They are stored per body, because genomes may be shared and then
/// change while their individuals live, and because a spare body keeps those of its last individual.
struct BornWith {
  IndividualId individual = 0;
  Species species = no_species;
  std::vector<double> body_genes;
  std::vector<double> gait_genes;
  static constexpr auto saved() {
    return std::tuple{&BornWith::individual, &BornWith::species, &BornWith::body_genes, &BornWith::gait_genes};
  }
};

/// The body and the gait of each robot in a table whose individuals differ in them. Otherwise it is empty, and all functions do
/// nothing.
template <class Rules>
class Phenotypes {
 public:
  static constexpr bool differ = GaitGenes<Rules>::differ;

  /// All arguments must outlive the phenotypes. Throws std::invalid_argument for rules that test newborns without a nursery.
  Phenotypes(const Policies<Rules>& rules, std::uint64_t seed, const Habitat* habitat, const Nursery* nursery)
      : rules_{rules},
        seed_{seed},
        habitat_{habitat},
        nursery_{nursery},
        bodies_{rules, habitat},
        gaits_{rules, habitat, nursery} {
    if ((GaitGenes<Rules>::are_learnt || has_trials) && nursery == nullptr)
      throw std::invalid_argument{"rules with trials of newborns: need a nursery"};
  }

  [[nodiscard]] std::span<const Phenotype> all() const { return expressed_; }
  /// The number of refused mutations of bodies.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

  /// Draws the genes of body and gait that the genome of a newborn lacks, mutates the others, and expresses them in its body; the
  /// index after the last body adds a new one. If the rule Viability refuses the newborn after a trial, they are drawn or mutated
  /// again. Random numbers are those of the individual `as`.
  void develop(BodyIndex body, const Individual& born, Genome& genome, IndividualId as) {
    if (!differ) return;
    const bool draws_body = genome.body_genes.empty();
    const bool draws_gait = genome.gait_genes.empty();
    const bool is_drawn = (BodyGenes<Rules>::are_inherited && draws_body) || (GaitGenes<Rules>::are_inherited && draws_gait);
    Rng body_rng{seed_, draws_body ? Stream::body_genes : Stream::body_mutation, as};
    Rng gait_rng{seed_, draws_gait ? Stream::gait_genes : Stream::gait_mutation, as};
    const Genome inherited = genome;
    const auto& viability = for_species(rules_.viability, born.species);
    std::string refusal;
    for (std::size_t attempt = 0; attempt < (is_drawn ? BodyGenes<Rules>::most_draws : viability.attempts()); ++attempt) {
      Phenotype own = bodies_.draw_or_mutate(genome.body_genes, born, body_rng, refused_);
      gaits_.draw_or_mutate(genome.gait_genes, model_of(own), born, gait_rng);
      own.gait = gaits_.express(born.species, genome.gait_genes, model_of(own));
      const auto reason = reproduction::ask::refusal_after_trial(viability, model_of(own), *own.gait, nursery_);
      if (!reason) return keep(body, born, genome, std::move(own));
      refusal = *reason;
      refused_ += is_drawn ? 0 : 1;
      genome = inherited;
    }
    if (is_drawn) BodyGenes<Rules>::throw_refused("newborns", refusal);
    express(body, born, genome);
  }

  /// Expresses the genes of an individual in its body unchanged.
  void express(BodyIndex body, const Individual& born, const Genome& genome) {
    if (differ) keep(body, born, genome, expressed(born.species, genome.body_genes, genome.gait_genes));
  }

  /// Sets the structure of the genes of gait and body.
  void describe(reproduction::GenomeStructure& structure, Species species, const Genome& genome) const {
    if (!genome.gait_genes.empty()) structure.gait_genes = gaits_.structure(species, genome.gait_genes);
    structure.has_modules = reproduction::genes_are_modules<typename BodyGenes<Rules>::Plan>;
  }

  /// Adds a body without an individual, with the shape of the first one.
  void add_spare() {
    if (!differ) return;
    if (genes_.empty()) throw RuleError{"recruitment", "a spare body 0: the first body must have an individual"};
    genes_.push_back(genes_.front());
    expressed_.push_back(expressed_.front());
  }

  /// Writes the genes, or reads them and expresses them again. Throws std::invalid_argument for genes from different rules or of
  /// a species beyond this number.
  void persist(Archive& archive, std::size_t species) {
    if (!differ) return;
    const std::size_t bodies = genes_.size();
    archive(refused_, genes_);
    if (!archive.reads()) return;
    Archive::require(genes_.size() == bodies, "different numbers of bodies and robots");
    for (BodyIndex body = 0; body < bodies; ++body) {
      const BornWith& genes = genes_[body];
      Archive::require(genes.species < species, "a body of no species");
      expressed_[body] = expressed(genes.species, genes.body_genes, genes.gait_genes);
      expressed_[body].individual = genes.individual;
    }
  }

 private:
  static constexpr bool has_trials = reproduction::TriesNewborns<AnswersForSpecies<PolicyIn<Rules, RuleSlot::viability>>>;

  [[nodiscard]] const RobotModel& model_of(const Phenotype& own) const { return own.robot ? *own.robot : habitat_->robot; }

  [[nodiscard]] Phenotype expressed(Species species, std::span<const double> body_genes,
                                    std::span<const double> gait_genes) const {
    Phenotype own = bodies_.express(species, body_genes);
    own.gait = gaits_.express(species, gait_genes, model_of(own));
    return own;
  }

  void keep(BodyIndex body, const Individual& born, const Genome& genome, Phenotype own) {
    if (body == genes_.size()) {
      genes_.emplace_back();
      expressed_.emplace_back();
    }
    own.individual = born.id;
    genes_[body] = {born.id, born.species, genome.body_genes, genome.gait_genes};
    expressed_[body] = std::move(own);
  }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
  const Habitat* habitat_;
  const Nursery* nursery_;
  BodyGenes<Rules> bodies_;
  GaitGenes<Rules> gaits_;
  std::uint64_t refused_ = 0;  ///< mutations
  std::vector<BornWith> genes_;
  std::vector<Phenotype> expressed_;
};

}  // namespace trophic
