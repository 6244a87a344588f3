// SPDX-License-Identifier: MIT
// The paper's table, and it with each shipped policy that neither trophic-ablations nor trophic-readings swaps and that acts
// without bodies. The test of effects runs them.
#include <trophic/experiment.hpp>
#include <trophic/trophic.hpp>

using namespace trophic;
using rules::Paper;
namespace brain = control::brain;
namespace birth = reproduction;

template <class Policy>
using WithStarvedParent = with_parent_after<Paper, Cause::starved, Policy>;
using Ageing = with_senescence<Paper, death::senescence::OldAgeOfVictims>;

int main(int argc, char** argv) {
  return experiment<
      Paper, Ageing, rules::with_sensor<Paper, perception::sensors::DistanceOverTerrain, perception::sensors::DistanceOverScale>,
      with_activation<Ageing, death::activation::AgesOnceAwayFromHunters>,
      with_community<Paper, initialization::community::FoodChain>, with_visibility<Paper, perception::visibility::AllActive>,
      with_visibility<Paper, perception::visibility::WithinRange>, with_tag_switch<Paper, perception::tag_switch::FreeTags>,
      with_brain<Paper, brain::FeedForwardBrain>, with_brain<Paper, brain::GrowingBrain>,
      with_brain<Paper, brain::Hebbian<brain::FeedForwardBrain>>, with_brain<Paper, brain::RecurrentBrain>,
      with_initial_genome<Paper, birth::initial_genome::NormalWeights>,
      with_genome_source<Paper, birth::genome_source::AlwaysInherited>,
      WithStarvedParent<birth::parent::AnySurvivor<birth::parent::NearestActiveVictim>>,
      WithStarvedParent<birth::parent::FastestEscape>, WithStarvedParent<birth::parent::LastEscapee>,
      WithStarvedParent<birth::parent::MostEscapes>, WithStarvedParent<birth::parent::NoParent>,
      with_heredity<Paper, birth::heredity::AllButBrain>, with_heredity<Paper, birth::heredity::NothingInherited>,
      with_heredity<Paper, birth::heredity::Switched<birth::heredity::OwnCopy>>,
      with_mutation<Paper, birth::mutation::NoMutation>, with_recruitment<Paper, birth::recruitment::AfterEscapes>,
      with_activation<Paper, death::activation::AlwaysActive>, with_capture<Paper, death::capture::NoCapture>,
      with_floor<Paper, death::floor::NoFloor>, with_starvation<Paper, death::starvation::NoStarvation>,
      with_starvation_choice<Paper, death::starvation::choice::HungriestShare>,
      with_starvation_exemption<Paper, death::starvation::exemption::NoExemption>,
      with_starvation_interval<Paper, death::starvation::interval::NeverDue>,
      with_minimum_predators<Paper, death::minimum_predators::NoMinimum>, with_senescence<Paper, death::senescence::OldAge>>(
      argc, argv);
}
