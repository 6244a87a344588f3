// SPDX-License-Identifier: MIT
// The decisions of a brain outside of an ecology.
#pragma once

#include <functional>
#include <span>
#include <trophic/control/brain/contract.hpp>

namespace trophic {

/// Returns the decision of a brain with these weights for these inputs. A brain with a State has its initial one.
using AskBrain = std::function<control::Decision(std::span<const double> inputs, std::span<const double> weights)>;

}  // namespace trophic
