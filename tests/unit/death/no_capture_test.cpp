// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/capture/no_capture.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("no capture: predator and prey at the same place -> no catch") {
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  Rng rng{1, Stream::captures};
  CHECK(death::capture::NoCapture{}.captures(robots.view(), rng).empty());
}
