// SPDX-License-Identifier: MIT
// All parameters of an experiment except its backend's, in one aggregate.
#pragma once

#include <cmath>
#include <stdexcept>
#include <trophic/ecology/history.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/null.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// All parameters of an experiment except those of its backend (BackendChoice). The defaults are the parameters of the rule
/// table.
template <class Rules>
struct Experiment {
  std::uint64_t seed = 1;
  EcologyParams ecology = Rules::ecology();
  Physics physics = Rules::physics();
  RuleParams<Rules> rules{};
  Null null = Null::none;      ///< files cannot set it
  SharedHistory history = {};  ///< for the neutral null: the run that it repeats
  /// If not empty, the run is a contest of these individuals, one per robot, all active from the start: robots move, perceive and
  /// decide, but there are no activations, catches, deaths or births. Files cannot set it.
  Lineup lineup = {};

  template <class Self, class Visitor>
  static constexpr void visit_fields(Self& experiment, Visitor&& visit) {
    visit(FieldText{"seed", any_seed(), "seed of all random numbers"}, experiment.seed);
    visit(FieldText{"ecology"}, experiment.ecology);
    visit(FieldText{"physics"}, experiment.physics);
    visit(FieldText{"rules"}, experiment.rules);
  }
};

/// The same seed and parameters under a null.
template <class Rules>
[[nodiscard]] Experiment<Rules> under(Null null, Experiment<Rules> experiment) {
  experiment.null = std::move(null);
  return experiment;
}

/// Control steps in one tick.
[[nodiscard]] inline std::int64_t control_steps_per_tick(const EcologyParams& ecology) {
  return std::llround(ecology.tick_s * ecology.clock_scale * ecology.control_hz);
}

/// Throws std::invalid_argument unless the control steps in a tick are a whole number >= 1 and, for a backend with joints, no
/// physics step is longer than a control step.
inline void check_control_steps(const EcologyParams& ecology, const Physics& physics, bool has_joints) {
  const double steps = ecology.tick_s * ecology.clock_scale * ecology.control_hz;
  const double whole = std::round(steps);
  if (whole < 1.0 || std::abs(steps - whole) > 1e-6) {
    throw std::invalid_argument{"ecology.tick_s = " + number_text(ecology.tick_s) + ": tick_s * clock_scale * control_hz = " +
                                number_text(steps) + " control steps, must be a whole number >= 1"};
  }
  constexpr double most_steps = 1e6;  // limit for a tick, whose frames are stored until its end because it may be cancelled
  constexpr double most_simulated_s = 3600.0;
  if (whole > most_steps || ecology.tick_s * ecology.clock_scale > most_simulated_s) {
    throw std::invalid_argument{"ecology.tick_s = " + number_text(ecology.tick_s) + ": a tick has " +
                                number_text(ecology.tick_s * ecology.clock_scale) + " simulated seconds and " +
                                number_text(steps) + " control steps: must have <= " + number_text(most_simulated_s) +
                                " and <= " + number_text(most_steps)};
  }
  if (has_joints && physics.timestep_s * ecology.control_hz > 1.0) {
    throw std::invalid_argument{"physics.timestep_s = " + number_text(physics.timestep_s) +
                                ": must be <= " + number_text(1.0 / ecology.control_hz) + ", the control period"};
  }
}

}  // namespace trophic
