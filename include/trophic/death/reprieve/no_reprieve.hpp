// SPDX-License-Identifier: MIT
// Nobody is spared.
#pragma once

#include <string_view>
#include <trophic/death/reprieve/contract.hpp>

namespace trophic::death::reprieve {

/// Rule: hunger alone decides.   Reads: nothing.   Random draws: 0.
struct NoReprieve {
  static constexpr std::string_view name = "no_reprieve";
  static constexpr std::string_view source = "control";
  [[nodiscard]] bool spared(BodyIndex, const View&) const { return false; }
};
static_assert(Reprieve<NoReprieve>);

}  // namespace trophic::death::reprieve
