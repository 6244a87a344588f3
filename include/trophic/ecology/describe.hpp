// SPDX-License-Identifier: MIT
// The description of an experiment's runs, for observers and manifests.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/brain_genes.hpp>
#include <trophic/ecology/economy.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/gait_genes.hpp>
#include <trophic/ecology/trait_genes.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic {

namespace detail {

/// Name the neutral null of a heredity and that of clones: the population applies them.
template <class Rule>
struct NeutralHeredity : reproduction::heredity::NothingInherited {
  static constexpr std::string_view name = prefixed_name<"neutral", Rule>;
};
struct OneGenomeForAll : reproduction::heredity::NothingInherited {
  static constexpr std::string_view name = "one_genome_for_all";
};

}  // namespace detail

/// Whether a parameter has no effect but through joints.
[[nodiscard]] constexpr bool acts_through_joints(std::string_view path) {
  return path.starts_with("rules.steering.") || path == "ecology.gait" || path == "ecology.control_hz" ||
         path == "ecology.cpg_integration" || path == "ecology.idle_control_steps" || path == "ecology.phase_at_birth";
}

/// All parameters of an experiment on a backend, in order.
template <class Rules>
[[nodiscard]] NamedParams named_params_of(Experiment<Rules> experiment, BackendChoice backend) {
  ParamRefs all = param_refs(experiment);
  backend.append_param_refs("backend", all);
  return named_params_of(all);
}

/// Everything that determines a run of `experiment` on `backend` in `habitat` until `until_s` (ecology seconds), and its
/// fingerprint. A neutral shadow is described as the table with NothingInherited, a neutral null as one with neutral_HEREDITY,
/// clones as one with one_genome_for_all.
template <class Rules>
[[nodiscard]] observe::RunDescription describe(const Experiment<Rules>& experiment, const BackendChoice& backend,
                                               const Habitat& habitat, double until_s) {
  const Policies<Rules> policies = make_policies<Rules>(experiment.rules);
  using Shadow = with_heredity<Rules, reproduction::heredity::NothingInherited>;
  using Neutral = with_heredity<Rules, detail::NeutralHeredity<PolicyIn<Rules, RuleSlot::heredity>>>;
  using Clones = with_heredity<Rules, detail::OneGenomeForAll>;
  const auto of_null = [&](const auto&... none_shadow_neutral_clones) {
    return std::array{none_shadow_neutral_clones...}[static_cast<std::size_t>(experiment.null)];
  };
  observe::RunDescription run{
      .rules = of_null(table_name<Rules>(), table_name<Shadow>(), table_name<Neutral>(), table_name<Clones>()),
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
  for (const rules::SlotRule& rule : of_null(rules::slot_rules<Rules>(), rules::slot_rules<Shadow>(),
                                             rules::slot_rules<Neutral>(), rules::slot_rules<Clones>())) {
    run.slots.emplace_back(rule.slot, rule.policy);
  }
  if (experiment.null == Null::shadow || experiment.null == Null::clones) {
    std::erase_if(run.named_params, [](const NamedParam& param) { return param.path.starts_with("rules.heredity."); });
  }
  if constexpr (requires { Rules::Capture::zone; }) {
    const auto is_named = [](const Zone& zone) { return zone.name == Rules::Capture::zone; };
    if (std::ranges::none_of(habitat.arena.zones, is_named)) {
      run.remarks.push_back("rules.capture = " + std::string{Rules::Capture::name} + ": arena " + habitat.arena.name +
                            " has no zone named " + std::string{Rules::Capture::zone});
    }
  }
  Experiment<Rules> table;
  if (!experiment.ecology.gait.empty()) table.ecology.gait = habitat.robot.gait;
  if (std::string said = backend.prescribe(table.physics, Rules::physics()); !said.empty())
    run.remarks.push_back(std::move(said));
  run.other_params = observe::other_params(run.named_params, named_params_of(std::move(table), backend.fresh()));
  for (const observe::OtherParam& param : run.other_params) {
    if (backend.has_joints() || !acts_through_joints(param.path)) continue;
    run.remarks.push_back(param.path + " = " + param.value + " has no effect: " + backend.name() + " has no joints");
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
  run.has_energy = Economy<Rules>::has_energy;
  run.has_resource = Economy<Rules>::has_field;
  run.inherits_bodies = BodyGenes<Rules>::are_inherited;
  run.has_more_genes = BrainGenes<Rules>::grow || run.inherits_bodies || GaitGenes<Rules>::are_inherited;
  run.fingerprint = observe::fingerprint(run, numbers_text(habitat));
  return run;
}

}  // namespace trophic
