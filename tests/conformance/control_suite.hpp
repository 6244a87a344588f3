// SPDX-License-Identifier: MIT
// The contract of every brain and every steering, as one doctest case for each:
// TEST_CASE_TEMPLATE_INVOKE(trophic_brain_suite, MyBrain);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/control/brain/contract.hpp>
#include <trophic/control/pace/contract.hpp>
#include <trophic/control/steering/contract.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic::conformance {

/// Random genes of a brain; those of one that grows after some births.
template <class Policy>
[[nodiscard]] std::vector<double> brain_genes(const Policy& policy, std::size_t inputs, Rng& rng) {
  constexpr std::size_t outputs = control::acts::TurnAndTag::outputs;
  std::vector<double> genes;
  if constexpr (control::GrowingBrain<Policy>) {
    genes = policy.first(inputs, outputs, rng);
    for (int birth = 0; birth < 30; ++birth) {
      CHECK(policy.fits(genes, inputs, outputs));
      for (double& weight : policy.weights_of(genes)) weight = rng.uniform(-3.0, 3.0);
      policy.mutate_structure(genes, inputs, outputs, rng);
    }
    for (int birth = 0; birth < 20; ++birth) policy.mutate_structure(genes, inputs, outputs, rng);
    CHECK(policy.fits(genes, inputs, outputs));
    CHECK_FALSE(policy.fits({}, inputs, outputs));
  } else {
    genes.resize(policy.genome_size(inputs, outputs));
    for (double& weight : genes) weight = rng.uniform(-3.0, 3.0);
  }
  return genes;
}

