// SPDX-License-Identifier: MIT
// What every rule of life and death must do, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, MyCaptures);
#pragma once

#include <conformance/policy_suite.hpp>
#include <functional>
#include <optional>
#include <set>
#include <trophic/death/concept.hpp>
#include <vector>

TEST_CASE_TEMPLATE_DEFINE("activation", Policy, trophic_activation_suite) {
  using namespace trophic;
  static_assert(death::Activation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  CHECK(policy.restarts_age() == policy.restarts_age());
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      CHECK(policy.activates(body, robots.view()) == policy.activates(body, robots.view()));
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("captures", Policy, trophic_capture_suite) {
  using namespace trophic;
  static_assert(death::CaptureRule<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const View view = robots.view();
    std::set<BodyIndex> victims;
    for (const auto& capture : conformance::asked_twice(seed, [&](Rng& rng) { return policy.captures(view, rng); })) {
      REQUIRE(capture.hunter < view.robots.size());
      REQUIRE(capture.victim < view.robots.size());
      CHECK(view.web.eats(view.robots[capture.hunter].species, view.robots[capture.victim].species));
      CHECK(view.robots[capture.victim].active);
      CHECK(victims.insert(capture.victim).second);
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("floor", Policy, trophic_floor_suite) {
  using namespace trophic;
  static_assert(death::Floor<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    for (Species species = 0; species < robots.web.size(); ++species) {
      CHECK(policy.may_die(species, robots.view()) == policy.may_die(species, robots.view()));
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("starvation schedule", Policy, trophic_starvation_schedule_suite) {
  using namespace trophic;
  static_assert(death::StarvationSchedule<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    const std::int64_t interval_ticks = policy.interval_ticks(robots.view());
    CHECK(interval_ticks >= 1);
    CHECK(policy.interval_ticks(robots.view()) == interval_ticks);
    const death::StarvationClock clock{.last_tick = robots.tick, .interval_ticks = interval_ticks};
    CHECK_FALSE(policy.due(clock, robots.view()));  // not twice in a tick
  });
}

TEST_CASE_TEMPLATE_DEFINE("reprieve", Policy, trophic_reprieve_suite) {
  using namespace trophic;
  static_assert(death::Reprieve<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      CHECK(policy.spared(body, robots.view()) == policy.spared(body, robots.view()));
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("starvation", Policy, trophic_starvation_suite) {
  using namespace trophic;
  static_assert(death::Starvation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    const std::function<bool(BodyIndex)> spared = [&](BodyIndex body) { return robots.individuals[body].tag == 1; };
    const std::optional<BodyIndex> victim = policy.victim(robots.view(), spared);
    CHECK((policy.victim(robots.view(), spared) == victim));
    if (!victim) return;
    REQUIRE(*victim < robots.individuals.size());
    CHECK(robots.web.hunts(robots.individuals[*victim].species));
  });
}

TEST_CASE_TEMPLATE_DEFINE("rescue", Policy, trophic_rescue_suite) {
  using namespace trophic;
  static_assert(death::Rescue<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const View view = robots.view();
    std::set<BodyIndex> victims;
    for (const auto& sacrifice : conformance::asked_twice(seed, [&](Rng& rng) { return policy.sacrifices(view, rng); })) {
      REQUIRE(sacrifice.victim < view.robots.size());
      REQUIRE(sacrifice.heir < view.web.size());
      CHECK(view.web.eats(sacrifice.heir, view.robots[sacrifice.victim].species));
      CHECK(victims.insert(sacrifice.victim).second);
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("senescence", Policy, trophic_senescence_suite) {
  using namespace trophic;
  static_assert(death::Senescence<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    for (const Individual& individual : robots.individuals) {
      conformance::asked_twice(seed, [&](Rng& rng) { return policy.dies(individual, robots.view(), rng); });
    }
  });
}
