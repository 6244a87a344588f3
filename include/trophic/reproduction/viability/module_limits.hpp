// SPDX-License-Identifier: MIT
// Bodies have a bounded number of parts, can be steered, and do not overlap with themselves.
#pragma once

#include <trophic/habitat/body/limits.hpp>
#include <trophic/reproduction/viability/contract.hpp>

namespace trophic::reproduction::viability {

/// Rule: a body is refused if it has more modules or hinges, or fewer hinges, than the limits, if it has no hinge on the left or
/// right side, or if its boxes overlap at rest (habitat/body/limits.hpp).   Reads: the body.   Random draws: 0.
struct ModuleLimits {
  static constexpr std::string_view name = "module_limits";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    body::Limits limits;
    std::size_t attempts = 10;
    static constexpr auto fields() {
      return std::tuple{field("limits", &Params::limits),
                        field("attempts", &Params::attempts, between(1.0, 1000.0),
                              "number of attempted mutations before the offspring keeps the parent's body")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<std::string> refusal(const body::Design& design, const RobotModel& robot) const {
    return body::refusal(design.modules, robot, params.limits);
  }
  [[nodiscard]] std::size_t attempts() const { return params.attempts; }
};
static_assert(Viability<ModuleLimits>);

}  // namespace trophic::reproduction::viability