/// Asked about several individuals at once, a brain sets what it sets for each.
template <control::EvaluatesAll Policy>
void check_evaluates_all(const Policy& policy, std::size_t inputs, Rng& rng) {
  constexpr std::size_t individuals = 3;
  constexpr std::size_t outputs = control::acts::TurnAndTag::outputs;
  std::vector<std::vector<double>> genes;
  for (std::size_t i = 0; i < individuals; ++i) genes.push_back(brain_genes(policy, inputs, rng));
  const std::vector<std::span<const double>> genomes{genes.begin(), genes.end()};
  std::vector<double> all(individuals * inputs);
  for (double& input : all) input = rng.uniform(-1.0, 1.0);
  std::vector<double> together(individuals * outputs);
  policy.evaluate_all(all, genomes, together);
  std::vector<double> apart(individuals * outputs);
  for (std::size_t i = 0; i < individuals; ++i)
    policy.evaluate(std::span{all}.subspan(i * inputs, inputs), genomes[i], std::span{apart}.subspan(i * outputs, outputs));
  CHECK(together == apart);
  CHECK_NOTHROW(policy.evaluate_all({}, {}, {}));
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("brain", Policy, trophic_brain_suite) {
  using namespace trophic;
  static_assert(control::Brain<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  CHECK_NOTHROW(check_tags(policy.tags()));
  constexpr std::size_t free_inputs = 4;
  constexpr std::size_t given = control::detail::inputs_taken<Policy, free_inputs>;
  const auto born_with = [&](std::uint64_t seed) {
    return conformance::own_state(policy, test::HandPopulation{{{}}}.individuals[0], seed);
  };
  for (const std::uint64_t seed : conformance::seeds) {
    Rng rng{seed, Stream::user};
    const std::vector<double> weights = conformance::brain_genes(policy, given, rng);
    std::vector<double> inputs(given);
    for (double& input : inputs) input = rng.uniform(-1.0, 1.0);
    const std::vector<double> genome = weights;
    auto own = born_with(seed);
    const control::Decision decision = control::ask::decide(policy, own, std::span{inputs}, std::span{genome});
    CHECK(genome == weights);
    CHECK(std::ranges::count(policy.tags(), decision.tag) == 1);
    CHECK(std::abs(decision.target_angle_rad) <= std::numbers::pi);
    auto same = born_with(seed);
    CHECK((control::ask::decide(policy, same, std::span{inputs}, std::span{genome}) == decision));
    if constexpr (Stateful<Policy>) CHECK(first_difference(own, same) == "");
    if constexpr (control::EvaluatesAll<Policy>) conformance::check_evaluates_all(policy, given, rng);
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      Rng rng{seed, Stream::user};
      const std::vector<double> genome = conformance::brain_genes(made, given, rng);
      auto own = born_with(seed);
      for (int tick = 0; tick < 20; ++tick) {
        std::vector<double> inputs(given);
        for (double& input : inputs) input = rng.uniform(-1.0, 1.0);
        const control::Decision decision = control::ask::decide(made, own, std::span{inputs}, std::span{genome});
        answers.add(decision.target_angle_rad);
        answers.add(decision.tag);
      }
      answers.add(own);
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("act", One, trophic_act_suite) {
  using namespace trophic;
  static_assert(control::Act<One>);
  CHECK_FALSE(std::string_view{One::name}.empty());
  Rng rng{1, Stream::user};
  for (const double most : {0.0, 1.0, 1e9}) {
    for (int i = 0; i < 100; ++i) {
      std::array<double, One::outputs> out{};
      for (double& neuron : out) neuron = rng.uniform(-most, most);
      const auto value = One::value(out);
      CHECK(static_cast<double>(value) >= One::least);
      CHECK(static_cast<double>(value) <= One::most);
      CHECK(One::value(out) == value);
    }
  }
}

TEST_CASE_TEMPLATE_DEFINE("pace", Policy, trophic_pace_suite) {
  using namespace trophic;
  static_assert(control::Pace<Policy>);
  conformance::check_policy<Policy>();
  const auto all_of = [](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t) {
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) answers.add(made.pace(body, robots.view()));
  };
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations<Policy>([&](const test::HandPopulation& robots, std::uint64_t seed) {
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      CHECK(policy.pace(body, robots.view()) >= 0.0);
      CHECK(std::isfinite(policy.pace(body, robots.view())));
    }
    conformance::check_each_robot(robots, seed,
                                  [&](const test::HandPopulation& any, BodyIndex body) { return policy.pace(body, any.view()); });
  });
  conformance::check_params_used_on_populations<Policy>(all_of);
}

TEST_CASE_TEMPLATE_DEFINE("steering", Policy, trophic_steering_suite) {
  using namespace trophic;
  static_assert(control::Steering<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const std::vector<HingePlace> hinges{{Side::left, 1.0, 1.0},
                                       {Side::middle, -1.0, -1.0},
                                       {Side::right, 0.0, 0.0},
                                       {Side::left, -2.0, 0.7},
                                       {Side::right, 2.0, -0.7}};
  const std::vector<double> targets_rad{0.5, -0.25, 0.75, 0.0, -1.0};
  for (const double target_angle_rad : {-std::numbers::pi, -0.7, 0.0, 0.7, std::numbers::pi}) {
    std::vector<double> steered = targets_rad;
    policy.steer(target_angle_rad, hinges, steered);
    for (const double target_rad : steered) CHECK(std::isfinite(target_rad));
    // the mirror image of a robot turns to the other side in the same way
    std::vector<HingePlace> mirror = hinges;
    for (HingePlace& hinge : mirror) {
      if (hinge.side != Side::middle) hinge.side = hinge.side == Side::left ? Side::right : Side::left;
      hinge.upright = -hinge.upright;
    }
    std::vector<double> mirrored = targets_rad;
    policy.steer(-target_angle_rad, mirror, mirrored);
    CHECK(mirrored == steered);
    // the order of the hinges does not matter
    std::vector<double> backwards{targets_rad.rbegin(), targets_rad.rend()};
    policy.steer(target_angle_rad, std::vector<HingePlace>{hinges.rbegin(), hinges.rend()}, backwards);
    CHECK(std::vector<double>{backwards.rbegin(), backwards.rend()} == steered);
  }
  policy.steer(0.7, {}, {});
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const double target_angle_rad : {-2.0, -0.7, 0.3, 0.7}) {
      std::vector<double> steered = targets_rad;
      made.steer(target_angle_rad, hinges, steered);
      answers.add(steered);
    }
    return answers;
  });
}
