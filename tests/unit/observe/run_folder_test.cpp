// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <trophic/io/run_folder.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("run folder: run -> all files, never overwritten") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "deep" / "run";
  test::HandPopulation robots = test::three_robots();
  {
    io::RunFolder run{path};
    CHECK(run.path() == path);
    run.on_start(test::short_run(), robots.view());
    for (BodyIndex body = 0; body < 3; ++body) {
      run.on_event({.kind = EventKind::birth, .body = body, .individual = robots.individuals[body], .cause = {}, .other = {}},
                   robots.view());
    }
    run.on_tick(robots.view());
    // past events are written before the run ends
    CHECK(test::content(path / "events.csv").find("birth,9,") != std::string::npos);
    run.on_end(robots.at_tick(5).view());
  }
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator{path}) files.insert(entry.path().filename());
  for (const char* file : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "manifest.json"})
    CHECK(files.contains(file));
  CHECK(test::message_of<std::invalid_argument>([&] { io::RunFolder{path}; }) ==
        "output folder " + path.string() + ": exists already; runs are never overwritten");
}
