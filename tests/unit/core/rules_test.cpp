// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <trophic/death/reprieve/no_reprieve.hpp>
#include <trophic/death/rescue/no_rescue.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/rule_error.hpp>
#include <utility>
#include <vector>

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

/// The first member takes the numbers, the one that is used does not.
struct Misplaced {
  static constexpr std::string_view name = "misplaced";
  using Params = death::senescence::OldAge::Params;
  Params spare;
  Params params{};
  bool dies(const Individual& one, const View& view, Rng&) const { return view.age_s(one) > params.max_age_s; }
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

TEST_CASE("rules: the paper's numbers") {
  const RuleParams<rules::Paper> numbers;
  CHECK(numbers.community.predators == 14);
  CHECK(numbers.tag_switch.cool_down_s == 50.0);
  CHECK(numbers.brain.turn_angle_rad == 0.7);
  CHECK(numbers.steering.exponent == 2.0);
  CHECK(numbers.initial_genome.limit == 1.0);
  CHECK(numbers.genome_source.random_share == 1.0 / 3.0);
  CHECK(numbers.starvation_parent.range_m == 12.0);
  CHECK(numbers.activation.distance_m == 5.0);
  CHECK(numbers.capture.reach_m == 1.0);
  CHECK(numbers.capture.min_age_s == 0.0);
  CHECK(numbers.floor.floor == 7);
  CHECK(numbers.starvation_schedule.base_ticks == 25);
  CHECK(numbers.starvation_schedule.only_above == 0);
  CHECK(numbers.reprieve.range_m == 5.0);
  CHECK(numbers.rescue.below == 7);
  const EcologyParams ecology = rules::Paper::ecology();
  CHECK(ecology.robots == 30);
  CHECK(ecology.duration_s == 6000.0);
  CHECK(ecology.tick_s == 2.0);
  CHECK(ecology.first_tick_s == 0.0);
  CHECK(ecology.control_hz == 60.0);
  CHECK(ecology.clock_scale == 1.0);
  CHECK(ecology.idle_control_steps == 0);
  CHECK(ecology.phase_at_birth == PhaseAtBirth::kept);
  CHECK(rules::Paper::physics().timestep_s == 0.0012);
}

TEST_CASE("rules: the released code's numbers") {
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
  CHECK(numbers.starvation_schedule.base_ticks == 25);
  CHECK(numbers.starvation_schedule.only_above == 7);
  CHECK(numbers.reprieve.range_m == 5.0);
  CHECK(numbers.rescue.below == 8);
  CHECK(rules::Released::ecology().duration_s == 6500.0);
  CHECK(rules::Released::ecology().first_tick_s == 2.0);
  CHECK(rules::Released::ecology().clock_scale == 1.2);
  CHECK(rules::Released::ecology().idle_control_steps == 1);
  CHECK(rules::Released::ecology().phase_at_birth == PhaseAtBirth::kept);
  CHECK(rules::Released::physics().timestep_s == 0.012);
  CHECK(rules::Released::physics().integrator == Integrator::rk4);
}

TEST_CASE("rules: with_<slot> swaps one rule and keeps the others with their numbers") {
  using Swapped = with_mutation<rules::Released, reproduction::mutation::NormalMutation>;
  static_assert(std::same_as<Swapped::Mutation, reproduction::mutation::NormalMutation>);
  static_assert(std::same_as<Swapped::Capture, rules::Released::Capture>);
  const RuleParams<Swapped> numbers;
  CHECK(numbers.mutation.sd == 0.05);
  CHECK(numbers.tag_switch.period_s == 100.0);
  CHECK(numbers.capture.min_age_s == 20.0);
  CHECK(Swapped::ecology().clock_scale == 1.2);
}

TEST_CASE("rules: a swapped rule starts at the policy's own numbers, not at those of the table it came from") {
  CHECK(RuleParams<with_starvation_schedule<rules::Released, rules::Released::StarvationSchedule>>{}
            .starvation_schedule.only_above == 0);
  CHECK(RuleParams<with_floor<rules::Released, death::floor::VictimFloor>>{}.floor.floor == 7);
}

TEST_CASE("rules: swaps can be stacked and the table's name tells them") {
  using Twice = with_senescence<with_reprieve<rules::Paper, death::reprieve::NoReprieve>, death::senescence::OldAge>;
  static_assert(std::same_as<Twice::Reprieve, death::reprieve::NoReprieve>);
  static_assert(std::same_as<Twice::Senescence, death::senescence::OldAge>);
  CHECK(table_name<rules::Paper>() == "paper");
  CHECK(table_name<Twice>() == "paper with reprieve = no_reprieve with senescence = old_age");
  using Back = with_reprieve<Twice, death::reprieve::NearPerceivedVictim>;
  static_assert(std::same_as<Back::Reprieve, rules::Paper::Reprieve>);
}

TEST_CASE("rules: a table of other numbers has the rules and the name of the one that it is made of") {
  using Lower = with_params<rules::Released, [](auto& params) { params.floor.floor = 3; }>;
  static_assert(is_rule_table<Lower>);
  static_assert(std::same_as<Lower::Floor, rules::Released::Floor>);
  const RuleParams<Lower> numbers;
  CHECK(numbers.floor.floor == 3);
  CHECK(numbers.rescue.below == 8);
  CHECK(Lower::ecology().clock_scale == 1.2);
  CHECK(Lower::physics().timestep_s == 0.012);
  CHECK(table_name<Lower>() == "released");
  using Swapped = with_rescue<with_params<Lower, [](auto& params) { params.capture.reach_m = 2.0; }>, death::rescue::NoRescue>;
  CHECK(RuleParams<Swapped>{}.floor.floor == 3);
  CHECK(RuleParams<Swapped>{}.capture.reach_m == 2.0);
}

TEST_CASE("rules: a table under its own name keeps rules and numbers, and tells what is swapped in it later") {
  using Ageing = named<with_senescence<rules::Released, death::senescence::OldAge>, "ageing">;
  static_assert(is_rule_table<Ageing>);
  static_assert(std::same_as<Ageing::Senescence, death::senescence::OldAge>);
  CHECK(table_name<Ageing>() == "ageing");
  CHECK(RuleParams<Ageing>{}.floor.floor == 6);
  CHECK(Ageing::ecology().first_tick_s == 2.0);
  CHECK(table_name<with_rescue<Ageing, death::rescue::NoRescue>>() == "ageing with rescue = no_rescue");
}

TEST_CASE("rules: numbers given in a program start at the table's, not at the policies'") {
  const RuleParams<rules::Released> numbers{.rescue = {.below = 9}};
  CHECK(numbers.rescue.below == 9);
  CHECK(numbers.floor.floor == 6);
  CHECK(numbers.capture.min_age_s == 20.0);
}

TEST_CASE("rules: numbers given at run time reach the policies") {
  RuleParams<rules::Paper> numbers;
  numbers.capture.reach_m = 3.5;
  numbers.community.predators = 2;
  const auto policies = make_policies<rules::Paper>(numbers);
  CHECK(policies.capture.params.reach_m == 3.5);
  CHECK(policies.community.founders(5).size() == 5);
  CHECK(policies.community.params.predators == 2);
}

TEST_CASE("rules: a policy that does not hold the numbers it was made from is refused by name and slot") {
  CHECK(made_with_50_s<death::senescence::OldAge>() == "50");
  CHECK(made_with_50_s<Kept>() == "50");
  CHECK(made_with_50_s<Deaf>() == "the policy deaf in rules.senescence holds another max_age_s than it was made from");
  CHECK(made_with_50_s<Misplaced>() == "the policy misplaced in rules.senescence holds another max_age_s than it was made from");
}

TEST_CASE("rules: every slot once, in the order of the table, with the policy's name") {
  std::vector<std::pair<std::string, std::string>> slots;
  for_each_rule<rules::Paper>([&](std::string_view slot, std::string_view policy) { slots.emplace_back(slot, policy); });
  REQUIRE(slots.size() == 27);
  CHECK(slots.front() == std::pair<std::string, std::string>{"community", "predator_prey"});
  CHECK(slots.back() == std::pair<std::string, std::string>{"senescence_parent", "no_parent"});
  for (std::size_t i = 0; i < slots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(slots[i].first != slots[j].first);
  }
}
