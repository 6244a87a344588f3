// SPDX-License-Identifier: MIT
// The slots of a rule table.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/gait/contract.hpp>
#include <trophic/control/gait/robots_gait.hpp>
#include <trophic/control/pace/contract.hpp>
#include <trophic/control/pace/same_pace.hpp>
#include <trophic/control/steering/contract.hpp>
#include <trophic/death/activation/always_active.hpp>
#include <trophic/death/activation/contract.hpp>
#include <trophic/death/capture/contract.hpp>
#include <trophic/death/capture/no_capture.hpp>
#include <trophic/death/floor/contract.hpp>
#include <trophic/death/floor/no_floor.hpp>
#include <trophic/death/minimum_predators/contract.hpp>
#include <trophic/death/minimum_predators/no_minimum.hpp>
#include <trophic/death/senescence/contract.hpp>
#include <trophic/death/senescence/no_senescence.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation/no_starvation.hpp>
#include <trophic/energy/metabolism/contract.hpp>
#include <trophic/energy/metabolism/no_metabolism.hpp>
#include <trophic/energy/order/contract.hpp>
#include <trophic/energy/order/together.hpp>
#include <trophic/energy/resource/contract.hpp>
#include <trophic/energy/resource/no_resource.hpp>
#include <trophic/initialization/community/contract.hpp>
#include <trophic/initialization/embodiment/contract.hpp>
#include <trophic/initialization/embodiment/keeps_body.hpp>
#include <trophic/initialization/placement/contract.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/perception/newborn_tag/contract.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/perception/tag_switch/contract.hpp>
#include <trophic/perception/tag_switch/free_tags.hpp>
#include <trophic/perception/visibility/all_active.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>
#include <trophic/reproduction/body_plan/one_body.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/reproduction/mutation/no_mutation.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>
#include <trophic/reproduction/recruitment/no_recruitment.hpp>
#include <trophic/reproduction/traits/contract.hpp>
#include <trophic/reproduction/traits/no_traits.hpp>
#include <trophic/reproduction/viability/always_viable.hpp>
#include <trophic/reproduction/viability/contract.hpp>

/// Every slot of a rule table: (Slot, member, kind, contract, neutral policy, may differ by species). Tables, parameters,
/// with_<slot>, checks and manifests are generated from this list. A contract's concept and sentence are in
/// trophic/KIND/SLOT/contract.hpp.
///
/// A table may omit a slot that has a neutral policy; it then has no such rule. Manifests, fingerprints and printed tables
/// omit a slot that holds its neutral policy. A table that lacks a slot without one (NoPolicy) does not compile. Slots that
/// concern one individual or species accept `by_species<Policy>` (rules/by_species.hpp): true.
#define TROPHIC_RULE_SLOTS(SLOT)                                                                                     \
  SLOT(Community, community, initialization, Community, detail::NoPolicy, false)                                     \
  SLOT(Placement, placement, initialization, Placement, detail::NoPolicy, false)                                     \
  SLOT(Embodiment, embodiment, initialization, Embodiment, initialization::embodiment::KeepsBody, false)             \
  SLOT(Heading, heading, perception, Heading, detail::NoPolicy, false)                                               \
  SLOT(Visibility, visibility, perception, Visibility, perception::visibility::AllActive, true)                      \
  SLOT(Sensors, sensors, perception, SensorList, detail::NoPolicy, false)                                            \
  SLOT(NewbornTag, newborn_tag, perception, NewbornTag, detail::NoPolicy, false)                                     \
  SLOT(TagSwitch, tag_switch, perception, TagSwitch, perception::tag_switch::FreeTags, true)                         \
  SLOT(Acts, acts, control, ActList, control::acts::TurnAndTag, false)                                               \
  SLOT(Brain, brain, control, Brain, detail::NoPolicy, true)                                                         \
  SLOT(Steering, steering, control, Steering, detail::NoPolicy, false)                                               \
  SLOT(Gait, gait, control, GaitRule, control::gait::RobotsGait, true)                                               \
  SLOT(Pace, pace, control, Pace, control::pace::SamePace, true)                                                     \
  SLOT(InitialGenome, initial_genome, reproduction, InitialGenome, detail::NoPolicy, true)                           \
  SLOT(GenomeSource, genome_source, reproduction, GenomeSource, reproduction::genome_source::AlwaysInherited, false) \
  SLOT(Parent, parent, reproduction, Parent, reproduction::parent::NoParent, true)                                   \
  SLOT(Heredity, heredity, reproduction, Heredity, detail::NoPolicy, true)                                           \
  SLOT(Mutation, mutation, reproduction, Mutation, reproduction::mutation::NoMutation, true)                         \
  SLOT(BodyPlan, body_plan, reproduction, BodyPlan, reproduction::body_plan::OneBody, true)                          \
  SLOT(Viability, viability, reproduction, Viability, reproduction::viability::AlwaysViable, true)                   \
  SLOT(Traits, traits, reproduction, TraitRule, reproduction::traits::NoTraits, true)                                \
  SLOT(Recruitment, recruitment, reproduction, Recruitment, reproduction::recruitment::NoRecruitment, true)          \
  SLOT(Activation, activation, death, Activation, death::activation::AlwaysActive, true)                             \
  SLOT(Capture, capture, death, CaptureRule, death::capture::NoCapture, true)                                        \
  SLOT(Floor, floor, death, Floor, death::floor::NoFloor, true)                                                      \
  SLOT(Starvation, starvation, death, Starvation, death::starvation::NoStarvation, false)                            \
  SLOT(MinimumPredators, minimum_predators, death, MinimumPredators, death::minimum_predators::NoMinimum, false)     \
  SLOT(Senescence, senescence, death, Senescence, death::senescence::NoSenescence, true)                             \
  SLOT(Metabolism, metabolism, energy, Metabolism, energy::metabolism::NoMetabolism, true)                           \
  SLOT(Resource, resource, energy, Resource, energy::resource::NoResource, false)                                    \
  SLOT(Order, order, energy, Order, energy::order::Together, false)

