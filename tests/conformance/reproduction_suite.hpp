// SPDX-License-Identifier: MIT
// The contract of every rule of reproduction, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_mutation_suite, MyMutation);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/population/mating_zones.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>
#include <trophic/reproduction/traits/contract.hpp>

TEST_CASE_TEMPLATE_DEFINE("initial genome", Policy, trophic_initial_genome_suite) {
  using namespace trophic;
  static_assert(reproduction::InitialGenome<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const Individual newborn;
  for (const std::uint64_t seed : conformance::seeds) {
    const auto weights = conformance::asked_twice(seed, [&, fill = 0.0](Rng& rng) mutable {
      std::vector<double> drawn(20, fill += 7.0);  // what was there before must not matter
      reproduction::ask::draw(policy, drawn, newborn, rng);
      return drawn;
    });
    for (const double weight : weights) CHECK(std::isfinite(weight));
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    std::vector<double> drawn(20);
    Rng rng{1, Stream::user};
    reproduction::ask::draw(made, drawn, newborn, rng);
    conformance::Answers answers;
    answers.add(drawn);
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("genome source", Policy, trophic_genome_source_suite) {
  using namespace trophic;
  static_assert(reproduction::GenomeSource<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  for (const std::uint64_t seed : conformance::seeds) {
    conformance::asked_twice(seed, [&](Rng& rng) { return policy.descent(rng); });
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Rng rng{seed, Stream::user};
      answers.add(made.descent(rng));
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("parent", Policy, trophic_parent_suite) {
  using namespace trophic;
  static_assert(reproduction::Parent<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const std::size_t size = robots.individuals.size();
    for (BodyIndex body = 0; body < size; ++body) {
      const reproduction::Vacancy caught{.body = body, .cause = Cause::caught, .killer = (body + 1) % size};
      const reproduction::Vacancy starved{.body = body, .cause = Cause::starved};
      const conformance::AnyStates<Policy> states{policy, robots, seed};
      for (const auto& vacancy : {caught, starved}) {
        std::optional<Ancestor> parent;
        conformance::asked_twice(seed, [&](Rng& rng) {
          parent = reproduction::ask::parent(policy, states.all(), vacancy, robots.view(), rng);
          return parent ? std::optional{parent->id} : std::nullopt;
        });
        for (const auto& same : {conformance::turned(robots), conformance::mirrored(robots)}) {
          Rng rng{seed, Stream::user};
          const auto there = reproduction::ask::parent(policy, states.all(), vacancy, same.view(), rng);
          CHECK((there ? std::optional{there->id} : std::nullopt) == (parent ? std::optional{parent->id} : std::nullopt));
        }
        // nor does it matter which bodies they all live in
        const auto order = test::random_order(seed, size);
        const auto body_of = [&](BodyIndex before) {
          return static_cast<BodyIndex>(std::ranges::find(order, before) - order.begin());
        };
        const test::HandPopulation moved = robots.reordered(order);
        auto moved_vacancy = vacancy;
        moved_vacancy.body = body_of(body);
        if (vacancy.killer) moved_vacancy.killer = body_of(*vacancy.killer);
        Rng rng{seed, Stream::user};
        const conformance::AnyStates<Policy> moved_states{policy, moved, seed};
        const auto there = reproduction::ask::parent(policy, moved_states.all(), moved_vacancy, moved.view(), rng);
        CHECK((there ? std::optional{there->id} : std::nullopt) == (parent ? std::optional{parent->id} : std::nullopt));
        if (!parent) continue;
        CHECK(parent->species < robots.web.size());
        CHECK(parent->genome != nullptr);
      }
    }
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
          const conformance::AnyStates<Policy> states{made, robots, seed};
          Rng rng{seed, Stream::user, body};
          const reproduction::Vacancy starved{.body = body, .cause = Cause::starved};
          answers.add(reproduction::ask::parent(made, states.all(), starved, robots.view(), rng));
        }
      });
}

/// For rules for causes after which the body's next species is fixed: caught, sacrificed, senescence.
TEST_CASE_TEMPLATE_DEFINE("parent of a given species", Policy, trophic_parent_species_suite) {
  using namespace trophic;
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const std::size_t size = robots.individuals.size();
    for (BodyIndex body = 0; body < size; ++body) {
      const BodyIndex killer = (body + 1) % size;
      const Species killers = robots.individuals[killer].species;
      const reproduction::Vacancy caught{.body = body, .cause = Cause::caught, .killer = killer, .successor = killers};
      const reproduction::Vacancy sacrificed{.body = body, .cause = Cause::sacrificed, .successor = killers};
      const reproduction::Vacancy aged{.body = body, .cause = Cause::senescence, .successor = robots.individuals[body].species};
      const conformance::AnyStates<Policy> states{policy, robots, seed};
      for (const auto& vacancy : {caught, sacrificed, aged}) {
        Rng rng{seed, Stream::user};
        const auto parent = reproduction::ask::parent(policy, states.all(), vacancy, robots.view(), rng);
        if (parent) CHECK(parent->species == *vacancy.successor);
      }
    }
  });
}

namespace trophic::conformance {

/// The same robots with a sex and a sight.
[[nodiscard]] inline test::HandPopulation with_traits(test::HandPopulation robots) {
  robots.traits = {"sex", "sight_m"};
  for (const Individual& one : robots.individuals)
    one.genome->traits = {static_cast<double>(one.id % 2), 8.0 + 0.3 * static_cast<double>(one.id % 7)};
  return robots;
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("recruitment", Policy, trophic_recruitment_suite) {
  using namespace trophic;
  static_assert(reproduction::Recruitment<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  ResourceField field{Arena{}, 3};  // with a zone in the middle of the world
  field.set_zone(4, 5.0);
  // Places turn with the world.
  const auto births_of = [&](const test::HandPopulation& robots, const AllStates<Policy>& states, std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    View view = robots.view();
    view.foods = {&field, 1};
    auto births = reproduction::ask::recruits(policy, states, view, rng);
    for (auto& birth : births) birth.place.reset();
    return births;
  };
  conformance::on_populations([&](const test::HandPopulation& bare, std::uint64_t seed) {
    test::HandPopulation robots = conformance::with_traits(bare);
    const std::size_t size = robots.individuals.size();
    for (BodyIndex body = 0; body < size; body += 3) {
      robots.individuals[body].species = no_species;
      robots.individuals[body].active = false;
    }
    const conformance::AnyStates<Policy> states{policy, robots, seed};
    const auto births = births_of(robots, states.all(), seed);
    CHECK(births == births_of(robots, states.all(), seed));
    CHECK(births == births_of(conformance::turned(robots), states.all(), seed));
    CHECK(births == births_of(conformance::mirrored(robots), states.all(), seed));
    for (const auto& birth : births) {
      CHECK(birth.species < robots.web.size());
      for (const Ancestor& parent : birth.parents) CHECK(parent.species == birth.species);
      for (const Ancestor& parent : birth.parents) CHECK(parent.genome != nullptr);
    }
    for (BodyIndex body = 0; body < size; ++body) {
      if (!robots.individuals[body].lives()) continue;
      for (const Cause cause : {Cause::caught, Cause::starved, Cause::sacrificed, Cause::senescence}) {
        const Vacancy death{.body = body, .cause = cause};
        CHECK(policy.leaves_spare(death, robots.view()) == policy.leaves_spare(death, conformance::turned(robots).view()));
      }
    }
    // nor does it matter which bodies they all live in
    const auto order = test::random_order(seed, size);
    const test::HandPopulation moved = robots.reordered(order);
    const conformance::AnyStates<Policy> moved_states{policy, moved, seed};
    CHECK(births == births_of(moved, moved_states.all(), seed));
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& whole, std::uint64_t seed) {
        test::HandPopulation robots = conformance::with_traits(whole);
        for (BodyIndex body = 0; body < robots.individuals.size(); body += 3) robots.individuals[body].species = no_species;
        const conformance::AnyStates<Policy> states{made, robots, seed};
        Rng rng{seed, Stream::user};
        View view = robots.view();
        view.foods = {&field, 1};
        answers.add(made.spare_bodies());
        for (const auto& birth : reproduction::ask::recruits(made, states.all(), view, rng)) {
          answers.add(std::pair{birth.parents.empty() ? 0 : birth.parents.front().id, birth.endowment_J});
          answers.add(birth.first_pays);
          answers.add(birth.place.value_or(GroundPose{}).x_m);
        }
        for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
          answers.add(made.leaves_spare({.body = body, .cause = Cause::starved}, robots.view()));
        }
      });
}

TEST_CASE_TEMPLATE_DEFINE("heredity", Policy, trophic_heredity_suite) {
  using namespace trophic;
  static_assert(reproduction::Heredity<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const std::vector<double> weights{0.5, -1.0, 0.0};
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = weights});
  const auto other = std::make_shared<Genome>(Genome{.id = 4, .weights = {0.0, 1.0, 2.0}});
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = parent}, {.id = 2, .species = 0, .genome = other}};
  Rng rng{1, Stream::user};
  const std::shared_ptr<Genome> offspring = reproduction::ask::inherit(policy, std::span{parents}, rng, {.neurons = {0, 0, 1}});
  // a part that is left empty is drawn anew
  if (offspring != nullptr && !offspring->weights.empty()) CHECK(offspring->weights.size() == weights.size());
  CHECK(parent->weights == weights);
  CHECK(other->weights == std::vector<double>{0.0, 1.0, 2.0});
}

TEST_CASE_TEMPLATE_DEFINE("mutation", Policy, trophic_mutation_suite) {
  using namespace trophic;
  static_assert(reproduction::Mutation<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const Individual offspring = test::HandPopulation{{{}}}.individuals[0];
  for (const std::uint64_t seed : conformance::seeds) {
    const auto weights = conformance::asked_twice(seed, [&](Rng& rng) {
      std::vector<double> mutated{0.0, 0.5, -0.5, 1.0, -1.0, 0.25};
      auto own = conformance::own_state(policy, offspring, seed);
      reproduction::ask::mutate(policy, own, std::span{mutated}, offspring, rng);
      return mutated;
    });
    for (const double weight : weights) CHECK(std::isfinite(weight));
    Rng rng{seed, Stream::user};
    auto own = conformance::own_state(policy, offspring, seed);
    reproduction::ask::mutate(policy, own, std::span<double>{}, offspring, rng);
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      std::vector<double> mutated(20, 0.5);
      auto own = conformance::own_state(made, offspring, seed);
      Rng rng{seed, Stream::user};
      reproduction::ask::mutate(made, own, std::span{mutated}, offspring, rng);
      answers.add(mutated);
      answers.add(own);
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("traits", Policy, trophic_traits_suite) {
  using namespace trophic;
  static_assert(reproduction::TraitRule<Policy>);
  conformance::check_policy<Policy>();
  const auto generations = [](const Policy& policy, Rng& rng) {
    std::vector<double> all;
    std::vector<double> traits = policy.draw(rng);
    for (int birth = 0; birth < 50; ++birth) {
      CHECK(traits.size() == std::size(Policy::trait_names));
      all.insert(all.end(), traits.begin(), traits.end());
      policy.mutate(std::span{traits}, rng);
    }
    return all;
  };
  for (const std::uint64_t seed : conformance::seeds) {
    const auto all = conformance::asked_twice(seed, [&](Rng& rng) { return generations(conformance::defaulted<Policy>(), rng); });
    for (const double trait : all) CHECK(std::isfinite(trait));
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    Rng rng{1, Stream::user};
    answers.add(generations(made, rng));
    return answers;
  });
}
