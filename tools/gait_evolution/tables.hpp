// SPDX-License-Identifier: MIT
// Named pre-experiments: one policy per slot, and their parameters.
#pragma once

#include <tools/gait_evolution/fitness.hpp>
#include <tools/gait_evolution/selection.hpp>
#include <tools/gait_evolution/trial.hpp>
#include <tools/gait_evolution/variation.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::gait_evolution {

/// How many of whom (Sec. "Targeted Steering").
struct Plan {
  std::size_t population = 20;
  std::size_t parents = 20;
  std::size_t children = 20;
  std::size_t generations = 20;

  static constexpr auto fields() {
    return std::tuple{field("population", &Plan::population, between(1, 1e6), "founders, and survivors of each generation"),
                      field("parents", &Plan::parents, between(2, 1e6), "selected for each generation; two in turn have a child"),
                      field("children", &Plan::children, between(1, 1e6), "of each generation"),
                      field("generations", &Plan::generations, between(0, 1e6), "after the founders")};
  }
};

/// Parameters of a table, by designated initialisers; a policy's own parameters if it states none.
template <class Table>
struct TableParams {
  std::string robot = "spider";
  Plan plan{};
  ParamsOf<typename Table::ParentSelection> parent_selection{};
  ParamsOf<typename Table::SurvivorSelection> survivor_selection{};
  ParamsOf<typename Table::Fitness> fitness{};
  ParamsOf<typename Table::Steering> steering{};
  Trial trial{};
  Physics physics{};
};

/// The paper's pre-experiment (Sec. "Targeted Steering"): 20 generations, population 20, 20 parents, 20 children, round-robin
/// tournament, 50 s an evaluation, displacement towards the negative x-axis. Survivors come from parents and children together.
struct Paper final {
  static constexpr std::string_view name = "paper";
  using ParentSelection = RoundRobin;
  using SurvivorSelection = RoundRobin;
  using Fitness = DisplacementMinusX;
  using Steering = control::steering::TargetedSteering;

  static TableParams<Paper> params() { return {}; }
};

/// The released code's: 20 s an evaluation, timestep 0.0005 s with RK4, tournaments of 2 (two distinct parents for each child),
/// steering closed on the heading with exponent 4, the core's x-axis along -x at the start, no control in the first period, the
/// lighter core. Survivors of its tournaments are out of the next ones; the released code holds one again whose winner was
/// selected before.
struct Released final {
  static constexpr std::string_view name = "released";
  using ParentSelection = TournamentCouples;
  using SurvivorSelection = Tournament;
  using Fitness = DisplacementMinusX;
  using Steering = control::steering::TargetedSteering;

  static TableParams<Released> params() {
    return {.robot = "spider_released",
            .plan = {.parents = 40},
            .fitness = {.aim = Aim::minus_x},
            .steering = {.exponent = 4.0},
            .trial = {.duration_s = 20.0, .idle_steps = 1, .facing = Facing::core_x, .cpg_integration = CpgIntegration::rk4},
            .physics = {.timestep_s = 0.0005, .integrator = Integrator::rk4}};
  }
};

/// The table with another fitness, at that policy's own parameters. It keeps its name. A fitness that says how far the robot is
/// turned at the start means its forward axis.
template <class Table, gait_evolution::Fitness Policy>
struct with_fitness final {
  static constexpr std::string_view name = Table::name;
  using ParentSelection = typename Table::ParentSelection;
  using SurvivorSelection = typename Table::SurvivorSelection;
  using Fitness = Policy;
  using Steering = typename Table::Steering;

  static TableParams<with_fitness> params() {
    TableParams<Table> base = Table::params();
    if constexpr (requires(typename Policy::Params params) { params.start_turn_rad; }) base.trial.facing = Facing::forward_axis;
    return {.robot = base.robot,
            .plan = base.plan,
            .parent_selection = base.parent_selection,
            .survivor_selection = base.survivor_selection,
            .fitness = {},
            .steering = base.steering,
            .trial = base.trial,
            .physics = base.physics};
  }
};

namespace detail {

/// Fails to compile, with one sentence, if a policy of a pre-experiment cannot be made from its parameters.
template <class Policy>
consteval bool made_from_params() {
  static_assert(!trophic::detail::HasParams<Policy> || trophic::detail::MadeFromParams<Policy>,
                "a policy of the pre-experiment has Params but cannot be made from them: it needs `Params params;` as its first "
                "member or a constructor from Params");
  return true;
}

}  // namespace detail

/// All parameters of a pre-experiment but its backend's. Starts at the parameters of its table.
template <class Table>
struct Params {
  static_assert(Selection<typename Table::ParentSelection> && Selection<typename Table::SurvivorSelection>,
                "ParentSelection and SurvivorSelection need std::vector<std::size_t> select(std::span<const double> fitness, "
                "std::size_t count, Rng&) const; see tools/gait_evolution/selection.hpp");
  static_assert(gait_evolution::Fitness<typename Table::Fitness>,
                "Fitness needs double fitness(const TryOut&) const; see tools/gait_evolution/fitness.hpp");
  static_assert(detail::made_from_params<typename Table::ParentSelection>() &&
                detail::made_from_params<typename Table::SurvivorSelection>() &&
                detail::made_from_params<typename Table::Fitness>() && detail::made_from_params<typename Table::Steering>());

  std::uint64_t seed = 1;
  std::string robot = Table::params().robot;
  Plan plan = Table::params().plan;
  ParamsOf<typename Table::ParentSelection> parent_selection = Table::params().parent_selection;
  ParamsOf<typename Table::SurvivorSelection> survivor_selection = Table::params().survivor_selection;
  ParamsOf<typename Table::Fitness> fitness = Table::params().fitness;
  ParamsOf<typename Table::Steering> steering = Table::params().steering;
  Variation variation{};
  Trial trial = Table::params().trial;
  Physics physics = Table::params().physics;

  static constexpr auto fields() {
    return std::tuple{field("seed", &Params::seed, any_seed(), "every random number follows from it"),
                      field("robot", &Params::robot, "name or path of a robot file"),
                      field("plan", &Params::plan),
                      field("parent_selection", &Params::parent_selection),
                      field("survivor_selection", &Params::survivor_selection),
                      field("fitness", &Params::fitness),
                      field("steering", &Params::steering),
                      field("variation", &Params::variation),
                      field("trial", &Params::trial),
                      field("physics", &Params::physics)};
  }
};

/// All parameters of a pre-experiment in place, those of its backend last.
template <class Table>
[[nodiscard]] ParamRefs param_refs_of(Params<Table>& params, BackendChoice& backend) {
  ParamRefs refs = param_refs(params);
  backend.append_param_refs("backend", refs);
  return refs;
}

template <class Table>
[[nodiscard]] NamedParams named_params_of(Params<Table> params, BackendChoice backend) {
  return trophic::named_params_of(param_refs_of(params, backend));
}

}  // namespace trophic::gait_evolution
