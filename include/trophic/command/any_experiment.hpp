// SPDX-License-Identifier: MIT
// Type-erased interface of an experiment: one rule table on one backend.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <trophic/ecology/ask_brain.hpp>
#include <trophic/ecology/lineup.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/rules/printed_rules.hpp>
#include <vector>

namespace trophic::command {

/// Starts with the numbers of its rule table.
class AnyExperiment {
 public:
  AnyExperiment() = default;
  AnyExperiment(const AnyExperiment&) = delete;
  AnyExperiment& operator=(const AnyExperiment&) = delete;
  virtual ~AnyExperiment() = default;

  /// Sets what a table names, as read_numbers.
  virtual void read(const toml::table& numbers) = 0;
  /// Throws std::invalid_argument for a number out of its bounds.
  virtual void check() const = 0;
  [[nodiscard]] virtual NamedParams named_params() const = 0;
  [[nodiscard]] virtual std::uint64_t& seed() = 0;
  [[nodiscard]] virtual EcologyParams& ecology() = 0;
  /// Of the engine; null if it has none.
  [[nodiscard]] virtual std::size_t* threads() = 0;
  /// Steps of the engine in a simulated second.
  [[nodiscard]] virtual double steps_a_second() const = 0;
  /// The rules with their numbers and sources.
  [[nodiscard]] virtual std::vector<rules::PrintedRule> printed_rules() const = 0;
  /// Makes its ecologies as the numbers are now, or those of its neutral shadow.
  [[nodiscard]] virtual MakeSimulation simulations(bool shadow) const = 0;
  /// Makes contests in its arena, with its brains and backend.
  [[nodiscard]] virtual MakeContest contests() const = 0;
  /// The brain of its table.
  [[nodiscard]] virtual AskBrain brain() const = 0;
  /// Writes the engine's model of an ecology that `simulations` made. Returns false if the engine has no such file.
  virtual bool save_mjcf(const Simulation& ecology, const std::string& path) const = 0;
};

}  // namespace trophic::command
