// SPDX-License-Identifier: MIT
// An experiment's parameters with the habitat that they name, checked before the simulation.
#pragma once

#include <algorithm>
#include <string>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/gait_genes.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/reproduction/viability/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/arithmetic.hpp>

namespace trophic {

/// Checks that parameters are within their bounds, that the gait fits the robot, and that the rules can steer the robot.
template <class Rules>
struct CheckedExperiment {
  Experiment<Rules> params;
  BackendChoice backend;
  Habitat habitat;
};

namespace detail {

/// Calls `visit(policy)` with each species' policy, or with the common one.
template <class P, class Visitor>
void for_each_species_policy(const P& policy, const Visitor& visit) {
  if constexpr (requires {
                  P::count;
                  policy.of(Species{});
                }) {
    for (Species species = 0; species < P::count; ++species) visit(policy.of(species));
  } else {
    visit(policy);
  }
}

/// Throws std::invalid_argument if a table names its backends and this is not one of them.
template <class Rules>
void check_backend(const std::string& name) {
  constexpr auto backends = backends_of<Rules>();
  if (backends.empty() || std::ranges::find(backends, name) != backends.end()) return;
  std::string names;
  for (const std::string_view one : backends) names.append(names.empty() ? "" : " or ").append(one);
  throw std::invalid_argument{"rule table " + table_name<Rules>() + " on backend " + name + ": must be on " + names};
}

/// The models that the rules BodyPlan and Gait name.
template <class Rules>
[[nodiscard]] ModelNames named_models(const Policies<Rules>& rules) {
  ModelNames names;
  const auto add = [](auto& to, const std::vector<std::string>& from) { to.insert(to.end(), from.begin(), from.end()); };
  for_each_species_policy(rules.body_plan, [&](const auto& policy) { add(names.robots, reproduction::ask::robots(policy)); });
  for_each_species_policy(rules.gait, [&](const auto& policy) { add(names.gaits, control::ask::gaits(policy)); });
  names.needs_design = !is_neutral<Rules, RuleSlot::body_plan>;
  return names;
}

/// Throws std::invalid_argument if the backend cannot simulate the gaits and bodies that the rules Gait and BodyPlan give
/// individuals, if these rules are incompatible, or for a rule that this table on this backend would never use, so that the run
/// would be the same without it.
template <class Rules>
void check_parts(const BackendChoice& backend) {
  constexpr bool bodies_differ = BodyGenes<Rules>::differ;
  constexpr bool bodies_inherited = BodyGenes<Rules>::are_inherited;
  constexpr bool fits_one_body = is_neutral<Rules, RuleSlot::gait> || requires {
    requires AnswersForSpecies<PolicyIn<Rules, RuleSlot::gait>>::fits_one_body;
  };
  constexpr bool has_trials = reproduction::TriesNewborns<AnswersForSpecies<PolicyIn<Rules, RuleSlot::viability>>>;
  const std::string gaits = "rules.gait = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::gait>>()};
  const std::string bodies = "rules.body_plan = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::body_plan>>()};
  const std::string viability = "rules.viability = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::viability>>()};
  const std::string embodiment = "rules.embodiment = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::embodiment>>()};
  const std::string heredity = "rules.heredity = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::heredity>>()};
  const std::string steering = "rules.steering = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::steering>>()};
  const std::string on_backend = " on backend " + backend.name();
  const auto refuse_if = [](bool refused, const std::string& what, const std::string& must) {
    if (refused) throw std::invalid_argument{what + ": must be " + must};
  };
  refuse_if(GaitGenes<Rules>::differ && !backend.has_joints(), (bodies_differ ? bodies : gaits) + on_backend,
            "a backend with joints, on which the bodies and gaits of individuals matter");
  refuse_if(bodies_differ && !backend.can_embody(), bodies + on_backend,
            "a backend that exchanges bodies (Embodying in backend/contract.hpp)");
  refuse_if(!is_neutral<Rules, RuleSlot::recruitment> && !backend.can_place(),
            "rules.recruitment = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::recruitment>>()} + on_backend,
            "a backend that adds and removes robots (Placing in backend/contract.hpp)");
  refuse_if(bodies_differ && is_neutral<Rules, RuleSlot::embodiment>, bodies + " with rules.embodiment = keeps_body",
            "a rule Embodiment that puts bodies down");
  refuse_if(bodies_inherited && fits_one_body, gaits + " with " + bodies,
            "a rule Gait that fits any body, such as inherited_cppn");
  refuse_if(has_trials && !GaitGenes<Rules>::differ, viability + " with " + gaits, "in a table with a rule Gait or BodyPlan");
  refuse_if(!has_trials && !is_neutral<Rules, RuleSlot::viability> && !bodies_inherited, viability + " with " + bodies,
            "in a table that inherits bodies; otherwise the rule Viability is never used");
  refuse_if(!bodies_differ && !is_neutral<Rules, RuleSlot::embodiment>, embodiment + " with " + bodies,
            "in a table with a rule BodyPlan; otherwise the rule Embodiment is never used");
  if constexpr (requires { AnswersForSpecies<PolicyIn<Rules, RuleSlot::heredity>>::left_out; }) {
    constexpr std::string_view left_out = AnswersForSpecies<PolicyIn<Rules, RuleSlot::heredity>>::left_out;
    const bool is_nothing = (left_out == "gait" && !GaitGenes<Rules>::are_inherited) ||
                            (left_out == "body" && !bodies_inherited) ||
                            (left_out == "traits" && is_neutral<Rules, RuleSlot::traits>);
    refuse_if(is_nothing, heredity + " with " + gaits + " and " + bodies,
              "in a table that inherits that part; otherwise it is the same as own_copy");
  }
  refuse_if(PolicyIn<Rules, RuleSlot::sensors>::needs_joints && !backend.has_joints(),
            "rules.sensors = " + std::string{policy_name<PolicyIn<Rules, RuleSlot::sensors>>()} + on_backend,
            "a backend with joints, whose robots have joint angles, tilt and touch");
  if constexpr (!requires { requires PolicyIn<Rules, RuleSlot::steering>::walks_use_it; }) {
    refuse_if(!backend.has_joints(), steering + on_backend,
              "a backend with joints; without joints robots turn as in their measured walk, which uses targeted_steering");
  }
}

}  // namespace detail

/// Throws std::invalid_argument naming field, value and bound, or a robot that the rules cannot steer.
template <class Rules>
[[nodiscard]] CheckedExperiment<Rules> checked(Experiment<Rules> params, BackendChoice backend, Habitat habitat) {
  check_arithmetic<Rules>();
  validate(params, "");
  backend.validate("backend");
  backend.prescribe(params.physics, Rules::physics());
  check_fit(habitat.gait, habitat.robot);
  detail::check_backend<Rules>(backend.name());
  detail::check_parts<Rules>(backend);
  if (backend.has_joints()) {
    locomotion::check_steerable(habitat.robot, make_policy<typename Rules::Steering>(params.rules.steering, "steering"));
  }
  if constexpr (requires { params.rules.body_plan.first_modules <= params.rules.viability.limits.most_modules; }) {
    const std::size_t most = params.rules.viability.limits.most_modules;
    if (params.rules.body_plan.first_modules > most) {
      throw std::invalid_argument{"rules.body_plan.first_modules = " + std::to_string(params.rules.body_plan.first_modules) +
                                  ": must be <= rules.viability.limits.most_modules, " + std::to_string(most)};
    }
  }
  check_control_steps(params.ecology, params.physics, backend.has_joints());
  return {std::move(params), std::move(backend), std::move(habitat)};
}

/// Loads the models that `params.ecology` names, using trophic/habitat/load/habitat.hpp. Throws as `checked`, and
/// std::runtime_error for a missing or invalid file.
template <class Rules>
[[nodiscard]] CheckedExperiment<Rules> load_checked(Experiment<Rules> params, BackendChoice backend, std::string_view installed) {
  validate(params, "");
  backend.validate("backend");
  if constexpr (requires { load_habitat(params.ecology, ModelNames{}, installed); }) {
    Habitat habitat = load_habitat(params.ecology, detail::named_models(make_policies<Rules>(params.rules)), installed);
    if (params.ecology.gait.empty()) params.ecology.gait = habitat.robot.gait;
    return checked(std::move(params), std::move(backend), std::move(habitat));
  } else {
    static_assert(std::same_as<Rules, void>,
                  "Ecology(params, backend) reads the robot, arena and gait that params.ecology names, but this program cannot "
                  "read model files: include <trophic/run.hpp> or <trophic/habitat/load/habitat.hpp>, or give the ecology a "
                  "Habitat as its third argument");
  }
}

}  // namespace trophic
