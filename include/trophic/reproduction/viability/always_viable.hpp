// SPDX-License-Identifier: MIT
// Every body that can be built may be born.
#pragma once

#include <trophic/reproduction/viability/contract.hpp>

namespace trophic::reproduction::viability {

/// Rule: no body is refused; a mutation that cannot be built is not retried.   Reads: nothing.   Random draws: 0.
struct AlwaysViable {
  static constexpr std::string_view name = "always_viable";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::optional<std::string> refusal(const body::Design&, const RobotModel&) const { return std::nullopt; }
  [[nodiscard]] std::size_t attempts() const { return 1; }
};
static_assert(Viability<AlwaysViable>);

}  // namespace trophic::reproduction::viability
