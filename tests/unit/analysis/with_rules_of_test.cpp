// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <tools/ablations/with_rules_of.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using rules::Paper;
using rules::Released;
using rules::RuleDifference;
using rules::slots;
using rules::with_rules_of;

namespace {

using Older = with_params<with_senescence<Paper, death::senescence::OldAge>, [](auto& params) {
  params.senescence.max_age_s = 77.0;
  params.floor.floor = 5;
}>;
/// Paper with one policy, one number and one number of EcologyParams changed.
using Aged = with_ecology<Older, [](EcologyParams& ecology) {
  ecology.duration_s = 1.0;
  ecology.tick_s = 3.0;
}>;

}  // namespace

TEST_CASE("with rules of: slots of another table -> its policies and numbers, others unchanged") {
  using Both = with_rules_of<Paper, Aged, slots({"senescence", "floor"})>;
  static_assert(std::same_as<Both::Senescence, death::senescence::OldAge>);
  static_assert(std::same_as<Both::Heredity, Paper::Heredity>);
  const RuleParams<Both> numbers;
  CHECK(numbers.senescence.max_age_s == 77.0);
  CHECK(numbers.floor.floor == 5);
  CHECK(Both::ecology().tick_s == 2.0);
  CHECK(table_name<Both>() == "paper with senescence = old_age");
  CHECK(RuleParams<with_rules_of<Aged, Paper, slots({"floor"})>>{}.floor.floor == RuleParams<Paper>{}.floor.floor);
  CHECK(RuleParams<with_rules_of<Aged, Paper, slots({"floor"})>>{}.senescence.max_age_s == 77.0);
}

TEST_CASE("with rules of: several swaps -> one list in the name, numbers omitted") {
  CHECK(table_name<with_rules_of<Paper, Released, slots({"mutation", "heredity"})>>() ==
        "paper with heredity = shared_copy, mutation = uniform_mutation");
  CHECK(table_name<with_rules_of<Paper, Released, slots({"floor"})>>() == "paper");
}

TEST_CASE("with rules of: all slots -> the other table's rules") {
  using All = with_rules_of<Paper, Released, rules::SlotSet{~std::uint64_t{0}}>;
  for (const RuleDifference& difference : rules::differences<All, Released>()) {
    CHECK_MESSAGE((difference.name.starts_with("ecology.") || difference.name.starts_with("physics.")), difference.name);
  }
}

TEST_CASE("with rules of: two tables -> differing policies and numbers, each once, without duration") {
  const auto all = rules::differences<Paper, Aged>();
  REQUIRE(all.size() == 3);
  CHECK(all[0].name == "floor.floor");
  CHECK(all[0].here == "7");
  CHECK(all[0].there == "5");
  CHECK(all[0].is_number);
  CHECK(all[1].name == "senescence");
  CHECK(all[1].there == "old_age");
  CHECK_FALSE(all[1].is_number);
  CHECK(all[2].name == "ecology.tick_s");
  CHECK(rules::differences<Paper, Paper>().empty());
}

TEST_CASE("with sensor: one sensor swapped -> others unchanged") {
  using Paper20 = rules::with_sensor<Paper, perception::sensors::DistanceOverTerrain, perception::sensors::DistanceOverScale>;
  static_assert(std::same_as<Paper20::Sensors::At<0>, Paper::Sensors::At<0>>);
  static_assert(std::same_as<Paper20::Sensors::At<1>, perception::sensors::DistanceOverScale>);
  static_assert(std::same_as<Paper20::Sensors::At<2>, Paper::Sensors::At<2>>);
  CHECK(table_name<Paper20>() == "paper with sensors = side_of_adversary + distance_over_scale + tag_ratio_of_all");
}
