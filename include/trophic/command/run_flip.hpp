// SPDX-License-Identifier: MIT
// How a flip becomes a table and runs.
#pragma once

#include <concepts>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <trophic/command/flips.hpp>
#include <trophic/control/brain/cognitive_brain_with_biases.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/replicates/run_with_shadow.hpp>
#include <utility>
#include <vector>

namespace trophic::command {

namespace detail {

template <class Table, Backend B>
std::vector<std::string> run_table(const std::string& name, Experiment<Table, B> experiment, const Study& study) {
  std::cout << name << ": " << table_name<Table>() << std::endl;
  experiment.world.duration_s = study.duration_s;
  replicates::Plan plan = study.plan;
  plan.out /= name;
  auto unfinished = replicates::run_with_shadow<Table, B>(experiment, plan, study.shadow, study.facts, std::cout);
  for (std::string& sentence : unfinished) sentence.insert(0, name + "/");
  return unfinished;
}

/// Base with one number as Other has it.
template <class Base, class Other, Backend B>
Experiment<Base, B> with_number_of(const std::string& name) {
  for (const rules::RuleDifference& difference : rules::differences<Base, Other>()) {
    if (difference.name != name || !difference.is_number()) continue;
    const bool of_rule = !name.starts_with("world.") && !name.starts_with("physics.");
    Experiment<Base, B> experiment;
    read_numbers(experiment, read_assignment((of_rule ? "rules." : "") + name + "=" + difference.there));
    return experiment;
  }
  throw std::invalid_argument{"flip " + name + ": the tables do not differ in it"};
}

template <class Base, class Other, Backend B, std::size_t group>
std::vector<std::string> run_group(const std::string& name, const Study& study) {
  Experiment<rules::with_rules_of<Base, Other, slot_groups[group].slots>, B> experiment;
  if (group == world_group) {
    experiment.world = Other::world();
    experiment.physics = Other::physics();
  }
  return run_table(name, std::move(experiment), study);
}

}  // namespace detail

template <class Base, class Other, Backend B>
std::vector<std::string> run_flip(const std::string& name, const Study& study) {
  if (name == base_name) return detail::run_table(name, Experiment<Base, B>{}, study);
  if (const std::string why = needs_joints(name); !JointDriven<B> && !why.empty()) {
    std::cout << why << std::endl;
    return {};
  }
  if (name == biases_name) {
    Experiment<with_brain<Base, control::brain::CognitiveBrainWithBiases>, B> experiment;
    const auto plain = RuleParams<Base>{}.brain;
    experiment.rules.brain = {.turn_angle_rad = plain.turn_angle_rad, .zero_turns_right = plain.zero_turns_right};
    return detail::run_table(name, std::move(experiment), study);
  }
  if (name == slot_groups[0].name) return detail::run_group<Base, Other, B, 0>(name, study);
  if (name == slot_groups[1].name) return detail::run_group<Base, Other, B, 1>(name, study);
  if (name == slot_groups[2].name) return detail::run_group<Base, Other, B, 2>(name, study);
  if (name == slot_groups[3].name) return detail::run_group<Base, Other, B, 3>(name, study);
  static_assert(slot_groups.size() == 4);
#define TROPHIC_RUN_FLIP(Slot, member, kind, Contract)                                                                    \
  if constexpr (!std::same_as<typename Base::Slot, typename Other::Slot>) {                                               \
    if (name == #member) {                                                                                                \
      return detail::run_table(name, Experiment<rules::with_rules_of<Base, Other, rules::slots({#member})>, B>{}, study); \
    }                                                                                                                     \
  }
  TROPHIC_RULE_SLOTS(TROPHIC_RUN_FLIP)
#undef TROPHIC_RUN_FLIP
  return detail::run_table(name, detail::with_number_of<Base, Other, B>(name), study);
}

}  // namespace trophic::command
