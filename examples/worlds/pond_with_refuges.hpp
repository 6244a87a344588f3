// SPDX-License-Identifier: MIT
// The pond with places at which prey are safe.
#pragma once

#include <trophic/death/capture/catch_outside_refuges.hpp>
#include <trophic/rules/with.hpp>

#include "worlds/pond.hpp"

namespace trophic::worlds {

inline constexpr auto in_refuges = [](EcologyParams& ecology) { ecology.arena = "refuges"; };

/// As Pond, in the arena `refuges`, whose four zones named refuge cover an eighth of the floor: no prey is caught there.
using PondWithRefuges =
    named<with_ecology<with_capture<Pond, death::capture::CatchOutsideRefuges>, in_refuges>, "pond_with_refuges">;

}  // namespace trophic::worlds
