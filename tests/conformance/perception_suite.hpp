// SPDX-License-Identifier: MIT
// The contract of every rule of perception, as one doctest case for each kind:
// TEST_CASE_TEMPLATE_INVOKE(trophic_visibility_suite, MyVisibility);
#pragma once

#include <Eigen/Geometry>
#include <conformance/policy_suite.hpp>
#include <trophic/control/acts/signal.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/perception/newborn_tag/contract.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/perception/tag_switch/contract.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/population/mating_zones.hpp>

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
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      Rng rng{seed, Stream::user};
      const Eigen::Quaterniond any{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0)};
      answers.add(made.heading_rad({.position_m = {1.0, -2.0, 0.1}, .orientation = any.normalized()}, 0.3));
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("visibility", Policy, trophic_visibility_suite) {
  using namespace trophic;
  static_assert(perception::Visibility<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    const std::size_t size = robots.individuals.size();
    const auto order = test::random_order(seed, size);
    const test::HandPopulation moved = robots.reordered(order);
    const auto ask = [&](const test::HandPopulation& any, BodyIndex self, BodyIndex other, Rng& rng) {
      const auto own = conformance::own_state(policy, any.individuals[self], seed);
      return perception::ask::perceives(policy, own, self, other, any.view(), rng);
    };
    for (BodyIndex self = 0; self < size; ++self) {
      for (BodyIndex other = 0; other < size; other += 3) {
        const auto says = [&](const test::HandPopulation& any, BodyIndex one, BodyIndex two) {
          Rng rng{seed, Stream::user};
          return ask(any, one, two, rng);
        };
        const bool seen = conformance::asked_twice(seed, [&](Rng& rng) { return ask(robots, order[self], order[other], rng); });
        CHECK(says(moved, self, other) == seen);
        conformance::on_same_worlds(
            robots, [&](const test::HandPopulation& same) { CHECK(says(same, order[self], order[other]) == seen); });
        if (!seen) continue;
        // what it says in advance is true
        const perception::Horizon horizon = perception::ask::horizon(policy, robots.individuals[order[self]]);
        const Individual& one = robots.individuals[order[other]];
        CHECK(robots.view().distance_m(order[self], order[other]) <= horizon.within_m);
        CHECK(horizon.tag.value_or(one.tag) == one.tag);
        CHECK((one.active || !horizon.only_active));
      }
    }
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (BodyIndex self = 0; self < robots.individuals.size(); ++self) {
          const auto own = conformance::own_state(made, robots.individuals[self], seed);
          for (BodyIndex other = 0; other < robots.individuals.size(); ++other) {
            Rng rng{seed, Stream::user, self, other};
            answers.add(perception::ask::perceives(made, own, self, other, robots.view(), rng));
          }
        }
      });
}

