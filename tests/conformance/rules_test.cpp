// SPDX-License-Identifier: MIT
// Every shipped rule against the suite of its kind.
#include <conformance/community_suite.hpp>
#include <conformance/control_suite.hpp>
#include <conformance/death_suite.hpp>
#include <conformance/energy_suite.hpp>
#include <conformance/parts_suite.hpp>
#include <conformance/perception_suite.hpp>
#include <conformance/placement_suite.hpp>
#include <conformance/reproduction_suite.hpp>
#include <trophic/control/acts/effort.hpp>
#include <trophic/control/acts/mate.hpp>
#include <trophic/control/acts/signal.hpp>
#include <trophic/control/brain/cognitive_brain_with_biases.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/growing_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/control/brain/outside.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <trophic/control/brain/turns_by_input.hpp>
#include <trophic/control/gait/inherited_cpg.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/control/gait/learnt.hpp>
#include <trophic/control/gait/named_gait.hpp>
#include <trophic/control/gait/robots_gait.hpp>
#include <trophic/control/pace/constant_pace.hpp>
#include <trophic/control/pace/inherited_pace.hpp>
#include <trophic/control/steering/bending_steering.hpp>
#include <trophic/control/steering/no_steering.hpp>
#include <trophic/death/activation/always_active.hpp>
#include <trophic/death/activation/founders_start_active.hpp>
#include <trophic/death/capture/catch_outside_refuges.hpp>
#include <trophic/death/capture/no_capture.hpp>
#include <trophic/death/capture/one_within_reach.hpp>
#include <trophic/death/floor/active_victim_floor.hpp>
#include <trophic/death/floor/no_floor.hpp>
#include <trophic/death/minimum_predators/no_minimum.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/death/senescence/old_age_of_victims.hpp>
#include <trophic/death/starvation/choice/hungriest_else_oldest.hpp>
#include <trophic/death/starvation/choice/hungriest_share.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/death/starvation/interval/never_due.hpp>
#include <trophic/death/starvation/no_starvation.hpp>
#include <trophic/energy/metabolism/falling_energy.hpp>
#include <trophic/energy/metabolism/fixed_gains.hpp>
#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/energy/metabolism/grazing_by_diet.hpp>
#include <trophic/energy/metabolism/no_metabolism.hpp>
#include <trophic/energy/order/by_turns.hpp>
#include <trophic/energy/order/together.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/energy/resource/foods.hpp>
#include <trophic/energy/resource/logistic_field.hpp>
#include <trophic/energy/resource/moving_zones.hpp>
#include <trophic/energy/resource/no_resource.hpp>
#include <trophic/initialization/community/food_chain.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/perception/heading/reversed_on_back.hpp>
#include <trophic/perception/newborn_tag/random_tag.hpp>
#include <trophic/perception/sensors/distance_over_diagonal.hpp>
#include <trophic/perception/sensors/food_gradient.hpp>
#include <trophic/perception/sensors/hearing.hpp>
#include <trophic/perception/sensors/joint_angles.hpp>
#include <trophic/perception/sensors/nearest_zone.hpp>
#include <trophic/perception/sensors/own_energy.hpp>
#include <trophic/perception/sensors/own_speed.hpp>
#include <trophic/perception/sensors/random_turn.hpp>
#include <trophic/perception/sensors/rays.hpp>
#include <trophic/perception/sensors/tilt.hpp>
#include <trophic/perception/sensors/touch.hpp>
#include <trophic/perception/tag_switch/first_switch_free.hpp>
#include <trophic/perception/tag_switch/free_tags.hpp>
#include <trophic/perception/visibility/all_active.hpp>
#include <trophic/perception/visibility/same_tag_if_active.hpp>
#include <trophic/perception/visibility/within_range.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/body_plan/named_body.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <trophic/reproduction/heredity/crossover.hpp>
#include <trophic/reproduction/heredity/crossover_by_neuron.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/reproduction/initial_genome/normal_weights.hpp>
#include <trophic/reproduction/mutation/no_mutation.hpp>
#include <trophic/reproduction/parent/any_survivor.hpp>
#include <trophic/reproduction/parent/fastest_escape.hpp>
#include <trophic/reproduction/parent/last_escapee.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/reproduction/recruitment/at_energy.hpp>
#include <trophic/reproduction/recruitment/by_chance.hpp>
#include <trophic/reproduction/recruitment/by_mating.hpp>
#include <trophic/reproduction/recruitment/in_zones.hpp>
#include <trophic/reproduction/recruitment/mate/alike_genomes.hpp>
#include <trophic/reproduction/recruitment/mate/alike_in.hpp>
#include <trophic/reproduction/recruitment/mate/other_sex.hpp>
#include <trophic/reproduction/recruitment/no_recruitment.hpp>
#include <trophic/reproduction/recruitment/with_mate.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/reproduction/traits/sex.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/reproduction/viability/within_mass.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

