// SPDX-License-Identifier: MIT
// A gait: the weights of one robot's CPG, as data.
#pragma once

#include <Eigen/Core>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic {

struct RobotModel;

/// Weights of a CPG with one oscillator per hinge (Sec. "Robot Controller"). Formulas: control/locomotion/cpg.hpp.
struct Gait {
  std::string name;
  std::string robot;                ///< the robot that it was evolved for; informative, `check_fit` compares hinges
  std::string provenance;           ///< the origin of the numbers
  std::vector<std::string> hinges;  ///< names in the order of RobotModel::hinges; n of them
  Eigen::VectorXd internal;         ///< n weights w_i between x_i and y_i
  Eigen::MatrixXd coupling;         ///< n x n, antisymmetric: c_ij between x_i and x_j; 0 if not coupled

  bool operator==(const Gait&) const = default;

  static constexpr auto fields() {
    return std::tuple{field("name", &Gait::name),     field("robot", &Gait::robot),       field("provenance", &Gait::provenance),
                      field("hinges", &Gait::hinges), field("internal", &Gait::internal), field("coupling", &Gait::coupling)};
  }
};

/// Throws std::invalid_argument unless sizes agree, all weights are finite and the coupling is antisymmetric.
void validate(const Gait& gait);

/// Throws std::invalid_argument unless the gait names the robot's hinges in the robot's order and couples only neighbours.
void check_fit(const Gait& gait, const RobotModel& robot);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/gait.ipp>
#endif
