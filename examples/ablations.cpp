// SPDX-License-Identifier: MIT
// Which differences between the paper's text and its released code matter: each of four rules flipped alone, in replicates.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/near_remembered_adversary.hpp>
#include <trophic/perception/blind_keeps_outputs.hpp>
#include <trophic/replicates/run.hpp>
#include <trophic/reproduction/last_seen_victim.hpp>
#include <trophic/reproduction/shared_copy.hpp>
#include <trophic/rules/paper.hpp>
#include <vector>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif

#include "command.hpp"
#include "facts.hpp"

namespace {

using trophic::rules::Paper;

using SharedGenome = trophic::with_heredity<Paper, trophic::reproduction::SharedCopy>;
using FrozenWhenBlind = trophic::with_blind_rule<Paper, trophic::perception::BlindKeepsOutputs>;
using StaleReprieve = trophic::with_reprieve<Paper, trophic::death::NearRememberedAdversary>;
using LastSeenParent = trophic::with_starvation_parent<Paper, trophic::reproduction::LastSeenVictim>;

struct Options {
  std::string backend = "kinematic";
  double duration_s = 6000.0;
  trophic::replicates::Plan plan;
  std::vector<std::string> only;
  trophic::observe::Facts facts;
};

/// Runs one table into OUT/NAME. Whether all its replicates are complete.
template <class Rules, class Backend>
bool run(const char* name, const Options& options) {
  if (!options.only.empty() && std::ranges::find(options.only, name) == options.only.end()) return true;
  std::cout << name << ": " << trophic::table_name<Rules>() << std::endl;
  trophic::Experiment<Rules, Backend> experiment;
  experiment.world.duration_s = options.duration_s;
  trophic::replicates::Plan plan = options.plan;
  plan.out /= name;
  const auto outcome = trophic::replicates::run<Rules, Backend>(experiment, plan, options.facts, std::cout);
  for (const std::string& sentence : outcome.unfinished) std::cerr << "ablations: " << name << "/" << sentence << "\n";
  return outcome.all_complete();
}

/// Every table, with the same seeds. Stops at the first with an unfinished replicate.
template <class Backend>
bool run_all(const Options& options) {
  return run<Paper, Backend>("paper", options) && run<SharedGenome, Backend>("shared_genome", options) &&
         run<FrozenWhenBlind, Backend>("frozen_when_blind", options) && run<StaleReprieve, Backend>("stale_reprieve", options) &&
         run<LastSeenParent, Backend>("last_seen_parent", options);
}

bool run_on_backend(const Options& options) {
  if (options.backend == trophic::backend::Kinematic::name) return run_all<trophic::backend::Kinematic>(options);
#ifdef TROPHIC_WITH_MUJOCO
  if (options.backend == trophic::backend::Mujoco::name) return run_all<trophic::backend::Mujoco>(options);
#endif
  throw std::invalid_argument{"--backend " + options.backend + ": is none of this build's backends"};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  options.facts = facts(argc, argv);

  CLI::App app{
      "The paper's rules, and with one rule each as in its released code: shared_genome (offspring and parent share one genome), "
      "frozen_when_blind (who sees nobody keeps angle and tag), stale_reprieve (hunger spares by the last remembered distance), "
      "last_seen_parent (prey descend from the one that the dying predator last saw). One folder each, for analyze --compare."};
  app.add_option("--backend", options.backend, "physics: kinematic, or mujoco where it is built (kinematic)");
  app.add_option("--seed", options.plan.master_seed, "the seeds of all replicates follow from it (1)");
  app.add_option("--duration", options.duration_s, "length of each run, seconds of the ecology's clock (6000)");
  app.add_option("--replicates", options.plan.count, "runs of each table (10)");
  app.add_option("--jobs", options.plan.jobs, "replicates at a time (1); results do not depend on it");
  app.add_option("--only", options.only, "these tables only")
      ->check(CLI::IsMember({"paper", "shared_genome", "frozen_when_blind", "stale_reprieve", "last_seen_parent"}));
  app.add_flag("--resume", options.plan.resume, "run only what OUT lacks");
  app.add_option("--out", options.plan.out, "folder for the tables' folders")->required();
  return run_command(app, argc, argv, "ablations", [&] {
    options.plan.check();
    return run_on_backend(options) ? 0 : run_error;
  });
}