namespace trophic::conformance {

/// Calls `ask(view)` with these robots in a world with food and zones, the same after a quarter turn and in a mirror, and with
/// calls.
template <class Ask>
auto in_world(const test::HandPopulation& robots, const Ask& ask) {
  ResourceField field{robots.arena, 20};
  for (std::size_t cell = 0; cell < field.cells(); ++cell) {
    const double x_m = std::abs(field.centre(cell).x_m);
    const double y_m = std::abs(field.centre(cell).y_m);
    field.food_J(cell) = std::fmod(7.3 * std::max(x_m, y_m) + 1.7 * std::min(x_m, y_m), 3.0);
    field.set_zone(cell, x_m == 4.5 && y_m == 4.5 ? 2.0 : 0.0);
  }
  const char* const call = &trophic::detail::act_key<control::acts::Signal<0>>;
  std::vector<double> calls;
  for (const Individual& one : robots.individuals) calls.push_back(one.tag > 0 ? 0.8 : 0.3);
  View view = robots.view();
  view.robot_radius_m = 0.3;
  view.foods = {&field, 1};
  view.acts = {.acts = {&call, 1}, .values = calls};
  return ask(view);
}

/// Whether values are the same but for rounding.
template <class Values>
[[nodiscard]] bool are_close(const Values& a, const Values& b) {
  return std::ranges::equal(a, b, [](double one, double other) { return std::abs(one - other) < 1e-9; });
}

/// Absolute values in ascending order: in a mirror left and right change places, and nothing else does.
template <class Values>
[[nodiscard]] Values without_sides(Values values) {
  for (double& value : values) value = std::abs(value);
  std::ranges::sort(values);
  return values;
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("sensor", Policy, trophic_sensor_suite) {
  using namespace trophic;
  static_assert(perception::Sensor<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const auto check_range = [](const auto& values) {
    for (const double value : values) CHECK(std::abs(value) <= 1.0);
    if constexpr (requires { Policy::least <= Policy::most; }) {
      for (const double value : values) CHECK((value >= Policy::least && value <= Policy::most));
    }
  };
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    if (robots.individuals.empty()) return;
    if constexpr (perception::CommonSensor<Policy>) {
      check_range(policy.sense(robots.view()));
      conformance::check_all_robots(robots, seed, [&](const test::HandPopulation& any) { return policy.sense(any.view()); });
    } else {
      Rng drawn{seed, Stream::user};
      for (BodyIndex self = 0; self < robots.individuals.size(); ++self) {
        const Sighting seen{.self = self,
                            .adversary = drawn.index(robots.individuals.size()),
                            .distance_m = drawn.uniform(0.0, 30.0),
                            .bearing_rad = drawn.uniform(-std::numbers::pi, std::numbers::pi)};
        for (const auto& sighting : {std::optional<Sighting>{}, std::optional{seen}}) {
          const auto own = conformance::own_state(policy, robots.individuals[self], seed);
          const auto ask = [&](const test::HandPopulation& any, Rng& rng) {
            return conformance::in_world(
                any, [&](const View& view) { return perception::ask::sense(policy, own, self, sighting, view, rng); });
          };
          const auto values = conformance::asked_twice(seed, [&](Rng& rng) { return ask(robots, rng); });
          check_range(values);
          for (const auto& same : {conformance::turned(robots), conformance::renamed(robots)}) {
            Rng rng{seed, Stream::user};
            CHECK(conformance::are_close(ask(same, rng), values));
          }
          auto seen_in_mirror = sighting;
          if (seen_in_mirror) seen_in_mirror->bearing_rad = -seen_in_mirror->bearing_rad;
          Rng rng{seed, Stream::user};
          const test::HandPopulation mirror = conformance::mirrored(robots);
          const auto there = conformance::in_world(
              mirror, [&](const View& view) { return perception::ask::sense(policy, own, self, seen_in_mirror, view, rng); });
          CHECK(conformance::are_close(conformance::without_sides(there), conformance::without_sides(values)));
          // nor does it matter which bodies the two live in
          const auto order = test::random_order(seed, robots.individuals.size());
          const test::HandPopulation moved = robots.reordered(order);
          const auto body_of = [&](BodyIndex before) {
            return static_cast<BodyIndex>(std::ranges::find(order, before) - order.begin());
          };
          auto seen_by_moved = sighting;
          if (seen_by_moved) seen_by_moved->self = body_of(self), seen_by_moved->adversary = body_of(sighting->adversary);
          Rng again{seed, Stream::user};
          const auto elsewhere = conformance::in_world(moved, [&](const View& view) {
            return perception::ask::sense(policy, own, body_of(self), seen_by_moved, view, again);
          });
          CHECK((elsewhere == values));
        }
      }
    }
  });
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
      if (robots.individuals.empty()) return;
      if constexpr (perception::CommonSensor<Policy>) {
        answers.add(made.sense(robots.view()));
      } else {
        Rng drawn{seed, Stream::user};
        for (BodyIndex self = 0; self < robots.individuals.size(); ++self) {
          const Sighting seen{.self = self, .adversary = 0, .distance_m = drawn.uniform(0.0, 30.0), .bearing_rad = 0.5};
          const auto own = conformance::own_state(made, robots.individuals[self], seed);
          answers.add(conformance::in_world(
              robots, [&](const View& view) { return perception::ask::sense(made, own, self, seen, view, drawn); }));
        }
      }
    });
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("tag of a newborn", Policy, trophic_newborn_tag_suite) {
  using namespace trophic;
  static_assert(perception::NewbornTag<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  for (const std::vector<int>& tags : {std::vector{-1, 1}, std::vector{1, 2, 3}}) {
    for (const std::optional<int> body_tag : {std::optional<int>{}, std::optional{tags[0]}, std::optional{tags[1]}}) {
      for (const std::uint64_t seed : conformance::seeds) {
        const int tag = conformance::asked_twice(seed, [&](Rng& rng) { return policy.tag(body_tag, tags, rng); });
        CHECK(std::ranges::count(tags, tag) == 1);
      }
    }
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    const std::vector<int> tags{-1, 1};
    for (const std::optional<int> body_tag : {std::optional<int>{}, std::optional{-1}, std::optional{1}}) {
      for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Rng rng{seed, Stream::user};
        answers.add(made.tag(body_tag, tags, rng));
      }
    }
    return answers;
  });
}

TEST_CASE_TEMPLATE_DEFINE("tag switch", Policy, trophic_tag_switch_suite) {
  using namespace trophic;
  static_assert(perception::TagSwitch<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  conformance::on_populations([&](const test::HandPopulation& robots, std::uint64_t seed) {
    conformance::check_each_robot(robots, seed, [&](const test::HandPopulation& any, BodyIndex body) {
      const auto own = conformance::own_state(policy, any.individuals[body], seed);
      return perception::ask::may_switch(policy, own, any.individuals[body], any.view());
    });
  });
  conformance::check_params_used_on_populations<Policy>(
      [&](conformance::Answers& answers, const Policy& made, const test::HandPopulation& robots, std::uint64_t seed) {
        for (std::int64_t later = 0; later < 60; later += 7) {
          test::HandPopulation then = robots;
          then.at_tick(robots.tick + later);
          for (const Individual& individual : then.individuals) {
            const auto own = conformance::own_state(made, individual, seed);
            answers.add(perception::ask::may_switch(made, own, individual, then.view()));
          }
        }
      });
}
