// SPDX-License-Identifier: MIT
// What happens to a body's gait at a birth.
#pragma once

#include <array>
#include <string_view>

namespace trophic {

/// The phase of a body's pattern generator when a new individual takes over the body. `kept`: the rhythm continues, as in the
/// released code. `reset`: it starts anew. The paper is silent.
enum class PhaseAtBirth { kept, reset };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(PhaseAtBirth) {
  return {"kept", "reset"};
}

}  // namespace trophic