using GrassAndPatches = energy::resource::Foods<energy::resource::Food<"grass", energy::resource::LogisticField>,
                                                energy::resource::Food<"patches", energy::resource::DelayedPatches>>;

struct Sight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 8.0, least = 1.0, most = 12.0, sd = 3.0;
};

}  // namespace

TEST_CASE("rules: every number of a shipped rule has a line of help") {
  using Others = with_senescence<rules::Paper, death::senescence::OldAge>;
  for (const NamedParams& named_params :
       {named_params_of(RuleParams<rules::Paper>{}), named_params_of(RuleParams<rules::Released>{}),
        named_params_of(RuleParams<Others>{})}) {
    for (const NamedParam& param : named_params) {
      CAPTURE(param.path);
      CHECK_FALSE(param.help.empty());
    }
  }
}

TEST_CASE_TEMPLATE_INVOKE(trophic_community_suite, initialization::community::PredatorPrey, initialization::community::FoodChain);
TEST_CASE_TEMPLATE_INVOKE(trophic_placement_suite, initialization::placement::Scattered,
                          initialization::placement::UniformSquare);

TEST_CASE_TEMPLATE_INVOKE(trophic_heading_suite, perception::heading::ForwardAxisHeading, perception::heading::RootYawHeading,
                          perception::heading::ReversedOnBack<perception::heading::ForwardAxisHeading>);
TEST_CASE_TEMPLATE_INVOKE(trophic_visibility_suite, perception::visibility::SameTag, perception::visibility::SameTagIfActive,
                          perception::visibility::AllActive, perception::visibility::WithinRange);
TEST_CASE_TEMPLATE_INVOKE(trophic_sensor_suite, perception::sensors::SideOfAdversary, perception::sensors::SideAwayFromHunter,
                          perception::sensors::DistanceOverTerrain, perception::sensors::DistanceOverDiagonal,
                          perception::sensors::DistanceOverScale, perception::sensors::TagRatioOfAll,
                          perception::sensors::TagRatioOfActive, perception::sensors::Hearing<0>,
                          perception::sensors::FoodGradient, perception::sensors::OwnEnergy, perception::sensors::OwnSpeed,
                          perception::sensors::JointAngles<4>, perception::sensors::Tilt, perception::sensors::Touch,
                          perception::sensors::Rays<8, perception::sensors::Sees::kin, perception::sensors::Sees::victims,
                                                    perception::sensors::Sees::walls, perception::sensors::Sees::food>,
                          perception::sensors::RandomTurn, perception::sensors::NearestZone);
TEST_CASE_TEMPLATE_INVOKE(trophic_newborn_tag_suite, perception::newborn_tag::KeepsBodyTag, perception::newborn_tag::RandomTag);
TEST_CASE_TEMPLATE_INVOKE(trophic_tag_switch_suite, perception::tag_switch::TagCoolDown, perception::tag_switch::FirstSwitchFree,
                          perception::tag_switch::TagSampling, perception::tag_switch::FreeTags);
