// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/habitat/body/plan.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>

using namespace trophic;
using reproduction::viability::ModuleLimits;

TEST_CASE("module limits: a plan -> the reason of the limits, attempts as given") {
  body::Design design;
  design.name = "drawn";
  design.modules = body::read_plan("core[left:hinge0[front:brick0] right:hinge0[front:brick0]]");
  const RobotModel robot = body::build(design);
  CHECK_FALSE(ModuleLimits{}.refusal(design, robot));
  CHECK(ModuleLimits{{.limits = {.most_hinges = 1}, .attempts = 3}}.refusal(design, robot) == "2 hinges: must be <= 1");
  CHECK(ModuleLimits{{.limits = {.most_modules = 4}, .attempts = 3}}.refusal(design, robot) == "5 modules: must be <= 4");
  CHECK(ModuleLimits{{.limits = {}, .attempts = 3}}.attempts() == 3);
}
