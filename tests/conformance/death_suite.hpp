// SPDX-License-Identifier: MIT
// What every rule of life and death must do, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, MyCaptures);
#pragma once

#include <conformance/policy_suite.hpp>
#include <functional>
#include <optional>
#include <set>
#include <trophic/death/activation/contract.hpp>
#include <trophic/death/capture/contract.hpp>
#include <trophic/death/floor/contract.hpp>
#include <trophic/death/reprieve/contract.hpp>
#include <trophic/death/rescue/contract.hpp>
#include <trophic/death/senescence/contract.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation_schedule/contract.hpp>
#include <utility>
#include <vector>

TEST_CASE_TEMPLATE_DEFINE("activation", Policy, trophic_activation_suite) {
  using namespace trophic;
  static_assert(death::Activation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(
        robots, seed, [&](const test::HandPopulation& any, BodyIndex body) { return policy.activates(body, any.view()); });
  });
}

TEST_CASE_TEMPLATE_DEFINE("captures", Policy, trophic_capture_suite) {
  using namespace trophic;
  static_assert(death::CaptureRule<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const View view = robots.view();
    const auto pairs_in = [&](const test::HandPopulation& any) {
      Rng rng{seed, Stream::user};
      std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
      for (const auto& capture : policy.captures(any.view(), rng)) pairs.emplace_back(capture.hunter, capture.victim);
      return pairs;
    };
    conformance::on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK((pairs_in(same) == pairs_in(robots))); });
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
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    for (Species species = 0; species < robots.web.size(); ++species) {
      conformance::check_all_robots(robots, seed,
                                    [&](const test::HandPopulation& any) { return policy.may_die(species, any.view()); });
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("starvation schedule", Policy, trophic_starvation_schedule_suite) {
  using namespace trophic;
  static_assert(death::StarvationSchedule<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const std::int64_t interval_ticks = policy.interval_ticks(robots.view());
    CHECK(interval_ticks >= 1);
    conformance::check_all_robots(robots, seed,
                                  [&](const test::HandPopulation& any) { return policy.interval_ticks(any.view()); });
    const death::StarvationClock clock{.last_tick = robots.tick, .interval_ticks = interval_ticks};
    CHECK_FALSE(policy.due(clock, robots.view()));  // not twice in a tick
  });
}

TEST_CASE_TEMPLATE_DEFINE("reprieve", Policy, trophic_reprieve_suite) {
  using namespace trophic;
  static_assert(death::Reprieve<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(
        robots, seed, [&](const test::HandPopulation& any, BodyIndex body) { return policy.spared(body, any.view()); });
  });
}

TEST_CASE_TEMPLATE_DEFINE("starvation", Policy, trophic_starvation_suite) {
  using namespace trophic;
  static_assert(death::Starvation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const auto victim_in = [&](const test::HandPopulation& any) {
      const std::function<bool(BodyIndex)> spared = [&](BodyIndex body) { return any.individuals[body].tag == 1; };
      return policy.victim(any.view(), spared);
    };
    const std::optional<BodyIndex> victim = victim_in(robots);
    conformance::on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK((victim_in(same) == victim)); });
    const auto order = test::random_order(seed, robots.individuals.size());
    const std::optional<BodyIndex> moved = victim_in(robots.reordered(order));
    REQUIRE(moved.has_value() == victim.has_value());
    if (!victim) return;
    CHECK(order[*moved] == *victim);
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
    const auto victims_in = [&](const test::HandPopulation& any) {
      Rng rng{seed, Stream::user};
      std::vector<std::pair<BodyIndex, Species>> found;
      for (const auto& sacrifice : policy.sacrifices(any.view(), rng)) found.emplace_back(sacrifice.victim, sacrifice.heir);
      return found;
    };
    conformance::on_same_worlds(robots,
                                [&](const test::HandPopulation& same) { CHECK((victims_in(same) == victims_in(robots))); });
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
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      Rng rng{seed, Stream::user};
      return policy.dies(any.individuals[body], any.view(), rng);
    });
  });
}
