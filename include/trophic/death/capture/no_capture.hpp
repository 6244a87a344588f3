// SPDX-License-Identifier: MIT
// No individual is caught.
#pragma once

#include <trophic/death/capture/contract.hpp>

namespace trophic::death::capture {

/// Rule: hunters never catch. This is the control without predation.   Reads: nothing.   Random draws: 0.
struct NoCapture {
  static constexpr std::string_view name = "no_capture";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::vector<Capture> captures(const View&, Rng&) const { return {}; }
};
static_assert(CaptureRule<NoCapture>);

}  // namespace trophic::death::capture
