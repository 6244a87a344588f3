// SPDX-License-Identifier: MIT
// The parameters of the ODE backend.
#pragma once

#include <cstddef>
#include <trophic/params/params.hpp>

namespace trophic::backend {
class Ode;
}

namespace trophic::backend::ode {

/// `quick_step`: dWorldQuickStep, relaxation with a fixed number of iterations over all constraints. Friction is limited by the
/// normal force that acts at the same moment. `world_step`: dWorldStep, exact except for friction, which it limits by the normal
/// forces that would act without friction. With it a robot that stands on many points and pushes them apart walks up to 27 %
/// faster and turns up to 28 % faster (README.md).
enum class Solver { quick_step, world_step };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Solver) {
  return {"quick_step", "world_step"};
}

/// From the ninth iteration on QuickStep shuffles its rows with the random numbers of the whole process; with at most 8 it draws
/// none.
inline constexpr int sweeps_without_draws = 8;

/// Contacts, friction and joint limits are springs and dampers in SI units, so that they are the same physics at every
/// timestep; ODE's ERP, CFM and slip are computed from them (compliance.hpp). The defaults are equivalent to MuJoCo's default
/// solref = (0.02, 1) and solimp = (0.9, 0.95, 0.001) for a leg of the spider, derived, not tuned: with time constant tau,
/// impedance d, effective mass m = 0.225 kg (inverse of MuJoCo's body_invweight0) and dmax = 0.95
///   contact stiffness = m d / (1 - d) / (dmax tau)^2 = 5600 N/m, damping = m d / (1 - d) 2 / (dmax tau) = 210 N s/m, d = 0.9,
///   friction damping half of that (of a pyramidal cone with coefficient 1), and for hinges beyond their range
///   with inertia 1.8e-4 kg m2 and d = 0.95: 9.5 N m/rad and 0.36 N m s/rad.
struct Params {
  using Backend = Ode;

  std::size_t threads = 1;
  Solver solver = Solver::quick_step;
  int sweeps = sweeps_without_draws;
  double contact_stiffness_N_m = 5600.0;
  double contact_damping_N_s_m = 210.0;
  double friction_damping_N_s_m = 105.0;
  double limit_stiffness_N_m_rad = 9.5;
  double limit_damping_N_m_s_rad = 0.36;

  static constexpr auto fields() {
    return std::tuple{
        field("threads", &Params::threads, between(1, 1024), "number of threads; results do not depend on it"),
        field("solver", &Params::solver, "quick_step or world_step"),
        field("sweeps", &Params::sweeps, between(1, 100'000),
              "iterations of quick_step; above 8 only one thread at a time solves"),
        field("contact_stiffness_N_m", &Params::contact_stiffness_N_m, above_to(0.0, 1e9), "stiffness of each contact point"),
        field("contact_damping_N_s_m", &Params::contact_damping_N_s_m, above_to(0.0, 1e9), "damping of each contact point"),
        field("friction_damping_N_s_m", &Params::friction_damping_N_s_m, above_to(0.0, 1e9),
              "friction force per sliding speed, below the friction limit"),
        field("limit_stiffness_N_m_rad", &Params::limit_stiffness_N_m_rad, above_to(0.0, 1e9),
              "stiffness of a hinge beyond its range"),
        field("limit_damping_N_m_s_rad", &Params::limit_damping_N_m_s_rad, above_to(0.0, 1e9),
              "damping of a hinge beyond its range")};
  }
};

}  // namespace trophic::backend::ode
