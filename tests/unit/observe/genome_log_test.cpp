// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/genome_log.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("genomes: birth -> a row with every weight, exact") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "genomes.csv";
  test::HandPopulation robots = test::three_robots();
  robots.individuals[0].genome->weights = {0.1, -1.0 / 3.0};
  const View view = robots.view();
  io::GenomeLog log{path};
  CHECK_FALSE(std::filesystem::exists(path));  // until a birth sets the number of weights
  log.on_event({.kind = EventKind::activation, .body = 1, .individual = view.robots[1], .cause = {}, .other = {}}, view);
  log.on_event({.kind = EventKind::birth, .body = 0, .individual = view.robots[0], .cause = {}, .other = {}}, view);
  log.on_tick(view);
  CHECK(test::content(path) == "id,genome_id,time_s,w0,w1\n7,7,6,0.1,-0.3333333333333333\n");
}
