// SPDX-License-Identifier: MIT
// Definitions of run_experiment.hpp.
#include <exception>
#include <system_error>
#include <thread>
#include <tools/changes/change.hpp>
#include <tools/changes/changing_simulation.hpp>
#include <tools/changes/may_follow.hpp>
#include <tools/command/output.hpp>
#include <tools/command/read_parameters.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/command/toml_writer.hpp>
#include <tools/experiment/experiment_of.hpp>
#include <tools/experiment/printed_rules.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/recording/read_recording.hpp>
#include <tools/recording/species_colour.hpp>
#include <tools/replicates/rewind.hpp>
#include <tools/replicates/run_with_nulls.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace detail {

/// Frames of a run's recording in a simulated second; 0 without one, the default if it cannot be read.
[[nodiscard]] inline double replay_hz_of(const std::filesystem::path& run) {
  const std::filesystem::path path = run / "replay.trp";
  if (!std::filesystem::exists(path)) return 0.0;
  try {
    const io::RecordingHead head = io::RecordingReader{path}.head();
    return static_cast<double>(head.frames_per_tick) / (head.times.tick_s * head.times.clock_scale);
  } catch (const std::runtime_error&) {
    return io::default_replay_hz;
  }
}

/// Output options from --replay-hz, --agents-every, --senses and --states.
[[nodiscard]] inline io::OutputOptions output_options_of(const ExperimentOptions& options) {
  return {.replay_hz = options.replay_hz ? static_cast<double>(*options.replay_hz) : io::default_replay_hz,
          .agents_every_ticks = static_cast<std::int64_t>(options.agents_every),
          .senses = options.senses,
          .states = options.states};
}

/// Plan of the replicates from --replicates, --jobs and --resume, with the master seed.
[[nodiscard]] inline replicates::Plan plan_of(const ExperimentOptions& options, std::uint64_t master_seed) {
  const std::uint64_t cores = std::max(1U, std::thread::hardware_concurrency());
  return {.out = options.out,
          .master_seed = master_seed,
          .count = *options.replicates,
          .jobs = options.jobs.value_or(std::min(cores, *options.replicates)),
          .resume = options.resume,
          .checkpoints = schedule_of(options),
          .output = output_options_of(options),
          .own_tables = changes::with_changes(options.own_tables)};
}

/// The parameters of a table on a backend as a configuration file.
[[nodiscard]] inline int print_config(const std::string& table, const std::string& backend, NamedParams named_params) {
  for (NamedParam& param : named_params)
    if (param.path.starts_with("rules.")) param.help += std::string{changes::when_read(param.read)};
  TomlWriter writer;
  writer.put("rule_table", table);
  writer.put("engine", backend);
  writer.put_all(named_params);
  return print_text(writer.text());
}

/// Reports replicates that are not complete, a sentence each, and returns the exit code.
[[nodiscard]] inline int report_unfinished(const ExperimentOptions& options, const std::vector<std::string>& unfinished) {
  flush_output();
  if (unfinished.empty()) return 0;
  for (const std::string& sentence : unfinished) std::cerr << options.program << ": " << sentence << "\n";
  std::cerr << "to resume only these, repeat the command with --resume\n";
  return replicates::StopOnSignal::caught() != 0 ? stopped : run_error;
}

