// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <trophic/death/starvation/exemption/near_perceived_victim.hpp>
#include <trophic/death/starvation/exemption/near_remembered_adversary.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/death/starvation/interval/delayed_crowding_interval.hpp>
#include <trophic/death/starvation/interval/never_due.hpp>
#include <trophic/death/starvation/procedure.hpp>
#include <trophic/params/named_params.hpp>

using namespace trophic;
using namespace trophic::test;
using namespace death::starvation;
using Chosen = std::vector<BodyIndex>;
using PaperProcedure = Procedure<interval::DelayedCrowdingInterval, exemption::NearPerceivedVictim, choice::HungriestNonexempt>;

static_assert(death::Starvation<PaperProcedure>);
static_assert(death::KeepsClock<PaperProcedure>);

TEST_CASE("procedure: interval due -> a hunter starves and the clock restarts") {
  HandPopulation robots{{{.species = predator, .fed_tick = 3}, {.species = predator, .fed_tick = 1}}};
  const PaperProcedure rule;
  const auto clock = rule.start(robots.view());
  CHECK(clock.last_tick == 0);
  CHECK(clock.interval_ticks == 23);
  CHECK(rule.starving(robots.at_tick(22).view(), robots.perceives(), {}, clock) == death::Starving{});
  CHECK(rule.starving(robots.at_tick(23).view(), robots.perceives(), {}, clock) ==
        death::Starving{.victims = {1}, .exempt = {}, .restarts_clock = true});
  CHECK(rule.start(robots.at_tick(23).view()).last_tick == 23);
}

TEST_CASE("procedure: exempt hunters -> skipped and reported, only those considered") {
  const HandPopulation robots = HandPopulation{
      {{.species = predator, .fed_tick = 3},
       {.species = predator, .x_m = 9.0, .fed_tick = 2},
       {.species = predator, .x_m = -9.0, .fed_tick = 1},
       {.species = prey, .x_m = -9.0},
       {.species = prey,
        .x_m = 0.1}}}.at_tick(100);
  const PaperProcedure rule;
  CHECK(rule.starving(robots.view(), robots.perceives(), {}, {}) ==
        death::Starving{.victims = {1}, .exempt = {2}, .restarts_clock = true});
  const PaperProcedure far_sighted{{.exemption = {.range_m = 30.0}}};
  CHECK(far_sighted.starving(robots.view(), robots.perceives(), {}, {}) ==
        death::Starving{.victims = {}, .exempt = {2, 1, 0}, .restarts_clock = true});
}

TEST_CASE("procedure: never due -> nothing happens") {
  const HandPopulation robots = HandPopulation{{{.species = predator}}}.at_tick(1'000'000);
  const Procedure<interval::NeverDue, exemption::NoExemption, choice::HungriestNonexempt> rule;
  CHECK(rule.starving(robots.view(), robots.perceives(), {}, rule.start(robots.view())) == death::Starving{});
}

TEST_CASE("procedure: exemption with a state -> state of the hunter considered") {
  using Remembering =
      Procedure<interval::DelayedCrowdingInterval, exemption::NearRememberedAdversary, choice::HungriestNonexempt>;
  const HandPopulation robots =
      HandPopulation{{{.species = predator, .fed_tick = 1}, {.species = predator, .fed_tick = 2}}}.at_tick(100);
  const std::vector<exemption::NearRememberedAdversary::State> remembered{{.adversary_distance_m = 1.0},
                                                                          {.adversary_distance_m = 9.0}};
  Remembering::States states;
  std::get<1>(states) = remembered;
  CHECK(Remembering{}.starving(robots.view(), robots.perceives(), states, {}) ==
        death::Starving{.victims = {1}, .exempt = {0}, .restarts_clock = true});
}

TEST_CASE("procedure: name and numbers -> list its parts") {
  CHECK(PaperProcedure::name ==
        "interval: delayed_crowding_interval, exemption: near_perceived_victim, choice: hungriest_nonexempt");
  std::vector<std::string> paths;
  for (const NamedParam& param : named_params_of(PaperProcedure::Params{})) paths.push_back(param.path);
  CHECK(paths == std::vector<std::string>{"interval.base_ticks", "interval.min_interval_ticks", "interval.only_above",
                                          "exemption.range_m"});
}
