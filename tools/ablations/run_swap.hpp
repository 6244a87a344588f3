// SPDX-License-Identifier: MIT
// How a swap becomes a table and runs.
#pragma once

#include <iostream>
#include <tools/ablations/swaps.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/replicates/run_with_nulls.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/with.hpp>

namespace trophic::command {

namespace detail {

template <class Table>
std::vector<std::string> run_table(const std::string& name, Experiment<Table> experiment, const Study& study) {
  std::cout << name << ": " << table_name<Table>() << std::endl;
  experiment.ecology.duration_s = study.duration_s;
  replicates::Plan plan = study.plan;
  plan.out /= name;
  auto unfinished = replicates::run_with_nulls(
      experiment, study.backend, plan, std::vector<Null>(study.shadow ? 1 : 0, Null::shadow), study.provenance, std::cout);
  for (std::string& sentence : unfinished) sentence.insert(0, name + "/");
  return unfinished;
}

/// Base with one parameter as Other has it.
template <class Base, class Other>
Experiment<Base> with_number_of(const std::string& name) {
  for (const rules::RuleDifference& difference : rules::differences<Base, Other>()) {
    if (difference.name != name || !difference.is_number) continue;
    const bool of_rule = !name.starts_with("ecology.") && !name.starts_with("physics.");
    Experiment<Base> experiment;
    read_parameters(experiment, read_assignment((of_rule ? "rules." : "") + name + "=" + difference.there));
    return experiment;
  }
  throw std::invalid_argument{"swap " + name + ": the tables do not differ in it"};
}

template <class Base, class Other, std::size_t group>
std::vector<std::string> run_group(const std::string& name, const Study& study) {
  Experiment<rules::with_rules_of<Base, Other, slot_groups[group].slots>> experiment;
  const EcologyParams of_base = Base::ecology();
  const EcologyParams of_other = Other::ecology();
  if (group == ecology_group) {
    experiment.ecology = of_other;
    experiment.physics = Other::physics();
  }
  const EcologyParams& decisions = group == perception_group ? of_other : of_base;
  experiment.ecology.decision_order = decisions.decision_order;
  experiment.ecology.without_target = decisions.without_target;
  return run_table(name, std::move(experiment), study);
}

/// Base with the sensor at one place of its list as Other has it, if `name` is that swap.
template <class Base, class Other, std::size_t place>
std::optional<std::vector<std::string>> run_sensor(const std::string& name, const Study& study) {
  if constexpr (Base::Sensors::count == Other::Sensors::count) {
    if (name.empty() || name != sensor_swap<Base, Other, place>()) return std::nullopt;
    using Old = typename Base::Sensors::template At<place>;
    using New = typename Other::Sensors::template At<place>;
    return run_table(name, Experiment<rules::with_sensor<Base, Old, New>>{}, study);
  }
  return std::nullopt;
}

template <class Base, class Other, std::size_t... place>
std::optional<std::vector<std::string>> run_sensors(const std::string& name, const Study& study, std::index_sequence<place...>) {
  std::optional<std::vector<std::string>> unfinished;
  static_cast<void>(((unfinished = run_sensor<Base, Other, place>(name, study)).has_value() || ...));
  return unfinished;
}

/// Base with one part of a policy as Other has it, if `name` is that swap.
template <class Base, class Other, RuleSlot slot, std::size_t place>
void run_part(const std::string& name, const Study& study, std::optional<std::vector<std::string>>& unfinished) {
  using Here = PolicyIn<Base, slot>;
  using There = PolicyIn<Other, slot>;
  if constexpr (!std::same_as<typename Here::template Part<place>, typename There::template Part<place>>) {
    if (name != join_path(slot_name(slot), Here::part_names[place])) return;
    unfinished = run_table(name, Experiment<rules::with_part_of<Base, Other, slot, place>>{}, study);
  }
}

/// Base with one policy, or one part of one, as Other has it, if `name` is that swap.
template <class Base, class Other, RuleSlot slot>
void run_slot(const std::string& name, const Study& study, std::optional<std::vector<std::string>>& unfinished) {
  using Here = PolicyIn<Base, slot>;
  using There = PolicyIn<Other, slot>;
  if constexpr (rules::detail::alike_in_parts<Here, There>) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (run_part<Base, Other, slot, place>(name, study, unfinished), ...);
    }
    (std::make_index_sequence<Here::part_count>{});
  } else if constexpr (!std::same_as<Here, There>) {
    if (name != slot_name(slot)) return;
    unfinished = run_table(name, Experiment<rules::with_rules_of<Base, Other, rules::slots({slot_name(slot)})>>{}, study);
  }
}

}  // namespace detail

template <class Base, class Other>
std::vector<std::string> run_swap(const std::string& name, const Study& study) {
  if (name == base_name) return detail::run_table(name, Experiment<Base>{}, study);
  if (const std::string why = needs_joints(name); !study.backend.has_joints() && !why.empty()) {
    std::cout << why << std::endl;
    return {};
  }
  if (name == biases_name) {
    Experiment<with_brain<Base, typename Base::Brain::WithBiases>> experiment;
    experiment.rules.brain.turn_angle_rad = RuleParams<Base>{}.brain.turn_angle_rad;
    return detail::run_table(name, std::move(experiment), study);
  }
  if (name == slot_groups[0].name) return detail::run_group<Base, Other, 0>(name, study);
  if (name == slot_groups[1].name) return detail::run_group<Base, Other, 1>(name, study);
  if (name == slot_groups[2].name) return detail::run_group<Base, Other, 2>(name, study);
  if (name == slot_groups[3].name) return detail::run_group<Base, Other, 3>(name, study);
  static_assert(slot_groups.size() == 4);
  constexpr std::make_index_sequence<Base::Sensors::count> places;
  if (const auto unfinished = detail::run_sensors<Base, Other>(name, study, places)) return *unfinished;
  std::optional<std::vector<std::string>> unfinished;
  for_each_slot([&]<RuleSlot slot>() { detail::run_slot<Base, Other, slot>(name, study, unfinished); });
  if (unfinished) return *unfinished;
  return detail::run_table(name, detail::with_number_of<Base, Other>(name), study);
}

}  // namespace trophic::command
