// SPDX-License-Identifier: MIT
// The ecologies of the rule tables that trophic ships: trophic::compiled has them, and a program need not compile them again.
#pragma once

#include <trophic/ecology/dynamics.hpp>
#include <trophic/rules/shipped.hpp>

#if !TROPHIC_HEADER_ONLY
namespace trophic {

#define TROPHIC_SHIPPED_ECOLOGY(Rules)                                                                           \
  extern template std::unique_ptr<TableSimulation<Rules>> make_dynamics<Rules>(Experiment<Rules>, BackendChoice, \
                                                                               std::string_view);                \
  extern template std::unique_ptr<TableSimulation<Rules>> make_dynamics_in<Rules>(Habitat, Experiment<Rules>, BackendChoice);
TROPHIC_SHIPPED_ECOLOGY(rules::Paper)
TROPHIC_SHIPPED_ECOLOGY(rules::Released)
#undef TROPHIC_SHIPPED_ECOLOGY

}  // namespace trophic
#endif
