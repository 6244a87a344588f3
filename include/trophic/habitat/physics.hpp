// SPDX-License-Identifier: MIT
// The physics parameters that an experiment specifies for any engine.
#pragma once

#include <trophic/params/params.hpp>

namespace trophic {

/// The bound for a floor or a body, beyond which engines let robots sink.
inline constexpr double most_friction = 10.0;

enum class Integrator { semi_implicit_euler, rk4 };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Integrator) {
  return {"semi_implicit_euler", "rk4"};
}

/// The integration of the equations of motion, the part of the physics that an experiment's rules specify (Sec. Methodology). The
/// paper gives the time step and is silent about the integrator.
struct Physics {
  double timestep_s = 0.0012;
  Integrator integrator = Integrator::semi_implicit_euler;
  double gravity_m_s2 = 9.81;

  static constexpr auto fields() {
    return std::tuple{field("timestep_s", &Physics::timestep_s, above_to(0.0, 0.1), "physics time step, simulated seconds"),
                      field("integrator", &Physics::integrator, "semi_implicit_euler or rk4"),
                      field("gravity_m_s2", &Physics::gravity_m_s2, at_least(0.0), "downwards")};
  }
};

}  // namespace trophic
