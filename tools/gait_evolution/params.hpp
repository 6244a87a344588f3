// SPDX-License-Identifier: MIT
// Parameters of a pre-experiment: those of the paper and of its released code.
#pragma once

#include <numbers>
#include <span>
#include <tools/gait_evolution/genome.hpp>
#include <tools/gait_evolution/trial.hpp>

namespace trophic::gait_evolution {

/// Whose pre-experiment.
enum class Table { paper, released };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Table) {
  return {"paper", "released"};
}

/// How many of whom (Sec. "Targeted Steering").
struct Plan {
  std::size_t population = 20;
  std::size_t parents = 20;
  std::size_t children = 20;
  std::size_t generations = 20;

  static constexpr auto fields() {
    return std::tuple{
        field("population", &Plan::population, between(1, 1e6), "number of founders and of survivors of each generation"),
        field("parents", &Plan::parents, between(2, 1e6), "number selected for each generation; two in turn have a child"),
        field("children", &Plan::children, between(1, 1e6), "number of children in each generation"),
        field("generations", &Plan::generations, between(0, 1e6), "number of generations after the founders")};
  }
};

/// round_robin (Sec. "Targeted Steering"; as in evolutionary programming [eiben2015]): every individual meets `opponents` others
/// drawn without repetition, or with 0 (the literal round robin; the paper gives no number) each other one; it wins a meeting
/// where its fitness is higher. Those with the most wins are selected, each once, in this order; equal wins are ordered by
/// fitness, then by age, older first. Draws: none if all are met, else size - 2 shuffling draws an individual.
///
/// tournament: the fittest of `size` individuals drawn with repetition is selected, the first drawn among equals; again until
/// there are enough. A selected individual is out of the next tournaments. Draws: size a tournament.
///
/// tournament_couples, as in the released code: individuals 2i and 2i + 1 of the result are a couple, winners of tournaments
/// among all; the second tournament is held again while its winner is the first parent. An individual may be in several couples.
enum class SelectionRule { round_robin, tournament, tournament_couples };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(SelectionRule) {
  return {"round_robin", "tournament", "tournament_couples"};
}

/// A rule of selection; its parameters are those that have an effect.
struct Selection {
  SelectionRule rule = SelectionRule::round_robin;
  std::size_t opponents = 0;
  std::size_t size = 2;

  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, const Visit& visit) {
    if (self.rule == SelectionRule::round_robin) {
      visit(FieldText{"opponents", at_least(0), "number of opponents of each individual; 0: all"}, self.opponents);
    } else {
      const Bound bound = self.rule == SelectionRule::tournament ? at_least(1) : between(1, 16);
      visit(FieldText{"size", bound, "number of individuals in a tournament"}, self.size);
    }
  }

  /// The indices of `count` selected individuals; `fitness` has one number each, older individuals first, -infinity for one whose
  /// trial diverged. Throws std::invalid_argument where it cannot select so many.
  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const;
};

/// displacement_minus_x: displacement towards the negative x-axis, m (Sec. "Targeted Steering"). The paper does not say whether
/// the gait is steered meanwhile; the released code's is closed on the heading (Aim::minus_x). Tries: 1.
///
/// steered_displacement: the same, but the robot first has to turn to it, steered as a cognitive brain steers: it starts facing
/// start_turn_rad to the left of -x and, in a second try, as far to the right; every decision_s the target angle is
/// +turn_angle_rad where -x lies to the right and -turn_angle_rad where it lies to the left (Sec. "Cognitive Brain": 2 s,
/// 0.7 rad). A try scores its displacement times the share of the time in which the robot faced -x (bearing within 90 degrees),
/// the fitness is the smaller of both: a gait that does not turn to both sides or turns the wrong way walks in circles or past
/// its aim, one that walks backwards never faces it, and both score about 0 or less. Tries: 2.
enum class FitnessRule { displacement_minus_x, steered_displacement };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(FitnessRule) {
  return {"displacement_minus_x", "steered_displacement"};
}

/// How the target angle is chosen while a gait is tried out.
enum class Aim {
  none,    ///< the gait alone: target angle 0
  minus_x  ///< the target angle is the bearing of the negative x-axis, at every control step
};
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Aim) {
  return {"none", "minus_x"};
}

/// Tries the candidate with a pilot; the robot starts turned by that angle from the trial's facing.
using TryOut = std::function<Track(const Pilot& pilot, double start_turn_rad)>;

/// A fitness function; its parameters are those that have an effect.
struct Fitness {
  FitnessRule rule = FitnessRule::displacement_minus_x;
  Aim aim = Aim::none;
  double turn_angle_rad = 0.7;
  double decision_s = 2.0;
  double start_turn_rad = std::numbers::pi / 2.0;

  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, const Visit& visit) {
    if (self.rule == FitnessRule::displacement_minus_x) {
      visit(FieldText{"aim", {}, "none or minus_x (steered)"}, self.aim);
    } else {
      visit(FieldText{"turn_angle_rad", between(0.0, std::numbers::pi), "absolute value of the target angle"},
            self.turn_angle_rad);
      visit(FieldText{"decision_s", above(0.0), "time between two changes of the target angle"}, self.decision_s);
      visit(FieldText{"start_turn_rad", between(0.0, std::numbers::pi), "how far -x is to the side at first"},
            self.start_turn_rad);
    }
  }

  /// The score of a candidate, higher is better. No random draws.
  [[nodiscard]] double score(const TryOut& try_out) const;
};

/// All parameters of a pre-experiment but its backend's. The defaults are the paper's (Sec. "Targeted Steering"): 20 generations,
/// population 20, 20 parents, 20 children, round-robin tournament, 50 s an evaluation, displacement towards the negative x-axis.
/// Survivors come from parents and children together.
struct Params {
  Table table = Table::paper;
  std::uint64_t seed = 1;
  std::string robot = "spider";
  Plan plan = {};
  Selection parent_selection = {};
  Selection survivor_selection = {};
  Fitness fitness = {};
  control::steering::TargetedSteering::Params steering = {};
  Variation variation = {};
  Trial trial = {};
  Physics physics = {};

  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, const Visit& visit) {
    visit(FieldText{"seed", any_seed(), "seed of all random numbers"}, self.seed);
    visit(FieldText{"robot", {}, "name or path of a robot file"}, self.robot);
    visit(FieldText{"plan"}, self.plan);
    visit(FieldText{"parent_selection"}, self.parent_selection);
    visit(FieldText{"survivor_selection"}, self.survivor_selection);
    visit(FieldText{"fitness"}, self.fitness);
    visit(FieldText{"steering"}, self.steering);
    visit(FieldText{"variation"}, self.variation);
    visit(FieldText{"trial"}, self.trial);
    visit(FieldText{"physics"}, self.physics);
  }
};

/// The parameters of a table with a fitness. The released code's: 20 s an evaluation, timestep 0.0005 s with RK4, tournaments of
/// 2 (two distinct parents for each child), steering closed on the heading with exponent 4, the core's x-axis along -x at the
/// start, no control in the first period, the lighter core. Survivors of its tournaments are out of the next ones; the released
/// code holds one again whose winner was selected before. steered_displacement says how far the robot's forward axis is turned.
[[nodiscard]] Params params_of(Table table, FitnessRule fitness = FitnessRule::displacement_minus_x);

/// All parameters in place, those of the backend last.
[[nodiscard]] ParamRefs param_refs_of(Params& params, BackendChoice& backend);

}  // namespace trophic::gait_evolution
