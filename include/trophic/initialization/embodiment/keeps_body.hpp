// SPDX-License-Identifier: MIT
// A newborn takes over the body of the dead individual.
#pragma once

#include <stdexcept>
#include <trophic/initialization/embodiment/contract.hpp>

namespace trophic::initialization::embodiment {

/// Rule: a newborn takes over the body of the dead individual as it stands (Sec. "Birth"). A table whose bodies differ is refused
/// before the run.   Reads: nothing.   Random draws: 0.
struct KeepsBody {
  static constexpr std::string_view name = "keeps_body";
  static constexpr std::string_view source = "paper, Sec. \"Birth\"";
  [[nodiscard]] Pose set_down(const GroundPose&, const RobotModel&, const Arena&, std::span<const PlacedBox>) const {
    throw std::logic_error{"keeps_body: sets no body down"};
  }
};
static_assert(Embodiment<KeepsBody>);

}  // namespace trophic::initialization::embodiment
