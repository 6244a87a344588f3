// SPDX-License-Identifier: MIT
// The definitions of trophic/experiment.hpp.
#include <algorithm>
#include <memory>
#include <optional>
#include <tools/command/backends.hpp>
#include <tools/command/offers.hpp>
#include <tools/command/output.hpp>
#include <tools/command/provenance.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/words.hpp>
#include <tools/contest/play_contests.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/experiment/run_live.hpp>
#include <tools/experiment/run_plan.hpp>
#include <tools/experiment/signatures.hpp>
#include <trophic/experiment.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <utility>

namespace trophic::command {

namespace detail {

std::vector<Option> options_of(ExperimentOptions& options, const Offer& offer) {
  const auto tables = table_names(offer);
  const auto backends = backend_names(offer.backends);
  std::vector<Option> all;
  const auto add = [&all](const std::string& group, std::vector<Option> some) {
    for (Option& option : in_group(group, std::move(some))) all.push_back(std::move(option));
  };
  add("The experiment",
      {{"--rules", &options.rules, "rule table: " + one_of(tables) + " (default: " + tables.front() + ")"},
       {"--backend", &options.backend, backend_help(backends, offer.default_backend)},
       {"--config", &options.config, "TOML file with parameters, in the format of --print-config"},
       {"--set", &options.assignments, "PATH=VALUE, e.g. rules.mutation.sd=0.1; may be repeated; overrides --config"},
       {"--robot", &options.robot, "name or path of a robot file (default: the table's)"},
       {"--robots", &options.robots, "number of bodies (default: the table's)"}});
  add("How long and how many",
      {{"--duration", &options.duration_s, "length of the run in simulated seconds (default: the table's)"},
       {"--seed", &options.seed, "seed of all random numbers (default: 1)"},
       {"--replicates", &options.replicates,
        "number of replicate runs, written to OUT/replicate-00, ...; their seeds are derived from --seed and listed in "
        "replicates.json"},
       {.name = "--shadow",
        .target = &options.shadow,
        .help = "also run the table's neutral shadow (no-inheritance control) in OUT/shadow: the same rules, parameters and "
                "seeds, but nothing is inherited",
        .needs = {"--replicates"}},
       {.name = "--neutral",
        .target = &options.neutral,
        .help = "also run the table's neutral null in OUT/neutral: it repeats each run's births, deaths and parents with "
                "independent genomes, so selection cannot act on them",
        .needs = {"--replicates"},
        .not_with = {"--from"}},
       {.name = "--clones",
        .target = &options.clones,
        .help = "also run the table in OUT/clones with one genome for all individuals, so that differences between individuals "
                "play no part",
        .needs = {"--replicates"},
        .not_with = {"--from"}},
       {.name = "--one-sided",
        .target = &options.one_sided,
        .help = "also run the table's one-sided worlds, one per species, in OUT/one_sided_SPECIES: that species inherits "
                "nothing, all others follow the table",
        .needs = {"--replicates"}},
       {.name = "--jobs",
        .target = &options.jobs,
        .help = "number of replicates, runs of a plan or contests to run in parallel (default: one per core); results do not "
                "depend on it",
        .needs = {"--replicates", "--plan", "--play"}},
       {"--threads", &options.threads,
        "number of physics threads (default: all cores, or 1 with --replicates); results do not depend on it"}});
  add("A plan of runs",
      {{.name = "--plan",
        .target = &options.plan,
        .help = "make the runs listed in this file, next to it, and resume incomplete ones; trophic plan writes such a file",
        .only_with = {"--jobs", "--run", "--status", "--describe", "--checkpoint-s", "--accept-other-build", "--no-verify"}},
       {.name = "--run",
        .target = &options.run,
        .help = "make only the runs of the plan with these numbers, counted from 0; for Slurm, GNU parallel, MPI, ...",
        .needs = {"--plan"}},
       {.name = "--status",
        .target = &options.status,
        .help = "print how many runs of the plan are done, running, failed or missing and how much time is left, then exit",
        .needs = {"--plan"},
        .only_with = {"--plan", "--no-verify"}},
       {.name = "--describe",
        .target = &options.describe,
        .help = "check each run of the plan, print its length, amount of work and fingerprint as JSON, then exit",
        .needs = {"--plan"},
        .only_with = {"--plan"}}});
  add("Output",
      {{"--out", &options.out, "new folder for the run's files (default: the next free runs/" + options.program + "-1, -2, ...)"},
       {"--replay-hz", &options.replay_hz,
        "recorded frames per simulated second: 0 (none), 5, 10 or 30 (default: 5); it changes nothing else in the run"},
       {"--agents-every", &options.agents_every, "write only every N-th tick to agents.csv (default: 1); for large ecologies"},
       {"--senses", &options.senses, "also write senses.csv: contacts, inputs and outputs of every robot"},
       {"--states", &options.states, "also write states.csv: what rules with a State store for every robot"},
       {"--checkpoint-s", &options.checkpoint_s,
        "simulated seconds between two checkpoints (default: 300); with 0, only when a run ends or is interrupted"},
       {.name = "--profile",
        .target = &options.profile,
        .help = "print at the end how MuJoCo's robots were stepped, if it counts that: apart, in touching pairs, ...",
        .not_with = {"--replicates"}},
       {.name = "--save-mjcf",
        .target = &options.save_mjcf,
        .help = "write the initial model as MJCF, which opens in MuJoCo's simulate; without --out there is no run",
        .not_with = {"--replicates"}}});
  add("Look", {{.name = "--live",
                .target = &options.live,
                .help = "show the run in a browser on this machine, where it can be paused and restarted and rule parameters can "
                        "be changed; prints the page's address",
                .not_with = {"--replicates", "--from", "--save-mjcf"}},
               {.name = "--live-port",
                .target = &options.live_port,
                .help = "port of that address, for ssh -L (default: any free port)",
                .needs = {"--live"}}});
  add("Resume and branch",
      {{.name = "--resume",
        .target = &options.resume,
        .help = "resume an interrupted run in OUT from its last checkpoint, or all missing or interrupted replicates; "
                "--replay-hz, --agents-every, --senses and --states keep the values they have in OUT",
        .needs = {"--out"}},
       {.name = "--accept-other-build",
        .target = &options.accept_other_build,
        .help = "accept runs made by another build of this program, whose rules may have the same names but "
                "other code; manifests record it",
        .needs = {"--resume", "--from", "--plan"}},
       {.name = "--no-verify",
        .target = &options.no_verify,
        .help = "skip the verification of complete runs' checksums, which is slow for ten thousand runs",
        .needs = {"--resume", "--plan"}},
       {.name = "--from",
        .target = &options.from,
        .help = "start from the state at --at of the run in this folder, with another --seed, other rules "
                "or rule parameters, or --replicates of its future",
        .not_with = {"--save-mjcf", "--changes"}},
       {.name = "--at",
        .target = &options.at_s,
        .help = "moment of that run, in simulated seconds (default: its last checkpoint)",
        .needs = {"--from"}}});
  add("Changes", {{"--changes", &options.changes,
                   "CSV file with columns time_s, number and value: changes to rule parameters during the run; replaying a run's "
                   "changes.csv reproduces the live run exactly"}});
  add("Contests", {{.name = "--play",
                    .target = &options.play,
                    .help = "play the contests in this file, --jobs in parallel, and write their outcomes next to it; trophic "
                            "contest --program writes the file and calls this option",
                    .only_with = {"--jobs"}},
                   {.name = "--signatures",
                    .target = &options.signatures,
                    .help = "print which genomes in this file make the same decisions; trophic analyze --lineages --program "
                            "writes the file and calls this option",
                    .only_with = {"--signatures"}}});
  const std::vector<std::string> of_the_experiment{"--rules",  "--backend",  "--config", "--set",    "--robot",
                                                   "--robots", "--duration", "--seed",   "--threads"};
  add("Print", {{.name = "--print-config",
                 .target = &options.print_config,
                 .help = "print every parameter as TOML, then exit",
                 .only_with = of_the_experiment},
                {.name = "--print-table",
                 .target = &options.print_table,
                 .help = "print the rules with their parameters and sources as a Markdown table, then exit",
                 .only_with = of_the_experiment}});
  return all;
}

void check(const ExperimentOptions& options) {
  if (options.threads == std::uint64_t{0}) throw std::invalid_argument{"--threads 0: must be >= 1"};
  if (!(options.checkpoint_s >= 0.0)) {
    throw std::invalid_argument{"--checkpoint-s " + number_text(options.checkpoint_s) + ": must be >= 0"};
  }
  if (!options.save_mjcf.empty()) check_new_file("--save-mjcf", options.save_mjcf);
  if (const auto hz = options.replay_hz; hz && *hz != 0 && *hz != 5 && *hz != 10 && *hz != 30) {
    throw std::invalid_argument{"--replay-hz " + std::to_string(*hz) + ": must be 0, 5, 10 or 30"};
  }
  if (options.agents_every < 1 || options.agents_every > 1'000'000) {
    throw std::invalid_argument{"--agents-every " + std::to_string(options.agents_every) + ": must be >= 1 and <= 1000000"};
  }
  if (options.live_port && (*options.live_port < 1024 || *options.live_port > 65535)) {
    throw std::invalid_argument{"--live-port " + std::to_string(*options.live_port) + ": must be >= 1024 and <= 65535"};
  }
}

void check_rule_table(const std::string& option, const std::string& table, const Offer& offer) {
  const auto tables = table_names(offer);
  if (std::ranges::find(tables, table) != tables.end()) return;
  throw std::invalid_argument{must_be_one_of(option + " " + table, tables) + did_you_mean(nearest_word(table, tables))};
}

/// The models or the program may differ from those that made the run.
void check_unchanged(const OriginRun& origin) {
  const checkpoint::Moment& moment = origin.moment;
  if (origin.description.fingerprint == moment.fingerprint) return;
  throw std::invalid_argument{"--from " + moment.run.string() + ": fingerprint = " + moment.fingerprint + ": must be " +
                              origin.description.fingerprint +
                              ", which this program computes from its parameters; rules, models or engine changed"};
}

/// The experiment of a table and a backend that the options name. Throws std::invalid_argument if the offer lacks one.
std::unique_ptr<AnyExperiment> chosen_experiment(const Offer& offer, const std::string& table, const std::string& backend) {
  check_rule_table("--rules", table, offer);
  if (find_backend(offer, backend) == nullptr) {
    throw std::invalid_argument{about_missing_backend(backend, backend_names(offer.backends))};
  }
  return find_experiment(offer, table, backend);
}

int run_chosen(ExperimentOptions& options, const Offer& offer) {
  Config config = read_config(options.config, options.assignments);
  std::optional<OriginRun> origin;
  if (!options.from.empty()) origin = read_origin(options);
  const std::string table =
      options.rules.value_or(config.rule_table.value_or(origin ? origin->rule_table : offer.rule_tables.front().first));
  const bool needs_engine = !options.print_table;  // a printed table is the same for all
  const std::string own = default_backend_of(offer, table);
  const std::string usual = needs_engine || find_backend(offer, own) != nullptr ? own : "kinematic";
  const std::string backend = options.backend.value_or(config.engine.value_or(origin ? origin->engine : usual));
  std::unique_ptr<AnyExperiment> chosen = chosen_experiment(offer, table, backend);
  check(options);
  check_made_for(config, table, backend);
  const bool has_snapshot =
      origin && std::filesystem::exists(checkpoint::snapshot_folder(options.out, origin->moment).parent_path());
  if (options.resume && !has_snapshot && !std::filesystem::exists(options.out)) {
    throw std::invalid_argument{
        "--resume: " + options.out +
        " does not exist: must be the folder of a run or of replicates; without --resume a new run starts there"};
  }
  const std::filesystem::path usual_out = std::filesystem::path{"runs"} / options.program;
  const bool has_usual_out = options.out.empty() && options.save_mjcf.empty();
  if (has_usual_out) options.out = io::next_free_folder(usual_out).string();
  std::unique_ptr<AnyExperiment> its;
  if (origin) {
    its = find_experiment(offer, origin->rule_table, origin->engine);
    if (its == nullptr) {
      throw std::invalid_argument{"--from " + options.from + ": has the table " + origin->rule_table + " on " + origin->engine +
                                  ", which this program does not have"};
    }
    origin->description = describe(*its, *origin);
    check_unchanged(*origin);
    config.origin = origin->params;
    if (table != origin->rule_table) config.origin.erase("rules");
    origin->make = [&](const std::filesystem::path& folder) { return replay_origin(*its, *origin, options, folder); };
  }
  const bool is_printed = options.print_config || options.print_table;
  if (options.live && !is_printed) return run_live(std::move(chosen), options, config, offer);
  for (;;) {
    try {
      return run_experiment(*chosen, options, config, origin);
    } catch (const io::FolderExists&) {  // another program may take a name at the same moment
      if (!has_usual_out) throw;
      options.out = io::next_free_folder(usual_out).string();
    }
  }
}

int run_options(ExperimentOptions& options, const Offer& offer) {
  const auto tables = table_names(offer);
  for (const std::string& table : tables) {
    if (std::ranges::count(tables, table) > 1) {
      throw std::invalid_argument{"two rule tables are called " + table + ": each must have its own name"};
    }
  }
  if (!options.play.empty()) return play_contests(options.play, options.jobs.value_or(1), offer);
  if (!options.signatures.empty()) return print_signatures(options.signatures, offer);
  if (options.plan.empty()) return run_chosen(options, offer);
  check(options);
  return run_plan(options, offer);
}

}  // namespace detail

int experiment_program(int argc, const char* const* argv, const std::function<Offer()>& own) {
  return guarded(argv[0], [&] {
    const Offer offer = with_backends(own());
    ExperimentOptions options;
    options.program = program_name(argv[0]);
    options.provenance = provenance(argc, argv);
    options.own_tables = offer.tables;
    return run_command(argc, argv,
                       {.name = {},
                        .about = "Runs an ecology of simulated robots under the rule table " + one_of(table_names(offer)) +
                                 ", and writes its events, agents, phylogeny and genomes to a new folder with a manifest.",
                        .options = detail::options_of(options, offer),
                        .work = [&] { return detail::run_options(options, offer); },
                        .version = version_text(backend_versions(offer.backends)),
                        .examples = {options.program + " --backend kinematic --duration 600",
                                     options.program + " --replicates 10 --shadow --out runs/study",
                                     options.program + " --plan runs/sweep/plan.jsonl --jobs 4"}});
  });
}

}  // namespace trophic::command
