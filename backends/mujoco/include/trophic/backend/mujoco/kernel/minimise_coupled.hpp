// SPDX-License-Identifier: MIT
// The search of robots whose links touch each other or a height field, one set of them after the other.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <trophic/backend/mujoco/kernel/coupled.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// For each lane, the lanes that contacts between links tie its robot to, itself among them.
[[nodiscard]] inline std::array<unsigned, lane_count> tied_lanes(const Workspace& work) {
  std::array<unsigned, lane_count> tied{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) tied[lane] = 1u << lane;
  for (const LinkContact& contact : work.link_contacts) {
    const unsigned both = tied[contact.lane[0]] | tied[contact.lane[1]];
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if ((both & (1u << lane)) != 0) tied[lane] = both;
    }
  }
  return tied;
}

/// Keeps the trial point of the lanes of `taken`.
TROPHIC_LANES_INLINE void keep_trial(Workspace& work, const Mask& taken) {
  std::vector<TrialPoint>& kept = work.coupled.trials;
  kept.resize(work.links.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].link.angular = select(taken, work.links[i].trial.angular, kept[i].link.angular);
    kept[i].link.linear = select(taken, work.links[i].trial.linear, kept[i].link.linear);
    if (i > 0) kept[i].hinge = select(taken, work.hinges[i - 1].trial, kept[i].hinge);
  }
}

/// Makes what was kept the trial point of all lanes.
TROPHIC_LANES_INLINE void take_kept_trial(Workspace& work) {
  const std::vector<TrialPoint>& kept = work.coupled.trials;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    work.links[i].trial = kept[i].link;
    if (i > 0) work.hinges[i - 1].trial = kept[i].hinge;
  }
}

/// Minimises the cost of the robots in `coupled`, set by set of robots that touch, as `trial` of links and hinges; that of the
/// other lanes stays. Returns the lanes that did not settle.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned minimise_coupled(const KernelModel& model, const LaneState& state, Workspace& work,
                                                             unsigned coupled) {
  const std::array<unsigned, lane_count> tied = tied_lanes(work);
  keep_trial(work, mask_of(all_lanes));
  unsigned unsettled = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const bool first = static_cast<std::size_t>(std::countr_zero(tied[lane])) == lane;
    if ((coupled & (1u << lane)) == 0 || !first) continue;
    if (!CoupledSearch{model, work, tied[lane]}.minimise(state)) unsettled |= tied[lane];
    keep_trial(work, mask_of(tied[lane]));
  }
  take_kept_trial(work);
  return unsettled;
}

}  // namespace trophic::backend::kernel
