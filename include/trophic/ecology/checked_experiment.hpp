// SPDX-License-Identifier: MIT
// An experiment's numbers with the habitat that they name, checked before the simulation.
#pragma once

#include <concepts>
#include <string_view>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <utility>

namespace trophic {

/// Checks that numbers are within their bounds, that the gait fits the robot, and that the rules can steer the robot.
template <class Rules>
struct CheckedExperiment {
  Experiment<Rules> params;
  BackendChoice backend;
  Habitat habitat;
};

/// Throws std::invalid_argument naming field, value and bound, or a robot that the rules cannot steer.
template <class Rules>
[[nodiscard]] CheckedExperiment<Rules> checked(Experiment<Rules> params, BackendChoice backend, Habitat habitat) {
  validate(params, "");
  backend.validate("backend");
  check_fit(habitat.gait, habitat.robot);
  if (backend.has_joints()) {
    locomotion::check_steerable(habitat.robot, make_policy<typename Rules::Steering>(params.rules.steering, "steering"));
  }
  return {std::move(params), std::move(backend), std::move(habitat)};
}

/// Loads the models that `params.ecology` names, using trophic/habitat/load/habitat.hpp. Throws as `checked`, and
/// std::runtime_error for a missing or invalid file.
template <class Rules>
[[nodiscard]] CheckedExperiment<Rules> load_checked(Experiment<Rules> params, BackendChoice backend, std::string_view installed) {
  validate(params, "");
  backend.validate("backend");
  if constexpr (requires { load_habitat(params.ecology, installed); }) {
    Habitat habitat = load_habitat(params.ecology, installed);
    if (params.ecology.gait.empty()) params.ecology.gait = habitat.robot.gait;
    return checked(std::move(params), std::move(backend), std::move(habitat));
  } else {
    static_assert(std::same_as<Rules, void>,
                  "Ecology(params, backend) reads the robot, arena and gait that params.ecology names, and this program has no "
                  "reader of model files: include <trophic/run.hpp> or <trophic/habitat/load/habitat.hpp>, or give the ecology a "
                  "Habitat as its third argument");
  }
}

}  // namespace trophic
