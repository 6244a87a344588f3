// SPDX-License-Identifier: MIT
// An experiment's numbers with the habitat that they name, checked before anything is simulated.
#pragma once

#include <concepts>
#include <trophic/backend/contract.hpp>
#include <trophic/control/locomotion/steerable.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/params/params.hpp>
#include <trophic/params/policy.hpp>
#include <utility>

namespace trophic {

/// Numbers within their bounds, and a robot that has this gait and that the rules can steer.
template <class Rules, Backend B>
struct CheckedExperiment {
  Experiment<Rules, B> params;
  Habitat habitat;
};

/// Throws std::invalid_argument naming field, value and bound, or a robot that the rules cannot steer.
template <class Rules, Backend B>
[[nodiscard]] CheckedExperiment<Rules, B> checked(Experiment<Rules, B> params, Habitat habitat) {
  validate(params, "");
  check_fit(habitat.gait, habitat.robot);
  if constexpr (JointDriven<B>) {
    locomotion::check_steerable(habitat.robot, make_policy<typename Rules::Steering>(params.rules.steering, "steering"));
  }
  return {std::move(params), std::move(habitat)};
}

/// Loads the models that `params.ecology` names, by trophic/habitat/load/habitat.hpp. Throws as `checked` does,
/// std::runtime_error for a missing or broken file.
template <class Rules, Backend B>
[[nodiscard]] CheckedExperiment<Rules, B> load_checked(Experiment<Rules, B> params) {
  validate(params, "");
  if constexpr (requires { load_habitat(params.ecology); }) {
    Habitat habitat = load_habitat(params.ecology);
    if (params.ecology.gait.empty()) params.ecology.gait = habitat.robot.gait;
    return checked<Rules, B>(std::move(params), std::move(habitat));
  } else {
    static_assert(std::same_as<Rules, void>,
                  "an Ecology made from numbers alone reads model files: #include <trophic/habitat/load/habitat.hpp>");
  }
}

}  // namespace trophic
