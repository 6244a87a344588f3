// SPDX-License-Identifier: MIT
// The paper's cognitive brain: a fully connected tanh network of three hidden neurons, without biases.
#pragma once

#include <trophic/control/brain/cognitive_network.hpp>

namespace trophic::control::brain {

/// The paper's brain (Sec. "Cognitive Brain", which names no bias): hidden = tanh(W1 in), out = tanh(W2 hidden). The paper does
/// not give the hidden size; 3 is from the released code. That code's genome has biases and mutates them, but the line that adds
/// them is commented out in every published run. At an angle output of 0 the robot turns left. Genome: W1 (3 rows with one weight
/// per input), W2 (2x3): 15 weights for three inputs.
using CognitiveBrain = CognitiveNetwork<Biases::none, ZeroTurns::left>;
static_assert(Brain<CognitiveBrain>);

}  // namespace trophic::control::brain
