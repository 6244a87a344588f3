// SPDX-License-Identifier: MIT
// An interrupted run on an engine resumes to the same bytes: robots that touch, height fields, other numbers of threads.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/control/gait/inherited_cppn.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/initialization/embodiment/stands_up.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/reproduction/viability/module_limits.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/released.hpp>
#include <unit/checkpoint/resumed.hpp>

namespace {

using namespace trophic;
using namespace trophic::test;

/// Few robots in a small square, which touch from the start.
Experiment<rules::Released> crowd(const std::string& arena, double half_extent_m, double duration_s) {
  Experiment<rules::Released> experiment;
  experiment.seed = 4;
  experiment.ecology.duration_s = duration_s;
  experiment.ecology.robots = 6;
  experiment.ecology.arena = arena;
  experiment.rules.community.predators = 3;
  experiment.rules.placement.half_extent_m = half_extent_m;
  return experiment;
}

/// The same with bodies and gaits that are inherited: predators from spiders, prey from random trees. All die of age every few
/// seconds.
using Ageing = with_parent_after<with_senescence<rules::Released, death::senescence::OldAge>, Cause::senescence,
                                 reproduction::parent::NearestConspecific>;
using Mixed =
    with_viability<with_gait<with_embodiment<with_body_plan<Ageing, rules::by_species<reproduction::body_plan::InheritedModules>>,
                                             initialization::embodiment::StandsUp>,
                             control::gait::InheritedCppn>,
                   reproduction::viability::ModuleLimits>;

/// The same with bodies that no individual has at the start.
using MixedWithSpare = with_recruitment<Mixed, reproduction::recruitment::AfterEscapes>;

template <class Rules, class BackendParams>
void check_mixed(const BackendParams& backend, double duration_s, double every_s, std::int64_t cut) {
  const auto uniform = crowd("walled_square", 0.8, duration_s);
  Experiment<Rules> mixed{.seed = uniform.seed, .ecology = uniform.ecology};
  if constexpr (std::same_as<Rules, MixedWithSpare>) {
    mixed.ecology.robots = 8;
    mixed.rules.recruitment.spare_bodies = 2;
  }
  mixed.rules.community.predators = 3;
  mixed.rules.placement.half_extent_m = 0.8;
  mixed.rules.body_plan.template get<test::prey>().first_modules = 7;
  mixed.rules.gait.first = control::gait::FirstGait::random;
  mixed.rules.senescence.max_age_s = 6.0;
  mixed.physics = {.timestep_s = 0.001, .integrator = Integrator::semi_implicit_euler};  // random gaits are fast
  const TemporaryFolder folder;
  check_resumed(mixed, backend, folder.path(), {cut}, every_s,
                [](std::size_t part, auto& numbers) { numbers.threads = part % 2 == 0 ? 2 : 1; });
  const std::string bodies = content(folder.path() / "whole" / "bodies.csv");
  CHECK(bodies.find(std::same_as<Rules, Mixed> ? ",prey,6," : ",prey,2,") != std::string::npos);  // seven plans; three founders
  CHECK(content(folder.path() / "whole" / "events.csv").find(",death,") != std::string::npos);
}

constexpr auto other_threads = [](std::size_t part, auto& backend) { backend.threads = part % 2 == 0 ? 2 : 1; };

}  // namespace

TEST_CASE("resume: MuJoCo, fast, robots that touch, another number of threads -> the same bytes") {
  const TemporaryFolder folder;
  check_resumed(crowd("walled_square", 0.8, 40.0), backend::Mujoco::Params{}, folder.path(), {7, 13}, 8.0, other_threads);
}

TEST_CASE("resume: MuJoCo, islands, robots that touch -> the same bytes") {
  const TemporaryFolder folder;
  const backend::Mujoco::Params islands{.stepping = backend::Mujoco::Stepping::islands};
  check_resumed(crowd("walled_square", 0.8, 16.0), islands, folder.path(), {5}, 6.0, other_threads);
}

TEST_CASE("resume: MuJoCo, fast, slopes of a height field -> the same bytes") {
  const TemporaryFolder folder;
  check_resumed(crowd("height_field", 9.3, 24.0), backend::Mujoco::Params{}, folder.path(), {4, 9}, 4.0, other_threads);
}

TEST_CASE("resume: ODE, robots that touch, another number of threads -> the same bytes") {
  const TemporaryFolder folder;
  check_resumed(crowd("walled_square", 0.8, 10.0), backend::Ode::Params{}, folder.path(), {3}, 2.0, other_threads);
}

TEST_CASE("resume: MuJoCo, inherited bodies and gaits of robots that touch -> the same bytes") {
  for (const auto stepping : {backend::Mujoco::Stepping::fast, backend::Mujoco::Stepping::islands}) {
    CAPTURE(stepping);
    check_mixed<Mixed>(backend::Mujoco::Params{.stepping = stepping}, 12.0, 4.0, 4);
  }
  check_mixed<MixedWithSpare>(backend::Mujoco::Params{}, 12.0, 4.0, 4);
}

TEST_CASE("resume: ODE, inherited bodies and gaits of robots that touch -> the same bytes") {
  check_mixed<Mixed>(backend::Ode::Params{}, 12.0, 4.0, 4);
  check_mixed<MixedWithSpare>(backend::Ode::Params{}, 12.0, 4.0, 4);
}
