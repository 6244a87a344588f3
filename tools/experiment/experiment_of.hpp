// SPDX-License-Identifier: MIT
// The experiment that options and configuration describe, and its ecologies with their changes.
#pragma once

#include <filesystem>
#include <thread>
#include <tools/changes/change.hpp>
#include <tools/changes/changing_simulation.hpp>
#include <tools/command/config.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/experiment/experiment_options.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/experiment/any_experiment.hpp>

namespace trophic::command::detail {

/// Applies --seed, --duration, --robots and --robot.
inline void apply(const ExperimentOptions& options, AnyExperiment& experiment) {
  if (options.seed) experiment.seed() = *options.seed;
  if (options.duration_s) experiment.ecology().duration_s = *options.duration_s;
  if (options.robots) experiment.ecology().robots = *options.robots;
  if (options.robot) experiment.ecology().robot = *options.robot;
}

/// The experiment with the parameters of configuration and options.
[[nodiscard]] inline std::unique_ptr<AnyExperiment> experiment_of(const AnyExperiment& chosen, const ExperimentOptions& options,
                                                                  const Config& config) {
  auto experiment = chosen.fresh();
  std::size_t* threads = experiment->backend().threads();
  if (threads != nullptr) *threads = std::max(1U, std::thread::hardware_concurrency());
  apply_config(experiment->params(), config);
  apply(options, *experiment);
  if (threads != nullptr) *threads = options.threads.value_or(options.replicates ? 1 : *threads);
  validate(experiment->params());
  experiment->backend().prescribe(experiment->physics(), chosen.fresh()->physics());
  return experiment;
}

/// The experiment of a run.
[[nodiscard]] inline std::unique_ptr<AnyExperiment> experiment_of(const AnyExperiment& chosen, const OriginRun& origin) {
  auto experiment = chosen.fresh();
  read_parameters(experiment->params(), origin.params);
  return experiment;
}

/// The experiment of a planned run, which has one thread.
[[nodiscard]] inline std::unique_ptr<AnyExperiment> planned_experiment(const AnyExperiment& chosen, const Config& config) {
  ExperimentOptions one_thread;
  one_thread.threads = 1;
  return experiment_of(chosen, one_thread, config);
}

/// Whether the parameters of a run, or of replicates, may change while it runs: that of a resumed one, if they could before.
[[nodiscard]] inline bool may_change(const ExperimentOptions& options) {
  if (options.live || !options.changes.empty()) return true;
  return options.resume && std::filesystem::exists(std::filesystem::path{options.out} / changes::file_name);
}

/// The changes of --changes. Throws std::invalid_argument for one after the last moment that a decision step follows.
[[nodiscard]] inline std::vector<changes::Change> schedule_of_changes(const ExperimentOptions& options,
                                                                      const EcologyParams& ecology) {
  if (options.changes.empty()) return {};
  std::vector<changes::Change> schedule = changes::read_changes(options.changes);
  auto last = static_cast<std::int64_t>(std::llround(ecology.duration_s / ecology.tick_s));
  while (clock_s(last, ecology.tick_s) >= ecology.duration_s) --last;
  if (!schedule.empty() && schedule.back().time_s > clock_s(last, ecology.tick_s)) {
    throw std::invalid_argument{options.changes + ": time_s = " + number_text(schedule.back().time_s) + ": must be <= " +
                                number_text(clock_s(last, ecology.tick_s)) + ", the last moment that a decision step follows"};
  }
  return schedule;
}

/// Makes the ecologies of an experiment, under a null, with --changes and those of a conductor, which may be null.
[[nodiscard]] inline MakeSimulation simulations(const AnyExperiment& chosen, const ExperimentOptions& options,
                                                const Config& config, AnyExperiment& experiment, const Null& null,
                                                const HistoryOf& history = {}, changes::Conductor* conductor = nullptr) {
  if (!may_change(options)) return experiment.simulations(null, history);
  const auto schedule = schedule_of_changes(options, experiment.ecology());
  return [=, &chosen](std::uint64_t seed) -> std::unique_ptr<Simulation> {
    const auto make = [=, &chosen](const std::vector<changes::Change>& made) {
      const auto changed = experiment_of(chosen, options, config);
      for (const changes::Change& change : made) {
        const toml::table number = read_assignment(change.number + "=" + change.value);
        command::check_keys(number, changed->params(), "");
        read_parameters(changed->params(), number);
      }
      validate(changed->params());
      return changed->simulations(null, history)(seed);
    };
    try {
      return std::make_unique<changes::ChangingSimulation>(make, schedule, conductor);
    } catch (const std::logic_error& error) {  // a RuleError, too
      if (options.changes.empty()) throw;
      throw std::invalid_argument{options.changes + ": " + error.what()};
    }
  };
}

}  // namespace trophic::command::detail