namespace trophic {

namespace detail {

/// Represents the policy of a slot that a table lacks.
struct NoPolicy {};

}  // namespace detail

/// The slots of a rule table as values.
#define TROPHIC_ENUMERATOR(Slot, member, ...) member,
enum class RuleSlot : std::size_t { TROPHIC_RULE_SLOTS(TROPHIC_ENUMERATOR) };
#undef TROPHIC_ENUMERATOR

namespace rules {

/// The names of the slots of a rule table, in order, as in manifests and configuration files.
#define TROPHIC_SLOT_NAME(Slot, member, ...) std::string_view{#member},
inline constexpr std::array slot_names{TROPHIC_RULE_SLOTS(TROPHIC_SLOT_NAME)};
#undef TROPHIC_SLOT_NAME

/// The kind of rules of each slot, in order.
#define TROPHIC_SLOT_KIND(Slot, member, kind, ...) std::string_view{#kind},
inline constexpr std::array slot_kinds{TROPHIC_RULE_SLOTS(TROPHIC_SLOT_KIND)};
#undef TROPHIC_SLOT_KIND

}  // namespace rules

[[nodiscard]] constexpr std::string_view slot_kind(RuleSlot slot) {
  return rules::slot_kinds[static_cast<std::size_t>(slot)];
}
[[nodiscard]] constexpr std::string_view slot_name(RuleSlot slot) {
  return rules::slot_names[static_cast<std::size_t>(slot)];
}

/// When the policy of a slot is asked for the last time; its parameters may be read earlier.
[[nodiscard]] constexpr Read slot_read(RuleSlot slot) {
  switch (slot) {
    case RuleSlot::community:
    case RuleSlot::placement:
      return Read::at_start;
    case RuleSlot::initial_genome:
      return Read::for_newcomers;
    case RuleSlot::newborn_tag:
    case RuleSlot::genome_source:
    case RuleSlot::heredity:
    case RuleSlot::mutation:
    case RuleSlot::traits:
    case RuleSlot::body_plan:
    case RuleSlot::viability:
    case RuleSlot::embodiment:
      return Read::at_birth;
    default:
      return Read::at_any_tick;
  }
}

/// Calls `visit.template operator()<slot>()` for each RuleSlot in order.
template <class Visit>
constexpr void for_each_slot(const Visit& visit) {
  [&]<std::size_t... slot>(std::index_sequence<slot...>) {
    (visit.template operator()<static_cast<RuleSlot>(slot)>(), ...);
  }
  (std::make_index_sequence<rules::slot_names.size()>{});
}

namespace detail {

/// The member of a slot, found without a search through all slots.
template <RuleSlot slot>
struct SlotMember;
#define TROPHIC_MEMBER(Slot, member, ...)     \
  template <>                                 \
  struct SlotMember<RuleSlot::member> {       \
    template <class OneEach>                  \
    static constexpr auto& in(OneEach& all) { \
      return all.member;                      \
    }                                         \
  };
TROPHIC_RULE_SLOTS(TROPHIC_MEMBER)
#undef TROPHIC_MEMBER

}  // namespace detail

/// The member of a slot in a struct with one member per slot: TableParams, RuleParams, Policies, RuleStates.
template <RuleSlot slot, class OneEach>
[[nodiscard]] constexpr auto& of_slot(OneEach& all) {
  return detail::SlotMember<slot>::in(all);
}

}  // namespace trophic
