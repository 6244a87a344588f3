// SPDX-License-Identifier: MIT
// The slots of a rule table.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <trophic/control/brain/contract.hpp>
#include <trophic/control/decision_order/contract.hpp>
#include <trophic/control/steering/contract.hpp>
#include <trophic/death/activation/contract.hpp>
#include <trophic/death/capture/contract.hpp>
#include <trophic/death/floor/contract.hpp>
#include <trophic/death/reprieve/contract.hpp>
#include <trophic/death/rescue/contract.hpp>
#include <trophic/death/senescence/contract.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation_schedule/contract.hpp>
#include <trophic/initialization/community/contract.hpp>
#include <trophic/initialization/placement/contract.hpp>
#include <trophic/perception/blind_rule/contract.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/perception/newborn_tag/contract.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/perception/tag_switch/contract.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/reproduction/parent/contract.hpp>

/// Every slot of a rule table: (Slot, member, kind, contract). The one list that tables, numbers, with_<slot>, checks and
/// manifests are made from; a contract's concept and sentence are in trophic/KIND/SLOT/contract.hpp.
#define TROPHIC_RULE_SLOTS(SLOT)                                           \
  SLOT(Community, community, initialization, Community)                    \
  SLOT(Placement, placement, initialization, Placement)                    \
  SLOT(Heading, heading, perception, Heading)                              \
  SLOT(Visibility, visibility, perception, Visibility)                     \
  SLOT(Sensors, sensors, perception, SensorList)                           \
  SLOT(BlindRule, blind_rule, perception, BlindRule)                       \
  SLOT(NewbornTag, newborn_tag, perception, NewbornTag)                    \
  SLOT(TagSwitch, tag_switch, perception, TagSwitch)                       \
  SLOT(Brain, brain, control, Brain)                                       \
  SLOT(DecisionOrder, decision_order, control, DecisionOrder)              \
  SLOT(Steering, steering, control, Steering)                              \
  SLOT(InitialGenome, initial_genome, reproduction, InitialGenome)         \
  SLOT(GenomeSource, genome_source, reproduction, GenomeSource)            \
  SLOT(CaptureParent, capture_parent, reproduction, Parent)                \
  SLOT(StarvationParent, starvation_parent, reproduction, Parent)          \
  SLOT(RescueParent, rescue_parent, reproduction, Parent)                  \
  SLOT(Heredity, heredity, reproduction, Heredity)                         \
  SLOT(Mutation, mutation, reproduction, Mutation)                         \
  SLOT(Activation, activation, death, Activation)                          \
  SLOT(Capture, capture, death, CaptureRule)                               \
  SLOT(Floor, floor, death, Floor)                                         \
  SLOT(StarvationSchedule, starvation_schedule, death, StarvationSchedule) \
  SLOT(Reprieve, reprieve, death, Reprieve)                                \
  SLOT(Starvation, starvation, death, Starvation)                          \
  SLOT(Rescue, rescue, death, Rescue)                                      \
  SLOT(Senescence, senescence, death, Senescence)                          \
  SLOT(SenescenceParent, senescence_parent, reproduction, Parent)

namespace trophic {

/// The slots of a rule table as values.
#define TROPHIC_ENUMERATOR(Slot, member, kind, Contract) member,
enum class RuleSlot : std::size_t { TROPHIC_RULE_SLOTS(TROPHIC_ENUMERATOR) };
#undef TROPHIC_ENUMERATOR

namespace rules {

/// The names of the slots of a rule table, in order, as in manifests and configuration files.
#define TROPHIC_SLOT_NAME(Slot, member, kind, Contract) std::string_view{#member},
inline constexpr std::array slot_names{TROPHIC_RULE_SLOTS(TROPHIC_SLOT_NAME)};
#undef TROPHIC_SLOT_NAME

}  // namespace rules

[[nodiscard]] constexpr std::string_view slot_name(RuleSlot slot) {
  return rules::slot_names[static_cast<std::size_t>(slot)];
}

}  // namespace trophic
