// SPDX-License-Identifier: MIT
// Experiments of a rule table on any backend, as the command line reads and runs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/command/any_experiment.hpp>
#include <trophic/command/backends.hpp>
#include <trophic/ecology/describe.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shipped.hpp>
#include <trophic/ecology/simulations_of.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/population/species_colour.hpp>
#include <trophic/rules/print_table.hpp>
#include <vector>

namespace trophic::command {

/// The experiment of a table on a backend.
template <class Rules>
class TableExperiment final : public AnyExperiment {
 public:
  explicit TableExperiment(const LinkedBackend& backend) : backend_{backend}, choice_{backend.choice()} {}

  void read(const toml::table& numbers) override {
    Numbers all{numbers_, {backend_, choice_}};
    read_numbers(all, numbers);
  }
  void check() const override {
    validate(numbers_, "");
    choice_.validate("backend");
  }
  [[nodiscard]] NamedParams named_params() const override { return named_params_of(numbers_, choice_); }
  [[nodiscard]] std::uint64_t& seed() override { return numbers_.seed; }
  [[nodiscard]] EcologyParams& ecology() override { return numbers_.ecology; }
  [[nodiscard]] std::size_t* threads() override { return choice_.threads(); }
  [[nodiscard]] double steps_a_second() const override {
    return choice_.has_joints() ? 1.0 / numbers_.physics.timestep_s : numbers_.ecology.control_hz;
  }
  [[nodiscard]] std::vector<rules::PrintedRule> printed_rules() const override {
    return rules::printed_rules<Rules>(numbers_.rules, numbers_.ecology, numbers_.physics);
  }
  [[nodiscard]] MakeSimulation simulations(bool shadow) const override {
    return simulations_of(shadow ? shadow_of(numbers_) : numbers_, choice_);
  }
  [[nodiscard]] MakeContest contests() const override { return contests_of(numbers_, choice_); }
  [[nodiscard]] AskBrain brain() const override { return ask_brain(numbers_); }
  bool save_mjcf(const Simulation& ecology, const std::string& path) const override {
    std::vector<Colour> colours;
    for (const Individual& individual : ecology.view().robots) colours.push_back(species_colour(individual.species));
    return backend_.save_mjcf(static_cast<const Ecology<Rules>&>(ecology).backend(), path, colours);
  }

 private:
  /// All numbers as a configuration file has them.
  struct Numbers {
    struct OfBackend {
      const LinkedBackend& backend;
      BackendChoice& choice;
      void read_numbers(const toml::table& numbers, const std::string& path) { backend.read(choice, numbers, path); }
    };
    Experiment<Rules>& experiment;
    OfBackend backend;

    template <class Self, class Visitor>
    static constexpr void visit_fields(Self& all, Visitor&& visit) {
      Experiment<Rules>::visit_fields(all.experiment, visit);
      visit(FieldText{"backend"}, all.backend);
    }
  };

  LinkedBackend backend_;
  Experiment<Rules> numbers_;
  BackendChoice choice_;
};

}  // namespace trophic::command
