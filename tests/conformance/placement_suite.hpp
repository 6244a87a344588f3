// SPDX-License-Identifier: MIT
// The contract of every placement, as one doctest case: TEST_CASE_TEMPLATE_INVOKE(trophic_placement_suite, MyPlacement);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/initialization/placement/contract.hpp>

TEST_CASE_TEMPLATE_DEFINE("placement", Policy, trophic_placement_suite) {
  using namespace trophic;
  static_assert(initialization::Placement<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const Arena arena{};
  for (const std::size_t robots : {std::size_t{1}, std::size_t{30}}) {
    for (const std::uint64_t seed : conformance::seeds) {
      const auto placed = conformance::asked_twice(seed, [&](Rng& rng) {
        std::vector<double> numbers;
        for (const GroundPose& pose : policy.place(robots, arena, 0.2, rng)) {
          numbers.insert(numbers.end(), {pose.x_m, pose.y_m, pose.heading_rad});
        }
        return numbers;
      });
      REQUIRE(placed.size() == 3 * robots);
      for (std::size_t robot = 0; robot < robots; ++robot) {
        CHECK(std::abs(placed[3 * robot]) <= arena.half_side_m);
        CHECK(std::abs(placed[3 * robot + 1]) <= arena.half_side_m);
        CHECK(std::isfinite(placed[3 * robot + 2]));
      }
    }
  }
  Arena court{};
  court.obstacles = {{.x_m = -8.0, .to_x_m = 8.0, .radius_m = 1.0}, {.y_m = 5.0, .to_y_m = 5.0, .radius_m = 2.0}};
  for (const std::uint64_t seed : conformance::seeds) {
    Rng rng{seed, Stream::user};
    for (const GroundPose& pose : policy.place(30, court, 0.2, rng)) CHECK(is_clear(court, pose, 0.2));
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    for (const std::uint64_t seed : conformance::seeds) {
      Rng rng{seed, Stream::user};
      for (const GroundPose& pose : made.place(30, arena, 0.2, rng)) {
        answers.add(std::pair{pose.x_m, pose.y_m});
        answers.add(pose.heading_rad);
      }
    }
    return answers;
  });
}
