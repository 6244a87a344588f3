// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <trophic/io/phylogeny.hpp>
#include <unit/observe/scene.hpp>
#include <vector>

using namespace trophic;
using observe::EventKind;

TEST_CASE("phylogeny: deaths and end -> rows, roots without ancestor") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "phylogeny.csv";
  test::HandPopulation robots = test::three_robots();
  io::Phylogeny log{path};
  log.on_start(test::short_run(), robots.view());
  for (BodyIndex body = 0; body < 3; ++body) {
    log.on_event({.kind = EventKind::birth, .body = body, .individual = robots.individuals[body], .cause = {}, .other = {}},
                 robots.view());
  }
  robots.individuals[1].tag = 1;  // switched since its birth
  log.on_event({.kind = EventKind::death, .body = 1, .individual = robots.individuals[1], .cause = Cause::caught, .other = 7},
               robots.view());
  log.on_end(robots.view());
  std::istringstream text{test::content(path)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  REQUIRE(lines.size() == 5);
  CHECK(lines[0].starts_with("id,ancestor_list,ancestor_id,origin_time,destruction_time,"));
  CHECK(lines[1] == "8,[none],8,0,6,prey,random,1,8,0,-1,1,caught,7");
  CHECK(lines[2] == "7,[none],7,0,inf,predator,random,0,7,0,-1,,,");
  CHECK(lines[4] == "9,[8],8,6,inf,prey,inherited,2,9,0.125,1,,,");
}
