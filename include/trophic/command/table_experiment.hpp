// SPDX-License-Identifier: MIT
// The experiments of a rule table on a backend, as the command line reads and runs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/backend/contract.hpp>
#include <trophic/command/any_experiment.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/shadow_of.hpp>
#include <trophic/ecology/simulations_of.hpp>
#include <trophic/population/species_colour.hpp>
#include <trophic/rules/print_table.hpp>
#include <vector>

namespace trophic::command {

/// The experiment of a table on a backend.
template <class Rules, Backend B>
class TableExperiment final : public AnyExperiment {
 public:
  void read(const toml::table& numbers) override { read_numbers(numbers_, numbers); }
  void check() const override { validate(numbers_, ""); }
  [[nodiscard]] NamedParams named_params() const override { return named_params_of(numbers_); }
  [[nodiscard]] std::uint64_t& seed() override { return numbers_.seed; }
  [[nodiscard]] EcologyParams& ecology() override { return numbers_.ecology; }
  [[nodiscard]] std::size_t* threads() override {
    if constexpr (requires { numbers_.backend.threads; }) {
      return &numbers_.backend.threads;
    } else {
      return nullptr;
    }
  }
  [[nodiscard]] double steps_a_second() const override {
    return JointDriven<B> ? 1.0 / numbers_.physics.timestep_s : numbers_.ecology.control_hz;
  }
  [[nodiscard]] std::string table_text(std::string_view format) const override {
    const auto text = format == "latex" ? &rules::latex_table<Rules> : &rules::markdown_table<Rules>;
    return text(numbers_.rules, numbers_.ecology, numbers_.physics);
  }
  [[nodiscard]] MakeSimulation simulations(bool shadow) const override {
    return shadow ? simulations_of(shadow_of(numbers_)) : simulations_of(numbers_);
  }
  bool save_mjcf(const Simulation& ecology, const std::string& path) const override {
    const B& engine = static_cast<const Ecology<Rules, B>&>(ecology).backend();
    if constexpr (requires { engine.save_mjcf(path); }) {
      std::vector<Colour> colours;
      for (const Individual& individual : ecology.view().robots) colours.push_back(species_colour(individual.species));
      engine.save_mjcf(path, colours);
      return true;
    } else {
      return false;
    }
  }

 private:
  Experiment<Rules, B> numbers_;
};

}  // namespace trophic::command
