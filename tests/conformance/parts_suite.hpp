// SPDX-License-Identifier: MIT
// The contract of every gait, body plan, viability and embodiment, as one doctest case for each:
// TEST_CASE_TEMPLATE_INVOKE(trophic_gait_suite, MyGait);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/control/gait/contract.hpp>
#include <trophic/initialization/embodiment/contract.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>
#include <trophic/reproduction/viability/contract.hpp>

namespace trophic::conformance {

/// A core with `legs` chains of two hinges.
[[nodiscard]] inline body::Design legged(std::size_t legs) {
  body::Design design;
  design.name = std::to_string(legs) + "_legs";
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const auto inner = design.modules.attach(0, body::all_faces.at(leg), body::ModuleType::hinge);
    design.modules.attach(inner, body::Face::front, body::ModuleType::hinge, 1);
  }
  return design;
}

/// A gait of unequal weights for a robot.
[[nodiscard]] inline Gait any_gait(const RobotModel& robot) {
  const auto n = static_cast<Eigen::Index>(robot.hinges.size());
  Gait gait{.name = robot.name, .robot = robot.name, .provenance = "a test", .hinges = {}, .internal = {}, .coupling = {}};
  for (const Hinge& hinge : robot.hinges) gait.hinges.push_back(hinge.name);
  gait.internal = Eigen::VectorXd::LinSpaced(n, -0.9, 0.8);
  gait.coupling = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const std::size_t other : robot.hinge_neighbours[static_cast<std::size_t>(i)]) {
      const auto j = static_cast<Eigen::Index>(other);
      gait.coupling(i, j) = i < j ? 0.3 : -0.3;
    }
  }
  return gait;
}

/// A robot with `legs` legs and its gait; rules find it also under its name.
[[nodiscard]] inline Habitat habitat_of(std::size_t legs) {
  Habitat habitat{.robot = body::build(legged(legs)), .arena = {}, .gait = {}};
  habitat.gait = any_gait(habitat.robot);
  habitat.design = legged(legs);
  return habitat;
}

/// A nursery in which robots walk the sum of their gaits' numbers in a second, and diverge after 50 s.
struct SummingNursery final : Nursery {
  [[nodiscard]] std::optional<double> walked_m(const RobotModel&, const Gait& gait, double duration_s) const override {
    if (duration_s > 50.0) return std::nullopt;
    return (gait.internal.sum() + gait.coupling.triangularView<Eigen::Upper>().toDenseMatrix().sum()) * duration_s;
  }
};

/// The common part of InheritedGait and InheritedBody: equal draws give equal genes, at least one, and finite ones.
template <class Draw, class Mutate>
std::vector<double> check_genes(std::uint64_t seed, std::size_t generations, Draw&& draw, Mutate&& mutate) {
  const auto lineage = [&] {
    std::vector<double> genes = asked_twice(seed, draw);
    CHECK_FALSE(genes.empty());
    for (std::size_t generation = 0; generation < generations; ++generation) {
      Rng rng{seed, Stream::user, 1, generation};
      mutate(genes, rng);
      for (const double gene : genes) CHECK(std::isfinite(gene));
    }
    return genes;
  };
  const std::vector<double> genes = lineage();
  CHECK(genes == lineage());
  return genes;
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("gait", Policy, trophic_gait_suite) {
  using namespace trophic;
  static_assert(control::GaitRule<Policy>);
  conformance::check_policy<Policy>();
  const Individual offspring = test::HandPopulation{{{}}}.individuals[0];
  const auto express = [&](const Policy& policy, std::size_t legs, std::uint64_t seed) {
    const Habitat habitat = conformance::habitat_of(legs);
    std::vector<double> genes;
    if constexpr (control::InheritedGait<Policy>) {
      genes = conformance::check_genes(
          seed, 30, [&](Rng& rng) { return policy.draw(habitat.robot, habitat, rng); },
          [&](std::vector<double>& own, Rng& rng) {
            policy.mutate(own, offspring, rng);
            if constexpr (control::LearntGait<Policy>) {
              policy.learn(own, habitat.robot, habitat, offspring, conformance::SummingNursery{}, rng);
            }
          });
      std::vector<double> foreign(genes.size() + 1, 0.5);
      CHECK_THROWS_AS(static_cast<void>(policy.express(foreign, habitat.robot, habitat)), std::invalid_argument);
    }
    const Gait gait = policy.express(genes, habitat.robot, habitat);
    CHECK_NOTHROW(check_fit(gait, habitat.robot));
    CHECK((policy.express(genes, habitat.robot, habitat) == gait));
    return gait;
  };
  for (const std::uint64_t seed : conformance::seeds) {
    for (const std::size_t legs : {1U, 2U, 4U}) express(conformance::defaulted<Policy>(), legs, seed);
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      const Gait gait = express(made, 2, seed);
      for (const double weight : gait.internal) answers.add(weight);
      for (const double weight : gait.coupling.reshaped()) answers.add(weight);
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("body plan", Policy, trophic_body_plan_suite) {
  using namespace trophic;
  static_assert(reproduction::BodyPlan<Policy>);
  conformance::check_policy<Policy>();
  const Individual offspring = test::HandPopulation{{{}}}.individuals[0];
  const Habitat habitat = conformance::habitat_of(4);
  const auto numbers_of = [&](const Policy& policy, std::uint64_t seed) {
    std::vector<double> genes;
    if constexpr (reproduction::InheritedBody<Policy>) {
      genes = conformance::check_genes(
          seed, 20, [&](Rng& rng) { return policy.draw(0, habitat, rng); },
          [&](std::vector<double>& own, Rng& rng) { policy.mutate(own, offspring, habitat, rng); });
      const std::vector<double> foreign{-0.5, 1e9};
      CHECK_THROWS_AS(static_cast<void>(policy.grow(foreign, 0, habitat)), std::invalid_argument);
    }
    std::string text;
    try {
      const RobotModel robot = body::build(policy.grow(genes, 0, habitat));
      text = numbers_text(robot);
      CHECK(numbers_text(body::build(policy.grow(genes, 0, habitat))) == text);
    } catch (const std::invalid_argument&) {  // a body that cannot be built is refused by every table
      text = "none";
    }
    return text;
  };
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      for (const char letter : numbers_of(made, seed)) answers.add(letter);
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("viability", Policy, trophic_viability_suite) {
  using namespace trophic;
  static_assert(reproduction::Viability<Policy>);
  conformance::check_policy<Policy>();
  conformance::check_params_used<Policy>([](const Policy& made) {
    conformance::Answers answers;
    CHECK(made.attempts() >= 1);
    answers.add(made.attempts());
    for (const std::size_t legs : {0U, 1U, 2U, 3U, 4U}) {
      const body::Design design = conformance::legged(legs);
      const RobotModel robot = body::build(design);
      const std::optional<std::string> refusal = made.refusal(design, robot);
      CHECK(made.refusal(design, robot) == refusal);
      if (refusal) CHECK_FALSE(refusal->empty());
      answers.add(refusal.has_value());
      if constexpr (reproduction::TriesNewborns<Policy>) {
        const auto tried = made.refusal_after_trial(robot, conformance::any_gait(robot), conformance::SummingNursery{});
        if (tried) CHECK_FALSE(tried->empty());
        answers.add(tried.has_value());
      }
    }
    return answers;
  });
}
