// SPDX-License-Identifier: MIT
// Definitions of cpg.hpp.
#pragma once

#include <cmath>
#include <numbers>
#include <trophic/control/locomotion/cpg.hpp>

namespace trophic::locomotion {

namespace detail {

inline constexpr int cpg_max_order = 200;

/// exp(step) = sum of step^k / k!, up to that order or until a term does not change the sum.
inline Eigen::MatrixXd exponential(const Eigen::MatrixXd& step, int order) {
  Eigen::MatrixXd term = Eigen::MatrixXd::Identity(step.rows(), step.cols());
  Eigen::MatrixXd sum = term;
  for (int k = 1; k <= order; ++k) {
    const Eigen::MatrixXd next = term.lazyProduct(step) / k;
    term = next;
    const Eigen::MatrixXd before = sum;
    sum += term;
    if (sum == before) break;
  }
  return sum;
}

}  // namespace detail

TROPHIC_INLINE Cpg::Cpg(const Gait& gait, const Params& params) {
  trophic::validate(params, "cpg");
  trophic::validate(gait);
  const auto n = gait.internal.size();
  weights_ = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  weights_.topLeftCorner(n, n) = gait.coupling;
  weights_.topRightCorner(n, n) = gait.internal.asDiagonal();
  weights_.bottomLeftCorner(n, n) = -weights_.topRightCorner(n, n);
  propagator_ =
      detail::exponential(weights_ * params.step_s, params.integration == CpgIntegration::rk4 ? 4 : detail::cpg_max_order);
}

TROPHIC_INLINE Eigen::MatrixXd Cpg::initial_states(std::size_t robots) const {
  return Eigen::MatrixXd::Constant(weights_.rows(), static_cast<Eigen::Index>(robots), std::numbers::sqrt2 / 2.0);
}

TROPHIC_INLINE void Cpg::step(Eigen::MatrixXd& states, Eigen::Index robot) const {
  Eigen::VectorXd next = Eigen::VectorXd::Zero(weights_.rows());
  for (Eigen::Index k = 0; k < weights_.rows(); ++k) next += propagator_.col(k) * states(k, robot);
  states.col(robot) = next;
}

TROPHIC_INLINE void Cpg::outputs(const Eigen::MatrixXd& states, std::size_t robot, std::span<double> targets_rad) const {
  for (std::size_t i = 0; i < targets_rad.size(); ++i) {
    targets_rad[i] = states(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(robot));
  }
}

}  // namespace trophic::locomotion
