// SPDX-License-Identifier: MIT
// How deep the contacts of boxes with each other are.
#pragma once

#include <array>
#include <string_view>

namespace trophic::backend::mujoco {

/// Depth of a contact between a face of a box and another box. MuJoCo up to 3.3.7 reports half of it, so that boxes press each
/// other with less force than a box and a plane do. Contacts of two edges have their whole depth, as have planes and height
/// fields.
enum class BoxDepth {
  engine,  ///< as MuJoCo reports it
  whole
};
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(BoxDepth) {
  return {"engine", "whole"};
}

}  // namespace trophic::backend::mujoco
