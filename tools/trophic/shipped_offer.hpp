// SPDX-License-Identifier: MIT
// The tables that trophic ships, on the backends that its program is linked with.
#pragma once

#include <tools/command/offers.hpp>

namespace trophic::command {

[[nodiscard]] Offer shipped_offer();

}  // namespace trophic::command
