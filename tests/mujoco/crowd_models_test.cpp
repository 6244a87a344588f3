// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mujoco/worlds.hpp>
#include <numeric>
#include <support/memory.hpp>
#include <thread>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <vector>

using namespace trophic;
using test::spider;
using test::square;
namespace engine = backend::mujoco;

namespace {

constexpr std::size_t robots = 33;  ///< too many in one island for the kernel

/// Spiders on the square, stepped by the kernel where it can (`fast`) or by MuJoCo.
engine::Islands islands_of(std::size_t threads, bool fast) {
  auto lanes = fast ? std::make_unique<engine::Lanes>(engine::BoxDepth::engine, threads) : nullptr;
  return {spider, square, {}, threads, engine::BoxDepth::engine, std::move(lanes)};
}

/// Robots in a row, as far from each other as this.
engine::RobotStates in_a_row(engine::Islands& islands, double distance_m, std::size_t count = robots) {
  engine::RobotStates states{islands.layout(), count};
  for (std::size_t i = 0; i < count; ++i)
    states.set_root(i, test::standing(spider, distance_m * static_cast<double>(i % 8) - 5.0,
                                      distance_m * static_cast<double>(i / 8) - 5.0, 0.0));
  return states;
}

/// The same target for all hinges.
engine::Rows all_targets(std::size_t count, double target_rad) {
  engine::Rows targets_rad{count, spider.hinges.size()};
  for (std::size_t i = 0; i < count; ++i) std::ranges::fill(targets_rad[i], target_rad);
  return targets_rad;
}

}  // namespace

// Later versions allocate that matrix for the dual solvers alone.
TEST_CASE("crowd models: crowd over many steps -> no memory for the matrix of the dual solvers" *
          doctest::skip(backend::mujoco::is_mujoco_3)) {
  constexpr std::size_t many = 30;
  engine::CompiledModel model{spider, square, {}, {}, many, 1};
  engine::RobotStates states{model.layout(), many};
  const std::vector<Pose> close = test::lattice(spider, many, 2.0 * spider.bounding_radius_m);
  for (std::size_t i = 0; i < many; ++i) states.set_root(i, close[i]);
  std::vector<std::size_t> all(many);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const engine::Rows targets_rad = all_targets(many, 0.4);

  const double before = test::resident_bytes();
  engine::RobotStates next = states;
  REQUIRE(engine::step_group(model, all, targets_rad, {}, 100, states, next).end == engine::GroupResult::End::done);
  REQUIRE(model.data(0).nefc > 100);
  const auto rows = static_cast<double>(model.model().njmax);
  const double matrix = rows * rows * (sizeof(mjtNum) + sizeof(int));
  const auto buffer = static_cast<double>(model.data(0).nbuffer);
  REQUIRE(matrix > 0.5 * buffer);
  CHECK(test::resident_bytes() - before < buffer - 0.9 * matrix);
}

TEST_CASE("crowd models: crowd that dissolved -> model dropped, and made again to the same bytes") {
  const engine::Rows targets_rad = all_targets(robots, 0.4);
  for (const bool fast : {true, false}) {
    CAPTURE(fast);
    engine::Islands islands = islands_of(1, fast);
    const engine::RobotStates crowd = in_a_row(islands, 1.2 * spider.bounding_radius_m);
    const engine::RobotStates apart = in_a_row(islands, 2.0);

    engine::RobotStates first = crowd;
    engine::RobotStates next = apart;
    REQUIRE(islands.advance(apart, targets_rad, 1, next).end == engine::GroupResult::End::done);
    const std::size_t without_crowd = islands.models();
    REQUIRE(islands.advance(crowd, targets_rad, 1, first).end == engine::GroupResult::End::done);
    const std::size_t with_crowd = islands.models();
    REQUIRE(with_crowd > without_crowd);

    for (std::uint64_t i = 0; i < engine::Islands::keeps_idle_models_for; ++i) {
      static_cast<void>(islands.advance(apart, targets_rad, 1, next));
    }
    CHECK(islands.models() == with_crowd);
    static_cast<void>(islands.advance(apart, targets_rad, 1, next));
    CHECK(islands.models() == without_crowd);

    engine::RobotStates again = crowd;
    REQUIRE(islands.advance(crowd, targets_rad, 1, again).end == engine::GroupResult::End::done);
    CHECK(islands.models() == with_crowd);
    CHECK(again.values() == first.values());
  }
}

