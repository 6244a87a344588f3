// SPDX-License-Identifier: MIT
// The contract of every rule of life and death, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_capture_suite, MyCaptures);
#pragma once

#include <conformance/policy_suite.hpp>
#include <set>
#include <trophic/death/activation/contract.hpp>
#include <trophic/death/capture/contract.hpp>
#include <trophic/death/floor/contract.hpp>
#include <trophic/death/minimum_predators/contract.hpp>
#include <trophic/death/senescence/contract.hpp>
#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation/exemption/contract.hpp>
#include <trophic/death/starvation/interval/contract.hpp>

namespace trophic::conformance {

/// Hunters, each once.
inline void check_who_starves(const test::HandPopulation& robots, const std::vector<BodyIndex>& starving) {
  std::set<BodyIndex> seen;
  for (const BodyIndex body : starving) {
    REQUIRE(body < robots.individuals.size());
    CHECK(robots.web.hunts(robots.individuals[body].species));
    CHECK(seen.insert(body).second);
  }
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("activation", Policy, trophic_activation_suite) {
  using namespace trophic;
  static_assert(death::Activation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      const auto own = conformance::own_state(policy, any.individuals[body], seed);
      return death::ask::activates(policy, own, body, any.view());
    });
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
          const auto own = conformance::own_state(made, robots.individuals[body], seed);
          answers.add(death::ask::activates(made, own, body, robots.view()));
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
    const auto captures_in = [&](const test::HandPopulation& any, Rng& rng) {
      const auto kept = conformance::own_states(policy, any, seed);
      const std::span<const StateOf<Policy>> states{kept};
      return death::ask::captures(policy, states, any.view(), rng);
    };
    const auto from_seed = [&](const test::HandPopulation& any) {
      Rng rng{seed, Stream::user};
      return captures_in(any, rng);
    };
    conformance::on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK((from_seed(same) == from_seed(robots))); });
    if constexpr (!requires { Policy::depends_on_order_of_bodies; }) {
      conformance::check_whom(robots, seed, [&](const test::HandPopulation& any, Rng& rng) {
        std::vector<BodyIndex> caught;
        for (const auto& capture : captures_in(any, rng)) caught.push_back(capture.victim);
        return caught;
      });
    }
    std::set<BodyIndex> victims;
    const auto ask = [&](Rng& rng) { return captures_in(robots, rng); };
    for (const auto& capture : conformance::asked_twice(seed, ask)) {
      REQUIRE(capture.hunter < view.robots.size());
      REQUIRE(capture.victim < view.robots.size());
      CHECK(view.web.eats(view.robots[capture.hunter].species, view.robots[capture.victim].species));
      CHECK(view.robots[capture.victim].active);
      CHECK(victims.insert(capture.victim).second);
    }
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        Rng rng{seed, Stream::user};
        const auto kept = conformance::own_states(made, robots, seed);
        const std::span<const StateOf<Policy>> states{kept};
        for (const auto& capture : death::ask::captures(made, states, robots.view(), rng)) {
          answers.add(std::pair{capture.hunter, capture.victim});
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
      conformance::check_all_robots(
          robots, seed, [&](const test::HandPopulation& any) { return death::ask::may_die(policy, species, any.view()); });
    }
  });
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
      for (Species species = 0; species < robots.web.size(); ++species)
        answers.add(death::ask::may_die(made, species, robots.view()));
    });
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("interval between starvation procedures", Policy, trophic_starvation_interval_suite) {
  using namespace trophic;
  static_assert(death::starvation::Interval<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const std::int64_t interval_ticks = policy.interval_ticks(robots.view());
    CHECK(interval_ticks >= 1);
    conformance::check_all_robots(robots, seed,
                                  [&](const test::HandPopulation& any) { return policy.interval_ticks(any.view()); });
    const death::starvation::StarvationClock clock{.last_tick = robots.tick, .interval_ticks = interval_ticks};
    CHECK_FALSE(policy.due(clock, robots.view()));  // not twice in a tick
  });
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
      answers.add(made.interval_ticks(robots.view()));
      for (std::int64_t last_tick = 0; last_tick < robots.tick; last_tick += 3) {
        answers.add(made.due({.last_tick = last_tick, .interval_ticks = 10}, robots.view()));
      }
    });
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("exemption from starvation", Policy, trophic_starvation_exemption_suite) {
  using namespace trophic;
  static_assert(death::starvation::Exemption<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      const auto own = conformance::own_state(policy, any.individuals[body], seed);
      return death::starvation::ask::is_exempt(policy, own, body, any.view(), any.perceives());
    });
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
          const auto own = conformance::own_state(made, robots.individuals[body], seed);
          answers.add(death::starvation::ask::is_exempt(made, own, body, robots.view(), robots.perceives()));
        }
      });
}