/// Reports how a run in a folder ended, and returns the exit code.
[[nodiscard]] inline int report_run(io::RunFolder& folder, const observe::Progress& progress, const Simulation& ecology,
                                    double until_s, bool profile) {
  const View view = ecology.view();
  const std::string slow = replicates::add_speed(folder.manifest(), progress.elapsed_s(), ecology, profile);
  const bool is_stopped = view.time_s < until_s && !view.is_over;
  if (is_stopped) {
    const int signal = replicates::StopOnSignal::caught();
    std::cout << (signal != 0 ? "stopped by signal " + std::to_string(signal) : "ended from its page") << " at "
              << number_text(view.time_s) << " of " << number_text(until_s)
              << " s; to resume it, repeat the command with --resume --out " << shown(folder.path()) << "\n";
  }
  progress.summary(std::cout, view);
  if (!slow.empty()) std::cout << "remark  " << slow << "\n";
  std::cout << "files   " << shown(folder.path()) << "/{";
  for (const std::string& name : folder.files()) {
    const bool is_table = name.ends_with(".csv");
    std::cout << (name == "events.csv"      ? ""
                  : is_table                ? ","
                  : name == "manifest.json" ? "}.csv, "
                                            : ", ")
              << (is_table ? name.substr(0, name.size() - 4) : name);
  }
  std::cout << ", checkpoint.bin\n";
  flush_output();
  return is_stopped ? stopped : 0;
}

/// The snapshot of a run at a moment, and the place to make it for the runs that begin there. Throws std::invalid_argument if
/// they cannot begin there, before anything is made.
[[nodiscard]] inline checkpoint::Snapshot snapshot_of(const ExperimentOptions& options, const OriginRun& origin,
                                                      const observe::RunDescription& run) {
  changes::check_may_follow(origin.description, run);
  if (!(origin.moment.at_s <= run.until_s)) {
    throw std::invalid_argument{"--at " + number_text(origin.moment.at_s) + ": must be <= " + number_text(run.until_s) +
                                ", the duration of the new run"};
  }
  if (!options.resume) io::check_new_folder(options.out);
  checkpoint::Snapshot snapshot{origin.moment, checkpoint::snapshot_folder(options.out, origin.moment)};
  for (const std::filesystem::path& place : {snapshot.folder.parent_path(), snapshot.folder}) {
    if (std::filesystem::exists(place) && std::filesystem::equivalent(place, origin.moment.run)) {
      throw std::invalid_argument{place.string() + ": must not exist: the snapshot of " + options.out + " is made there"};
    }
  }
  return snapshot;
}

/// The value in a manifest's "params" under a path such as "rules.mutation.sd"; null if there is none.
[[nodiscard]] inline Json value_at(const Json& params, std::string_view path) {
  const std::size_t dot = path.find('.');
  const auto found = params.is_object() ? params.find(std::string{path.substr(0, dot)}) : params.end();
  if (!params.is_object() || found == params.end()) return nullptr;
  return dot == std::string_view::npos ? *found : value_at(*found, path.substr(dot + 1));
}

/// Throws std::invalid_argument for a run of other rules or parameters in a folder that is to be resumed: the first three that
/// differ, with both values. Other differences, such as models, are found by those who resume.
inline void check_resumed(const std::filesystem::path& folder, const observe::RunDescription& run) {
  const std::filesystem::path path = folder / "manifest.json";
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return;
  const Json there = parse_sealed(read_whole_file(path));
  const Json fingerprint = value_at(there, "fingerprint");
  if (fingerprint.is_null() || fingerprint == Json(run.fingerprint)) return;
  std::string text;
  std::size_t found = 0;
  const auto compare = [&](const std::string& name, const Json& its, const Json& ours) {
    if (its.is_null() || its == ours || ++found > 3) return;
    text += (text.empty() ? "" : "; ") + name + " = " + json_text(its) + " there, " + json_text(ours) + " here";
  };
  compare("engine", value_at(there, "backend"), run.backend);
  compare("rule_table", value_at(there, "rule_table"), run.rules);
  for (const NamedParam& param : run.named_params) {
    if (param.path == "seed" || param.path == "ecology.duration_s") continue;
    std::visit([&](const auto& value) { compare(param.path, value_at(there, "params." + param.path), value); }, param.value);
  }
  if (found == 0) return;
  if (found > 3) text += " and " + std::to_string(found - 3) + " more";
  throw std::invalid_argument{"--resume: " + folder.string() + " has a run with different rules or parameters: " + text};
}

