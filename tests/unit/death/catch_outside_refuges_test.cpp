// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/capture/catch_outside_refuges.hpp>

using namespace trophic;
using death::capture::CatchOutsideRefuges;

TEST_CASE("catch_outside_refuges: prey in a zone named refuge -> safe, in any other zone or outside -> caught") {
  test::HandPopulation robots{{{.species = test::predator}, {.x_m = 0.5}, {.x_m = -0.5}, {.y_m = 0.5}}};
  robots.arena.zones = {{.name = "refuge", .x_m = 1.0, .radius_m = 0.5}, {.name = "lake", .x_m = -1.0, .radius_m = 0.5}};
  Rng rng{1, Stream::captures};
  std::vector<BodyIndex> caught;
  for (const death::Capture& capture : CatchOutsideRefuges{}.captures(robots.view(), rng)) caught.push_back(capture.victim);
  CHECK(caught == std::vector<BodyIndex>{2, 3});
}
