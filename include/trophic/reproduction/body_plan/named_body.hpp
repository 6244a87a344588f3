// SPDX-License-Identifier: MIT
// The robot of a file, which may differ between species.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>

namespace trophic::reproduction::body_plan {

/// Rule: each individual has the robot that `robot` names, as `ecology.robot` does. `by_species<NamedBody>` gives each species
/// its own: spiders that hunt geckos. Without a rule Gait, each robot uses the gait that its file names.   Reads: the
/// species.   Random draws: 0.
struct NamedBody {
  static constexpr std::string_view name = "named_body";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    std::string robot;
    static constexpr auto fields() {
      return std::tuple{field("robot", &Params::robot, "name or path of a robot file; empty: that of ecology.robot")};
    }
  };
  Params params;

  /// The models to load before the run.
  [[nodiscard]] std::vector<std::string> robots() const {
    return params.robot.empty() ? std::vector<std::string>{} : std::vector{params.robot};
  }

  [[nodiscard]] body::Design grow(std::span<const double> genes, Species, const Habitat& habitat) const {
    if (!genes.empty()) throw std::invalid_argument{"genes of a body: must be absent with the rule named_body"};
    if (params.robot.empty() && habitat.design) return *habitat.design;
    if (const NamedRobot* named = habitat.robot_named(params.robot)) return named->design;
    throw std::invalid_argument{"robot \"" + params.robot + "\": must be a model of the habitat"};
  }
};
static_assert(BodyPlan<NamedBody>);

}  // namespace trophic::reproduction::body_plan
