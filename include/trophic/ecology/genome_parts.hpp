// SPDX-License-Identifier: MIT
// Draws, mutates and expresses the parts of genomes: brain, body and gait.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/control/brain/contract.hpp>
#include <trophic/control/gait/contract.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/reproduction/viability/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// The parts of genomes under the rules of a table. A part that is empty is drawn; one that is not is inherited and mutates.
template <class Rules>
class GenomeParts {
 public:
  using AnyBrain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
  static constexpr bool is_growing = control::GrowingBrain<AnyBrain>;          ///< whether brains grow
  static constexpr bool has_bodies = !is_neutral<Rules, RuleSlot::body_plan>;  ///< whether bodies differ
  static constexpr bool has_gaits = !is_neutral<Rules, RuleSlot::gait> || has_bodies;
  static constexpr bool has_body_genes = reproduction::InheritedBody<AnswersForSpecies<PolicyIn<Rules, RuleSlot::body_plan>>>;
  static constexpr bool has_gait_genes = control::InheritedGait<AnswersForSpecies<PolicyIn<Rules, RuleSlot::gait>>>;
  static constexpr bool learns = control::LearntGait<AnswersForSpecies<PolicyIn<Rules, RuleSlot::gait>>>;
  static constexpr bool has_trials = reproduction::TriesNewborns<AnswersForSpecies<PolicyIn<Rules, RuleSlot::viability>>>;

  /// `inputs`: of the brain. `habitat`: only for tables with other rules Gait or BodyPlan than the neutral ones; `nursery`: for
  /// rules that use it. Throws std::invalid_argument without one that they need.
  GenomeParts(const Policies<Rules>& rules, std::size_t inputs, std::uint64_t seed, const Habitat* habitat,
              const Nursery* nursery = nullptr)
      : rules_{rules}, inputs_{inputs}, seed_{seed}, habitat_{habitat}, nursery_{nursery} {
    if ((learns || has_trials) && nursery == nullptr)
      throw std::invalid_argument{"rules with trials of newborns: need a nursery"};
  }

  /// Draws the weights of an individual without a parent.
  void draw_weights(Genome& genome, const Individual& born) const {
    Rng rng{seed_, Stream::initial_genome, born.id};
    if constexpr (is_growing) {
      Rng structure{seed_, Stream::brain_structure, born.id};
      genome.weights = rules_.brain.first(inputs_, control::Decision::outputs, structure);
      reproduction::ask::draw(rules_.initial_genome, rules_.brain.weights_of(std::span{genome.weights}), born, rng);
    } else {
      genome.weights.assign(rules_.brain.genome_size(inputs_, control::Decision::outputs), 0.0);
      reproduction::ask::draw(rules_.initial_genome, std::span{genome.weights}, born, rng);
    }
  }

  /// Mutates inherited weights; `own` is the offspring's state of the rule Mutation.
  template <class State>
  void mutate_weights(Genome& genome, State& own, const Individual& born) const {
    Rng rng{seed_, Stream::mutation, born.id};
    if constexpr (is_growing) {
      reproduction::ask::mutate(rules_.mutation, own, rules_.brain.weights_of(std::span{genome.weights}), born, rng);
      Rng growth{seed_, Stream::brain_growth, born.id};
      rules_.brain.mutate_structure(genome.weights, inputs_, control::Decision::outputs, growth);
    } else {
      reproduction::ask::mutate(rules_.mutation, own, std::span{genome.weights}, born, rng);
    }
  }

  /// Why the brain does not take these weights: the demand that they violate.
  [[nodiscard]] std::optional<std::string> misfit(const Genome* genome) const {
    if constexpr (is_growing) {
      if (genome != nullptr && rules_.brain.fits(genome->weights, inputs_, control::Decision::outputs)) return std::nullopt;
      return "a genome that fits the brain " + std::string{AnyBrain::name};
    } else {
      const std::size_t size = rules_.brain.genome_size(inputs_, control::Decision::outputs);
      if (genome != nullptr && genome->weights.size() == size) return std::nullopt;
      return "a genome of " + std::to_string(size) + " weights";
    }
  }

