// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <trophic/habitat/body/build.hpp>
#include <trophic/io/body_log.hpp>
#include <trophic/io/growing_file.hpp>
#include <unit/observe/scene.hpp>
#include <vector>

using namespace trophic;
using observe::EventKind;

namespace {

/// A core with hinges at its first faces.
Phenotype with_hinges(std::size_t hinges) {
  auto design = std::make_shared<body::Design>();
  for (std::size_t i = 0; i < hinges; ++i) design->modules.attach(0, body::all_faces.at(i), body::ModuleType::hinge);
  Phenotype own;
  own.robot = std::make_shared<RobotModel>(body::build(*design));
  own.design = std::move(design);
  return own;
}

}  // namespace

TEST_CASE("body log: births -> plans numbered by their first births, and the distance from the parent's") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "bodies.csv";
  test::HandPopulation robots = test::three_robots();
  const std::vector<Phenotype> phenotypes{with_hinges(1), with_hinges(2), with_hinges(3)};
  View view = robots.view();
  view.phenotypes = phenotypes;
  io::BodyLog log{path, Opening::created};
  for (BodyIndex body = 0; body < 3; ++body) {
    log.on_event({.kind = EventKind::activation, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
    log.on_event({.kind = EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
  }
  log.on_tick(view);
  const std::string text = test::content(path);
  CHECK(text.starts_with("id,time_s,species,plan,parent_plan,edit_distance,modules_text,modules,hinges,bricks,"));
  CHECK(text.find("\n7,6,predator,0,,,core[front:hinge0],2,1,0,") != std::string::npos);
  CHECK(text.find("\n8,6,prey,1,,,core[front:hinge0 back:hinge0],3,2,0,") != std::string::npos);
  CHECK(text.find("\n9,6,prey,2,1,1,core[front:hinge0 back:hinge0 left:hinge0],4,3,0,") != std::string::npos);
  CHECK(log.sum().rows == 3);
}
