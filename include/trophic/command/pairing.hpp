// SPDX-License-Identifier: MIT
// What an experiment's command line says, and what each of its rule tables does on each of its backends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <trophic/checkpoint/schedule.hpp>
#include <trophic/command/config.hpp>
#include <trophic/observe/joint_progress.hpp>
#include <trophic/observe/manifest.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/replicates/keeping.hpp>
#include <trophic/replicates/sweep/claim.hpp>
#include <vector>

namespace trophic::command {

/// Everything that the command line says. What it leaves out comes from the configuration file, then from the rule table.
struct ExperimentOptions {
  std::optional<std::string> rules;
  std::optional<std::string> backend;
  std::optional<std::uint64_t> seed;
  std::optional<double> duration_s;
  std::optional<std::uint64_t> robots;
  std::optional<std::string> robot;
  std::optional<std::uint64_t> threads;
  std::optional<std::uint64_t> replicates;
  std::optional<std::uint64_t> jobs;
  bool resume = false;
  std::string from;            ///< folder of a run that this one begins from
  std::optional<double> at_s;  ///< when
  double checkpoint_s = checkpoint::Schedule{}.every_s;
  bool shadow = false;
  std::string config;
  std::vector<std::string> assignments;
  std::string out;
  std::string save_mjcf;
  bool watch = false;  ///< in a window
  std::optional<std::uint64_t> replay_hz;
  std::uint64_t agents_every = 1;
  bool senses = false;
  bool states = false;
  bool print_config = false;
  std::string sweep;  ///< file of a grid of settings
  std::string shard;  ///< "I/N"; empty: all of it
  bool dry_run = false;
  double lease_s = sweep::default_lease_s;
  std::string print_table;  ///< markdown or latex; empty: no table is printed
  std::string program;      ///< as it was called
  observe::Provenance provenance;
};

/// A run that another one begins from.
struct OriginRun {
  std::filesystem::path folder;
  std::string rule_table;
  std::string engine;
  std::string fingerprint;
  std::uint64_t seed = 0;
  double at_s = 0.0;
  observe::Extent extent;  ///< how much of it is written down
  toml::table params;
  observe::RunDescription description;  ///< as the program itself makes it of these numbers
  std::function<bool()> make;           ///< makes the new run's folder as this run was; false if a signal came first
};

/// What a plan says of a run: what it is, and how much.
struct PlannedFacts {
  observe::RunDescription description;
  double work = 0.0;  ///< robots times steps of the engine
};

/// One rule table on one backend. A program has one for each that it was built with.
struct Pairing {
  std::string table;
  std::string backend;
  NamedParams (*named_params)();  ///< all numbers as the table has them
  int (*run)(const ExperimentOptions& options, const Config& config, const std::optional<OriginRun>& origin);
  observe::RunDescription (*describe)(const toml::table& params);
  /// Makes in a folder what that run was at its moment, the same bytes. False if a signal came first.
  bool (*replay)(const OriginRun& origin, const std::filesystem::path& folder);
  /// Of the numbers of a configuration file, or of the table's neutral shadow with them.
  PlannedFacts (*facts)(const Config& config, bool shadow);
  /// Runs that, or goes on with it, in a folder.
  void (*run_planned)(const Config& config, bool shadow, std::uint64_t seed, const std::filesystem::path& folder,
                      const replicates::Keeping& keeping, observe::JointProgress::Part progress,
                      const observe::StopOnSignal& stop);
};

}  // namespace trophic::command
