// SPDX-License-Identifier: MIT
// The contract of a slot: the pose in which a newborn's body replaces the old one.
#pragma once

#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/touch.hpp>
#include <trophic/support/units.hpp>

#define TROPHIC_SENTENCE_Embodiment                                                                                        \
  "Pose set_down(const GroundPose& place, const RobotModel&, const Arena&, std::span<const PlacedBox> others) const; see " \
  "trophic/initialization/embodiment/contract.hpp"

namespace trophic::initialization {

/// What happens if the engine can no longer compute the motion of a body.
enum class Divergence { ends_run, ends_individual };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Divergence) {
  return {"ends_run", "ends_individual"};
}

/// `set_down(place, robot, arena, others)`: returns the root pose in which a newborn's body appears, joint angles 0; `place` is
/// where the old body stood, `others` are the boxes of all robots near it. It always returns a pose, because a death cannot be
/// refused. It is called only if bodies differ; bodies born in one tick are put in place in the order of their births. Optional:
/// `Divergence divergence() const`; without it a body that diverges ends the run.
template <class P>
concept Embodiment = requires(const P policy, const GroundPose& place, const RobotModel& robot, const Arena& arena,
                              std::span<const PlacedBox> others) {
  { policy.set_down(place, robot, arena, others) } -> std::same_as<Pose>;
};

namespace ask {

template <class P>
[[nodiscard]] Divergence divergence([[maybe_unused]] const P& policy) {
  if constexpr (requires { policy.divergence(); }) return policy.divergence();
  return Divergence::ends_run;
}

}  // namespace ask

}  // namespace trophic::initialization
