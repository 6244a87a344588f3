// SPDX-License-Identifier: MIT
// Robots simulated with the Open Dynamics Engine.
#pragma once

#include <string>
#include <string_view>
#include <trophic/backend/ode/params.hpp>
#include <trophic/backend/ode/state.hpp>
#include <trophic/backend/with_engine.hpp>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::backend {

/// ODE as a backend. Satisfies JointDriven, Embodying and Placing. Steps are semi-implicit Euler on velocities, for any
/// integrator in Physics (ODE has no other; `remarks` reports it), with servos, contacts, friction and joint limits solved
/// implicitly within the step. Boxes touch the floor, the walls or the height field, other robots, and links of their own robot
/// that are not joined to theirs by a hinge. Links are free bodies joined by constraints, so a hinge's anchor drifts by
/// micrometres under load.
///
/// SI units. No random draws from the library's streams. Results are bitwise independent of `Params::threads`. Errors:
/// std::invalid_argument on construction; Diverged if ODE reports an error or a robot leaves the arena or is unphysically fast:
/// the backend then still holds the last valid state. Must not be called from several threads at once; several backends may run
/// in several threads.
class Ode : public WithEngine<ode::State> {
 public:
  static constexpr std::string_view name = "ode";
  [[nodiscard]] static std::string version();
  [[nodiscard]] static std::vector<std::string> remarks(const Physics& physics);

  using Params = ode::Params;

  /// Throws std::invalid_argument for a number outside its bound, no robots, a start pose outside the arena, a hinge range
  /// above 3 rad, and all that validate(RobotModel) rejects.
  Ode(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params& params);

 private:
  class Simulation;
};
static_assert(Embodying<Ode> && Placing<Ode>);

}  // namespace trophic::backend

#if TROPHIC_HEADER_ONLY
#include <trophic/backend/ode.ipp>
#endif
