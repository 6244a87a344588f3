// SPDX-License-Identifier: MIT
// The models of an ecology: the robot, the arena, the gait, and those that rules name.
#pragma once

#include <optional>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// A robot with its own gait, under the name by which rules refer to it.
struct NamedRobot {
  std::string name;
  body::Design design;
  RobotModel robot;
  Gait gait;
  static constexpr auto fields() { return std::tuple{field("robot", &NamedRobot::robot), field("gait", &NamedRobot::gait)}; }
};

/// A gait under the name by which rules refer to it.
struct NamedGait {
  std::string name;
  Gait gait;
  static constexpr auto fields() { return std::tuple{field("gait", &NamedGait::gait)}; }
};

/// The loaded models that `EcologyParams` names, or any models made by a program.
struct Habitat {
  RobotModel robot;
  Arena arena;
  Gait gait;
  std::optional<body::Design> design = {};  ///< design of `robot`: evolving bodies have its masses, servos and friction
  std::vector<NamedRobot> robots = {};      ///< robots that the rule BodyPlan names
  std::vector<NamedGait> gaits = {};        ///< gaits that the rule Gait names

  /// The robot or the gait that a rule names; null if it is not loaded.
  [[nodiscard]] const NamedRobot* robot_named(std::string_view name) const;
  [[nodiscard]] const Gait* gait_named(std::string_view name) const;
  /// A robot's own gait; null for a robot that is not in this habitat.
  [[nodiscard]] const Gait* gait_of(const RobotModel& one) const;

  static constexpr auto fields() {
    return std::tuple{field("robot", &Habitat::robot), field("arena", &Habitat::arena), field("gait", &Habitat::gait)};
  }
};

/// The models that rules name, to be loaded with those of EcologyParams.
struct ModelNames {
  std::vector<std::string> robots;
  std::vector<std::string> gaits;
  bool needs_design = false;  ///< whether rules need the design of `ecology.robot`
};

/// All numbers of a habitat as text, for fingerprints: params/numbers_text.hpp. Models that rules name follow if there are any.
[[nodiscard]] std::string numbers_text(const Habitat& habitat);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/habitat.ipp>
#endif
