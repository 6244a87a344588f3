// SPDX-License-Identifier: MIT
// Body plans drawn by hand, as text.
#pragma once

#include <trophic/habitat/body/plan.hpp>

namespace hand {

/// The paper's spider: four legs of a hinge and a brick.
inline constexpr const char* spider =
    "core[front:hinge0[front:brick0] back:hinge1[front:brick0] left:hinge0[front:brick0] right:hinge1[front:brick0]]";
/// Core and four bricks: a plus.
inline constexpr const char* plus = "core[front:brick0 back:brick0 left:brick0 right:brick0]";
/// Core, hinge, brick, hinge, brick: a straight line.
inline constexpr const char* snake = "core[front:hinge0[front:brick0[front:hinge0[front:brick0]]]]";
/// A leg on the left side only.
inline constexpr const char* one_leg = "core[left:hinge0[front:brick0]]";
/// A brick at the front that carries a hinge on its left.
inline constexpr const char* hook = "core[front:brick0[left:hinge0]]";

}  // namespace hand