TEST_CASE_TEMPLATE_DEFINE("choice of hunters that starve", Policy, trophic_starvation_choice_suite) {
  using namespace trophic;
  static_assert(death::starvation::Choice<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const auto victims_in = [&](const test::HandPopulation& any) {
      return policy.victims(any.view(), [&](BodyIndex body) { return any.individuals[body].tag == 1; });
    };
    const std::vector<BodyIndex> victims = victims_in(robots);
    conformance::check_who_starves(robots, victims);
    conformance::on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK((victims_in(same) == victims)); });
    const auto order = test::random_order(seed, robots.individuals.size());
    const std::vector<BodyIndex> moved = victims_in(robots.reordered(order));
    REQUIRE(moved.size() == victims.size());
    for (std::size_t i = 0; i < victims.size(); ++i) CHECK(order[moved[i]] == victims[i]);
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t) {
        answers.add(made.victims(robots.view(), [&](BodyIndex body) { return robots.individuals[body].tag == 1; }));
      });
}

TEST_CASE_TEMPLATE_DEFINE("starvation", Policy, trophic_starvation_suite) {
  using namespace trophic;
  static_assert(death::Starvation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const auto starving = [](const Policy& rule, const test::HandPopulation& any, std::uint64_t seed) {
    test::HandPopulation start = any;
    const auto clock = death::ask::start(rule, start.at_tick(0).view());
    const conformance::AnyStates<Policy> kept{rule, any, seed};
    return death::ask::starving(rule, kept.all(), clock, any.view(), any.perceives());
  };
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const death::Starving starves = starving(policy, robots, seed);
    conformance::check_who_starves(robots, starves.victims);
    conformance::check_who_starves(robots, starves.exempt);
    conformance::on_same_worlds(robots,
                                [&](const test::HandPopulation& same) { CHECK((starving(policy, same, seed) == starves)); });
    const auto order = test::random_order(seed, robots.individuals.size());
    const death::Starving moved = starving(policy, robots.reordered(order), seed);
    REQUIRE(moved.victims.size() == starves.victims.size());
    for (std::size_t i = 0; i < starves.victims.size(); ++i) CHECK(order[moved.victims[i]] == starves.victims[i]);
    CHECK(moved.restarts_clock == starves.restarts_clock);
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (const std::int64_t tick : {std::int64_t{0}, std::int64_t{5}, std::int64_t{12}, robots.tick}) {
          test::HandPopulation then = robots;
          const death::Starving starves = starving(made, then.at_tick(tick), seed);
          answers.add(starves.victims);
          answers.add(starves.exempt);
        }
      });
}

TEST_CASE_TEMPLATE_DEFINE("minimum predators", Policy, trophic_minimum_predators_suite) {
  using namespace trophic;
  static_assert(death::MinimumPredators<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const View view = robots.view();
    const auto sacrifices_in = [&](const test::HandPopulation& any, Rng& rng) {
      const auto kept = conformance::own_states(policy, any, seed);
      const std::span<const StateOf<Policy>> states{kept};
      return death::ask::sacrifices(policy, states, any.view(), rng);
    };
    const auto from_seed = [&](const test::HandPopulation& any) {
      Rng rng{seed, Stream::user};
      return sacrifices_in(any, rng);
    };
    conformance::on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK((from_seed(same) == from_seed(robots))); });
    conformance::check_whom(robots, seed, [&](const test::HandPopulation& any, Rng& rng) {
      std::vector<BodyIndex> given_up;
      for (const auto& sacrifice : sacrifices_in(any, rng)) given_up.push_back(sacrifice.victim);
      return given_up;
    });
    std::set<BodyIndex> victims;
    const auto ask = [&](Rng& rng) { return sacrifices_in(robots, rng); };
    for (const auto& sacrifice : conformance::asked_twice(seed, ask)) {
      REQUIRE(sacrifice.victim < view.robots.size());
      REQUIRE(sacrifice.successor < view.web.size());
      CHECK(view.web.eats(sacrifice.successor, view.robots[sacrifice.victim].species));
      CHECK(victims.insert(sacrifice.victim).second);
    }
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        Rng rng{seed, Stream::user};
        const auto kept = conformance::own_states(made, robots, seed);
        const std::span<const StateOf<Policy>> states{kept};
        for (const auto& sacrifice : death::ask::sacrifices(made, states, robots.view(), rng)) {
          answers.add(std::pair{sacrifice.victim, sacrifice.successor});
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
      const auto own = conformance::own_state(policy, individual, seed);
      conformance::asked_twice(seed, [&](Rng& rng) { return death::ask::dies(policy, own, individual, robots.view(), rng); });
    }
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      Rng rng{seed, Stream::user};
      const auto own = conformance::own_state(policy, any.individuals[body], seed);
      return death::ask::dies(policy, own, any.individuals[body], any.view(), rng);
    });
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (const Individual& individual : robots.individuals) {
          const auto own = conformance::own_state(made, individual, seed);
          for (std::uint64_t event = 0; event < 20; ++event) {
            Rng rng{seed, Stream::user, individual.id, event};
            answers.add(death::ask::dies(made, own, individual, robots.view(), rng));
          }
        }
      });
}
