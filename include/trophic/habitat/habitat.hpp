// SPDX-License-Identifier: MIT
// The models of an ecology: the robot, the arena, the gait.
#pragma once

#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/linkage.hpp>
#include <tuple>

namespace trophic {

/// The models that `EcologyParams` names, loaded, or any others, made by a program.
struct Habitat {
  RobotModel robot;
  Arena arena;
  Gait gait;

  static constexpr auto fields() {
    return std::tuple{field("robot", &Habitat::robot), field("arena", &Habitat::arena), field("gait", &Habitat::gait)};
  }
};

/// Every number of a habitat as text, for fingerprints: params/numbers_text.hpp.
[[nodiscard]] std::string numbers_text(const Habitat& habitat);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/habitat.ipp>
#endif
