// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <soak/growth.hpp>
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

TEST_CASE("soak: growth by the margin -> flat in one run of twenty, no growth -> flat in most") {
  using analysis::Equivalence;
  // Like the memory of crowds: 600 measurements about a mean of 1, each of which remembers half of the one before.
  const auto conclusions = [](double growth, double deviation) {
    std::array<int, 4> counted{};
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      Rng rng{seed, Stream::placement};
      std::vector<double> measured;
      double about = 0.0;
      for (std::size_t i = 0; i < 600; ++i) {
        about = 0.5 * about + rng.normal(0.0, deviation);
        measured.push_back(1.0 + about + growth * (i < 330 ? 0.0 : 1.0));  // the middle of what is left of 600 without a tenth
      }
      ++counted[static_cast<std::size_t>(test::growth_of(measured).conclusion)];
    }
    return counted;
  };
  const auto at = [](Equivalence conclusion) { return static_cast<std::size_t>(conclusion); };
  const auto flat = conclusions(0.0, 0.15);
  CHECK(flat[at(Equivalence::equivalent)] > 900);
  CHECK(flat[at(Equivalence::different)] < 80);
  const auto by_margin = conclusions(test::same_within, 0.2);
  CHECK(by_margin[at(Equivalence::equivalent)] < 80);
  CHECK(by_margin[at(Equivalence::different)] > 700);
  const auto noise = conclusions(0.0, 2.0);
  CHECK(noise[at(Equivalence::inconclusive)] > 900);
  CHECK(test::growth_of(std::vector<double>(21, 1.0)).conclusion == Equivalence::unknown);
  CHECK(test::growth_of(std::vector<double>(22, 1.0)).conclusion == Equivalence::equivalent);
  CHECK(test::growth_of(std::vector<double>(600, 0.0)).conclusion == Equivalence::unknown);
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
