// SPDX-License-Identifier: MIT
// Which rule chose the parent of a newborn, for errors about that parent.
#pragma once

#include <string_view>
#include <trophic/population/individual.hpp>

namespace trophic {

/// The slot that chooses a parent for the successor of someone who died of that cause.
[[nodiscard]] inline std::string_view parent_slot(Cause cause) {
  switch (cause) {
    case Cause::caught:
      return "capture_parent";
    case Cause::starved:
      return "starvation_parent";
    case Cause::sacrificed:
      return "rescue_parent";
    case Cause::senescence:
      break;
  }
  return "senescence_parent";
}

}  // namespace trophic
