// SPDX-License-Identifier: MIT
// All robots have the same body.
#pragma once

#include <trophic/reproduction/body_plan/contract.hpp>

namespace trophic::reproduction::body_plan {

/// Rule: every individual has the robot that `ecology.robot` names (Sec. "Robot Body and Environment").   Reads: nothing.
/// Random draws: 0.
struct OneBody {
  static constexpr std::string_view name = "one_body";
  static constexpr std::string_view source = "paper, Sec. \"Robot Body and Environment\"";
  [[nodiscard]] body::Design grow(std::span<const double>, Species, const Habitat& habitat) const {
    return habitat.design.value_or(body::Design{});
  }
};
static_assert(BodyPlan<OneBody>);

}  // namespace trophic::reproduction::body_plan
