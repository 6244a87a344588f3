// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <soak/invariants.hpp>
#include <soak/resting.hpp>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using test::message_of;

namespace {

template <class Rules>
std::uint64_t deaths_in(double duration_s) {
  Experiment<Rules> numbers;
  test::Invariants invariants{numbers.rules.floor.floor};
  Ecology<Rules> ecology{numbers, backend::Kinematic::Params{}};
  ecology.run_until(duration_s, invariants);
  CHECK(ecology.time_s() == duration_s);
  return invariants.deaths();
}

/// Three robots of two species, as many as were born.
struct Born {
  test::HandPopulation robots{
      {{.species = test::predator, .id = 0}, {.species = test::prey, .id = 1}, {.species = test::prey, .id = 2}}};
  test::Invariants invariants{2};
  void give_birth(std::size_t body) {
    const View view = robots.view();
    invariants.on_event(
        {.kind = observe::EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
  }
  Born() {
    robots.at_tick(0);
    invariants.on_start({}, robots.view());
    for (std::size_t body = 0; body < 3; ++body) give_birth(body);
  }
};

}  // namespace

TEST_CASE("soak: 60000 s of both rule tables -> the invariants of long runs hold") {
  CHECK(deaths_in<rules::Paper>(60000.0) > 1000);
  CHECK(deaths_in<rules::Released>(60000.0) > 1000);
}

TEST_CASE("soak: population that breaks an invariant -> found") {
  Born sound;
  CHECK_NOTHROW(sound.invariants.on_tick(sound.robots.view()));
  CHECK(message_of<std::logic_error>([&] { sound.invariants.on_tick(sound.robots.view()); }) == "tick 0 follows tick 0");
  CHECK(message_of<std::logic_error>([&] { sound.give_birth(1); }) == "individual 1 is born out of turn");

  Born below;
  below.invariants.on_tick(below.robots.view());
  below.robots.individuals[1].species = test::predator;
  below.robots.at_tick(1);
  CHECK(message_of<std::logic_error>([&] { below.invariants.on_tick(below.robots.view()); }).ends_with("fell below its floor"));

  Born stranger;
  stranger.robots.individuals[2].id = 9;
  CHECK(message_of<std::logic_error>([&] { stranger.invariants.on_tick(stranger.robots.view()); }) ==
        "who lives in body 2 was never born");

  Born nowhere;
  nowhere.robots.poses[1].x_m = std::numeric_limits<double>::quiet_NaN();
  CHECK(message_of<std::logic_error>([&] { nowhere.invariants.on_tick(nowhere.robots.view()); }) == "a body is nowhere");
}

TEST_CASE("soak: robot at rest that rises or moves -> found at once") {
  const RobotModel robot = load_robot("spider");
  const auto after = [&](Eigen::Vector3d moved_m, double since_s) {
    const std::vector<Pose> rest(2);
    std::vector<Pose> later = rest;
    later[1].position_m = std::move(moved_m);
    test::Resting resting;
    resting.see(0.0, later, robot);  // not at rest yet
    resting.see(test::Resting::settles_s, rest, robot);
    return message_of<std::logic_error>([&] { resting.see(test::Resting::settles_s + since_s, later, robot); });
  };
  CHECK(after({0.0, 0.0, 1e-3}, 1.0).starts_with("a robot at rest has gained"));
  CHECK(after({0.0, 0.0, 1e-9}, 1e-9).starts_with("a robot at rest has gained"));
  CHECK(after({1e-3, 0.0, 0.0}, 1e6).starts_with("a robot at rest has moved"));
  CHECK(after({0.0, 0.0, -1e-9}, 1.0).empty());
}
