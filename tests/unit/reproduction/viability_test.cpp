// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <optional>
#include <trophic/habitat/body/plan.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/reproduction/viability/always_viable.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/reproduction/viability/survives_trial.hpp>
#include <trophic/reproduction/viability/within_mass.hpp>

using namespace trophic;
using reproduction::viability::ModuleLimits;
using reproduction::viability::SurvivesTrial;
using reproduction::viability::WithinMass;

TEST_CASE("always viable: any body -> not refused, and tried once") {
  const reproduction::viability::AlwaysViable rule;
  CHECK_FALSE(rule.refusal({}, body::build({})));
  CHECK(rule.attempts() == 1);
}

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
  CHECK(lengthy.refusal_after_trial(robot, {}, TwoSeconds{}) == "diverges within 2.5 s: must walk until the end of the trial");
}

TEST_CASE("within mass: a core of 0.25 kg -> refused below its mass, by a sentence") {
  const RobotModel core = body::build({});
  CHECK_FALSE(WithinMass{{.most_kg = 0.25}}.refusal({}, core));
  CHECK(WithinMass{{.most_kg = 0.125}}.refusal({}, core) == "0.25 kg: must be <= 0.125");
  CHECK(WithinMass{{.attempts = 7}}.attempts() == 7);
}
