// SPDX-License-Identifier: MIT
// A program whose individuals have bodies and gaits of their own, which they inherit, on a backend that costs nothing.
#include <support/toy_bodies.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/experiment.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;

using Walking = with_embodiment<with_gait<rules::Paper, control::gait::InheritedCppn>, initialization::embodiment::StandsUp>;
using Evolving = named<
    with_viability<with_body_plan<Walking, reproduction::body_plan::InheritedModules>, reproduction::viability::ModuleLimits>,
    "evolving">;

int main(int argc, char** argv) {
  return experiment<Evolving>(argc, argv, {.backends = {test::ToyBodies::Params{}}});
}
