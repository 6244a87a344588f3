// SPDX-License-Identifier: MIT
// The swaps of an ablation study between two tables: each difference alone, groups of slots together, and biases in the brain.
#pragma once

#include <tools/ablations/with_rules_of.hpp>
#include <tools/replicates/plan.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/io/run_folder.hpp>

namespace trophic::command {

/// Slots that are flipped together. The first group takes decision_order and without_target of EcologyParams, too, the last all
/// other parameters of EcologyParams and Physics.
struct SlotGroup {
  std::string_view name;
  rules::SlotSet slots;
};

inline constexpr std::array slot_groups{
    SlotGroup{"perception", rules::slots({"heading", "visibility", "sensors", "newborn_tag", "tag_switch", "acts", "brain",
                                          "pace", "steering", "gait"})},
    SlotGroup{"reproduction", rules::slots({"initial_genome", "genome_source", "parent", "heredity", "mutation", "traits",
                                            "body_plan", "viability", "recruitment"})},
    SlotGroup{"death", rules::slots({"activation", "capture", "floor", "starvation", "minimum_predators", "senescence"})},
    SlotGroup{"ecology", rules::slots({"community", "placement", "embodiment", "metabolism", "resource"})}};
inline constexpr std::size_t perception_group = 0;
inline constexpr std::size_t ecology_group = slot_groups.size() - 1;

/// Whether every slot is in exactly one group.
[[nodiscard]] constexpr bool groups_are_a_partition() {
  std::uint64_t seen = 0;
  for (const SlotGroup& group : slot_groups) {
    if ((seen & group.slots.mask) != 0) return false;
    seen |= group.slots.mask;
  }
  return seen == (std::uint64_t{1} << rules::slot_names.size()) - 1;
}
static_assert(groups_are_a_partition(), "each slot of a rule table belongs to one group of an ablation study");

inline constexpr std::string_view direction_prefix = "from_";
inline constexpr std::string_view base_name = "base";
inline constexpr std::string_view biases_name = "brain_with_biases";

/// One set of runs: its folder's name, and what is different in it.
struct Swap {
  std::string name;
  std::string change;
};

/// The swap of one sensor, if the sensors of two tables differ at a place of lists of one length; empty if they do not.
template <class Base, class Other, std::size_t place>
[[nodiscard]] std::string sensor_swap() {
  if constexpr (Base::Sensors::count == Other::Sensors::count) {
    using Here = typename Base::Sensors::template At<place>;
    using There = typename Other::Sensors::template At<place>;
    if (!std::same_as<Here, There>) return "sensor_" + std::string{There::name};
  }
  return "";
}

template <class Base, class Other, std::size_t... place>
void append_sensor_swaps(std::vector<Swap>& all, std::index_sequence<place...>) {
  const auto append = [&](std::string name, std::string_view here) {
    if (!name.empty()) all.push_back({name, std::string{here} + " -> " + name.substr(name.find('_') + 1)});
  };
  (append(sensor_swap<Base, Other, place>(), Base::Sensors::template At<place>::name), ...);
}

/// The table itself, every difference to the other table alone, each sensor alone, the brain with biases, and every group.
template <class Base, class Other>
[[nodiscard]] std::vector<Swap> swaps() {
  std::vector<Swap> all{{std::string{base_name}, "the table itself"}};
  const auto shown = [](const std::string& value) { return value.empty() ? "none" : value; };
  for (const rules::RuleDifference& one : rules::differences<Base, Other>()) {
    all.push_back({one.name, shown(one.here) + " -> " + shown(one.there)});
  }
  append_sensor_swaps<Base, Other>(all, std::make_index_sequence<Base::Sensors::count>{});
  all.push_back({std::string{biases_name}, "a bias in every neuron, as in neither table"});
  for (const SlotGroup& group : slot_groups) all.push_back({std::string{group.name}, "all of its slots and parameters together"});
  return all;
}

/// Why a swap changes nothing on an engine that moves no joints; empty if it changes something.
[[nodiscard]] inline std::string needs_joints(std::string_view name) {
  const bool of_engine = name.starts_with("physics.") || name == "ecology.robot" || name == "ecology.gait" ||
                         name == "ecology.cpg_integration" || name == "ecology.idle_control_steps" ||
                         name == "ecology.phase_at_birth";
  return of_engine ? std::string{name} + ": skipped, it acts through joints and this backend has none" : "";
}

/// The settings that all swaps share. `plan.out` is the folder of a direction.
struct Study {
  replicates::Plan plan;
  BackendChoice backend;
  double duration_s = 6000.0;
  bool shadow = false;
  io::Provenance provenance;
};

/// Runs one swap of Base towards Other into a folder of its name. A sentence for each replicate that is not complete. Defined in
/// run_swap.hpp and compiled once for each direction.
template <class Base, class Other>
[[nodiscard]] std::vector<std::string> run_swap(const std::string& name, const Study& study);

}  // namespace trophic::command
