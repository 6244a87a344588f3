// SPDX-License-Identifier: MIT
// The nursery of an ecology: one robot in the middle of the arena, in the ecology's engine.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/ecology/standing_poses.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Each walk has its own engine with one thread. The robot starts upright, at rest, with target angle 0.
template <control::Steering SteeringRule>
class EngineNursery final : public Nursery {
 public:
  /// All arguments must outlive the nursery.
  EngineNursery(const BackendChoice& choice, const Arena& arena, const Physics& physics, const EcologyParams& ecology,
                const SteeringRule& steering)
      : choice_{choice}, arena_{arena}, physics_{physics}, ecology_{ecology}, steering_{steering} {
    arena_.obstacles.clear();
  }

  [[nodiscard]] std::optional<double> walked_m(const RobotModel& robot, const Gait& gait, double duration_s) const override {
    BackendChoice alone = choice_;
    if (std::size_t* threads = alone.threads()) *threads = 1;
    const auto backend = alone.build(robot, arena_, standing_poses(std::array{GroundPose{}}, robot, arena_), physics_);
    locomotion::Locomotion<SteeringRule> locomotion{robot, gait, steering_, 1, {ecology_.control_hz, ecology_.cpg_integration}};
    const std::int64_t steps = std::max<std::int64_t>(1, std::llround(duration_s * ecology_.control_hz));
    try {
      locomotion.advance(*backend, steps, std::array{0.0}, [] { return false; });
    } catch (const Diverged&) {
      return std::nullopt;
    }
    return backend->pose(0).position_m.x();
  }

 private:
  const BackendChoice& choice_;
  Arena arena_;  ///< without obstacles in the middle
  const Physics& physics_;
  const EcologyParams& ecology_;
  const SteeringRule& steering_;
};

}  // namespace trophic
