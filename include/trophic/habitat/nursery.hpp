// SPDX-License-Identifier: MIT
// The contract of a nursery, in which newborns walk before birth.
#pragma once

#include <optional>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// An arena with one robot at a time, with the physics and the control of the ecology. Nothing there affects the ecology.
class Nursery {
 public:
  virtual ~Nursery() = default;

  /// The distance in metres that this robot covers with this gait in `duration_s` of simulated time, in the direction that it
  /// faces at the start; negative if it walks backwards. Empty if its motion diverges. A pure function.
  [[nodiscard]] virtual std::optional<double> walked_m(const RobotModel& robot, const Gait& gait, double duration_s) const = 0;

 protected:
  Nursery() = default;
  Nursery(const Nursery&) = default;
  Nursery& operator=(const Nursery&) = default;
};

}  // namespace trophic
