// SPDX-License-Identifier: MIT
// The table `paper` with each rule of `released` alone, and with groups of them. The parts of `released` have the parameters that
// it states by default, but for the interval between starvation procedures.
#include "swaps.hpp"

namespace trophic::ablations {

using Slot = RuleSlot;
template <Slot... slots>
using swapped = with_slots_of<Paper, Released, slots...>;
template <class Old, class New>
using sensor = rules::with_sensor<Paper, Old, New>;

Tables from_paper() {
  namespace parent = reproduction::parent;
  namespace starvation = death::starvation;
  namespace sensors = perception::sensors;
  constexpr auto stated_interval = [](auto& params) { params.starvation.interval = Released::params().starvation.interval; };
  return rule_tables<
      named<swapped<Slot::placement>, "paper_placement">, named<swapped<Slot::heading>, "paper_heading">,
      named<swapped<Slot::sensors>, "paper_sensors">, named<swapped<Slot::tag_switch>, "paper_tag_switch">,
      named<swapped<Slot::brain>, "paper_brain">, named<swapped<Slot::genome_source>, "paper_genome_source">,
      named<with_parent_after<Paper, Cause::starved, parent::LastSeenVictim>, "paper_parent_starved">,
      named<with_parent_after<Paper, Cause::sacrificed, parent::LastKiller>, "paper_parent_sacrificed">,
      named<swapped<Slot::heredity>, "paper_heredity">, named<swapped<Slot::mutation>, "paper_mutation">,
      named<swapped<Slot::activation>, "paper_activation">, named<swapped<Slot::capture>, "paper_capture">,
      named<with_params<with_starvation_interval<Paper, starvation::interval::DirectCrowdingInterval>, stated_interval>,
            "paper_starvation_interval">,
      named<with_starvation_exemption<Paper, starvation::exemption::NearRememberedAdversary>, "paper_starvation_exemption">,
      named<with_starvation_choice<Paper, starvation::choice::HungriestNonexemptElseHungriest>, "paper_starvation_choice">,
      // One sensor alone.
      named<sensor<sensors::SideOfAdversary, sensors::SideAwayFromHunter>, "paper_side_away_from_hunter">,
      named<sensor<sensors::DistanceOverTerrain, sensors::DistanceOverScale>, "paper_distance_over_scale">,
      named<sensor<sensors::TagRatioOfAll, sensors::TagRatioOfActive>, "paper_tag_ratio_of_active">,
      // A bias in every neuron, as in neither table.
      named<with_brain<Paper, Paper::Brain::WithBiases>, "paper_brain_with_biases">,
      // Groups.
      named<swapped<Slot::heading, Slot::sensors, Slot::tag_switch, Slot::brain>, "paper_perception">,
      named<swapped<Slot::genome_source, Slot::parent, Slot::heredity, Slot::mutation>, "paper_reproduction">,
      named<swapped<Slot::activation, Slot::capture, Slot::floor, Slot::starvation, Slot::minimum_predators>, "paper_death">>();
}

}  // namespace trophic::ablations
