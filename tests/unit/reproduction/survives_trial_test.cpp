// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>

using namespace trophic;
using reproduction::viability::ModuleLimits;
using reproduction::viability::SurvivesTrial;

namespace {

/// A nursery in which every motion diverges after 2 s.
struct TwoSeconds final : Nursery {
  [[nodiscard]] std::optional<double> walked_m(const RobotModel&, const Gait&, double duration_s) const override {
    return duration_s > 2.0 ? std::nullopt : std::optional{0.0};
  }
};

}  // namespace

TEST_CASE("survives trial: a body -> the reason of the other rule, or of a trial that is longer than the motion") {
  body::Design design;
  design.name = "drawn";
  design.modules = body::read_plan("core[left:hinge0 right:hinge0]");
  const RobotModel robot = body::build(design);
  const SurvivesTrial<ModuleLimits> brief{{.bodies = {.limits = {.most_hinges = 1}, .attempts = 3}, .trial_s = 1.0}};
  CHECK(brief.refusal(design, robot) == "2 hinges: must be <= 1");
  CHECK(brief.attempts() == 3);
  CHECK_FALSE(brief.refusal_after_trial(robot, {}, TwoSeconds{}));
  const SurvivesTrial<ModuleLimits> lengthy{{.bodies = {}, .trial_s = 2.5}};
  CHECK_FALSE(lengthy.refusal(design, robot));
  CHECK(lengthy.refusal_after_trial(robot, {}, TwoSeconds{}) == "diverges within 2.5 s: must walk so long");
}
