// SPDX-License-Identifier: MIT
// A program for rule tables: `int main(int argc, char** argv) { return trophic::command::experiment<MyRules>(argc, argv); }`.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <trophic/checkpoint/go_on.hpp>
#include <trophic/checkpoint/rewind.hpp>
#include <trophic/command/backends.hpp>
#include <trophic/command/config.hpp>
#include <trophic/command/experiment_program.hpp>
#include <trophic/command/option.hpp>
#include <trophic/command/output.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/watching.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/ecology/shadow_of.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/state_columns.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/population/species_colour.hpp>
#include <trophic/replicates/run_in_folder.hpp>
#include <trophic/replicates/run_with_shadow.hpp>
#include <trophic/rules/print_table.hpp>
#include <trophic/rules/table.hpp>
#include <utility>
#include <vector>
// Who links trophic::mpi has this definition.
#ifdef TROPHIC_WITH_MPI
#include <trophic/mpi/team.hpp>
#endif

namespace trophic::command {

namespace detail {

template <class Rules, Backend B>
[[nodiscard]] Experiment<Rules, B> numbers_of(const ExperimentOptions& options, const Config& config) {
  Experiment<Rules, B> numbers;
  constexpr bool has_threads = requires {
    numbers.backend.threads;
  };
  if constexpr (has_threads) numbers.backend.threads = std::max(1U, std::thread::hardware_concurrency());
  read_config_into(numbers, config);
  apply(options, numbers.seed, numbers.ecology);
  if constexpr (has_threads) {
    if (options.replicates) numbers.backend.threads = 1;
    if (options.threads) numbers.backend.threads = *options.threads;
  }
  validate(numbers, "");
  return numbers;
}

template <class Rules, Backend B>
[[nodiscard]] int run_once(const ExperimentOptions& options, const Experiment<Rules, B>& numbers,
                           const std::optional<OriginRun>& origin) {
  std::optional<Watching> watching;
  if (options.watch) watching.emplace(options.program);
  Ecology<Rules, B> ecology{numbers};
  if (!options.save_mjcf.empty()) {
    if constexpr (requires { ecology.backend().save_mjcf(options.save_mjcf); }) {
      std::vector<Colour> colours;
      for (const Individual& individual : ecology.view().robots) colours.push_back(species_colour(individual.species));
      ecology.backend().save_mjcf(options.save_mjcf, colours);
    } else {
      throw std::invalid_argument{"--save-mjcf: needs --backend mujoco"};
    }
    if (options.out.empty()) return 0;
  }
  const double until_s = numbers.ecology.duration_s;
  Beginning standing;
  if (origin) {
    checkpoint::check_may_follow(origin->description, ecology.describe(until_s));
    if (!(origin->at_s <= until_s)) {
      throw std::invalid_argument{"--at " + number_text(origin->at_s) + ": must be <= " + number_text(until_s) +
                                  ", the duration of the run that begins there"};
    }
    if (!origin->make()) return stopped;
    standing = standing_after(*origin, options.out, ecology.describe(until_s));
  } else if (options.resume) {
    standing = {checkpoint::standing_in(options.out, ecology.describe(until_s))};
  }
  if (!standing.remark.empty()) std::cout << options.out << " " << standing.remark << std::endl;
  if (standing.complete) return 0;
  Watching::Spectator nobody;
  auto& spectator = watching ? watching->spectator() : nobody;
  const auto simulate = [&] {
    observe::StopOnSignal stop;
    observe::RunFolder folder{options.out, options.provenance, extent_of(options), standing.opening(),
                              observe::state_columns(ecology.states())};
    observe::Progress progress;
    try {
      if (standing.begins) {
        checkpoint::restore_any(*standing.from, ecology, folder, progress, stop);
        folder.manifest().begin_from(text_of(*origin, standing.from->time_s));
        standing.from.reset();
      }
      checkpoint::run_kept(ecology, until_s, options.out, {.every_s = options.checkpoint_s}, standing.from, folder, progress,
                           stop, spectator);
    } catch (const std::exception& error) {
      std::cerr << options.program << ": " << what_of(error) << "\nwhat was written before is in " << folder.path().string()
                << "\n";
      return run_error;
    }
    return report_run(folder, progress, ecology.view(), until_s);
  };
  return watching ? watching->show(simulate) : simulate();
}

template <class Rules, Backend B>
[[nodiscard]] int run_table(const ExperimentOptions& options, const Config& config, const std::optional<OriginRun>& origin) {
  const Experiment<Rules, B> numbers = numbers_of<Rules, B>(options, config);
  if (options.print_config) return print_config(table_name<Rules>(), std::string{B::name}, named_params_of(numbers));
  if (options.print_table == "markdown")
    return print_text(rules::markdown_table<Rules>(numbers.rules, numbers.ecology, numbers.physics));
  if (options.print_table == "latex")
    return print_text(rules::latex_table<Rules>(numbers.rules, numbers.ecology, numbers.physics));
  if (!options.replicates) return run_once<Rules, B>(options, numbers, origin);
  const auto plan = plan_of(options, numbers.seed);
  return report_unfinished(options,
                           replicates::run_with_shadow<Rules, B>(numbers, plan, options.shadow, options.provenance, std::cout));
}

template <class Rules, Backend B>
[[nodiscard]] Experiment<Rules, B> numbers_of(const toml::table& params) {
  Experiment<Rules, B> numbers;
  read_numbers(numbers, params);
  return numbers;
}

template <class Rules, Backend B>
[[nodiscard]] observe::RunDescription describe(const toml::table& params) {
  return Ecology<Rules, B>{numbers_of<Rules, B>(params)}.describe(0.0);
}

template <class Rules, Backend B>
[[nodiscard]] bool replay(const OriginRun& origin, const std::filesystem::path& folder) {
  Ecology<Rules, B> ecology{numbers_of<Rules, B>(origin.params)};
  if (!std::filesystem::exists(folder)) checkpoint::copy_until(origin.folder, origin.at_s, folder);
  const checkpoint::Standing standing = checkpoint::standing_in(folder, ecology.describe(origin.at_s));
  if (standing.complete) return true;
  observe::StopOnSignal stop;
  observe::RunFolder files{folder, {}, origin.extent, standing.opening(), observe::state_columns(ecology.states())};
  observe::Progress progress;
  checkpoint::run_kept(ecology, origin.at_s, folder, {}, standing.from, files, progress, stop);
  return ecology.time_s() >= origin.at_s;
}

/// Calls `use` with an experiment of these numbers or with its neutral shadow.
template <class Rules, Backend B, class Use>
decltype(auto) with_planned(const Config& config, bool shadow, Use&& use) {
  ExperimentOptions one_thread;
  one_thread.threads = 1;
  const Experiment<Rules, B> numbers = numbers_of<Rules, B>(one_thread, config);
  return shadow ? use(shadow_of(numbers)) : use(numbers);
}

template <class Rules, Backend B>
[[nodiscard]] PlannedFacts facts(const Config& config, bool shadow) {
  return with_planned<Rules, B>(config, shadow, []<class Table>(const Experiment<Table, B>& numbers) {
    const EcologyParams& ecology = numbers.ecology;
    const double steps_a_second = JointDriven<B> ? 1.0 / numbers.physics.timestep_s : ecology.control_hz;
    return PlannedFacts{
        Ecology<Table, B>{numbers}.describe(ecology.duration_s),
        static_cast<double>(ecology.robots) * std::ceil(ecology.duration_s * ecology.clock_scale * steps_a_second)};
  });
}

template <class Rules, Backend B>
void run_planned(const Config& config, bool shadow, std::uint64_t seed, const std::filesystem::path& folder,
                 const replicates::Keeping& keeping, observe::JointProgress::Part progress, const observe::StopOnSignal& stop) {
  with_planned<Rules, B>(config, shadow, [&]<class Table>(Experiment<Table, B> numbers) {
    numbers.seed = seed;
    replicates::run_in_folder(numbers, folder, keeping, std::move(progress), stop);
  });
}

template <class Rules, class Backends>
void add_pairings(std::vector<Pairing>& pairings) {
  const std::string table = table_name<Rules>();
  Backends::for_each([&]<class B>() {
    pairings.push_back({table, std::string{B::name}, [] { return named_params_of(Experiment<Rules, B>{}); }, &run_table<Rules, B>,
                        &describe<Rules, B>, &replay<Rules, B>, &facts<Rules, B>, &run_planned<Rules, B>});
  });
}

}  // namespace detail

/// The command line of an experiment with rule tables to choose from, on backends of one's own choice: `BackendList<...>`.
template <class Backends, class... Rules>
[[nodiscard]] int experiment_on(int argc, const char* const* argv) {
  static_assert(sizeof...(Rules) > 0, "trophic::command::experiment needs at least one rule table");
  return guarded(argv[0], [&] {
    std::vector<Pairing> pairings;
    (detail::add_pairings<Rules, Backends>(pairings), ...);
#ifdef TROPHIC_WITH_MPI
    return experiment_program(argc, argv, pairings, backend_versions<Backends>(), &mpi::find_team);
#else
    return experiment_program(argc, argv, pairings, backend_versions<Backends>());
#endif
  });
}

/// The command line of an experiment with rule tables to choose from, the first of them the default, on the kinematic backend and
/// every engine that the program is linked with: --help, --rules, --backend, --config, --set, --replicates, --shadow, --resume,
/// --sweep and more. Returns the exit code: 0, 1 for what went wrong in a run, 2 for what is wrong with the arguments, 3 for a
/// run that a signal stopped.
template <class... Rules>
[[nodiscard]] int experiment(int argc, const char* const* argv) {
  return experiment_on<LinkedBackends, Rules...>(argc, argv);
}

}  // namespace trophic::command
