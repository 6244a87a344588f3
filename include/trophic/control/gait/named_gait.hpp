// SPDX-License-Identifier: MIT
// A gait from a file, which may differ between species.
#pragma once

#include <trophic/control/gait/contract.hpp>

namespace trophic::control::gait {

/// Rule: each robot walks with the gait that `gait` names, as `ecology.gait` does. `by_species<NamedGait>` gives each species its
/// own. The pattern generator of a body restarts at each birth.   Reads: nothing.   Random draws: 0.
struct NamedGait {
  static constexpr std::string_view name = "named_gait";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    std::string gait;
    static constexpr auto fields() {
      return std::tuple{field("gait", &Params::gait, "name or path of a gait; empty: the robot's own")};
    }
  };
  Params params;

  /// The models to load before the run.
  [[nodiscard]] std::vector<std::string> gaits() const {
    return params.gait.empty() ? std::vector<std::string>{} : std::vector{params.gait};
  }

  [[nodiscard]] Gait express(std::span<const double>, const RobotModel& robot, const Habitat& habitat) const {
    const Gait* gait = params.gait.empty() ? habitat.gait_of(robot) : habitat.gait_named(params.gait);
    if (gait != nullptr) return *gait;
    throw std::invalid_argument{"gait \"" + params.gait + "\" of robot " + robot.name + ": must be a model of the habitat"};
  }
};
static_assert(GaitRule<NamedGait>);

}  // namespace trophic::control::gait
