// SPDX-License-Identifier: MIT
// What the cognitive brain is told.
#pragma once

namespace trophic::perception {

/// What the cognitive brain is told, each in [-1, 1] (Sec. "Inputs").
struct BrainInputs {
  double angle = 0.0;
  double distance = 0.0;
  double tag_ratio = 0.0;
  friend bool operator==(const BrainInputs&, const BrainInputs&) = default;
};

}  // namespace trophic::perception
