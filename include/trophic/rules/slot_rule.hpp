// SPDX-License-Identifier: MIT
// The rule in a slot of a table, by name.
#pragma once

#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic::rules {

/// A policy other than the neutral one of its slot.
struct SlotRule {
  std::string_view kind;  ///< perception, control, reproduction, death, ...
  std::string_view slot;
  std::string_view policy;
  std::string_view source;  ///< the policy's own `source`; empty if it names none
};

}  // namespace trophic::rules
