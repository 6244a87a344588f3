// SPDX-License-Identifier: MIT
// Owner of who lives: founders, births, ids, genomes.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/population/view.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// One individual per body, from the founders on. Applies the birth rules of a table; which body falls vacant, and when, is the
/// ecology's.
template <class Rules>
class Population {
 public:
  /// Founders of these species, one per body, all with random genomes (Sec. "Initialization"). Hunted species start inactive.
  /// Throws RuleError for a brain that lists no tag or one twice, and for a species or a tag that does not exist, here and at
  /// later births.
  Population(const Policies<Rules>& rules, const FoodWeb& web, std::uint64_t seed, std::span<const Species> founders)
      : rules_{rules}, web_{web}, seed_{seed}, tags_{rules.brain.tags()} {
    check_tags(tags_);
    for (const Species species : founders) check_index("community", "species", species, web.size());
    for (const Species species : founders) {
      individuals_.push_back(newborn(species, 0.0, 0, std::nullopt));
      give_genome(individuals_.back(), std::nullopt);
    }
  }

  [[nodiscard]] std::span<const Individual> individuals() const { return individuals_; }
  [[nodiscard]] const std::vector<int>& tags() const { return tags_; }  ///< that an individual may show
  [[nodiscard]] IndividualId next_id() const { return next_id_; }       ///< of whoever is born next
  [[nodiscard]] Individual& operator[](BodyIndex body) { return individuals_[body]; }
  [[nodiscard]] const Individual& operator[](BodyIndex body) const { return individuals_[body]; }

  /// Who inherits a vacant body: decides between random and inherited and asks the parent rule. Changes nobody.
  struct Succession {
    bool inherits = false;
    std::optional<Ancestor> parent;
  };
  template <reproduction::Parent ParentRule>
  [[nodiscard]] Succession succession(const reproduction::Vacancy& vacancy, const ParentRule& rule, const View& view) const {
    Rng source{seed_, Stream::genome_source, next_id_};
    Succession result{.inherits = rules_.genome_source.inherits(source), .parent = std::nullopt};
    if (result.inherits) {
      Rng rng{seed_, Stream::parent, next_id_};
      result.parent = rule.parent(vacancy, view, rng);
    }
    return result;
  }

  /// The body's occupant is gone, an offspring or a random newcomer of `species` takes over where it stands.
  void succeed(BodyIndex body, Species species, const Succession& succession, const View& view) {
    Individual born = newborn(species, view.time_s, view.tick, individuals_[body]);
    give_genome(born, succession.parent);
    if (succession.inherits && !succession.parent) born.origin = rules_.genome_source.without_parent();
    individuals_[body] = std::move(born);
  }

 private:
  /// Everything of a newborn but its genome. `previous` is the body's last owner, none for a founder.
  [[nodiscard]] Individual newborn(Species species, double time_s, std::int64_t tick, const std::optional<Individual>& previous) {
    Individual born;
    born.id = next_id_++;
    born.species = species;
    born.active = !web_.is_hunted(species);
    born.born_s = born.age_from_s = born.tag_since_s = time_s;
    born.fed_tick = tick;
    Rng rng{seed_, Stream::newborn_tag, born.id};
    born.tag = rules_.newborn_tag.tag(previous ? std::optional{previous->tag} : std::nullopt, rng);
    check_tag(tags_, born.tag, "newborn_tag");
    if (previous) {
      born.target_angle_rad = previous->target_angle_rad;
      born.memory = previous->memory;
    }
    return born;
  }

  [[nodiscard]] std::shared_ptr<Genome> drawn_genome(IndividualId id) {
    auto genome =
        std::make_shared<Genome>(Genome{.id = next_genome_id_++, .weights = std::vector<double>(rules_.brain.genome_size())});
    Rng rng{seed_, Stream::initial_genome, id};
    rules_.initial_genome.draw(genome->weights, rng);
    return genome;
  }

  /// Origin and parent of a newborn and its genome: drawn, or passed on and mutated.
  void give_genome(Individual& born, const std::optional<Ancestor>& parent) {
    if (!parent) {
      born.genome = drawn_genome(born.id);
      return;
    }
    born.origin = Origin::inherited;
    born.parent = parent->id;
    const std::vector<double> before = parent->genome->weights;
    born.genome = rules_.heredity.inherit(parent->genome);
    if (!born.genome) {
      born.genome = drawn_genome(born.id);
    } else {
      if (born.genome != parent->genome) born.genome->id = next_genome_id_++;
      Rng rng{seed_, Stream::mutation, born.id};
      rules_.mutation.mutate(born.genome->weights, rng);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
      sum += (born.genome->weights[i] - before[i]) * (born.genome->weights[i] - before[i]);
    born.mutation_distance = std::sqrt(sum);
  }

  const Policies<Rules>& rules_;
  const FoodWeb& web_;
  std::uint64_t seed_;
  std::vector<int> tags_;
  IndividualId next_id_ = 0;
  std::uint64_t next_genome_id_ = 0;
  std::vector<Individual> individuals_;
};

}  // namespace trophic
