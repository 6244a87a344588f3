// SPDX-License-Identifier: MIT
// When the parameters of a run are read, and which of them have no effect in their table on their backend.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/brain_genes.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// The rule or parameter because of which a species inherits nothing even without a null; empty if it may inherit.
template <class Rules>
[[nodiscard]] std::string why_nothing_inherited(const Policies<Rules>& policies, Species species) {
  const auto& heredity = for_species(policies.heredity, species);
  if constexpr (std::same_as<std::remove_cvref_t<decltype(heredity)>, reproduction::heredity::NothingInherited>)
    return "rules.heredity = " + std::string{reproduction::heredity::NothingInherited::name};
  if constexpr (requires { heredity.params.inherited; })
    if (!heredity.params.inherited) return "rules.heredity: inherited = false";
  const auto& source = for_species(policies.genome_source, species);
  if constexpr (requires { source.params.random_share; })
    if (source.params.random_share >= 1.0) return "rules.genome_source: random_share = 1";
  return {};
}

/// Whether a parameter has an effect only through joints.
[[nodiscard]] constexpr bool acts_through_joints(std::string_view path) {
  return path.starts_with("rules.steering.") || path == "ecology.gait" || path == "ecology.control_hz" ||
         path == "ecology.cpg_integration" || path == "ecology.idle_control_steps" || path == "ecology.phase_at_birth";
}

namespace detail {

/// Whether individuals may be born after the start that inherit nothing or that no parent endows.
template <class Rules>
[[nodiscard]] bool has_newcomers(const Policies<Rules>& policies, const Null& null) {
  using Recruitment = AnswersForSpecies<PolicyIn<Rules, RuleSlot::recruitment>>;
  if (reproduction::has_newcomers<Recruitment> || !is_neutral<Rules, RuleSlot::embodiment> || null != Null::none) return true;
  for (Species species = 0; species < policies.community.web().size(); ++species)
    if (!why_nothing_inherited<Rules>(policies, species).empty()) return true;
  return false;
}

/// The result of why_no_effect of a policy, or of the policy of the species in the path. The optional `std::string_view
/// why_no_effect(std::string_view number, const FoodWeb&, OneSpecies) const` returns why a parameter has no effect, such as "for
/// a species that hunts nothing", or an empty text. `number` is its path in Params.
template <class P>
[[nodiscard]] std::string why_no_effect(const P& policy, std::string_view number, const FoodWeb& web, OneSpecies species = {}) {
  if constexpr (requires { policy.why_no_effect(number, web, species); }) {
    return std::string{policy.why_no_effect(number, web, species)};
  } else if constexpr (requires { policy.of(Species{}); }) {
    const std::size_t dot = number.find('.');
    for (Species one = 0; one < web.size() && dot != std::string_view::npos; ++one)
      if (number.substr(0, dot) == web.name(one)) return why_no_effect(policy.of(one), number.substr(dot + 1), web, one);
  }
  return {};
}

}  // namespace detail

/// Sets when each parameter is read, and why a parameter has no effect.
template <class Rules>
void note_effects(NamedParams& params, const Experiment<Rules>& experiment, const Policies<Rules>& policies,
                  const BackendChoice& backend) {
  const FoodWeb web = policies.community.web();
  const bool newcomers = detail::has_newcomers<Rules>(policies, experiment.null);
  const bool weightless = BrainGenes<Rules>{policies, experiment.seed}.most(web.size()) == std::size_t{0};
  constexpr bool only_turns = std::same_as<PolicyIn<Rules, RuleSlot::acts>, control::acts::List<control::acts::Turn>>;
  const bool one_tag = for_species(policies.brain, 0).tags().size() == 1 && is_neutral<Rules, RuleSlot::acts>;
  for (NamedParam& param : params) {
    if (param.read == Read::for_newcomers) param.read = newcomers ? Read::at_birth : Read::at_start;
    if (acts_through_joints(param.path) && !backend.has_joints()) param.no_effect = ": " + backend.name() + " has no joints";
    if (param.path == "ecology.decision_order" && (one_tag || only_turns))
      param.no_effect = ": a decision changes nothing that others perceive";
    if ((param.path.starts_with("rules.initial_genome.") || param.path.starts_with("rules.mutation.")) && weightless)
      param.no_effect = ": brains of this table have no weights";
  }
  for_each_slot([&]<RuleSlot slot>() {
    const std::string prefix = "rules." + std::string{slot_name(slot)} + ".";
    for (NamedParam& param : params) {
      if (!param.path.starts_with(prefix)) continue;
      const std::string why =
          detail::why_no_effect(of_slot<slot>(policies), std::string_view{param.path}.substr(prefix.size()), web);
      if (!why.empty()) param.no_effect = " " + why;
    }
  });
}

}  // namespace trophic
