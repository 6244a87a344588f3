// SPDX-License-Identifier: MIT
// The ecology of a rule table in a backend.
#pragma once

#include <trophic/ecology/dynamics.hpp>
#include <trophic/ecology/refused.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/table_simulation.hpp>
#include <trophic/habitat/load/installed_models.hpp>

namespace trophic {

/// A population of robots that live, perceive, catch, starve and reproduce under the rules of one table, in a physics backend
/// of any type: `Ecology<Paper> ecology({.seed = 1}, backend::Mujoco::Params{.threads = 2})`.
///
/// A tick is `EcologyParams::tick_s` of the ecology's clock; ecology/dynamics.hpp defines what happens in it. Equal parameters
/// and seeds give equal runs, for any number of threads and any observers.
template <class Rules, bool is_table>
class Ecology final : public Simulation {
 public:
  using Params = Experiment<Rules>;

  /// Loads the models that `params.ecology` names. Throws as make_dynamics does.
  explicit Ecology(Params params, BackendChoice backend, std::string_view installed = TROPHIC_MODEL_DIR)
      : dynamics_{make_dynamics<Rules>(std::move(params), std::move(backend), installed)} {}

  /// Uses a habitat made by the program; the names in `params.ecology` are then only labels.
  Ecology(Params params, BackendChoice backend, Habitat habitat)
      : dynamics_{make_dynamics_in<Rules>(std::move(habitat), std::move(params), std::move(backend))} {}

  void persist(Archive& archive) override { dynamics_->persist(archive); }

  [[nodiscard]] double time_s() const override { return dynamics_->time_s(); }
  [[nodiscard]] std::int64_t tick() const override { return dynamics_->tick(); }
  [[nodiscard]] View view() const override { return dynamics_->view(); }
  [[nodiscard]] const AnyBackend& backend() const override { return dynamics_->backend(); }
  [[nodiscard]] const Params& params() const { return dynamics_->params(); }
  [[nodiscard]] const Habitat& habitat() const { return dynamics_->habitat(); }
  [[nodiscard]] const RuleStates<Rules>& states() const { return dynamics_->states(); }  ///< the states of rules with a State

  [[nodiscard]] observe::RunDescription describe(double until_s) const override { return dynamics_->describe(until_s); }
  [[nodiscard]] io::StateColumns state_columns() const override { return dynamics_->state_columns(); }
  [[nodiscard]] Stepping& stepping() override { return dynamics_->stepping(); }

 private:
  void run(double until_s, observe::Audience& audience) override { dynamics_->run_before(audience, until_s); }

  std::unique_ptr<TableSimulation<Rules>> dynamics_;
};

}  // namespace trophic
