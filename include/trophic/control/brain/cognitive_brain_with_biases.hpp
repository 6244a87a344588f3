// SPDX-License-Identifier: MIT
// The cognitive brain with a bias in every neuron.
#pragma once

#include <trophic/control/brain/cognitive_network.hpp>

namespace trophic::control::brain {

/// Like CognitiveBrain, but with biases on both layers: hidden = tanh(W1 in + b1), out = tanh(W2 hidden + b2). Neither the
/// paper's text nor its published runs have them. A bias can make a robot turn to one side or show one tag independently of its
/// inputs. Genome: W1 (3 rows with one weight per input), b1 (3), W2 (2x3), b2 (2): 20 weights for three inputs.
using CognitiveBrainWithBiases = CognitiveNetwork<Biases::both_layers, ZeroTurns::left>;
static_assert(Brain<CognitiveBrainWithBiases>);

}  // namespace trophic::control::brain
