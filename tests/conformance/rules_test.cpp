// SPDX-License-Identifier: MIT
// Every shipped rule against the suite of its kind.
#include <conformance/community_suite.hpp>
#include <conformance/control_suite.hpp>
#include <conformance/death_suite.hpp>
#include <conformance/perception_suite.hpp>
#include <conformance/placement_suite.hpp>
#include <conformance/reproduction_suite.hpp>
#include <trophic/control/cognitive_brain_with_biases.hpp>
#include <trophic/death/no_reprieve.hpp>
#include <trophic/death/old_age.hpp>
#include <trophic/perception/everybody.hpp>
#include <trophic/perception/random_tag.hpp>
#include <trophic/reproduction/nearest_conspecific.hpp>
#include <trophic/reproduction/nothing_inherited.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/settings.hpp>

using namespace trophic;

TEST_CASE("rules: every number of a shipped rule has a line of help") {
  using Others = with_senescence<rules::Paper, death::OldAge>;
  for (const Settings& settings : {settings_of(RuleNumbers<rules::Paper>{}), settings_of(RuleNumbers<rules::Released>{}),
                                   settings_of(RuleNumbers<Others>{})}) {
    for (const Setting& setting : settings) {
      CAPTURE(setting.path);
      CHECK_FALSE(setting.help.empty());
    }
  }
}

TEST_CASE_TEMPLATE_INVOKE(trophic_community_suite, community::PredatorPrey);
TEST_CASE_TEMPLATE_INVOKE(trophic_placement_suite, placement::Scattered, placement::UniformSquare);

TEST_CASE_TEMPLATE_INVOKE(trophic_heading_suite, perception::ForwardAxisHeading, perception::RootYawHeading);
TEST_CASE_TEMPLATE_INVOKE(trophic_visibility_suite, perception::SameTag, perception::Everybody);
TEST_CASE_TEMPLATE_INVOKE(trophic_sighting_input_suite, perception::SideOfAdversary, perception::SideAwayFromHunter,
                          perception::DistanceOverTerrain, perception::DistanceOverScale);
TEST_CASE_TEMPLATE_INVOKE(trophic_population_input_suite, perception::TagRatioOfAll, perception::TagRatioOfActive);
TEST_CASE_TEMPLATE_INVOKE(trophic_blind_rule_suite, perception::BlindSeesNothing, perception::BlindKeepsOutputs);
TEST_CASE_TEMPLATE_INVOKE(trophic_newborn_tag_suite, perception::KeepsBodyTag, perception::RandomTag);
TEST_CASE_TEMPLATE_INVOKE(trophic_tag_switch_suite, perception::TagCoolDown, perception::TagSampling);
TEST_CASE_TEMPLATE_INVOKE(trophic_brain_suite, control::CognitiveBrain, control::CognitiveBrainWithBiases);
TEST_CASE_TEMPLATE_INVOKE(trophic_decision_order_suite, control::DecideTogether, control::DecideInTurn);
TEST_CASE_TEMPLATE_INVOKE(trophic_steering_suite, control::TargetedSteering);

TEST_CASE_TEMPLATE_INVOKE(trophic_initial_genome_suite, reproduction::UniformWeights);
TEST_CASE_TEMPLATE_INVOKE(trophic_genome_source_suite, reproduction::RandomOrInherited);
TEST_CASE_TEMPLATE_INVOKE(trophic_parent_suite, reproduction::Killer, reproduction::LastKiller, reproduction::LastSeenVictim,
                          reproduction::NearestConspecific, reproduction::NearestVictim, reproduction::NoParent);
TEST_CASE_TEMPLATE_INVOKE(trophic_heir_parent_suite, reproduction::Killer, reproduction::LastKiller,
                          reproduction::NearestConspecific, reproduction::NoParent);
TEST_CASE_TEMPLATE_INVOKE(trophic_heredity_suite, reproduction::OwnCopy, reproduction::SharedCopy,
                          reproduction::NothingInherited);
TEST_CASE_TEMPLATE_INVOKE(trophic_mutation_suite, reproduction::NormalMutation, reproduction::UniformMutation);

TEST_CASE_TEMPLATE_INVOKE(trophic_activation_suite, death::ActiveAwayFromHunters);
TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, death::CatchWithinReach, death::CatchClosest);
TEST_CASE_TEMPLATE_INVOKE(trophic_floor_suite, death::VictimFloor);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_schedule_suite, death::CrowdingInterval);
TEST_CASE_TEMPLATE_INVOKE(trophic_reprieve_suite, death::NearPerceivedVictim, death::NearRememberedAdversary, death::NoReprieve);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_suite, death::HungriestStarves);
TEST_CASE_TEMPLATE_INVOKE(trophic_rescue_suite, death::SacrificeRandomVictim);
TEST_CASE_TEMPLATE_INVOKE(trophic_senescence_suite, death::NoSenescence, death::OldAge);
