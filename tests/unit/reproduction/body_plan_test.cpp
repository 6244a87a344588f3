// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/reproduction/body_plan/named_body.hpp>
#include <trophic/reproduction/body_plan/one_body.hpp>
#include <vector>

using namespace trophic;
using reproduction::body_plan::NamedBody;

TEST_CASE("named body: name -> that robot's design, no name -> the habitat's, other names and genes -> errors") {
  Habitat habitat{.robot = {}, .arena = {}, .gait = {}};
  habitat.design.emplace().friction = 0.25;
  habitat.robots.push_back({.name = "gecko", .design = {}, .robot = {}, .gait = {}});
  habitat.robots[0].design.friction = 0.5;
  CHECK(NamedBody{}.grow({}, 0, habitat).friction == 0.25);
  CHECK(NamedBody{}.robots().empty());
  const NamedBody gecko{{.robot = "gecko"}};
  CHECK(gecko.grow({}, 0, habitat).friction == 0.5);
  CHECK(gecko.robots() == std::vector<std::string>{"gecko"});
  const NamedBody newt{{.robot = "newt"}};
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(newt.grow({}, 0, habitat)); }) ==
        "robot \"newt\": must be a model of the habitat");
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(gecko.grow(std::vector{1.0}, 0, habitat)); }) ==
        "genes of a body: must be absent with the rule named_body");
}

TEST_CASE("one body: any species -> the habitat's design") {
  Habitat habitat{.robot = {}, .arena = {}, .gait = {}};
  habitat.design.emplace().friction = 0.25;
  for (const Species species : {0U, 1U}) CHECK(reproduction::body_plan::OneBody{}.grow({}, species, habitat).friction == 0.25);
}
