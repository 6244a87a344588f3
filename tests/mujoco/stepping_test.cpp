// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <mujoco/touching.hpp>

using namespace trophic;
using backend::Mujoco;
using test::spider;
using test::square;

namespace {

constexpr Physics released{.timestep_s = 0.012, .integrator = Integrator::rk4};

Mujoco::Params one_model() {
  return {.stepping = Mujoco::Stepping::one_model};
}
Mujoco::Params islands(std::size_t threads) {
  return {.stepping = Mujoco::Stepping::islands, .threads = threads};
}

}  // namespace

TEST_CASE("stepping: crowd with 1, 2 and 4 threads -> same bits") {
  const std::vector<Pose> starts = test::tight_crowd(spider, 16, 2.3, 5000);
  test::TouchWatch watch{spider, square, starts.size()};
  Mujoco first{spider, square, starts, {}, islands(1)};
  for (double time_s = 0.1; time_s < 4.05; time_s += 0.1) {
    test::walk(first, time_s);
    watch.look(first);
  }
  CHECK(watch.touched().size() >= 4);
  for (const std::size_t threads : {2U, 4U}) {
    Mujoco other{spider, square, starts, {}, islands(threads)};
    test::walk(other, first.time_s());
    CHECK(other.save() == first.save());
  }
}

TEST_CASE("stepping: restored crowd, both modes -> continues bitwise") {
  const std::vector<Pose> starts = test::tight_crowd(spider, 12, 2.0, 5000);
  for (const Mujoco::Params& params : {islands(2), one_model()}) {
    Mujoco original{spider, square, starts, {}, params};
    test::walk(original, 1.0);
    const Mujoco::State state = original.save();
    test::walk(original, 2.0);
    Mujoco fresh{spider, square, starts, {}, params};
    fresh.restore(state);
    CHECK(fresh.save() == state);
    test::walk(fresh, 2.0);
    CHECK(fresh.save() == original.save());

    Mujoco::State cold = state;
    const std::size_t row = cold.robots.size() / starts.size();
    for (std::size_t i = 0; i < cold.robots.size(); ++i) {
      if (i % row >= row - 10) cold.robots[i] = 0.0;
    }
    fresh.restore(cold);
    test::walk(fresh, 2.0);
    CHECK(fresh.save() != original.save());  // the warm start is part of the state
  }
}

TEST_CASE("stepping: state of another world -> rejected") {
  Mujoco one{spider, square, test::lattice(spider, 1, 1.0), {}, {}};
  const Mujoco two{spider, square, test::lattice(spider, 2, 1.0), {}, {}};
  CHECK_THROWS_AS(one.restore(two.save()), std::invalid_argument);
}

TEST_CASE("stepping: RK4 at 0.012 s -> same motion in both modes") {
  const std::vector<Pose> starts = test::lattice(spider, 9, 2.0);
  Mujoco fast{spider, square, starts, released, islands(2)};
  Mujoco whole{spider, square, starts, released, one_model()};
  test::walk(fast, 5.0);
  test::walk(whole, 5.0);
  CHECK(test::largest_difference(fast, whole) < 1e-10);
}

TEST_CASE("stepping: released physics on the released height field -> same motion in both modes") {
  const RobotModel heavy = load_robot("spider_released");
  const Arena slopes = load_arena("height_field");
  std::vector<Pose> starts = test::lattice(heavy, 9, 2.0);
  starts[8] = test::standing(heavy, 9.1, 3.0, 0.0);  // near the foot of the slope
  Mujoco fast{heavy, slopes, starts, released, islands(2)};
  Mujoco whole{heavy, slopes, starts, released, one_model()};
  // MuJoCo finds contacts with a height field by iteration to 1e-6, which amplifies rounding within seconds.
  test::walk(fast, 1.0);
  test::walk(whole, 1.0);
  const double difference = test::largest_difference(fast, whole);
  MESSAGE("largest difference of any coordinate after 1 s: ", difference);
  CHECK(difference < 1e-8);
  for (Mujoco* backend : {&fast, &whole}) {
    test::walk(*backend, 8.0);
    CHECK((backend->pose(0).position_m - starts[0].position_m).norm() > 0.02);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      CHECK(backend->pose(i).position_m.z() > 0.0);
      CHECK(std::abs(backend->pose(i).position_m.x()) < 9.9);
    }
  }
}

TEST_CASE("stepping: smooth fall -> error of the integrator's order") {
  // Free fall from rest: semi-implicit Euler is h t g / 2 lower than the exact parabola, RK4 is exact.
  const std::vector<Pose> starts{{{0.0, 0.0, 5.0}, Eigen::Quaterniond::Identity()}};
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4}) {
    Mujoco backend{spider, square, starts, {.timestep_s = 0.004, .integrator = integrator}, {}};
    backend.advance_to(0.8);
    CHECK(backend.time_s() == doctest::Approx(0.8).epsilon(1e-12));
    const double exact_m = 5.0 - 0.5 * 9.81 * 0.64;
    const double lower_m = integrator == Integrator::rk4 ? 0.0 : 0.5 * 9.81 * 0.004 * 0.8;
    CHECK(std::abs(backend.pose(0).position_m.z() - (exact_m - lower_m)) < 1e-9);
  }
}

TEST_CASE("stepping: time -> whole steps without drift") {
  Mujoco backend{spider, square, test::lattice(spider, 1, 1.0), {}, {}};
  for (int tick = 1; tick <= 600; ++tick) backend.advance_to(tick / 60.0);
  CHECK(backend.time_s() == 8334 * 0.0012);  // the first multiple of 0.0012 s not below 10 s
  CHECK(backend.save().steps == 8334);
}

TEST_CASE("stepping: robot faster than its slack -> contacts found") {
  // Shot at 8 m/s at a standing robot 1 m away, from a state whose slack was measured before the shot.
  const std::vector<Pose> starts{test::standing(spider, 0.0, 0.0, 0.0), test::standing(spider, 1.0, 0.05, 0.0)};
  Mujoco fast{spider, square, starts, {}, islands(1)};
  Mujoco whole{spider, square, starts, {}, one_model()};
  for (Mujoco* backend : {&fast, &whole}) {
    backend->advance_to(0.1);
    Mujoco::State state = backend->save();
    const std::size_t positions = 7 + spider.hinges.size();
    state.robots[positions] = 8.0;
    backend->restore(state);
    backend->advance_to(0.4);
  }
  CHECK(std::abs(whole.pose(1).position_m.x() - 1.0) > 0.05);
  CHECK(test::largest_difference(fast, whole) < 1e-8);
}
