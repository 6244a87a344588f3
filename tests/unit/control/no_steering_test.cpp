// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/toy_backend.hpp>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/control/steering/no_steering.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using control::steering::NoSteering;

TEST_CASE("no steering: any target angle -> joint targets unchanged") {
  const std::vector<HingePlace> hinges{{Side::right}, {Side::left}, {Side::middle}};
  for (const double target_angle_rad : {-0.7, 0.0, 0.7, 4.0}) {
    std::vector<double> targets_rad{1.0, -0.5, 0.25};
    NoSteering{}.steer(target_angle_rad, hinges, targets_rad);
    CHECK(targets_rad == std::vector<double>{1.0, -0.5, 0.25});
  }
}

TEST_CASE("no steering: backend with joints -> accepted, because of `steers = false`") {
  CHECK_NOTHROW(locomotion::check_steerable(load_robot("spider"), NoSteering{}));
  Experiment<with_steering<rules::Paper, NoSteering>> experiment{.seed = 1};
  CHECK_NOTHROW(Ecology<with_steering<rules::Paper, NoSteering>>{experiment, test::ToyBackend::Params{}});
}
