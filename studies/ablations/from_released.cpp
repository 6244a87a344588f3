// SPDX-License-Identifier: MIT
// The table `released` with each rule of `paper` alone, and with groups of them. The parts of `paper` have the parameters that it
// states by default.
#include "swaps.hpp"

namespace trophic::ablations {

using Slot = RuleSlot;
template <Slot... slots>
using swapped = with_slots_of<Released, Paper, slots...>;
template <class Old, class New>
using sensor = rules::with_sensor<Released, Old, New>;

Tables from_released() {
  namespace parent = reproduction::parent;
  namespace starvation = death::starvation;
  namespace sensors = perception::sensors;
  return rule_tables<
      named<swapped<Slot::placement>, "released_placement">, named<swapped<Slot::heading>, "released_heading">,
      named<swapped<Slot::sensors>, "released_sensors">, named<swapped<Slot::tag_switch>, "released_tag_switch">,
      named<swapped<Slot::brain>, "released_brain">, named<swapped<Slot::genome_source>, "released_genome_source">,
      named<with_parent_after<Released, Cause::starved, parent::NearestActiveVictim>, "released_parent_starved">,
      named<with_parent_after<Released, Cause::sacrificed, parent::NoParent>, "released_parent_sacrificed">,
      named<swapped<Slot::heredity>, "released_heredity">, named<swapped<Slot::mutation>, "released_mutation">,
      named<swapped<Slot::activation>, "released_activation">, named<swapped<Slot::capture>, "released_capture">,
      named<with_starvation_interval<Released, starvation::interval::DelayedCrowdingInterval>, "released_starvation_interval">,
      named<with_starvation_exemption<Released, starvation::exemption::NearPerceivedVictim>, "released_starvation_exemption">,
      named<with_starvation_choice<Released, starvation::choice::HungriestNonexempt>, "released_starvation_choice">,
      // One sensor alone.
      named<sensor<sensors::SideAwayFromHunter, sensors::SideOfAdversary>, "released_side_of_adversary">,
      named<sensor<sensors::DistanceOverScale, sensors::DistanceOverTerrain>, "released_distance_over_terrain">,
      named<sensor<sensors::TagRatioOfActive, sensors::TagRatioOfAll>, "released_tag_ratio_of_all">,
      // A bias in every neuron, as in neither table.
      named<with_brain<Released, Released::Brain::WithBiases>, "released_brain_with_biases">,
      // Groups.
      named<swapped<Slot::heading, Slot::sensors, Slot::tag_switch, Slot::brain>, "released_perception">,
      named<swapped<Slot::genome_source, Slot::parent, Slot::heredity, Slot::mutation>, "released_reproduction">,
      named<swapped<Slot::activation, Slot::capture, Slot::floor, Slot::starvation, Slot::minimum_predators>,
            "released_death">>();
}

}  // namespace trophic::ablations
