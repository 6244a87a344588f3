// SPDX-License-Identifier: MIT
// The rule tables of the study: bodies, gaits and brains that evolve, each also with survival alone.
#pragma once

#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/reproduction/parent/any_survivor.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/nearest_active_victim.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with_part.hpp>

#include <trophic/worlds/pond.hpp>

namespace trophic::bodies_study {

using reproduction::parent::AnySurvivor;
using reproduction::parent::Killer;
using reproduction::parent::NearestActiveVictim;
using reproduction::parent::NearestConspecific;
using rules::by_species;

/// The paper's rules with parents for all: no random newcomers, and a sacrificed prey's body goes to an offspring of the nearest
/// predator.
using Lineages = with_parent_after<with_genome_source<rules::Paper, reproduction::genome_source::AlwaysInherited>,
                                   Cause::sacrificed, NearestConspecific>;

/// Survival alone selects: each parent is drawn among the living of its species.
using LineagesBySurvival = with_parent_after<with_parent_after<with_parent_after<Lineages, Cause::caught, AnySurvivor<Killer>>,
                                                               Cause::starved, AnySurvivor<NearestActiveVictim>>,
                                             Cause::sacrificed, AnySurvivor<NearestConspecific>>;

/// A starved predator has a parent for the prey that follows at any distance, and starvation is frequent: more births.
inline constexpr auto turnover = [](auto& params) {
  params.parent.starved.range_m = 100.0;
  params.starvation.interval.base_ticks = 10;
};

/// Each species has bodies and gaits of its own. Both start from the walker that `first_robot` and `gait` name.
template <class Base>
using WithBodies = with_viability<with_body_plan<with_gait<with_embodiment<Base, initialization::embodiment::StandsUp>,
                                                           by_species<control::gait::InheritedCppn>>,
                                                 by_species<reproduction::body_plan::InheritedModules>>,
                                  reproduction::viability::SurvivesTrial<reproduction::viability::ModuleLimits>>;

/// Spiders hunt geckos. Limits keep bodies of the size of the walkers: a larger body costs more time. Ten seconds in the nursery
/// refuse most of the bodies that diverge.
inline constexpr auto spiders_hunt_geckos = [](auto& params) {
  params.gait.template get<0>().gait = "gecko_steered";
  params.body_plan.template get<0>().first_robot = "gecko";
  params.viability.bodies.limits.most_modules = 14;
  params.viability.trial_s = 10.0;
};

template <class Base>
using Bodies = with_params<WithBodies<Base>, spiders_hunt_geckos>;
template <class Base>
using Brains = with_params<with_brain<Base, control::brain::GrowingBrain>, turnover>;

using EvolvingBodies = named<with_params<Bodies<Lineages>, turnover>, "evolving_bodies">;
using EvolvingBodiesBySurvival = named<with_params<Bodies<LineagesBySurvival>, turnover>, "evolving_bodies_by_survival">;
/// Energy decides who lives and, among the active, who has offspring.
using EvolvingPond = named<Bodies<worlds::Pond>, "evolving_pond">;

/// Gaits walk faster if their weights grow, up to ten times the first ones.
inline constexpr auto with_room_to_grow = [](auto& params) {
  const auto widen = [](auto& gait) {
    gait.sd = 0.05;
    gait.limit = 10.0;
  };
  widen(params.gait.template get<0>());
  widen(params.gait.template get<1>());
};
/// The pond in which both species inherit the weights of their gait, or one does against another that inherits nothing.
using GaitsRace =
    named<with_params<with_gait<with_heredity<worlds::Pond, by_species<reproduction::heredity::Switched<worlds::Pond::Heredity>>>,
                                by_species<control::gait::InheritedCpg>>,
                      with_room_to_grow>,
          "gaits_race">;
using EvolvingBrains = named<Brains<Lineages>, "evolving_brains">;
using EvolvingBrainsBySurvival = named<Brains<LineagesBySurvival>, "evolving_brains_by_survival">;

}  // namespace trophic::bodies_study
