// SPDX-License-Identifier: MIT
// Springs and dampers as ODE's constraint parameters.
#pragma once

namespace trophic::backend::ode {

/// A spring and damper, f = -stiffness x - damping v, in newtons and metres or newton metres and radians.
struct Spring {
  double stiffness = 0.0;
  double damping = 0.0;
};

/// ERP and CFM of a constraint row that acts as a spring over a step h. A row demands J v' + CFM f = ERP (-x) / h; with v' the
/// velocity and x' = x + h v' the position at the end of the step, f = -k x' - c v' needs ERP = h k / (h k + c) and
/// CFM = 1 / (h k + c): the spring is integrated implicitly and is stable at any step. Some of k, c must be > 0.
struct Row {
  double erp = 0.0;
  double cfm = 0.0;
};
[[nodiscard]] constexpr Row row_of(const Spring& spring, double timestep_s) {
  const double impulse = timestep_s * spring.stiffness + spring.damping;
  return {.erp = timestep_s * spring.stiffness / impulse, .cfm = 1.0 / impulse};
}

}  // namespace trophic::backend::ode
