// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/genome_log.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("genomes: birth -> a row with every weight, exact, and a smaller brain leaves its last cells empty, resumed or not") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "genomes.csv";
  test::HandPopulation robots = test::three_robots();
  robots.individuals[0].genome->weights = {0.1};
  robots.individuals[1].genome->weights = {-1.0 / 3.0, 2.0};  // of a species that is born after the founders
  const View view = robots.view();
  auto run = test::short_run();
  run.brain_weights = 2;
  const auto bear = [&](io::GenomeLog& log, BodyIndex body) {
    log.on_event({.kind = EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
    log.on_tick(view);
  };
  io::GenomeLog log{path};
  log.on_start(run, view);
  CHECK_FALSE(std::filesystem::exists(path));  // until a birth
  log.on_event({.kind = EventKind::activation, .body = 1, .individual = view.robots[1], .cause = {}, .other = {}}, view);
  bear(log, 0);
  io::GenomeLog resumed{path, Opening::resumed};
  resumed.on_start(run, view);
  bear(resumed, 1);
  bear(resumed, 0);
  const std::string small = "7,7,6,0.1,\n";
  CHECK(test::content(path) == "id,genome_id,time_s,w0,w1\n" + small + "8,8,6,-0.3333333333333333,2\n" + small);
}