TEST_CASE_TEMPLATE_INVOKE(trophic_brain_suite, control::brain::CognitiveBrain, control::brain::CognitiveBrainZeroRight,
                          control::brain::CognitiveBrainWithBiases, control::brain::CognitiveBrainZeroRight::WithBiases,
                          control::brain::FeedForwardBrain, control::brain::RecurrentBrain,
                          control::brain::Hebbian<control::brain::FeedForwardBrain>,
                          control::brain::Hebbian<control::brain::RecurrentBrain>, control::brain::GrowingBrain,
                          control::brain::Hebbian<control::brain::GrowingBrain>, control::brain::TurnsByInput);
TEST_CASE("brain: Outside -> the numbers of its genome, no outputs of its own") {
  conformance::check_policy<control::brain::Outside>();
  const control::brain::Outside brain{{.genes = 5}};
  CHECK(brain.genome_size(3, 2) == 5);
  std::array<double, 2> outputs{};
  CHECK_THROWS_AS(brain.evaluate({}, {}, outputs), RuleError);
}
TEST_CASE_TEMPLATE_INVOKE(trophic_act_suite, control::acts::Turn, control::acts::Tag, control::acts::Effort, control::acts::Eat,
                          control::acts::Mate, control::acts::Signal<0>);
TEST_CASE_TEMPLATE_INVOKE(trophic_pace_suite, control::pace::SamePace, control::pace::ConstantPace,
                          control::pace::InheritedPace<reproduction::traits::List<control::pace::WalkingPace>>);
TEST_CASE_TEMPLATE_INVOKE(trophic_steering_suite, control::steering::TargetedSteering, control::steering::BendingSteering,
                          control::steering::NoSteering);

TEST_CASE_TEMPLATE_INVOKE(trophic_initial_genome_suite, reproduction::initial_genome::UniformWeights,
                          reproduction::initial_genome::NormalWeights);
TEST_CASE_TEMPLATE_INVOKE(trophic_genome_source_suite, reproduction::genome_source::RandomOrInherited,
                          reproduction::genome_source::RandomOrInheritedInName, reproduction::genome_source::AlwaysInherited);
TEST_CASE_TEMPLATE_INVOKE(trophic_parent_suite, reproduction::parent::FastestEscape, reproduction::parent::LastEscapee,
                          reproduction::parent::MostEscapes, reproduction::parent::Killer, reproduction::parent::LastKiller,
                          reproduction::parent::LastSeenVictim, reproduction::parent::NearestConspecific,
                          reproduction::parent::NearestActiveVictim, reproduction::parent::NearestVictim,
                          reproduction::parent::NoParent, reproduction::parent::AnySurvivor<reproduction::parent::Killer>,
                          rules::Paper::Parent, rules::Released::Parent);
TEST_CASE_TEMPLATE_INVOKE(trophic_parent_species_suite, rules::Paper::Parent, rules::Released::Parent,
                          reproduction::parent::Killer, reproduction::parent::LastKiller,
                          reproduction::parent::NearestConspecific, reproduction::parent::NoParent,
                          reproduction::parent::FastestEscape, reproduction::parent::LastEscapee,
                          reproduction::parent::MostEscapes);
TEST_CASE_TEMPLATE_INVOKE(trophic_recruitment_suite, reproduction::recruitment::NoRecruitment,
                          reproduction::recruitment::AfterEscapes, reproduction::recruitment::AtEnergy,
                          reproduction::recruitment::ByMating, reproduction::recruitment::ByChance,
                          reproduction::recruitment::InZones, reproduction::recruitment::WithMate<>,
                          reproduction::recruitment::WithMate<reproduction::recruitment::mate::OtherSex,
                                                              reproduction::recruitment::mate::AlikeIn<Sight>,
                                                              reproduction::recruitment::mate::AlikeGenomes>);
TEST_CASE_TEMPLATE_INVOKE(trophic_gait_suite, control::gait::RobotsGait, control::gait::NamedGait, control::gait::InheritedCpg,
                          control::gait::InheritedCppn, control::gait::Learnt<control::gait::InheritedCpg>,
                          control::gait::Learnt<control::gait::InheritedCppn>);
