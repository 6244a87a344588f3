// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/death/minimum_predators/no_minimum.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/rule_error.hpp>

using namespace trophic;

namespace {

/// Takes its numbers and keeps its own.
struct Deaf {
  static constexpr std::string_view name = "deaf";
  using Params = death::senescence::OldAge::Params;
  Deaf() = default;
  explicit Deaf(const Params&) {}
  bool dies(const Individual& one, const View& view, Rng&) const { return view.age_s(one) > params.max_age_s; }
  Params params;
};

struct Kept {
  static constexpr std::string_view name = "kept";
  using Params = death::senescence::OldAge::Params;
  explicit Kept(const Params& given) : params{given} {}
  bool dies(const Individual& one, const View& view, Rng&) const { return view.age_s(one) > params.max_age_s; }
  Params params;
};

template <class Policy>
std::string made_with_50_s() {
  using Rules = with_senescence<rules::Paper, Policy>;
  RuleParams<Rules> numbers;
  numbers.senescence.max_age_s = 50.0;
  try {
    return number_text(make_policies<Rules>(numbers).senescence.params.max_age_s);
  } catch (const RuleError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("rules: paper -> its numbers") {
  const RuleParams<rules::Paper> numbers;
  CHECK(numbers.community.predators == 14);
  CHECK(numbers.tag_switch.cool_down_s == 50.0);
  CHECK(numbers.brain.turn_angle_rad == 0.7);
  CHECK(numbers.steering.exponent == 2.0);
  CHECK(numbers.initial_genome.limit == 1.0);
  CHECK(numbers.genome_source.random_share == 1.0 / 3.0);
  CHECK(numbers.parent.starved.range_m == 12.0);
  CHECK(numbers.activation.distance_m == 5.0);
  CHECK(numbers.capture.reach_m == 1.0);
  CHECK(numbers.capture.min_age_s == 0.0);
  CHECK(numbers.floor.floor == 7);
  CHECK(numbers.starvation.interval.base_ticks == 25);
  CHECK(numbers.starvation.interval.only_above == 0);
  CHECK(numbers.starvation.exemption.range_m == 5.0);
  CHECK(numbers.minimum_predators.below == 7);
  const EcologyParams ecology = rules::Paper::ecology();
  CHECK(ecology.robots == 30);
  CHECK(ecology.duration_s == 6000.0);
  CHECK(ecology.tick_s == 2.0);
  CHECK(ecology.first_tick_s == 0.0);
  CHECK(ecology.control_hz == 60.0);
  CHECK(ecology.clock_scale == 1.0);
  CHECK(ecology.idle_control_steps == 0);
  CHECK(ecology.phase_at_birth == PhaseAtBirth::kept);
  CHECK(ecology.decision_order == DecisionOrder::together);
  CHECK(ecology.without_target == WithoutTarget::decides);
  CHECK(rules::Paper::physics().timestep_s == 0.0012);
}

TEST_CASE("rules: released -> the code's numbers") {
  const RuleParams<rules::Released> numbers;
  CHECK(numbers.placement.half_extent_m == 9.0);
  CHECK(numbers.sensors.get<1>().full_scale_m == 20.0);
  CHECK(numbers.tag_switch.period_s == 100.0);
  CHECK(numbers.brain.turn_angle_rad == 0.7);
  CHECK(numbers.genome_source.random_share == 0.34);
  CHECK(numbers.mutation.half_width == 0.05);
  CHECK(numbers.mutation.limit == 1.0);
  CHECK(numbers.capture.min_age_s == 20.0);
  CHECK(numbers.floor.floor == 6);
  CHECK(numbers.starvation.interval.base_ticks == 25);
  CHECK(numbers.starvation.interval.only_above == 7);
  CHECK(numbers.starvation.exemption.range_m == 5.0);
  CHECK(numbers.minimum_predators.below == 8);
  CHECK(rules::Released::ecology().duration_s == 6500.0);
  CHECK(rules::Released::ecology().first_tick_s == 2.0);
  CHECK(rules::Released::ecology().clock_scale == 1.2);
  CHECK(rules::Released::ecology().idle_control_steps == 1);
  CHECK(rules::Released::ecology().phase_at_birth == PhaseAtBirth::kept);
  CHECK(rules::Released::ecology().decision_order == DecisionOrder::in_turn);
  CHECK(rules::Released::ecology().without_target == WithoutTarget::keeps_decision);
  CHECK(rules::Released::physics().timestep_s == 0.012);
  CHECK(rules::Released::physics().integrator == Integrator::rk4);
}

TEST_CASE("rules: with_<slot> -> one rule swapped, others keep their numbers") {
  using Swapped = with_mutation<rules::Released, reproduction::mutation::NormalMutation>;
  static_assert(std::same_as<Swapped::Mutation, reproduction::mutation::NormalMutation>);
  static_assert(std::same_as<Swapped::Capture, rules::Released::Capture>);
  const RuleParams<Swapped> numbers;
  CHECK(numbers.mutation.sd == 0.05);
  CHECK(numbers.tag_switch.period_s == 100.0);
  CHECK(numbers.capture.min_age_s == 20.0);
  CHECK(Swapped::ecology().clock_scale == 1.2);
}

TEST_CASE("rules: swapped rule -> the policy's own numbers, not another table's") {
  CHECK(RuleParams<with_starvation<rules::Released, rules::Released::Starvation>>{}.starvation.interval.only_above == 0);
  CHECK(RuleParams<with_floor<rules::Released, death::floor::VictimFloor>>{}.floor.floor == 7);
}

TEST_CASE("rules: nested swaps -> all in the table's name") {
  using Twice = with_senescence<with_mutation<rules::Paper, reproduction::mutation::NoMutation>, death::senescence::OldAge>;
  static_assert(std::same_as<Twice::Mutation, reproduction::mutation::NoMutation>);
  static_assert(std::same_as<Twice::Senescence, death::senescence::OldAge>);
  CHECK(table_name<rules::Paper>() == "paper");
  CHECK(table_name<Twice>() == "paper with mutation = no_mutation with senescence = old_age");
  using Back = with_mutation<Twice, reproduction::mutation::NormalMutation>;
  static_assert(std::same_as<Back::Mutation, rules::Paper::Mutation>);
}

TEST_CASE("rules: one part swapped -> others keep the table's parameters") {
  using Shorter = with_params<rules::Released, [](auto& params) { params.starvation.interval.base_ticks = 15; }>;
  using Harsh = with_starvation_exemption<Shorter, death::starvation::exemption::NoExemption>;
  static_assert(is_rule_table<Harsh>);
  static_assert(std::same_as<PolicyIn<Harsh, RuleSlot::starvation>::Part<0>, rules::Released::Starvation::Part<0>>);
  static_assert(std::same_as<PolicyIn<Harsh, RuleSlot::starvation>::Part<1>, death::starvation::exemption::NoExemption>);
  CHECK(table_name<Harsh>() == "released with starvation.exemption = no_exemption");
  CHECK(RuleParams<Harsh>{}.starvation.interval.base_ticks == 15);
  CHECK(RuleParams<Harsh>{}.starvation.interval.only_above == 7);
  CHECK(RuleParams<Harsh>{}.floor.floor == 6);
  CHECK(Harsh::ecology().clock_scale == 1.2);

  using AnyPrey = with_parent_after<rules::Paper, Cause::starved, reproduction::parent::NearestVictim>;
  CHECK(table_name<AnyPrey>() == "paper with parent.starved = nearest_victim");
  CHECK(RuleParams<AnyPrey>{}.parent.starved.range_m == 4.0);
  static_assert(std::same_as<PolicyIn<AnyPrey, RuleSlot::parent>::Part<0>, rules::Paper::Parent::Part<0>>);
}

namespace {

/// All that a table must state.
struct Smallest final {
  using P = rules::Paper;
  static constexpr std::string_view name = "smallest";
  using Community = P::Community;
  using Placement = P::Placement;
  using Heading = P::Heading;
  using Sensors = P::Sensors;
  using NewbornTag = P::NewbornTag;
  using Brain = P::Brain;
  using Steering = P::Steering;
  using InitialGenome = P::InitialGenome;
  using Heredity = P::Heredity;
  static TableParams<Smallest> params() { return {}; }
  static EcologyParams ecology() { return {}; }
  static Physics physics() { return {}; }
};

}  // namespace

TEST_CASE("rules: slot left out -> neutral policy, not listed") {
  static_assert(is_rule_table<Smallest>);
  static_assert(std::same_as<PolicyIn<Smallest, RuleSlot::capture>, death::capture::NoCapture>);
  static_assert(is_neutral<Smallest, RuleSlot::senescence> && is_neutral<rules::Paper, RuleSlot::senescence>);
  std::vector<std::string> slots;
  for (const auto& rule : rules::slot_rules<Smallest>()) slots.emplace_back(rule.slot);
  CHECK(slots == std::vector<std::string>{"community", "placement", "heading", "sensors", "newborn_tag", "brain", "steering",
                                          "initial_genome", "heredity"});
  // stated or left out, there is no such rule
  std::vector<std::string> stated;
  for (const auto& rule : rules::slot_rules<with_capture<Smallest, death::capture::NoCapture>>()) stated.emplace_back(rule.slot);
  CHECK(stated == slots);
}

TEST_CASE("rules: with_params -> same rules and name, other numbers") {
  using Lower = with_params<rules::Released, [](auto& params) { params.floor.floor = 3; }>;
  static_assert(is_rule_table<Lower>);
  static_assert(std::same_as<Lower::Floor, rules::Released::Floor>);
  const RuleParams<Lower> numbers;
  CHECK(numbers.floor.floor == 3);
  CHECK(numbers.minimum_predators.below == 8);
  CHECK(Lower::ecology().clock_scale == 1.2);
  CHECK(Lower::physics().timestep_s == 0.012);
  CHECK(table_name<Lower>() == "released");
  using Swapped = with_minimum_predators<with_params<Lower, [](auto& params) { params.capture.reach_m = 2.0; }>,
                                         death::minimum_predators::NoMinimum>;
  CHECK(RuleParams<Swapped>{}.floor.floor == 3);
  CHECK(RuleParams<Swapped>{}.capture.reach_m == 2.0);
}

TEST_CASE("rules: named -> same rules and numbers, later swaps in the name") {
  using Ageing = named<with_senescence<rules::Released, death::senescence::OldAge>, "ageing">;
  static_assert(is_rule_table<Ageing>);
  static_assert(std::same_as<Ageing::Senescence, death::senescence::OldAge>);
  CHECK(table_name<Ageing>() == "ageing");
  CHECK(RuleParams<Ageing>{}.floor.floor == 6);
  CHECK(Ageing::ecology().first_tick_s == 2.0);
  CHECK(table_name<with_minimum_predators<Ageing, death::minimum_predators::NoMinimum>>() ==
        "ageing with minimum_predators = no_minimum");
}

TEST_CASE("rules: numbers in a program -> default to the table's, not the policies'") {
  const RuleParams<rules::Released> numbers{.minimum_predators = {.below = 9}};
  CHECK(numbers.minimum_predators.below == 9);
  CHECK(numbers.floor.floor == 6);
  CHECK(numbers.capture.min_age_s == 20.0);
}

TEST_CASE("rules: numbers at run time -> reach the policies") {
  RuleParams<rules::Paper> numbers;
  numbers.capture.reach_m = 3.5;
  numbers.community.predators = 2;
  const auto policies = make_policies<rules::Paper>(numbers);
  CHECK(policies.capture.params.reach_m == 3.5);
  CHECK(policies.community.founders(5).size() == 5);
  CHECK(policies.community.params.predators == 2);
}

TEST_CASE("rules: policy with other numbers than given -> RuleError with name and slot") {
  CHECK(made_with_50_s<death::senescence::OldAge>() == "50");
  CHECK(made_with_50_s<Kept>() == "50");
  CHECK(made_with_50_s<Deaf>() == "the policy deaf in rules.senescence holds another max_age_s than it was made from");
}

TEST_CASE("rules: visit of slots -> each one that is not neutral, once, in order, with its policy") {
  std::vector<std::pair<std::string, std::string>> slots;
  for (const auto& rule : rules::slot_rules<rules::Paper>()) slots.emplace_back(rule.slot, rule.policy);
  REQUIRE(slots.size() == 19);
  CHECK(rules::slot_names.size() == 31);  // Paper leaves out those of bodies and gaits, recruitment and senescence
  CHECK(slots.front() == std::pair<std::string, std::string>{"community", "predator_prey"});
  CHECK(slots.back() == std::pair<std::string, std::string>{"minimum_predators", "sacrifice_random_victim"});
  for (std::size_t i = 0; i < slots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(slots[i].first != slots[j].first);
  }
}
