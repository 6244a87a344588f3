// SPDX-License-Identifier: MIT
// The description of an experiment's runs, for observers and manifests.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/brain/outside.hpp>
#include <trophic/ecology/births.hpp>
#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/brain_genes.hpp>
#include <trophic/ecology/economy.hpp>
#include <trophic/ecology/effects.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/gait_genes.hpp>
#include <trophic/ecology/idle_rules.hpp>
#include <trophic/ecology/trait_genes.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic {

/// The name of the rule that replaces a table's rule Heredity under a null; empty without a null.
template <class Rules>
[[nodiscard]] std::string heredity_under(const Null& null) {
  const std::string own{detail::policy_name<PolicyIn<Rules, RuleSlot::heredity>>()};
  const std::string nothing{reproduction::heredity::NothingInherited::name};
  switch (null.kind) {
    case Null::none:
      return {};
    case Null::shadow:
      return nothing;
    case Null::neutral:
      return "neutral_" + own;
    case Null::clones:
      return "one_genome_for_all";
    case Null::one_sided:
      return own + ", " + nothing + " for " + null.species;
  }
  return {};
}

/// All parameters of an experiment on a backend, in order.
template <class Rules>
[[nodiscard]] NamedParams named_params_of(Experiment<Rules> experiment, BackendChoice backend) {
  ParamRefs all = param_refs(experiment);
  backend.append_param_refs("backend", all);
  return named_params_of(all);
}

/// Who decides for the robots of a run: the brains of their genomes, or a program outside the ecology (ecology/stepped_run.hpp).
enum class Decider { genome, outside };

/// Everything that determines a run of `experiment` on `backend` in `habitat` until `until_s` (ecology seconds), and its
/// fingerprint. A run under a null is described as the table with another heredity: heredity_under; one that is decided from
/// outside as the table with the brain "outside".
template <class Rules>
[[nodiscard]] observe::RunDescription describe(const Experiment<Rules>& experiment, const BackendChoice& backend,
                                               const Habitat& habitat, double until_s, Decider decider = Decider::genome) {
  const Policies<Rules> policies = make_policies<Rules>(experiment.rules);
  observe::RunDescription run{.rules = table_name<Rules>(),
                              .slots = {},
                              .named_params = named_params_of(experiment, backend),
                              .tags = for_species(policies.brain, 0).tags(),
                              .inputs = PolicyIn<Rules, RuleSlot::sensors>::value_names(),
                              .backend = backend.name() + " " + backend.version(),
                              .remarks = backend.remarks(experiment.physics),
                              .seed = experiment.seed,
                              .tick_s = experiment.ecology.tick_s,
                              .clock_scale = experiment.ecology.clock_scale,
                              .until_s = until_s,
                              .fingerprint = {}};
  note_effects(run.named_params, experiment, policies, backend);
  const std::string heredity = heredity_under<Rules>(experiment.null);
  if (!heredity.empty()) run.rules += " with heredity = " + heredity;
  for (const rules::SlotRule& rule : rules::slot_rules<Rules>())
    run.slots.emplace_back(rule.slot, rule.slot == slot_name(RuleSlot::heredity) && !heredity.empty() ? heredity : rule.policy);
  if (decider == Decider::outside && !control::IsOutside<AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>>) {
    const auto brain = std::ranges::find(run.slots, slot_name(RuleSlot::brain), &std::pair<std::string, std::string>::first);
    brain->second = control::brain::Outside::name;
    run.rules += " with brain = " + brain->second;
  }
  if (experiment.null == Null::shadow || experiment.null == Null::clones) {
    std::erase_if(run.named_params, [](const NamedParam& param) { return param.path.starts_with("rules.heredity."); });
  }
  if (const OneSpecies one_sided = species_of(experiment.null, policies.community.web())) {
    const std::string its_params = "rules.heredity." + experiment.null.species + ".";  // of by_species
    std::erase_if(run.named_params, [&](const NamedParam& param) { return param.path.starts_with(its_params); });
    if (const std::string why = why_nothing_inherited<Rules>(policies, *one_sided); !why.empty())
      run.remarks.push_back("null = " + name_of(experiment.null) + " has no effect: " + experiment.null.species +
                            " already inherits nothing because of " + why);
  }
  if (experiment.lineup.empty())
    for (std::string& idle : idle_rules<Rules>(policies, habitat.arena, experiment.ecology.robots))
      run.remarks.push_back(std::move(idle));
  Experiment<Rules> table;
  if (!experiment.ecology.gait.empty()) table.ecology.gait = habitat.robot.gait;
  if (std::string said = backend.prescribe(table.physics, Rules::physics()); !said.empty())
    run.remarks.push_back(std::move(said));
  run.other_params = observe::other_params(run.named_params, named_params_of(std::move(table), backend.fresh()));
  for (const observe::OtherParam& param : run.other_params) {
    const std::string& why = std::ranges::find(run.named_params, param.path, &NamedParam::path)->no_effect;
    if (!why.empty()) run.remarks.push_back(param.path + " = " + param.value + " has no effect" + why);
  }
  if constexpr (requires { requires Rules::Heading::acts_on_tilt_alone; }) {
    if (run.rules.find("heading = ") != std::string::npos && !backend.has_joints())
      run.remarks.push_back("rules.heading = " + std::string{Rules::Heading::name} + " has no effect: robots of " +
                            backend.name() + " stand upright");
  }
  if (!is_neutral<Rules, RuleSlot::acts>) run.outputs = PolicyIn<Rules, RuleSlot::acts>::output_names();
  run.traits.assign(TraitGenes<Rules>::names.begin(), TraitGenes<Rules>::names.end());
  run.brain_weights = BrainGenes<Rules>{policies, experiment.seed}.most(policies.community.web().size());
  run.bodies_differ = BodyGenes<Rules>::differ;
  run.several_parents = reproduction::names_several_parents<AnswersForSpecies<PolicyIn<Rules, RuleSlot::recruitment>>>;
  run.has_energy = has_energy<Rules>;
  run.has_resource = has_field<Rules>;
  run.inherits_bodies = BodyGenes<Rules>::are_inherited;
  run.has_more_genes = BrainGenes<Rules>::grow || run.inherits_bodies || GaitGenes<Rules>::are_inherited;
  run.fingerprint = observe::fingerprint(run, numbers_text(habitat));
  return run;
}

}  // namespace trophic
