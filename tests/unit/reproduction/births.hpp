// SPDX-License-Identifier: MIT
// Births under rules with which bodies evolve, without a world.
#pragma once

#include <support/hand_population.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/ecology/turnover.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::test {

using Evolving = with_viability<
    with_body_plan<with_embodiment<with_gait<rules::Paper, control::gait::InheritedCppn>, initialization::embodiment::StandsUp>,
                   reproduction::body_plan::InheritedModules>,
    reproduction::viability::ModuleLimits>;

/// Two prey and two predators without bodies in space; predators catch prey, and their offspring take the bodies.
template <class Rules>
struct Births {
  Births() : Births{[](auto&) {}} {}
  /// `change`: of the rules' parameters.
  template <class Change>
  explicit Births(const Change& change) {
    RuleParams<Rules> numbers;
    numbers.genome_source.random_share = 0.0;
    change(numbers);
    policies = std::make_unique<Policies<Rules>>(make_policies<Rules>(numbers));
    population = std::make_unique<Population<Rules>>(*policies, web, 7, std::vector<Species>{prey, prey, predator, predator},
                                                     BirthSetting{.habitat = &habitat});
  }
  /// The newborn in `body`, whose parent lives in `killer`.
  const Individual& birth(BodyIndex body, BodyIndex killer) {
    const View view{.web = web, .arena = habitat.arena, .robots = population->individuals(), .poses = poses};
    population->replace(body, predator,
                        parentage_of(*policies, *population, {.body = body, .cause = Cause::caught, .killer = killer}, view),
                        view);
    return (*population)[body];
  }
  Habitat habitat = [] {
    Habitat loaded = load_habitat(rules::Paper::ecology());
    loaded.design = load_design("spider");
    return loaded;
  }();
  FoodWeb web = predator_prey_web();
  std::vector<GroundPose> poses = std::vector<GroundPose>(4);
  std::unique_ptr<Policies<Rules>> policies;
  std::unique_ptr<Population<Rules>> population;
};

}  // namespace trophic::test
