// SPDX-License-Identifier: MIT
// The simulation of one rule table, which gives a program access to its parameters and states.
#pragma once

#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/habitat.hpp>

namespace trophic {

template <class Rules>
struct RuleStates;

/// A Simulation with the members whose types depend on its table. Dynamics is its only implementation.
template <class Rules>
class TableSimulation : public Simulation {
 public:
  [[nodiscard]] virtual const Experiment<Rules>& params() const = 0;
  [[nodiscard]] virtual const Habitat& habitat() const = 0;
  [[nodiscard]] virtual const RuleStates<Rules>& states() const = 0;
};

}  // namespace trophic
