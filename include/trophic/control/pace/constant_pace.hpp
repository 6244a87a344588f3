// SPDX-License-Identifier: MIT
// One pace for all robots, or one per species.
#pragma once

#include <trophic/control/pace/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::control::pace {

/// Rule: `factor` multiplies the gait's frequency; with by_species, predators can walk 1.3 times as fast as prey, or plants stand
/// still. With joints, speed grows more slowly than the frequency: the spider needs 1.4 to be 1.3 to 1.4 times as fast. The
/// factor is a free parameter.   Reads: nothing.   Random draws: 0.
struct ConstantPace {
  static constexpr std::string_view name = "constant_pace";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double factor = 1.0;
    static constexpr auto fields() {
      return std::tuple{
          field("factor", &Params::factor, between(0.0, 10.0), "fraction of the gait's frequency; 0: the robot stands still")};
    }
  };
  Params params;

  [[nodiscard]] double pace(BodyIndex, const View&) const { return params.factor; }
};
static_assert(Pace<ConstantPace>);

}  // namespace trophic::control::pace