/// Throws std::invalid_argument if a run that is to be resumed had changes and the options have none, or the other way round.
inline void check_same_changes(const ExperimentOptions& options, const std::filesystem::path& folder) {
  std::error_code unknown;
  if (!options.resume || options.live || !std::filesystem::exists(folder / "manifest.json", unknown)) return;
  const bool has_changes = std::filesystem::exists(folder / changes::file_name);
  if (has_changes == !options.changes.empty()) return;
  throw std::invalid_argument{has_changes ? "--changes: is needed to resume, because " + folder.string() + " has changes.csv"
                                          : "--changes " + options.changes + ": must be omitted, because the run in " +
                                                folder.string() + " has no changes.csv"};
}

/// Makes the past of runs that begin at a moment. Returns false if a signal came before it was made. Throws
/// std::invalid_argument if `first`, the ecology of such a run, cannot begin there.
[[nodiscard]] inline bool make_snapshot(const checkpoint::Snapshot& snapshot, const OriginRun& origin, Simulation& first) {
  std::cout << shown(snapshot.folder) << ": making the snapshot, " << shown(origin.moment.run) << " until "
            << number_text(origin.moment.at_s) << " s" << std::endl;
  if (!origin.make(snapshot.folder)) return false;
  checkpoint::check_begins(snapshot, first);
  return true;
}

/// The state from which the run of the options starts; `nullopt` if a signal came before its past was made.
[[nodiscard]] inline std::optional<checkpoint::RunState> run_state_for(const ExperimentOptions& options, Simulation& ecology,
                                                                       double until_s, const std::optional<OriginRun>& origin) {
  const observe::RunDescription run = ecology.describe(until_s);
  const checkpoint::Schedule schedule = schedule_of(options);
  if (!options.changes.empty()) check_same_changes(options, options.out);  // else the checkpoint has them
  if (options.resume) check_resumed(options.out, run);
  if (!origin) return options.resume ? checkpoint::run_state_in(options.out, run, schedule) : checkpoint::RunState{};
  const checkpoint::Snapshot snapshot = snapshot_of(options, *origin, run);
  if (!checkpoint::needs_snapshot(options.out, run.until_s) && !checkpoint::SnapshotFolder::exists(snapshot)) {
    return checkpoint::run_state_in(options.out, run, snapshot, schedule);
  }
  checkpoint::SnapshotFolder room{snapshot};
  if (!options.resume) io::check_new_folder(options.out);
  if (checkpoint::needs_snapshot(options.out, run.until_s) && !make_snapshot(snapshot, *origin, ecology)) return std::nullopt;
  auto run_state = checkpoint::run_state_in(options.out, run, snapshot, schedule);
  room.clear();
  return run_state;
}

/// How large agents.csv will be, a line. The estimate with the numbers of the start is right within a factor 1.5 in every shipped
/// table, from 0.67 (wolf_sheep, pond_with_conditions) to 1.5 (lotka_volterra).
[[nodiscard]] inline std::string size_of_agents(const View& view, double until_s, std::uint64_t every_ticks) {
  constexpr double bytes_a_row = 97.0;
  const double ticks = std::floor(until_s / (view.tick_s * static_cast<double>(every_ticks))) + 1.0;
  const auto size_MB = [&](std::size_t rows_a_tick) {
    return number_text(std::ceil(bytes_a_row * ticks * static_cast<double>(rows_a_tick) / 1e5) / 10.0) + " MB";
  };
  const auto living = static_cast<std::size_t>(std::ranges::count_if(view.robots, &Individual::lives));
  std::string line = "writes  agents.csv, about " + size_MB(living);
  if (living < view.robots.size()) line += " with the numbers of the start, at most " + size_MB(view.robots.size());
  return line + (every_ticks == 1 ? "; --agents-every 10: a tenth" : "");
}

