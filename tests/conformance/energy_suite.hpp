// SPDX-License-Identifier: MIT
// The contract of every rule of energy: TEST_CASE_TEMPLATE_INVOKE(trophic_metabolism_suite, MyMetabolism);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/energy/metabolism/contract.hpp>
#include <trophic/energy/order/contract.hpp>
#include <trophic/energy/resource/contract.hpp>

TEST_CASE_TEMPLATE_DEFINE("metabolism", Policy, trophic_metabolism_suite) {
  using namespace trophic;
  static_assert(energy::Metabolism<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const auto all_of = [](conformance::Answers& answers, const Policy& made, test::HandPopulation robots, std::uint64_t seed) {
    robots.foods.assign(3, ResourceField{robots.arena, 1});
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      if (!robots.individuals[body].lives()) continue;
      Rng rng{seed, Stream::user, body};
      answers.add(made.first_J(robots.individuals[body], rng));
      answers.add(made.upkeep_J(body, 0.01 * static_cast<double>(body), robots.view()));
      for (std::size_t food = 0; food < 3; ++food) {
        const double bite_J = made.bite_J(body, food, 50.0, robots.view());
        answers.add(bite_J);
        answers.add(energy::ask::waste_J(made, body, food, bite_J, robots.view()));
      }
      answers.add(made.meal_J(body, 0, robots.view()));
      answers.add(made.starves(body, robots.view()));
      answers.add(energy::ask::grant_J(made, robots.individuals[body]));
    }
  };
  conformance::on_populations<Policy>([&](test::HandPopulation robots, std::uint64_t seed) {
    robots.foods.assign(3, ResourceField{robots.arena, 1});
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      const double first_J =
          conformance::asked_twice(seed, [&](Rng& rng) { return policy.first_J(robots.individuals[body], rng); });
      CHECK(first_J >= 0.0);
      CHECK(std::isfinite(first_J));
      for (const double walked_m : {0.0, 0.1, 5.0}) {
        CHECK(policy.upkeep_J(body, walked_m, robots.view()) >= 0.0);
        CHECK(std::isfinite(policy.upkeep_J(body, walked_m, robots.view())));
      }
      for (const double there_J : {0.0, 0.01, 1000.0}) {
        for (std::size_t food = 0; food < robots.foods.size(); ++food) {
          const double bite_J = policy.bite_J(body, food, there_J, robots.view());
          CHECK(bite_J >= 0.0);
          CHECK(bite_J <= there_J);
          CHECK(energy::ask::waste_J(policy, body, food, bite_J, robots.view()) >= 0.0);
        }
      }
      const BodyIndex victim = robots.individuals.size() - 1 - body;
      CHECK(policy.meal_J(body, victim, robots.view()) >= 0.0);
      CHECK(policy.meal_J(body, victim, robots.view()) <= std::max(robots.individuals[victim].energy_J, 0.0));
    }
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      return std::tuple{policy.upkeep_J(body, 0.1, any.view()), policy.bite_J(body, 1, 5.0, any.view()),
                        policy.starves(body, any.view())};
    });
  });
  conformance::check_params_used_on_populations<Policy>(all_of);
}

TEST_CASE_TEMPLATE_DEFINE("order", Policy, trophic_order_suite) {
  using namespace trophic;
  static_assert(energy::Order<Policy>);
  conformance::check_policy<Policy>();
  conformance::check_params_used<Policy>([](const Policy& made) {
    conformance::Answers answers;
    answers.add(made.in_turn());
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("resource", Policy, trophic_resource_suite) {
  using namespace trophic;
  static_assert(energy::Resource<Policy>);
  conformance::check_policy<Policy>();
  // The fields of a policy after some ticks, with bites in between.
  const auto grown = [](const Policy& policy, test::HandPopulation robots, std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    std::vector<ResourceField> foods = energy::ask::start(policy, robots.arena, rng);
    CHECK(foods.size() == std::max<std::size_t>(energy::food_names<Policy>.size(), 1));
    std::vector<double> numbers;
    for (int tick = 1; tick <= 40; ++tick) {
      energy::ask::grow(policy, foods, robots.at_tick(tick).view(), rng);
      for (std::size_t food = 0; food < foods.size(); ++food) {
        ResourceField& field = foods[food];
        for (std::size_t cell = food; cell < field.cells(); cell += 7) {
          const double bite_J = tick == 1 ? field.food_J(cell) : 0.5 * field.food_J(cell);
          field.food_J(cell) -= bite_J;
          if (bite_J > 0.0) energy::ask::on_bite(policy, foods, food, cell, bite_J, BodyIndex{0}, robots.view());
        }
        for (std::size_t cell = 0; cell < field.cells(); ++cell) {
          REQUIRE(field.food_J(cell) >= 0.0);
          REQUIRE(std::isfinite(field.food_J(cell)));
          if (cell % 5 == 0) numbers.push_back(field.food_J(cell));
          if (tick == 40) numbers.push_back(field.zone_m(cell));
        }
        numbers.push_back(field.total_J());
      }
      energy::ask::on_birth(policy, foods, std::array{BodyIndex{0}}, robots.view(), rng);
    }
    return numbers;
  };
  const auto policy = conformance::defaulted<Policy>();
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
    const auto robots = test::random_population(seed, 5);
    CHECK(grown(policy, robots, seed) == grown(policy, robots, seed));
    CHECK(grown(policy, robots, seed) == grown(policy, conformance::renamed(robots), seed));
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    answers.add(grown(made, test::random_population(1, 5), 1));
    return answers;
  });
}
