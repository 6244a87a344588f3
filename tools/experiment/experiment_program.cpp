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
      {{"--rules", &options.rules, "rule table: " + one_of(tables) + " (" + tables.front() + ")"},
       {"--backend", &options.backend, backend_help(backends, offer.default_backend)},
       {"--config", &options.config, "TOML file with parameters, as --print-config writes it"},
       {"--set", &options.assignments, "PATH=VALUE, e.g. rules.mutation.sd=0.1; may be repeated; wins over --config"},
       {"--robot", &options.robot, "name or path of a robot file (the table's)"},
       {"--robots", &options.robots, "number of bodies (the table's)"}});
  add("How long and how many",
      {{"--duration", &options.duration_s, "length of the run, seconds of the ecology's clock (the table's)"},
       {"--seed", &options.seed, "every random number follows from it (1)"},
       {"--replicates", &options.replicates,
        "number of runs, into OUT/replicate-00, ...; their seeds follow from --seed and are written to replicates.json"},
       {.name = "--shadow",
        .target = &options.shadow,
        .help =
            "run the table's neutral shadow too, into OUT/shadow: the same rules, parameters and seeds, but nothing is inherited",
        .needs = {"--replicates"}},
       {.name = "--neutral",
        .target = &options.neutral,
        .help =
            "run the table's neutral null too, into OUT/neutral: the births, deaths and parents of the runs are repeated with "
            "genomes of their own, so that nothing is selected",
        .needs = {"--replicates"},
        .not_with = {"--from"}},
       {.name = "--clones",
        .target = &options.clones,
        .help = "run the table with one genome for all too, into OUT/clones: who differs from whom cannot matter",
        .needs = {"--replicates"},
        .not_with = {"--from"}},
       {.name = "--one-sided",
        .target = &options.one_sided,
        .help = "run the table's one-sided worlds too, into OUT/one_sided_SPECIES for each species: that species inherits "
                "nothing, all "
                "others as the table says",
        .needs = {"--replicates"}},
       {.name = "--jobs",
        .target = &options.jobs,
        .help = "replicates, runs of a plan or contests at a time (one per core); results do not depend on it",
        .needs = {"--replicates", "--plan", "--play"}},
       {"--threads", &options.threads, "threads of the physics; results do not depend on it (all cores; 1 with --replicates)"}});
  add("A plan of runs",
      {{.name = "--plan",
        .target = &options.plan,
        .help = "make the runs that this file lists, next to it, or resume those that are not complete; trophic plan writes one",
        .only_with = {"--jobs", "--run", "--status", "--describe", "--checkpoint-s", "--accept-other-build", "--no-verify"}},
       {.name = "--run",
        .target = &options.run,
        .help = "only the plan's runs with these numbers, from 0; for Slurm, GNU parallel, MPI, ...",
        .needs = {"--plan"}},
       {.name = "--status",
        .target = &options.status,
        .help = "print how many runs of the plan are done, running, failed and missing, and the time left, and exit",
        .needs = {"--plan"},
        .only_with = {"--plan", "--no-verify"}},
       {.name = "--describe",
        .target = &options.describe,
        .help = "check each run of the plan, print its length, amount of work and fingerprint as JSON, and exit",
        .needs = {"--plan"},
        .only_with = {"--plan"}}});
  add("Output",
      {{"--out", &options.out, "new folder for the run's files (the next free runs/" + options.program + "-1, -2, ...)"},
       {"--replay-hz", &options.replay_hz,
        "frames of the recording in a simulated second: 0 (none), 5, 10 or 30 (5); nothing else of a run depends on it"},
       {"--agents-every", &options.agents_every,
        "agents.csv has the ticks whose number is a multiple of this (1); for large ecologies"},
       {"--senses", &options.senses, "write senses.csv too: contacts, inputs and outputs of every robot"},
       {"--states", &options.states, "write states.csv too: what rules with a State keep for every robot"},
       {"--checkpoint-s", &options.checkpoint_s,
        "seconds of the ecology's clock between two checkpoints (300); 0: only when a run ends or is stopped"},
       {.name = "--profile",
        .target = &options.profile,
        .help = "print at the end what the steps of MuJoCo's robots were, if it counts them: apart, in touching pairs, ...",
        .not_with = {"--replicates"}},
       {.name = "--save-mjcf",
        .target = &options.save_mjcf,
        .help = "write the model at the start as MJCF (opens in MuJoCo's simulate); without --out nothing is run",
        .not_with = {"--replicates"}}});
  add("Look",
      {{.name = "--live",
        .target = &options.live,
        .help = "show the run in a browser of this machine and let the page pause it, change rule parameters and start again; it "
                "prints the page's address",
        .not_with = {"--replicates", "--from", "--save-mjcf"}},
       {.name = "--live-port",
        .target = &options.live_port,
        .help = "port of that address, for ssh -L (any free one)",
        .needs = {"--live"}}});
  add("Resume and branch",
      {{.name = "--resume",
        .target = &options.resume,
        .help = "resume in OUT: a run, or those replicates that are missing or were interrupted, from their last checkpoints. It "
                "keeps what OUT has of --replay-hz, --agents-every, --senses and --states",
        .needs = {"--out"}},
       {.name = "--accept-other-build",
        .target = &options.accept_other_build,
        .help = "resume runs that another build of this program made, whose rules may be other code under the same names; "
                "manifests record it",
        .needs = {"--resume", "--from", "--plan"}},
       {.name = "--no-verify",
        .target = &options.no_verify,
        .help = "keep complete runs without comparing their files with their checksums, which takes time for ten thousand runs",
        .needs = {"--resume", "--plan"}},
       {.name = "--from",
        .target = &options.from,
        .help = "begin at the state of the run in this folder at --at, with another --seed, other rules or other parameters of "
                "rules, or with --replicates of its future",
        .not_with = {"--save-mjcf", "--changes"}},
       {.name = "--at",
        .target = &options.at_s,
        .help = "seconds of that run's clock (its last checkpoint)",
        .needs = {"--from"}}});
  add("Changes",
      {{"--changes", &options.changes,
        "CSV file with columns time_s, number and value: rule parameters that change during the run; replaying a run's "
        "changes.csv reproduces the live run exactly"}});
  add("Contests",
      {{.name = "--play",
        .target = &options.play,
        .help = "play the contests in this file, with --jobs at a time, and write their outcomes next to it; trophic contest "
                "--program writes the file and calls this",
        .only_with = {"--jobs"}},
       {.name = "--signatures",
        .target = &options.signatures,
        .help = "print which genomes in this file decide alike; trophic analyze --lineages --program writes the file and calls "
                "this",
        .only_with = {"--signatures"}}});
  const std::vector<std::string> of_the_experiment{"--rules",  "--backend",  "--config", "--set",    "--robot",
                                                   "--robots", "--duration", "--seed",   "--threads"};
  add("Print", {{.name = "--print-config",
                 .target = &options.print_config,
                 .help = "print every parameter as TOML and stop",
                 .only_with = of_the_experiment},
                {.name = "--print-table",
                 .target = &options.print_table,
                 .help = "print the rules with their parameters and sources as a Markdown table, and stop",
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
                              ", what this program makes of its parameters; rules, models or engine changed"};
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
        " is not there: must be the folder of a run or of replicates; without --resume a run begins there"};
  }
  const std::filesystem::path usual_out = std::filesystem::path{"runs"} / options.program;
  const bool has_usual_out = options.out.empty() && options.save_mjcf.empty();
  if (has_usual_out) options.out = io::next_free_folder(usual_out).string();
  std::unique_ptr<AnyExperiment> its;
  if (origin) {
    its = find_experiment(offer, origin->rule_table, origin->engine);
    if (its == nullptr) {
      throw std::invalid_argument{"--from " + options.from + ": is a run of " + origin->rule_table + " on " + origin->engine +
                                  ", which this program lacks"};
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
      throw std::invalid_argument{"two rule tables are called " + table + ": each needs a name of its own"};
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
                        .about = "Runs an ecology of simulated robots by the rules of " + one_of(table_names(offer)) +
                                 ", and writes its events, agents, phylogeny and genomes with a manifest into a new folder.",
                        .options = detail::options_of(options, offer),
                        .work = [&] { return detail::run_options(options, offer); },
                        .version = version_text(backend_versions(offer.backends)),
                        .examples = {options.program + " --backend kinematic --duration 600",
                                     options.program + " --replicates 10 --shadow --out runs/study",
                                     options.program + " --plan runs/sweep/plan.jsonl --jobs 4"}});
  });
}

}  // namespace trophic::command