/// Runs an ecology into the folder that the options name and returns the exit code. `live`: null without --live.
[[nodiscard]] inline int run_into_folder(const ExperimentOptions& options, Simulation& ecology, double until_s,
                                         checkpoint::RunState run_state, const std::optional<OriginRun>& origin,
                                         LiveServer* live) {
  replicates::StopOnSignal stop;
  io::RunFolder folder{options.out,         options.provenance,      output_options_of(options),
                       run_state.opening(), ecology.state_columns(), changes::with_changes(options.own_tables)(ecology)};
  if (options.states && ecology.state_columns().columns.empty()) {
    std::cout << "states  none: no rule in this table has a State, so states.csv lists only the robots\n";
  }
  if (run_state.opening() == Opening::created) {
    std::cout << size_of_agents(ecology.view(), until_s, options.agents_every) << std::endl;
  }
  observe::Progress progress;
  try {
    if (run_state.begins) {
      checkpoint::begin_at(run_state, origin->moment, ecology, folder.manifest(), checkpoint::parts_of(folder, progress, stop));
    }
    const checkpoint::Schedule schedule = schedule_of(options);
    if (live != nullptr) {
      live->run_with_checkpoints(ecology, until_s, options.out, schedule, run_state.from, folder, progress, stop);
    } else {
      checkpoint::run_with_checkpoints(ecology, until_s, options.out, schedule, run_state.from, folder, progress, stop);
    }
  } catch (const std::exception& error) {
    const int code = report_failure(options.program.c_str(), error);
    if (live != nullptr) live->failed(error.what());
    std::error_code unknown;
    const bool is_there = std::filesystem::exists(folder.path(), unknown);
    std::cerr << (is_there ? "all output so far is in " : "the run's folder was removed or moved: ") << folder.path().string()
              << "\n";
    return code;
  }
  return report_run(folder, progress, ecology, until_s, options.profile);
}

int run_once(const ExperimentOptions& options, AnyExperiment& experiment, const MakeSimulation& make,
             const std::optional<OriginRun>& origin, LiveServer* live) {
  const std::unique_ptr<Simulation> ecology = make(experiment.seed());
  if (!options.save_mjcf.empty()) {
    const std::unique_ptr<Simulation> plain = experiment.simulations(Null::none)(experiment.seed());
    std::vector<Colour> colours;
    for (const Individual& individual : plain->view().robots) colours.push_back(species_colour(individual.species));
    if (!plain->backend().save_mjcf(options.save_mjcf, colours))
      throw std::invalid_argument{"--save-mjcf: needs --backend mujoco"};
    if (options.out.empty()) return 0;
  }
  const double until_s = experiment.ecology().duration_s;
  std::optional<checkpoint::RunState> run_state = run_state_for(options, *ecology, until_s, origin);
  if (!run_state) return stopped;
  if (!run_state->remark.empty()) std::cout << shown(options.out) << " " << run_state->remark << std::endl;
  if (run_state->complete) return 0;
  return run_into_folder(options, *ecology, until_s, std::move(*run_state), origin, live);
}

/// Whether a replicate of the experiment, or of one of its nulls, has nothing to resume from.
[[nodiscard]] inline bool needs_snapshot(const replicates::Plan& plan, std::span<const Null> nulls, double until_s) {
  const auto any = [&](const replicates::Plan& set) {
    return std::ranges::any_of(set.all(),
                               [&](const replicates::Replicate& one) { return checkpoint::needs_snapshot(one.folder, until_s); });
  };
  return any(plan) || std::ranges::any_of(nulls, [&](const Null& null) {
           replicates::Plan beside = plan;
           beside.out /= name_of(null);
           return any(beside);
         });
}

/// The nulls that the options ask for, of the ecologies that `make` makes. Throws std::invalid_argument for --one-sided with one
/// species.
[[nodiscard]] inline std::vector<Null> nulls_of(const ExperimentOptions& options, const MakeSimulation& make,
                                                std::uint64_t seed) {
  std::vector<Null> nulls;
  if (options.shadow) nulls.emplace_back(Null::shadow);
  if (options.neutral) nulls.emplace_back(Null::neutral);
  if (options.clones) nulls.emplace_back(Null::clones);
  if (!options.one_sided) return nulls;
  const FoodWeb web = make(seed)->view().web;
  if (web.size() < 2) {
    throw std::invalid_argument{"--one-sided: needs a table with at least two species; with " + web.name(0) +
                                " only, it would be the same as --shadow"};
  }
  for (Species species = 0; species < web.size(); ++species) nulls.emplace_back(Null::one_sided, web.name(species));
  return nulls;
}

