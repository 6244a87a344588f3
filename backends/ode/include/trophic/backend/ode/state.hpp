// SPDX-License-Identifier: MIT
// The state of the ODE backend between two steps.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace trophic::backend::ode {

/// A link: position of its centre of mass, rotation (w, x, y, z) of its frame, velocities in world axes.
struct LinkState {
  std::array<double, 3> position_m{};
  std::array<double, 4> rotation{1.0, 0.0, 0.0, 0.0};
  std::array<double, 3> velocity_m_s{};
  std::array<double, 3> spin_rad_s{};
  bool operator==(const LinkState&) const = default;
  static constexpr auto saved() {
    return std::tuple{&LinkState::position_m, &LinkState::rotation, &LinkState::velocity_m_s, &LinkState::spin_rad_s};
  }
};

/// A whole backend, robot by robot. ODE keeps no warm start, contact joints live for one step, forces are zero between steps
/// and nothing sleeps: there is no other state.
struct State {
  std::uint64_t steps = 0;
  std::vector<LinkState> links;       ///< robot by robot
  std::vector<double> angles_rad;     ///< robot by robot
  std::vector<double> targets_rad;    ///< robot by robot, clipped
  std::vector<std::uint64_t> bodies;  ///< body_hash of each robot
  std::vector<std::uint8_t> absent;   ///< one per robot: 1 if it is not in the world
  bool operator==(const State&) const = default;
  static constexpr auto saved() {
    return std::tuple{&State::steps, &State::links, &State::angles_rad, &State::targets_rad, &State::bodies, &State::absent};
  }
};

}  // namespace trophic::backend::ode
