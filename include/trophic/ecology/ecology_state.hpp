// SPDX-License-Identifier: MIT
// The state of an ecology at a moment: its parameters, models, rules, individuals and bodies.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/bodies.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/engine_nursery.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/population.hpp>
#include <trophic/ecology/start.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// Whether the number of individuals may change under a table: births without a death, and deaths without a birth.
template <class Rules>
inline constexpr bool grows = !is_neutral<Rules, RuleSlot::recruitment>;

/// The data that all parts of an ecology share. It cannot be moved, because its members refer to each other.
template <class Rules>
struct EcologyState {
  explicit EcologyState(CheckedExperiment<Rules> from)
      : params{std::move(from.params)},
        choice{std::move(from.backend)},
        habitat{std::move(from.habitat)},
        rules{make_policies<Rules>(params.rules)},
        web{rules.community.web()},
        nursery{choice, habitat.arena, params.physics, params.ecology, rules.steering},
        population{rules, web, genome_seed(), founders_of(params, rules, web), {params.null, &habitat, &nursery}},
        bodies{params, choice, habitat, rules, population} {
    if (!params.lineup.empty()) population.enlist(params.lineup);
    bodies.embody_founders();
  }
  EcologyState(const EcologyState&) = delete;
  EcologyState& operator=(const EcologyState&) = delete;

  [[nodiscard]] double time_s() const { return clock_s(tick, params.ecology.tick_s); }
  /// Whether the body of an individual is in the world.
  [[nodiscard]] bool is_there(BodyIndex body) const { return bodies.backend().is_there(body); }

  [[nodiscard]] View view() const {
    const auto robots = population.individuals();
    return {.time_s = time_s(),
            .tick = tick,
            .tick_s = params.ecology.tick_s,
            .robot_radius_m = habitat.robot.bounding_radius_m,
            .web = web,
            .arena = habitat.arena,
            .robots = robots,
            .poses = bodies.poses(),
            .tree = robots.size() >= tree_from_robots ? population.tree() : nullptr,
            .members = population.members(),
            .refused_bodies = population.refused_bodies(),
            .phenotypes = population.phenotypes(),
            .foods = population.economy().food().fields(),
            .food_names = FoodSupply<Rules>::names,
            .energy = population.economy().flows(),
            .resource = population.economy().food().flows(),
            .refused_births = refused_births,
            .bodies = bodies.backend().has_joints() ? &bodies : nullptr,
            .acts = population.acts().values(),
            .traits = TraitGenes<Rules>::names,
            .is_over = ends_now(params.ecology.ends_when, population.members(), robots.size()),
            .space = bodies.space()};
  }

  Experiment<Rules> params;
  BackendChoice choice;
  Habitat habitat;
  Policies<Rules> rules;
  FoodWeb web;
  EngineNursery<PolicyIn<Rules, RuleSlot::steering>> nursery;
  Population<Rules> population;
  Bodies<Rules> bodies;
  std::int64_t tick = 0;
  std::uint64_t refused_births = 0;  ///< births that found no free body or place

 private:
  /// A neutral null has different genomes from the run that it repeats.
  [[nodiscard]] std::uint64_t genome_seed() const {
    return params.history ? Rng{params.seed, Stream::null_model}.bits() : params.seed;
  }
};

}  // namespace trophic
