// SPDX-License-Identifier: MIT
// Moves bodies through a tick and passes observers the frames that they want.
#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <trophic/backend/any_backend.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/population/phenotype.hpp>
#include <vector>

namespace trophic {

/// The poses of the bodies after some control steps of a tick.
struct KeptFrame {
  std::int64_t step = 0;
  std::vector<Pose> roots;
  std::vector<double> angles_rad;
  std::vector<std::size_t> first_angle;  ///< of each robot

  [[nodiscard]] static KeptFrame of(const AnyBackend& backend, std::int64_t step) {
    KeptFrame kept{.step = step, .roots = {}, .angles_rad = {}, .first_angle = {}};
    for (std::size_t robot = 0; robot < backend.robots(); ++robot) {
      kept.roots.push_back(backend.pose(robot));
      kept.first_angle.push_back(kept.angles_rad.size());
      const std::span<const double> own = backend.joint_angles(robot);
      kept.angles_rad.insert(kept.angles_rad.end(), own.begin(), own.end());
    }
    return kept;
  }
};

/// Passes the observers a frame of the tick that begins at `clock_s`.
inline void show_frame(observe::Audience& audience, const KeptFrame& kept, const Habitat& habitat,
                       std::span<const Phenotype> phenotypes, const observe::FrameTimes& times, double clock_s) {
  const double part = static_cast<double>(kept.step) / static_cast<double>(times.steps);
  audience.frame(observe::Frame{.time_s = clock_s + part * times.tick_s,
                                .times = times,
                                .roots = kept.roots,
                                .joint_angles_rad = kept.angles_rad,
                                .robot = habitat.robot,
                                .arena = habitat.arena,
                                .phenotypes = phenotypes,
                                .first_angle = kept.first_angle},
                 kept.step);
}

/// Moves the bodies through a whole tick, then passes the observers the frames that they want. Observers do not affect the
/// motion: a backend's steps do not depend on where it pauses. Returns false, without frames and with the bodies somewhere in
/// the tick, if `is_cancelled()` returned true between two control steps.
template <class Locomotion, class IsCancelled>
[[nodiscard]] bool advance_in_frames(observe::Audience& audience, Locomotion& locomotion, AnyBackend& backend,
                                     std::span<const double> target_angles_rad, const Habitat& habitat,
                                     std::span<const Phenotype> phenotypes, const observe::FrameTimes& times, double clock_s,
                                     IsCancelled&& is_cancelled) {
  std::vector<KeptFrame> kept;
  for (std::int64_t step = 0; step < times.steps;) {
    const std::int64_t next = audience.next_frame(times, step);
    if (!locomotion.advance(backend, next - step, target_angles_rad, is_cancelled)) return false;
    step = next;
    if (audience.wants_frame(times, step)) kept.push_back(KeptFrame::of(backend, step));
  }
  for (const KeptFrame& frame : kept) show_frame(audience, frame, habitat, phenotypes, times, clock_s);
  return true;
}

/// The same; if an observer cancels the tick, the bodies return to where they were before it, and the result is false.
template <class Locomotion>
[[nodiscard]] bool advance_or_return(observe::Audience& audience, Locomotion& locomotion, AnyBackend& backend,
                                     std::span<const double> target_angles_rad, const Habitat& habitat,
                                     std::span<const Phenotype> phenotypes, const observe::FrameTimes& times, double clock_s) {
  struct Before {
    std::any bodies;
    typename Locomotion::State rhythms;
  };
  std::optional<Before> before;
  if (backend.has_joints() && audience.may_cancel()) before.emplace(Before{backend.save(), locomotion.save()});
  const auto is_cancelled = [&] { return before && audience.cancels_tick(); };
  if (advance_in_frames(audience, locomotion, backend, target_angles_rad, habitat, phenotypes, times, clock_s, is_cancelled)) {
    return true;
  }
  backend.restore(before->bodies);
  locomotion.restore(before->rhythms);
  return false;
}

}  // namespace trophic