TEST_CASE_TEMPLATE_INVOKE(trophic_body_plan_suite, reproduction::body_plan::OneBody, reproduction::body_plan::NamedBody,
                          reproduction::body_plan::InheritedModules);
TEST_CASE_TEMPLATE_INVOKE(trophic_viability_suite, reproduction::viability::AlwaysViable, reproduction::viability::WithinMass,
                          reproduction::viability::ModuleLimits,
                          reproduction::viability::SurvivesTrial<reproduction::viability::ModuleLimits>);
TEST_CASE_TEMPLATE_INVOKE(trophic_metabolism_suite, energy::metabolism::GrazingAndHunting, energy::metabolism::FixedGains,
                          energy::metabolism::FallingEnergy, energy::metabolism::NoMetabolism,
                          energy::metabolism::GrazingByDiet<>);
TEST_CASE_TEMPLATE_INVOKE(trophic_resource_suite, energy::resource::LogisticField, energy::resource::DelayedPatches,
                          energy::resource::MovingZones, energy::resource::NoResource, GrassAndPatches);
TEST_CASE_TEMPLATE_INVOKE(trophic_order_suite, energy::order::ByTurns, energy::order::Together);

TEST_CASE_TEMPLATE_INVOKE(trophic_heredity_suite, reproduction::heredity::Crossover, reproduction::heredity::CrossoverByNeuron,
                          reproduction::heredity::OwnCopy, reproduction::heredity::SharedCopy,
                          reproduction::heredity::NothingInherited, reproduction::heredity::AllButBrain,
                          reproduction::heredity::AllButGait, reproduction::heredity::AllButBody,
                          reproduction::heredity::Switched<reproduction::heredity::OwnCopy>);
TEST_CASE_TEMPLATE_INVOKE(trophic_traits_suite, reproduction::traits::NoTraits, reproduction::traits::List<Sight>,
                          reproduction::traits::List<reproduction::traits::Sex>);
TEST_CASE_TEMPLATE_INVOKE(trophic_mutation_suite, reproduction::mutation::NormalMutation, reproduction::mutation::UniformMutation,
                          reproduction::mutation::NoMutation);

TEST_CASE_TEMPLATE_INVOKE(trophic_activation_suite, death::activation::ActiveAwayFromHunters,
                          death::activation::FoundersStartActive, death::activation::AgesOnceAwayFromHunters,
                          death::activation::AlwaysActive);
TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, death::capture::CatchWithinReach, death::capture::CatchClosest,
                          death::capture::CatchOutsideRefuges, death::capture::OneWithinReach, death::capture::NoCapture);
TEST_CASE_TEMPLATE_INVOKE(trophic_floor_suite, death::floor::VictimFloor, death::floor::ActiveVictimFloor, death::floor::NoFloor);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_interval_suite, death::starvation::interval::DelayedCrowdingInterval,
                          death::starvation::interval::DirectCrowdingInterval, death::starvation::interval::NeverDue);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_exemption_suite, death::starvation::exemption::NearPerceivedVictim,
                          death::starvation::exemption::NearRememberedAdversary, death::starvation::exemption::NoExemption);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_choice_suite, death::starvation::choice::HungriestNonexempt,
                          death::starvation::choice::HungriestElseOldest, death::starvation::choice::HungriestShare,
                          death::starvation::choice::HungriestNonexemptElseHungriest);
TEST_CASE_TEMPLATE_INVOKE(trophic_starvation_suite, rules::Paper::Starvation, rules::Released::Starvation,
                          death::starvation::NoStarvation);
TEST_CASE_TEMPLATE_INVOKE(trophic_minimum_predators_suite, death::minimum_predators::SacrificeRandomVictim,
                          death::minimum_predators::NoMinimum);
TEST_CASE_TEMPLATE_INVOKE(trophic_senescence_suite, death::senescence::NoSenescence, death::senescence::OldAge,
                          death::senescence::OldAgeOfVictims);
