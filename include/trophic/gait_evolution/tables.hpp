// SPDX-License-Identifier: MIT
// Named pre-experiments: one policy per slot, and their numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/backend/contract.hpp>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/gait_evolution/fitness.hpp>
#include <trophic/gait_evolution/selection.hpp>
#include <trophic/gait_evolution/trial.hpp>
#include <trophic/gait_evolution/variation.hpp>
#include <trophic/params/params.hpp>
#include <trophic/rules/table.hpp>
#include <tuple>

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

/// The paper's pre-experiment (Sec. "Targeted Steering"): 20 generations, population 20, 20 parents, 20 children, round-robin
/// tournament, 50 s an evaluation, displacement towards the negative x-axis. Survivors come from parents and children together.
struct Paper {
  static constexpr std::string_view name = "paper";
  using ParentSelection = RoundRobin;
  using SurvivorSelection = RoundRobin;
  using Fitness = DisplacementMinusX;
  using Steering = control::steering::TargetedSteering;

  static Plan plan() { return {}; }
  static Trial trial() { return {}; }
  static Physics physics() { return {}; }
};

/// The released code's: 20 s an evaluation, timestep 0.0005 s with RK4, tournaments of 2 (two distinct parents for each child),
/// steering closed on the heading with exponent 4, the core's x-axis along -x at the start, no control in the first period.
struct Released {
  static constexpr std::string_view name = "released";
  using ParentSelection = TournamentCouples;
  using SurvivorSelection = Tournament;
  using Fitness = DisplacementMinusX;
  static constexpr Fitness::Params fitness{.aim = Aim::minus_x};
  using Steering = control::steering::TargetedSteering;
  static constexpr Steering::Params steering{.exponent = 4.0};

  static Plan plan() { return {.parents = 40}; }
  static Trial trial() {
    return {.duration_s = 20.0, .idle_steps = 1, .facing = Facing::core_x, .cpg_integration = CpgIntegration::rk4};
  }
  static Physics physics() { return {.timestep_s = 0.0005, .integrator = Integrator::rk4}; }
};

/// The table with another fitness, at that policy's own numbers.
template <class Table, gait_evolution::Fitness Policy>
struct with_fitness : Table {
  using Fitness = Policy;
  inline static const ParamsOf<Policy> fitness{};
};

/// All numbers of a pre-experiment. Starts at the numbers of its table, at a policy's own where the table states none.
template <class Table, Backend B>
struct Params {
  static_assert(Selection<typename Table::ParentSelection> && Selection<typename Table::SurvivorSelection>,
                "ParentSelection and SurvivorSelection need std::vector<std::size_t> select(std::span<const double> fitness, "
                "std::size_t count, Rng&) const; see trophic/gait_evolution/selection.hpp");
  static_assert(gait_evolution::Fitness<typename Table::Fitness>,
                "Fitness needs double fitness(const TryOut&) const; see trophic/gait_evolution/fitness.hpp");

  std::uint64_t seed = 1;
  std::string robot = "spider";
  Plan plan = Table::plan();
#define TROPHIC_START(Slot, member)                                                                                          \
  static_assert(!trophic::detail::HasNumbers<typename Table::Slot> || trophic::detail::MadeFromParams<typename Table::Slot>, \
                #Slot                                                                                                        \
                " has Params but cannot be made from them: it needs `Params params;` as its first member or a constructor "  \
                "from Params");                                                                                              \
  ParamsOf<typename Table::Slot> member = [] {                                                                               \
    if constexpr (requires { Table::member; })                                                                               \
      return Table::member;                                                                                                  \
    else                                                                                                                     \
      return ParamsOf<typename Table::Slot>{};                                                                               \
  }();
  TROPHIC_START(ParentSelection, parent_selection)
  TROPHIC_START(SurvivorSelection, survivor_selection)
  TROPHIC_START(Fitness, fitness)
  TROPHIC_START(Steering, steering)
#undef TROPHIC_START
  Variation variation{};
  Trial trial = Table::trial();
  Physics physics = Table::physics();
  typename B::Params backend{};

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
                      field("physics", &Params::physics),
                      field("backend", &Params::backend)};
  }
};

}  // namespace trophic::gait_evolution
