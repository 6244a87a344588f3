// SPDX-License-Identifier: MIT
// Experiments of a rule table on any backend.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulations_of.hpp>
#include <trophic/experiment/any_experiment.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/rules/print_table.hpp>
#include <trophic/rules/table.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// The experiment of a table on a backend.
template <class Rules>
class TableExperiment final : public AnyExperiment {
 public:
  explicit TableExperiment(const BackendChoice& backend) : default_backend_{backend}, backend_{backend} {}

  [[nodiscard]] std::string rule_table() const override { return table_name<Rules>(); }
  [[nodiscard]] std::unique_ptr<AnyExperiment> fresh() const override {
    return std::make_unique<TableExperiment>(default_backend_);
  }
  [[nodiscard]] ParamRefs params() override {
    ParamRefs all = param_refs(experiment_);
    backend_.append_param_refs("backend", all);
    return all;
  }
  [[nodiscard]] std::uint64_t& seed() override { return experiment_.seed; }
  [[nodiscard]] EcologyParams& ecology() override { return experiment_.ecology; }
  [[nodiscard]] const Physics& physics() const override { return experiment_.physics; }
  [[nodiscard]] BackendChoice& backend() override { return backend_; }
  [[nodiscard]] std::vector<rules::PrintedRule> printed_rules() const override {
    return rules::printed_rules<Rules>(experiment_.rules, experiment_.ecology, experiment_.physics);
  }
  [[nodiscard]] MakeSimulation simulations(bool shadow) const override {
    return simulations_of(shadow ? shadow_of(experiment_) : experiment_, backend_);
  }
  [[nodiscard]] MakeContest contests() const override { return contests_of(experiment_, backend_); }
  [[nodiscard]] AskBrain brain() const override { return ask_brain(experiment_); }

 private:
  BackendChoice default_backend_;
  Experiment<Rules> experiment_;
  BackendChoice backend_;
};

}  // namespace trophic
