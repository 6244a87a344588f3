// SPDX-License-Identifier: MIT
// The paper's cognitive brain: a fully connected tanh network of three hidden neurons, without biases.
#pragma once

#include <trophic/control/brain/cognitive_network.hpp>

namespace trophic::control::brain {

/// The paper's brain (Sec. "Cognitive Brain", which names no bias): hidden = tanh(W1 in), out = tanh(W2 hidden). The paper states
/// no hidden size; 3 is the released code's. That code's genome carries biases and mutates them, but the line that adds them is
/// commented out in every published run. An angle output of 0 turns left. Genome: W1 (3 rows of one weight an input), W2 (2x3):
/// 15 weights for three inputs.
using CognitiveBrain = CognitiveNetwork<Biases::none, ZeroTurns::left>;
static_assert(Brain<CognitiveBrain>);

}  // namespace trophic::control::brain
