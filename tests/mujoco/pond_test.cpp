// SPDX-License-Identifier: MIT
// Runs of the pond on MuJoCo that are killed and resumed.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/worlds/pond.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("pond on mujoco: run killed three times -> the same bytes") {
  const TemporaryFolder folder;
  Experiment<worlds::Pond> experiment{.seed = 2};
  experiment.ecology.robots = 40;
  experiment.ecology.duration_s = 90.0;
  experiment.rules.community.predators = 6;
  experiment.rules.recruitment = {.spare_bodies = 20, .birth_J = 35.0, .share = 0.5};
  experiment.rules.metabolism.get<1>().resting_W = 0.6;  // who catches nothing starves
  const backend::Mujoco::Params engine{.threads = 1};
  check_resumed(experiment, engine, folder.path(), {9, 20, 31}, 10.0,
                [](std::size_t part, backend::Mujoco::Params& own) { own.threads = 1 + part % 2; });
  const std::string events = content(folder.path() / "whole" / "events.csv");
  for (const char* text : {",birth,", ",death,", ",inherited,"}) CHECK(events.find(text) != std::string::npos);
}