/// Runs replicates into the folder that the options name, with the nulls that are asked for, and returns the exit code.
[[nodiscard]] inline int run_replicates(const AnyExperiment& chosen, const ExperimentOptions& options, const Config& config,
                                        AnyExperiment& experiment, const std::optional<OriginRun>& origin) {
  const MakeSimulation make = simulations(chosen, options, config, experiment, Null::none);
  const double until_s = experiment.ecology().duration_s;
  replicates::Plan plan = plan_of(options, experiment.seed());
  plan.check();
  for (const replicates::Replicate& one : plan.all()) check_same_changes(options, one.folder);
  if (options.resume) check_resumed(plan.all().front().folder, make(plan.master_seed)->describe(until_s));
  const std::vector<Null> nulls = nulls_of(options, make, plan.master_seed);
  std::optional<checkpoint::SnapshotFolder> room;
  if (origin) {
    plan.check();
    plan.snapshot = snapshot_of(options, *origin, make(plan.master_seed)->describe(until_s));
    if (needs_snapshot(plan, nulls, until_s) || checkpoint::SnapshotFolder::exists(*plan.snapshot)) room.emplace(*plan.snapshot);
    if (!options.resume) io::check_new_folder(options.out);
    if (needs_snapshot(plan, nulls, until_s) && !make_snapshot(*plan.snapshot, *origin, *make(plan.master_seed))) return stopped;
  }
  std::vector<replicates::SetOfRuns> sets{{Null::none, make}};
  for (const Null& null : nulls) {
    const HistoryOf history = null == Null::neutral ? replicates::histories_of(plan) : HistoryOf{};
    sets.push_back({null, simulations(chosen, options, config, experiment, null, history)});
  }
  const auto unfinished = replicates::run_with_nulls(sets, until_s, plan, options.provenance, std::cout);
  if (room && unfinished.empty()) room->clear();
  return report_unfinished(options, unfinished);
}

}  // namespace detail

