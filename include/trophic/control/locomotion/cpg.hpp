// SPDX-License-Identifier: MIT
// Central pattern generator: coupled linear oscillators, one per hinge.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/params/params.hpp>

namespace trophic::locomotion {

/// CPG of one gait (Sec. "Robot Controller"): X' = W X with X = [x_0 .. x_{n-1}, y_0 .. y_{n-1}], W[i][n+i] = w_i, W[n+i][i] =
/// -w_i, and for i < j W[i][j] = c_ij, W[j][i] = -c_ij. Output i is x_i; the servos clip it after steering. All states start at
/// sqrt(2)/2. No random draws.
///
/// The class holds no robot state: the states of many robots are the columns of one 2n x robots matrix that the caller owns. Each
/// column's result is bitwise independent of the other columns.
class Cpg {
 public:
  struct Params {
    CpgIntegration integration = CpgIntegration::exact;
    double step_s = 1.0 / 60.0;

    static constexpr auto fields() {
      return std::tuple{field("integration", &Params::integration, "exact or rk4"),
                        field("step_s", &Params::step_s, above_to(0.0, 1.0), "control period, simulated seconds")};
    }
  };

  /// Throws std::invalid_argument for an invalid gait or number.
  explicit Cpg(const Gait& gait) : Cpg{gait, Params{}} {}
  Cpg(const Gait& gait, const Params& params);

  [[nodiscard]] const Eigen::MatrixXd& weights() const { return weights_; }        ///< W, 2n x 2n
  [[nodiscard]] const Eigen::MatrixXd& propagator() const { return propagator_; }  ///< one step of the state, 2n x 2n

  /// The initial states of `robots` robots, 2n x robots.
  [[nodiscard]] Eigen::MatrixXd initial_states(std::size_t robots = 1) const;

  /// Advances every column by one step. `states`: 2n x robots.
  void step(Eigen::MatrixXd& states) const {
    for (Eigen::Index robot = 0; robot < states.cols(); ++robot) step(states, robot);
  }
  /// The same for one column.
  void step(Eigen::MatrixXd& states, Eigen::Index robot) const;

  /// Returns the joint targets of one robot, its x, in radians. `targets_rad` has one element per hinge.
  void outputs(const Eigen::MatrixXd& states, std::size_t robot, std::span<double> targets_rad) const;

 private:
  Eigen::MatrixXd weights_;
  Eigen::MatrixXd propagator_;
};

}  // namespace trophic::locomotion

#if TROPHIC_HEADER_ONLY
#include <trophic/control/locomotion/cpg.ipp>
#endif
