// SPDX-License-Identifier: MIT
// All individuals act together.
#pragma once

#include <trophic/energy/order/contract.hpp>

namespace trophic::energy::order {

/// Rule: all individuals spend and bite, then all catches happen, then all deaths, then all births (Dynamics).   Reads: nothing.
/// Random draws: 0.
struct Together {
  static constexpr std::string_view name = "together";
  static constexpr std::string_view source = "paper: no such rule";
  [[nodiscard]] bool in_turn() const { return false; }
};
static_assert(Order<Together>);

}  // namespace trophic::energy::order
