// SPDX-License-Identifier: MIT
// A planned run of a sweep, on the rule tables and backends of a program.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <tools/changes/changing_simulation.hpp>
#include <tools/command/backends.hpp>
#include <tools/command/config.hpp>
#include <tools/command/offers.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/command/words.hpp>
#include <tools/experiment/experiment_options.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/replicates/joint_progress.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <tools/sweep/plan_file.hpp>
#include <tools/sweep/sweep_file.hpp>
#include <trophic/backend/contract.hpp>

namespace trophic::command::detail::sweeps {

using sweep::PlannedRun;

[[nodiscard]] inline std::string cell_name(std::size_t cell) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "cell-%03zu", cell);
  return name.data();
}

/// One value under its path, in nested tables.
inline void insert(toml::table& table, std::string_view path, const Json& value) {
  const std::size_t dot = path.find('.');
  if (dot != std::string_view::npos) {
    toml::node* nested = &table.insert(path.substr(0, dot), toml::table{}).first->second;
    if (!nested->is_table()) throw std::invalid_argument{std::string{path} + ": is below a key that has a value"};
    return insert(*nested->as_table(), path.substr(dot + 1), value);
  }
  insert_value(table, path, value);
}

/// Settings as a configuration file has them.
[[nodiscard]] inline Config config_of(const sweep::Settings& settings) {
  Config config{.origin = {}, .file = {}, .parameters = {}, .rule_table = {}, .engine = {}, .assignments = {}};
  for (const auto& [path, value] : settings.items()) insert(config.parameters, path, value);
  return config;
}

[[nodiscard]] inline std::unique_ptr<AnyExperiment> experiment_of(const std::string& table, const std::string& engine,
                                                                  const Offer& offer) {
  const auto check = [](const std::string& key, const std::string& name, const std::vector<std::string>& names) {
    if (std::ranges::find(names, name) != names.end()) return;
    throw std::invalid_argument{key + " = " + must_be_one_of(name, names) + did_you_mean(nearest_word(name, names))};
  };
  check("rule_table", table, table_names(offer));
  check("engine", engine, backend_names(offer.backends));
  return find_experiment(offer, table, engine);
}

/// A plan's runs on what the program offers.
class Runner {
 public:
  Runner(const ExperimentOptions& options, const Offer& offer, const replicates::StopOnSignal& stop)
      : options_{options}, offer_{offer}, stop_{stop} {}

  /// Runs one for as long as the plan says or, with `until_s`, for less; in a folder.
  void run(const PlannedRun& run, const std::filesystem::path& folder, replicates::JointProgress& progress,
           std::optional<double> until_s = {}) const {
    Config config = config_of(run.settings);
    if (until_s) insert_duration(config.parameters, *until_s);
    replicates::CommonOptions common{
        options_.provenance, schedule_of(options_), run.output, {}, changes::with_changes(options_.own_tables)};
    common.provenance.emplace_back("planned_run", std::to_string(run.index));
    try {
      run_planned(*experiment_of(run.rule_table, run.engine, offer_), config, run.shadow, run.seed, folder, common,
                  progress.watch(run.folder.string()), stop_);
    } catch (const Diverged&) {
      ++diverged_;
      throw;
    }
  }

  /// The number of runs that diverged, which they do again with the same parameters.
  [[nodiscard]] std::size_t diverged() const { return diverged_; }

 private:
  static void insert_duration(toml::table& parameters, double until_s) {
    parameters.insert("ecology", toml::table{});
    parameters["ecology"].as_table()->insert_or_assign("duration_s", until_s);
  }

  const ExperimentOptions& options_;
  const Offer& offer_;
  const replicates::StopOnSignal& stop_;
  mutable std::atomic<std::size_t> diverged_ = 0;
};

}  // namespace trophic::command::detail::sweeps
