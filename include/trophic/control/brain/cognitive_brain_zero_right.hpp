// SPDX-License-Identifier: MIT
// The released code's cognitive brain: an angle output of zero turns right.
#pragma once

#include <trophic/control/brain/cognitive_network.hpp>

namespace trophic::control::brain {

/// Like CognitiveBrain, but an angle output of exactly 0 counts as positive, so the robot turns right (released code). This
/// happens if all inputs are 0, because the network has no biases.
using CognitiveBrainZeroRight = CognitiveNetwork<Biases::none, ZeroTurns::right>;
static_assert(Brain<CognitiveBrainZeroRight>);

}  // namespace trophic::control::brain
