// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mujoco/worlds.hpp>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>

using namespace trophic;
using test::spider;
using test::square;
namespace engine = backend::mujoco;

TEST_CASE("crowd models: crowd that dissolved -> model dropped, and made again to the same bytes") {
  constexpr std::size_t robots = 33;  // too many in one island for the kernel
  engine::Rows targets_rad{robots, spider.hinges.size()};
  for (std::size_t i = 0; i < robots; ++i) std::ranges::fill(targets_rad[i], 0.4);
  for (const bool fast : {true, false}) {
    CAPTURE(fast);
    auto lanes = fast ? std::make_unique<engine::Lanes>(engine::BoxDepth::engine, 1) : nullptr;
    engine::Islands islands{spider, square, {}, 1, engine::BoxDepth::engine, std::move(lanes)};
    const auto in_rows = [&](double distance_m) {
      engine::RobotStates states{islands.layout(), robots};
      for (std::size_t i = 0; i < robots; ++i) {
        const double row = distance_m * static_cast<double>(i / 8) - 5.0;
        states.set_root(i, test::standing(spider, distance_m * static_cast<double>(i % 8) - 5.0, row, 0.0));
      }
      return states;
    };
    const engine::RobotStates crowd = in_rows(1.2 * spider.bounding_radius_m);
    const engine::RobotStates apart = in_rows(2.0);

    engine::RobotStates first = crowd;
    engine::RobotStates next = apart;
    REQUIRE(islands.advance(apart, targets_rad, 1, next).end == engine::GroupResult::End::done);
    REQUIRE(islands.advance(crowd, targets_rad, 1, first).end == engine::GroupResult::End::done);
    const std::size_t with_crowd = islands.models();
    for (std::uint64_t i = 0; i <= engine::Islands::keeps_idle_models_for; ++i) {
      static_cast<void>(islands.advance(apart, targets_rad, 1, next));
    }
    CHECK(islands.models() < with_crowd);

    engine::RobotStates again = crowd;
    REQUIRE(islands.advance(crowd, targets_rad, 1, again).end == engine::GroupResult::End::done);
    CHECK(again.values() == first.values());
  }
}
