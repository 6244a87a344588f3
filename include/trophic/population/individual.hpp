// SPDX-License-Identifier: MIT
// The individual in a body: genome, species, tag, ages, ancestry.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <trophic/population/cause.hpp>
#include <trophic/population/food_web.hpp>
#include <tuple>

namespace trophic {

/// Index of a robot body, in which individuals live one after the other.
using BodyIndex = std::size_t;

/// Id of an individual (the controller in a body), unique in a run and counting births from 0.
using IndividualId = std::uint64_t;

/// The species and the id of a spare body, which has no individual (reproduction/recruitment/contract.hpp).
inline constexpr Species no_species = std::numeric_limits<Species>::max();
inline constexpr IndividualId no_individual = std::numeric_limits<IndividualId>::max();

/// Whether a genome was drawn at random or copied from a parent. `inherited` is the rule's label: see GenomeSource.
enum class Origin { random, inherited };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Origin) {
  return {"random", "inherited"};
}

/// The genome of an individual, in parts; the policy of one slot defines the meaning of each part. A part that does not evolve in
/// a table is empty. Held by shared_ptr: the Heredity rule decides whether parent and offspring share one genome.
struct Genome {
  std::uint64_t id = 0;                 ///< unique in a run; a shared genome keeps its id through mutations
  std::vector<double> weights = {};     ///< weights of the brain
  std::vector<double> gait_genes = {};  ///< genes of the rule Gait
  std::vector<double> body_genes = {};  ///< genes of the rule BodyPlan
  std::vector<double> traits = {};      ///< traits of the rule Traits
  static constexpr auto saved() {
    return std::tuple{&Genome::id, &Genome::weights, &Genome::gait_genes, &Genome::body_genes, &Genome::traits};
  }
};

/// An individual that offspring can descend from, possibly dead.
struct Ancestor {
  IndividualId id = 0;
  Species species = 0;
  std::shared_ptr<Genome> genome = {};
  friend bool operator==(const Ancestor&, const Ancestor&) = default;
  static constexpr auto saved() { return std::tuple{&Ancestor::id, &Ancestor::species, &Ancestor::genome}; }
};

/// One living individual, or a spare body without one. The `Population` holds one per body and is its only writer.
struct Individual {
  IndividualId id = 0;  // members that searches read of others are adjacent
  Species species = 0;
  int tag = 0;         ///< one of the brain's tags
  bool active = true;  ///< a newborn of a hunted species is inactive: it cannot be caught and hunters do not perceive it
  Origin origin = Origin::random;
  std::vector<IndividualId> parents = {};  ///< no, one or more parents; the first one is the `parent_id` in tables
  std::shared_ptr<Genome> genome = {};
  double mutation_distance = 0.0;  ///< Euclidean distance by which mutation moved the inherited weights; 0 if they were drawn
  double energy_J = 0.0;           ///< 0 in a table without a rule Metabolism

  double born_s = 0.0;
  double age_from_s = 0.0;    ///< start of its age: birth, or activation if the rule restarts it
  std::int64_t fed_tick = 0;  ///< tick of birth or of the last catch

  double tag_since_s = 0.0;  ///< start of the current tag clock: birth, or the last restart by TagSwitch

  std::optional<BodyIndex> adversary = {};                                 ///< closest perceivable opponent at the last tick
  double adversary_distance_m = std::numeric_limits<double>::quiet_NaN();  ///< at the last tick; NaN without adversary
  double target_angle_rad = 0.0;                                           ///< the brain's last decision, positive to the right

  /// Whether there is an individual; a spare body has no species and no genome, and is inactive.
  [[nodiscard]] bool lives() const { return species != no_species; }
  [[nodiscard]] Ancestor as_ancestor() const { return {id, species, genome}; }
  /// The first parent, if any.
  [[nodiscard]] std::optional<IndividualId> parent() const {
    return parents.empty() ? std::nullopt : std::optional{parents.front()};
  }

  static constexpr auto saved() {
    return std::tuple{&Individual::id,
                      &Individual::parents,
                      &Individual::genome,
                      &Individual::species,
                      &Individual::origin,
                      &Individual::mutation_distance,
                      &Individual::energy_J,
                      &Individual::active,
                      &Individual::born_s,
                      &Individual::age_from_s,
                      &Individual::fed_tick,
                      &Individual::tag,
                      &Individual::tag_since_s,
                      &Individual::adversary,
                      &Individual::adversary_distance_m,
                      &Individual::target_angle_rad};
  }
};

/// Returns a newborn without genome and tag.
[[nodiscard]] inline Individual newborn_at(IndividualId id, Species species, bool active, double time_s, std::int64_t tick) {
  return {.id = id,
          .species = species,
          .active = active,
          .born_s = time_s,
          .age_from_s = time_s,
          .fed_tick = tick,
          .tag_since_s = time_s};
}

/// Returns a body without an individual, with the tag and the target angle of its last one.
[[nodiscard]] inline Individual spare_body(int tag, double target_angle_rad) {
  return {.id = no_individual, .species = no_species, .tag = tag, .active = false, .target_angle_rad = target_angle_rad};
}

}  // namespace trophic