  /// The distance between the weights of a parent and of its offspring. Missing weights count as 0.
  [[nodiscard]] double distance(std::span<const double> before, std::span<const double> after) const {
    if constexpr (requires { rules_.brain.distance(before, after); }) {
      return rules_.brain.distance(before, after);
    } else {
      double sum = 0.0;
      for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
        const double step = (i < after.size() ? after[i] : 0.0) - (i < before.size() ? before[i] : 0.0);
        sum += step * step;
      }
      return std::sqrt(sum);
    }
  }

  /// Draws the body and the gait of a newborn where its genome lacks them; mutates them if they are inherited. If the rule
  /// Viability refuses it after a trial, both are drawn or mutated again.
  void draw_or_mutate(Genome& genome, const Individual& born) {
    Rng of_body{seed_, genome.body.empty() ? Stream::body_genes : Stream::body_mutation, born.id};
    Rng of_gait{seed_, genome.gait.empty() ? Stream::gait_genes : Stream::gait_mutation, born.id};
    if constexpr (has_trials) {
      const auto& rule = for_species(rules_.viability, born.species);
      const std::vector<double> body = genome.body;
      const std::vector<double> gait = genome.gait;
      const bool is_drawn = (has_body_genes && body.empty()) || (has_gait_genes && gait.empty());
      std::string refusal;
      for (std::size_t attempt = 0; attempt < (is_drawn ? most_draws : rule.attempts()); ++attempt) {
        vary(genome, born, of_body, of_gait);
        const Phenotype own = express(born.species, genome.body, genome.gait);
        const auto reason = rule.refusal_after_trial(own.robot ? *own.robot : habitat_->robot, *own.gait, *nursery_);
        if (!reason) return;
        refusal = *reason;
        refused_ += is_drawn ? 0 : 1;
        genome.body = body;
        genome.gait = gait;
      }
      if (is_drawn) throw_refused("newborns", refusal);
    } else {
      vary(genome, born, of_body, of_gait);
    }
  }

  /// The body and the gait of these genes. Throws std::invalid_argument for genes of other rules.
  [[nodiscard]] Phenotype express([[maybe_unused]] Species species, [[maybe_unused]] std::span<const double> body,
                                  [[maybe_unused]] std::span<const double> gait) const {
    Phenotype own;
    if constexpr (has_bodies) own = body_of(species, body);
    if constexpr (has_gaits) {
      const RobotModel& robot = own.robot ? *own.robot : habitat_->robot;
      auto walk = std::make_shared<Gait>(for_species(rules_.gait, species).express(gait, robot, *habitat_));
      check_fit(*walk, robot);
      own.gait = std::move(walk);
    }
    return own;
  }

  /// The number of mutations of bodies that were refused.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }
  void persist(Archive& archive) { archive(refused_); }

 private:
  static constexpr std::size_t most_draws = 1000;  ///< of a body without a parent

  [[noreturn]] static void throw_refused(std::string_view what, const std::string& refusal) {
    throw RuleError{"body_plan", std::to_string(most_draws) + " random " + std::string{what} +
                                     " in a row refused, the last one for \"" + refusal + "\": some must be viable"};
  }

  /// Draws or mutates the body and the gait once, with what the newborn learns.
  void vary(Genome& genome, const Individual& born, Rng& of_body, Rng& of_gait) {
    std::shared_ptr<const RobotModel> robot;
    if constexpr (has_body_genes) {
      robot = genome.body.empty() ? draw_body(genome, born, of_body) : mutate_body(genome, born, of_body);
    }
    if constexpr (has_gait_genes) {
      if constexpr (has_bodies && !has_body_genes) robot = body_of(born.species, {}).robot;
      const auto& rule = for_species(rules_.gait, born.species);
      const RobotModel& own = robot ? *robot : habitat_->robot;
      if (genome.gait.empty()) {
        genome.gait = rule.draw(own, *habitat_, of_gait);
      } else {
        rule.mutate(genome.gait, born, of_gait);
      }
      if constexpr (learns) rule.learn(genome.gait, own, *habitat_, born, *nursery_, of_gait);
      if (genome.gait.empty()) throw RuleError{"gait", "no genes: must have at least one"};
    }
  }

  /// The body of these genes. Throws std::invalid_argument if it cannot be built or no table lets it live.
  [[nodiscard]] Phenotype body_of(Species species, std::span<const double> genes) const {
    auto design = std::make_shared<body::Design>(for_species(rules_.body_plan, species).grow(genes, species, *habitat_));
    auto robot = std::make_shared<RobotModel>(body::build(*design));
    if (robot->hinges.empty()) throw std::invalid_argument{"robot " + robot->name + ": no hinges, must be >= 1"};
    return {.individual = 0, .design = std::move(design), .robot = std::move(robot), .gait = nullptr};
  }

  /// The body of these genes, or why none may be born with it.
  [[nodiscard]] Phenotype viable_body(Species species, std::span<const double> genes, std::string& refusal) const {
    try {
      if (genes.empty()) throw std::invalid_argument{"a core without modules"};
      Phenotype own = body_of(species, genes);
      const auto reason = for_species(rules_.viability, species).refusal(*own.design, *own.robot);
      if (!reason) return own;
      refusal = *reason;
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    return {};
  }

  [[nodiscard]] std::shared_ptr<const RobotModel> draw_body(Genome& genome, const Individual& born, Rng& rng) const {
    std::string refusal;
    for (std::size_t attempt = 0; attempt < most_draws; ++attempt) {
      genome.body = for_species(rules_.body_plan, born.species).draw(born.species, *habitat_, rng);
      if (const Phenotype own = viable_body(born.species, genome.body, refusal); own.robot) return own.robot;
    }
    throw_refused("bodies", refusal);
  }

  [[nodiscard]] std::shared_ptr<const RobotModel> mutate_body(Genome& genome, const Individual& born, Rng& rng) {
    const std::vector<double> parents = genome.body;
    const std::size_t attempts = for_species(rules_.viability, born.species).attempts();
    std::string refusal;
    for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
      for_species(rules_.body_plan, born.species).mutate(genome.body, born, *habitat_, rng);
      if (const Phenotype own = viable_body(born.species, genome.body, refusal); own.robot) return own.robot;
      ++refused_;
      genome.body = parents;
    }
    return body_of(born.species, genome.body).robot;
  }

  const Policies<Rules>& rules_;
  std::size_t inputs_;
  std::uint64_t seed_;
  const Habitat* habitat_;
  const Nursery* nursery_;
  std::uint64_t refused_ = 0;
};

}  // namespace trophic
