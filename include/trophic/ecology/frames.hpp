// SPDX-License-Identifier: MIT
// Moves bodies through a tick and shows observers the frames that they ask for on the way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/frame.hpp>
#include <vector>

namespace trophic {

/// Shows the audience where the bodies are after `step` control steps of the tick that begins at `clock_s`, if one of it wants to
/// know.
template <class Audience, Backend B>
void show_frame(Audience& audience, const B& backend, const Habitat& habitat, const observe::FrameTimes& times, double clock_s,
                std::int64_t step) {
  if (!audience.wants_frame(times, step)) return;
  std::vector<Pose> roots;
  std::vector<double> angles_rad;
  for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
    roots.push_back(backend.pose(robot));
    const std::span<const double> own = backend.joint_angles(robot);
    angles_rad.insert(angles_rad.end(), own.begin(), own.end());
  }
  const double part = static_cast<double>(step) / static_cast<double>(times.steps);
  audience.frame(observe::Frame{.time_s = clock_s + part * times.tick_s,
                                .times = times,
                                .roots = roots,
                                .joint_angles_rad = angles_rad,
                                .robot = habitat.robot,
                                .arena = habitat.arena},
                 step);
}

/// Moves the bodies through a whole tick. They move as without an audience: a backend's steps do not depend on where it is asked
/// to pause.
template <class Audience, class Locomotion, Backend B>
void advance_in_frames(Audience& audience, Locomotion& locomotion, B& backend, std::span<const double> target_angles_rad,
                       const Habitat& habitat, const observe::FrameTimes& times, double clock_s) {
  for (std::int64_t step = 0; step < times.steps;) {
    const std::int64_t next = audience.next_frame(times, step);
    locomotion.advance(backend, next - step, target_angles_rad);
    step = next;
    show_frame(audience, backend, habitat, times, clock_s, step);
  }
}

}  // namespace trophic