OriginRun read_origin(const ExperimentOptions& options) {
  OriginRun origin;
  origin.moment.run = options.from;
  const std::filesystem::path path = origin.moment.run / "manifest.json";
  const Json json = parse_sealed(read_whole_file(path));
  try {
    if (!json.is_object()) throw std::invalid_argument{"is not a run's manifest, or was modified after trophic wrote it"};
    if (const std::string damage = checkpoint::damage_in(origin.moment.run); !damage.empty()) throw std::runtime_error{damage};
    origin.rule_table = json.at("rule_table").get<std::string>();
    origin.engine = json.at("backend").get<std::string>();
    origin.engine.resize(std::min(origin.engine.find(' '), origin.engine.size()));
    origin.moment.fingerprint = json.at("fingerprint").get<std::string>();
    origin.moment.seed = whole_number<std::uint64_t>(json, "seed");
    if (json.contains("code")) origin.moment.code = json["code"].get<std::string>();
    if (json.contains("agents_every_ticks")) {
      origin.output.agents_every_ticks = whole_number<std::int64_t>(json, "agents_every_ticks", 1);
    }
    origin.output.replay_hz = detail::replay_hz_of(origin.moment.run);
    origin.output.senses = json.contains("senses");
    origin.output.states = std::filesystem::exists(origin.moment.run / io::StateLog::file_name);
    origin.params = toml_of(json.at("params"));
  } catch (const Json::exception& error) {
    throw std::invalid_argument{path.string() + ": " + reason_of(error)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{path.string() + ": " + error.what()};
  }
  if (std::filesystem::exists(origin.moment.run / changes::file_name)) {
    throw std::invalid_argument{"--from " + options.from +
                                ": its parameters changed while it ran (changes.csv); make it again with " +
                                "--changes, or begin from a run without changes"};
  }
  const auto last_s = checkpoint::last_moment_s(origin.moment.run);
  if (!options.at_s && !last_s)
    throw std::invalid_argument{"--at: is needed, because " + options.from + " has no complete checkpoint"};
  origin.moment.at_s = options.at_s.value_or(last_s.value_or(0.0));
  if (!(origin.moment.at_s >= 0.0) || std::isinf(origin.moment.at_s)) {
    throw std::invalid_argument{"--at " + number_text(origin.moment.at_s) + ": must be >= 0 and finite"};
  }
  return origin;
}

observe::RunDescription describe(const AnyExperiment& chosen, const OriginRun& origin) {
  return detail::experiment_of(chosen, origin)->simulations(Null::none)(origin.moment.seed)->describe(0.0);
}

bool replay_origin(const AnyExperiment& chosen, const OriginRun& origin, const ExperimentOptions& options,
                   const std::filesystem::path& folder) {
  const std::unique_ptr<Simulation> ecology = detail::experiment_of(chosen, origin)->simulations(Null::none)(origin.moment.seed);
  if (checkpoint::read_all(folder).empty()) {
    std::filesystem::remove_all(folder);  // a copy that was interrupted
    checkpoint::copy_until(origin.moment.run, origin.moment.at_s, folder);
  }
  const checkpoint::RunState run_state =
      checkpoint::run_state_in(folder, ecology->describe(origin.moment.at_s), schedule_of(options));
  if (run_state.complete) return true;
  replicates::StopOnSignal stop;
  io::RunFolder files{folder, {}, origin.output, run_state.opening(), ecology->state_columns(), options.own_tables};
  observe::Progress progress;
  checkpoint::run_with_checkpoints(*ecology, origin.moment.at_s, folder, {}, run_state.from, files, progress, stop);
  return ecology->time_s() >= origin.moment.at_s;
}

int run_experiment(const AnyExperiment& chosen, const ExperimentOptions& options, const Config& config,
                   const std::optional<OriginRun>& origin) {
  const auto experiment = detail::experiment_of(chosen, options, config);
  if (options.print_config)
    return detail::print_config(chosen.rule_table(), experiment->backend().name(), named_params_of(experiment->params()));
  if (options.print_table)
    return print_text(markdown_table(printed_rules(experiment->slot_rules(), named_params_of(experiment->params()))));
  if (options.replicates) return detail::run_replicates(chosen, options, config, *experiment, origin);
  return detail::run_once(options, *experiment, detail::simulations(chosen, options, config, *experiment, Null::none), origin,
                          nullptr);
}

PlannedFacts facts(const AnyExperiment& chosen, const Config& config, const Null& null) {
  const auto experiment = detail::planned_experiment(chosen, config);
  const EcologyParams& ecology = experiment->ecology();
  const double steps_a_second = experiment->backend().has_joints() ? 1.0 / experiment->physics().timestep_s : ecology.control_hz;
  const std::unique_ptr<Simulation> simulation = experiment->simulations(null)(experiment->seed());
  PlannedFacts facts{simulation->describe(ecology.duration_s),
                     static_cast<double>(ecology.robots) * std::ceil(ecology.duration_s * ecology.clock_scale * steps_a_second),
                     {}};
  const FoodWeb& web = simulation->view().web;
  for (Species species = 0; species < web.size(); ++species) facts.species.push_back(web.name(species));
  return facts;
}

std::string run_planned(const AnyExperiment& chosen, const Config& config, const Null& null, const HistoryOf& history,
                        std::uint64_t seed, const std::filesystem::path& folder, const replicates::CommonOptions& common,
                        replicates::Watch watch) {
  const auto experiment = detail::planned_experiment(chosen, config);
  const std::unique_ptr<Simulation> ecology = experiment->simulations(null, history)(seed);
  return replicates::run_in_folder(*ecology, experiment->ecology().duration_s, folder, common, std::move(watch));
}

}  // namespace trophic::command
