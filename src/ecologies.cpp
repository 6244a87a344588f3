// SPDX-License-Identifier: MIT
// trophic::compiled: the ecologies and experiments of the tables that trophic ships.
#include <trophic/ecology/shipped.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

namespace trophic {

template <class Rules>
using MadeDynamics = std::unique_ptr<TableSimulation<Rules>>;

#define TROPHIC_COMPILE(Rules)                                                                           \
  static_assert(detail::has_no_fault<Rules>());                                                          \
  template MadeDynamics<Rules> make_dynamics<Rules>(Experiment<Rules>, BackendChoice, std::string_view); \
  template MadeDynamics<Rules> make_dynamics_in<Rules>(Habitat, Experiment<Rules>, BackendChoice);       \
  template std::unique_ptr<AnyExperiment> make_experiment<Rules>(const BackendChoice&, std::string_view);
TROPHIC_COMPILE(rules::Paper)
TROPHIC_COMPILE(rules::Released)
#undef TROPHIC_COMPILE

}  // namespace trophic
