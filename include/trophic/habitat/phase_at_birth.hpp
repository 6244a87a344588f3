// SPDX-License-Identifier: MIT
// A body's gait at a birth.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// The phase of a body's pattern generator when a new individual takes over the body. `kept`: it continues, as in the released
/// code. `reset`: it restarts. The paper is silent.
enum class PhaseAtBirth { kept, reset };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(PhaseAtBirth) {
  return {"kept", "reset"};
}

}  // namespace trophic