#ifndef __SANITIZE_ADDRESS__  // whose allocator keeps what is freed
TEST_CASE("crowd models: dropped below other memory -> memory returned to the system") {
  std::vector<char>(std::size_t{31} << 20);  // glibc no longer maps what is smaller, once such a block was freed
  engine::Islands islands = islands_of(1, false);
  const auto advance = [&](double distance_m, std::size_t many, std::size_t steps) {
    const engine::RobotStates from = in_a_row(islands, distance_m, many);
    engine::RobotStates to = from;
    const engine::Rows targets_rad = all_targets(many, 0.4);
    return islands.advance(from, targets_rad, steps, to).end;
  };
  REQUIRE(advance(1.0, 11, 1) == engine::GroupResult::End::done);

  engine::give_back_freed_pages();  // of other tests: crowds would be in them
  const double before = test::resident_bytes();
  for (std::size_t many = 7; many <= 11; ++many)
    REQUIRE(advance(1.2 * spider.bounding_radius_m, many, 10) == engine::GroupResult::End::done);
  const double of_crowds = test::resident_bytes() - before;
  REQUIRE(of_crowds > 5e6);
  const std::vector<std::vector<char>> above(100, std::vector<char>(100'000));
  const double with_crowds = test::resident_bytes();
  for (std::uint64_t i = 0; i <= engine::Islands::keeps_idle_models_for; ++i) {
    static_cast<void>(advance(1.0, 11, 1));
  }
  CHECK(with_crowds - test::resident_bytes() > 0.5 * of_crowds);  // nine tenths here; two thirds of a smaller crowd elsewhere
}
#endif

TEST_CASE("crowd models: threads at the same time -> a working memory each, in sequence -> one") {
  engine::CompiledModel model{spider, square, {}, {}, 1, 2};
  {
    const engine::CompiledModel::Turn first{model};
    const engine::CompiledModel::Turn second{model};
    CHECK(first.slot() == 0);
    CHECK(second.slot() == 1);
  }
  for (int i = 0; i < 3; ++i) CHECK(engine::CompiledModel::Turn{model}.slot() == 0);
}

TEST_CASE("crowd models: all working memories in use -> a thread waits") {
  engine::CompiledModel model{spider, square, {}, {}, 1, 1};
  std::atomic<bool> is_over = false;
  bool waited = false;
  std::thread other;
  {
    const engine::CompiledModel::Turn first{model};
    other = std::thread{[&] {
      const engine::CompiledModel::Turn second{model};
      waited = is_over;
    }};
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    is_over = true;
  }
  other.join();
  CHECK(waited);
}

TEST_CASE("crowd models: kernel's remainder -> one working memory a model, no kernel -> one a thread") {
  constexpr std::size_t threads = 3;
  const auto memories = [&](bool fast, std::size_t together) {
    engine::Islands islands = islands_of(threads, fast);
    const engine::RobotStates crowd = in_a_row(islands, 1.2 * spider.bounding_radius_m, together);
    engine::RobotStates next = crowd;
    const engine::Rows targets_rad = all_targets(together, 0.4);
    const std::size_t before = islands.memories();
    REQUIRE(islands.advance(crowd, targets_rad, 1, next).end == engine::GroupResult::End::done);
    REQUIRE(islands.memories() > before);
    return islands.memories() - before;
  };
  CHECK(memories(true, robots) == 1);
  CHECK(memories(false, 2) == threads);
}
