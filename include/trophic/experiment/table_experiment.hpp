// SPDX-License-Identifier: MIT
// Experiments of a rule table on any backend.
#pragma once

#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/checked_experiment.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulations_of.hpp>
#include <trophic/experiment/any_experiment.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// The experiment of a table on a backend.
template <class Rules>
class TableExperiment final : public AnyExperiment {
 public:
  /// `installed`: the folder of installed models, which must outlive the experiment.
  explicit TableExperiment(const BackendChoice& backend, std::string_view installed = TROPHIC_MODEL_DIR)
      : default_backend_{backend}, installed_{installed}, backend_{backend} {}

  [[nodiscard]] std::string rule_table() const override { return table_name<Rules>(); }
  [[nodiscard]] std::unique_ptr<AnyExperiment> fresh() const override {
    return std::make_unique<TableExperiment>(default_backend_, installed_);
  }
  [[nodiscard]] ParamRefs params() override {
    ParamRefs all = param_refs(experiment_);
    backend_.append_param_refs("backend", all);
    return all;
  }
  [[nodiscard]] std::uint64_t& seed() override { return experiment_.seed; }
  [[nodiscard]] EcologyParams& ecology() override { return experiment_.ecology; }
  [[nodiscard]] Physics& physics() override { return experiment_.physics; }
  [[nodiscard]] BackendChoice& backend() override { return backend_; }
  [[nodiscard]] std::vector<std::string> backends() const override {
    constexpr auto names = detail::backends_of<Rules>();
    return {names.begin(), names.end()};
  }
  [[nodiscard]] std::vector<rules::SlotRule> slot_rules() const override { return rules::slot_rules<Rules>(); }
  [[nodiscard]] MakeSimulation simulations(const Null& null, const HistoryOf& history) const override {
    return simulations_of(under(null, experiment_), backend_, history, installed_);
  }
  /// The arena is loaded once. Throws as the ecology's constructor does.
  [[nodiscard]] MakeContest contests() const override {
    return [loaded = load_checked(experiment_, backend_, installed_)](std::uint64_t places, Lineup lineup) {
      Experiment<Rules> own = loaded.params;
      own.seed = places;
      own.ecology.robots = lineup.size();
      own.lineup = std::move(lineup);
      return make_dynamics_in<Rules>(loaded.habitat, std::move(own), loaded.backend);
    };
  }
  [[nodiscard]] AskBrain brain() const override {
    using Brain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
    using Acts = PolicyIn<Rules, RuleSlot::acts>;
    return [brains = make_policies<Rules>(experiment_.rules).brain](Species species, std::span<const double> inputs,
                                                                    std::span<const double> weights) {
      const control::BrainShape shape{.inputs = PolicyIn<Rules, RuleSlot::sensors>::size_of(species), .outputs = Acts::outputs};
      const auto check = [](bool good, std::string_view what, std::size_t given, const std::string& must) {
        if (good) return;
        throw std::invalid_argument{std::string{what} + ": " + std::to_string(given) + ": must be " + must +
                                    ", as the rule table's brain needs"};
      };
      const Brain& brain = for_species(brains, species);
      check(inputs.size() == shape.inputs, "inputs", inputs.size(), std::to_string(shape.inputs));
      check(control::ask::fits(brain, weights, shape), "weights", weights.size(), control::ask::demand(brain, shape));
      StateOf<Brain> own{};
      std::array<double, Acts::outputs> outputs{};
      const control::Decision decision = control::ask::decide<Acts>(brain, own, inputs, weights, std::span{outputs});
      std::vector<int> choices;
      Acts::each(outputs, [&]<class One>(std::size_t, std::span<const double, One::outputs> out) {
        if constexpr (std::same_as<One, control::acts::Tag>) {
          choices.push_back(decision.tag);
        } else {
          auto value = static_cast<double>(One::value(out));
          if constexpr (std::same_as<One, control::acts::Turn>) value = decision.target_angle_rad;
          constexpr bool has_bounds = One::most - One::least < std::numeric_limits<double>::infinity();
          constexpr double middle = has_bounds ? 0.5 * (One::least + One::most) : static_cast<double>(One::by_default);
          choices.push_back((value > middle ? 1 : 0) - (value < middle ? 1 : 0));
        }
      });
      return choices;
    };
  }

 private:
  BackendChoice default_backend_;
  std::string_view installed_;
  Experiment<Rules> experiment_;
  BackendChoice backend_;
};

/// Makes the experiment of a table on a backend.
template <class Rules>
[[nodiscard]] std::unique_ptr<AnyExperiment> make_experiment(const BackendChoice& backend, std::string_view installed) {
  return std::make_unique<TableExperiment<Rules>>(backend, installed);
}
#if !TROPHIC_HEADER_ONLY
extern template std::unique_ptr<AnyExperiment> make_experiment<rules::Paper>(const BackendChoice&, std::string_view);
extern template std::unique_ptr<AnyExperiment> make_experiment<rules::Released>(const BackendChoice&, std::string_view);
#endif

/// Rule tables by name, for an Offer; their models are those that the program's headers find.
template <class... Rules>
[[nodiscard]] std::vector<std::pair<std::string, MakeExperiment>> rule_tables() {
  return {
      {table_name<Rules>(), [](const BackendChoice& backend) { return make_experiment<Rules>(backend, TROPHIC_MODEL_DIR); }}...};
}

}  // namespace trophic
