// SPDX-License-Identifier: MIT
// What every rule of perception must do, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_visibility_suite, MyVisibility);
#pragma once

#include <Eigen/Geometry>
#include <conformance/policy_suite.hpp>
#include <numbers>
#include <optional>
#include <trophic/perception/blind_rule/contract.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/perception/newborn_tag/contract.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/perception/tag_switch/contract.hpp>
#include <trophic/perception/visibility/contract.hpp>

TEST_CASE_TEMPLATE_DEFINE("heading", Policy, trophic_heading_suite) {
  using namespace trophic;
  static_assert(perception::Heading<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  for (const std::uint64_t seed : conformance::seeds) {
    Rng rng{seed, Stream::user};
    const double forward_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const double turn_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const Eigen::Quaterniond any{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0)};
    const Eigen::Quaterniond about_z{Eigen::AngleAxisd{turn_rad, Eigen::Vector3d::UnitZ()}};
    const auto heading_rad = [&](const Eigen::Quaterniond& orientation) {
      return policy.heading_rad({.position_m = {1.0, -2.0, 0.1}, .orientation = orientation}, forward_rad);
    };
    // upright it is where the forward axis points; turning the world turns it
    CHECK(wrap_angle(heading_rad(about_z) - turn_rad - forward_rad) == doctest::Approx(0.0).epsilon(1e-9));
    const double before_rad = heading_rad(any.normalized());
    CHECK(std::abs(before_rad) <= std::numbers::pi);
    CHECK(wrap_angle(heading_rad(about_z * any.normalized()) - before_rad - turn_rad) == doctest::Approx(0.0).epsilon(1e-9));
  }
}

TEST_CASE_TEMPLATE_DEFINE("visibility", Policy, trophic_visibility_suite) {
  using namespace trophic;
  static_assert(perception::Visibility<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t) {
    const test::HandPopulation same = conformance::renamed(robots);
    for (BodyIndex self = 0; self < robots.individuals.size(); ++self) {
      for (BodyIndex other = 0; other < robots.individuals.size(); ++other) {
        CHECK(policy.perceives(same.individuals[self], same.individuals[other]) ==
              policy.perceives(robots.individuals[self], robots.individuals[other]));
      }
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("input that describes the adversary", Policy, trophic_sighting_input_suite) {
  using namespace trophic;
  static_assert(perception::SightingInput<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    for (BodyIndex self = 0; self < robots.individuals.size(); ++self) {
      const perception::Sighting sighting{.self = self,
                                          .adversary = rng.index(robots.individuals.size()),
                                          .distance_m = rng.uniform(0.0, 30.0),
                                          .bearing_rad = rng.uniform(-std::numbers::pi, std::numbers::pi)};
      const double input = policy.input(sighting, robots.view());
      CHECK(std::abs(input) <= 1.0);
      CHECK(policy.input(sighting, conformance::turned(robots).view()) == input);
      CHECK(policy.input(sighting, conformance::renamed(robots).view()) == input);
    }
  });
}

TEST_CASE_TEMPLATE_DEFINE("input that describes the population", Policy, trophic_population_input_suite) {
  using namespace trophic;
  static_assert(perception::PopulationInput<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    if (robots.individuals.empty()) return;
    CHECK(std::abs(policy.input(robots.view())) <= 1.0);
    conformance::check_all_robots(robots, seed, [&](const test::HandPopulation& any) { return policy.input(any.view()); });
  });
}

TEST_CASE_TEMPLATE_DEFINE("rule for who sees nobody", Policy, trophic_blind_rule_suite) {
  using namespace trophic;
  static_assert(perception::BlindRule<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  for (const double tag_ratio : {-0.5, -0.1, 0.0, 0.3, 0.5}) {
    const auto inputs = policy.inputs(tag_ratio);
    CHECK((inputs == policy.inputs(tag_ratio)));
    if (!inputs) continue;
    CHECK(std::abs(inputs->angle) <= 1.0);
    CHECK(std::abs(inputs->distance) <= 1.0);
    CHECK(std::abs(inputs->tag_ratio) <= 1.0);
  }
}

TEST_CASE_TEMPLATE_DEFINE("tag of a newborn", Policy, trophic_newborn_tag_suite) {
  using namespace trophic;
  static_assert(perception::NewbornTag<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  for (const std::optional<int> body_tag : {std::optional<int>{}, std::optional{1}, std::optional{-1}}) {
    for (const std::uint64_t seed : conformance::seeds) {
      const int tag = conformance::asked_twice(seed, [&](Rng& rng) { return policy.tag(body_tag, rng); });
      CHECK((tag == 1 || tag == -1));
    }
  }
}

TEST_CASE_TEMPLATE_DEFINE("tag switch", Policy, trophic_tag_switch_suite) {
  using namespace trophic;
  static_assert(perception::TagSwitch<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      return policy.may_switch(any.individuals[body], any.view());
    });
  });
  CHECK(policy.restarts(true));  // or a switched tag could be switched again at once
}
