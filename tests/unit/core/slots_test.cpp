// SPDX-License-Identifier: MIT
// What a flip of one rule does to a fingerprint. Every flip of either table into the other is compiled and run by
// studies/tests/test_ablations.py.
#include <doctest/doctest.h>

#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

TEST_CASE("slots: rules or parameters differ -> other fingerprint, seed, duration or name -> same") {
  using Paper = Ecology<rules::Paper>;
  const auto fingerprint = [](auto params) {
    return Paper{std::move(params), backend::Kinematic::Params{}}.describe(1.0).fingerprint;
  };
  const std::string paper = fingerprint(Paper::Params{});
  CHECK(fingerprint(Paper::Params{.seed = 77}) == paper);
  Paper::Params longer;
  longer.ecology.duration_s = 1.0;
  CHECK(fingerprint(longer) == paper);
  Paper::Params wider;
  wider.rules.capture.reach_m = 1.25;
  CHECK(fingerprint(wider) != paper);
  using Same = with_floor<rules::Paper, death::floor::VictimFloor>;
  CHECK(Ecology<Same>{{}, backend::Kinematic::Params{}}.describe(1.0).fingerprint == paper);
  using Other = with_mutation<rules::Paper, reproduction::mutation::UniformMutation>;
  CHECK(Ecology<Other>{{}, backend::Kinematic::Params{}}.describe(1.0).fingerprint != paper);
  Habitat quicker = load_habitat(Paper::Params{}.ecology);
  Paper::Params own_gait;
  own_gait.ecology.gait = quicker.gait.name;
  CHECK(Paper(own_gait, backend::Kinematic::Params{}, quicker).describe(1.0).fingerprint == paper);
  quicker.robot.walk.turn_rate_per_rad *= 1.1;
  CHECK(Paper(own_gait, backend::Kinematic::Params{}, quicker).describe(1.0).fingerprint != paper);
}
