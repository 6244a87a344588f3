// SPDX-License-Identifier: MIT
// The body and the gait in each robot, kept as genes and expressed.
#pragma once

#include <cstddef>
#include <span>
#include <trophic/ecology/genome_parts.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/support/rule_error.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace trophic {

/// The species and the genes with which an individual was born. Kept for each body: heredities may share genomes, which then
/// change while their individuals live, and a spare body keeps its last individual's.
struct BornWith {
  IndividualId individual = 0;
  Species species = no_species;
  std::vector<double> body;
  std::vector<double> gait;
  static constexpr auto saved() {
    return std::tuple{&BornWith::individual, &BornWith::species, &BornWith::body, &BornWith::gait};
  }
};

/// The body and the gait in each robot under a table whose individuals differ; empty otherwise.
template <class Rules>
class Phenotypes {
 public:
  [[nodiscard]] std::span<const Phenotype> all() const { return expressed_; }

  /// Expresses the genes of the individual that is born in a body; the body after the last one is a new one.
  void express(BodyIndex body, const Individual& born, const GenomeParts<Rules>& parts) {
    if (body == expressed_.size()) add({}, {});
    genes_[body] = {.individual = born.id, .species = born.species, .body = born.genome->body, .gait = born.genome->gait};
    expressed_[body] = expressed(genes_[body], parts);
  }

  /// Adds a body that starts without an individual: it is as the first one.
  void add_spare() {
    if (genes_.empty()) throw RuleError{"recruitment", "a spare body 0: the first body must have an individual"};
    add(genes_.front(), expressed_.front());
  }

  /// Writes the genes, or reads them and expresses them again.
  void persist(Archive& archive, std::size_t species, const GenomeParts<Rules>& parts) {
    const std::size_t bodies = genes_.size();
    archive(genes_);
    if (!archive.reads()) return;
    Archive::require(genes_.size() == bodies, "another number of bodies than of robots");
    for (BodyIndex body = 0; body < bodies; ++body) {
      Archive::require(genes_[body].species < species, "a body of no species");
      expressed_[body] = expressed(genes_[body], parts);
    }
  }

 private:
  void add(BornWith genes, Phenotype own) {
    genes_.push_back(std::move(genes));
    expressed_.push_back(std::move(own));
  }
  [[nodiscard]] static Phenotype expressed(const BornWith& genes, const GenomeParts<Rules>& parts) {
    Phenotype own = parts.express(genes.species, genes.body, genes.gait);
    own.individual = genes.individual;
    return own;
  }

  std::vector<BornWith> genes_;
  std::vector<Phenotype> expressed_;
};

}  // namespace trophic
