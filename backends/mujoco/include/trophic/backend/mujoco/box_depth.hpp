// SPDX-License-Identifier: MIT
// The depth of contacts between boxes.
#pragma once

#include <array>
#include <string_view>

namespace trophic::backend::mujoco {

/// Depth of a contact between a face of a box and another box. MuJoCo up to 3.3.7 reports half of it, so that the contact force
/// between boxes is smaller than between a box and a plane. Contacts of two edges have their whole depth; so do contacts with
/// planes and height fields.
enum class BoxDepth {
  engine,  ///< as MuJoCo reports it
  whole
};
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(BoxDepth) {
  return {"engine", "whole"};
}

}  // namespace trophic::backend::mujoco
