// SPDX-License-Identifier: MIT
// Which differences between the paper's text and its released code matter: each flipped alone, and in groups, from either table
// towards the other, in replicates. `flip_table` reads the result.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <vector>
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif

#include "ablations/flips.hpp"
#include "command.hpp"
#include "facts.hpp"

namespace {

namespace examples = trophic::examples;
using trophic::rules::Paper;
using trophic::rules::Released;

struct Options {
  std::string from = "both";
  std::string backend = "kinematic";
  std::optional<std::size_t> replicates;
  std::vector<std::string> only;
  bool list = false;
  examples::Study study;
};

/// Every flip of one table, with the same seeds. Stops at the first with an unfinished replicate.
template <class Base, class Other, class Backend>
bool run_from(const Options& options) {
  examples::Study study = options.study;
  study.plan.out /= "from_" + std::string{Base::name};
  for (const examples::Flip& flip : examples::flips<Base, Other>()) {
    if (!options.only.empty() && std::ranges::find(options.only, flip.name) == options.only.end()) continue;
    const auto unfinished = examples::run_flip<Base, Other, Backend>(flip.name, study);
    for (const std::string& sentence : unfinished) std::cerr << "ablations: from_" << Base::name << "/" << sentence << "\n";
    if (!unfinished.empty()) return false;
  }
  return true;
}

template <class Backend>
bool run_both(const Options& options) {
  return (options.from == Released::name || run_from<Paper, Released, Backend>(options)) &&
         (options.from == Paper::name || run_from<Released, Paper, Backend>(options));
}

bool run_on_backend(const Options& options) {
  if (options.backend == trophic::backend::Kinematic::name) return run_both<trophic::backend::Kinematic>(options);
#ifdef TROPHIC_WITH_MUJOCO
  if (options.backend == trophic::backend::Mujoco::name) return run_both<trophic::backend::Mujoco>(options);
#endif
  throw std::invalid_argument{"--backend " + options.backend + ": is none of this build's backends"};
}

template <class Base, class Other>
void list(std::ostream& out) {
  for (const examples::Flip& flip : examples::flips<Base, Other>()) {
    out << "from_" << Base::name << "/" << flip.name << "  " << flip.change << "\n";
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  const auto add = [&](const std::vector<examples::Flip>& flips) {
    for (const examples::Flip& flip : flips) {
      if (std::ranges::find(all, flip.name) == all.end()) all.push_back(flip.name);
    }
  };
  add(examples::flips<Paper, Released>());
  add(examples::flips<Released, Paper>());
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  options.study.facts = facts(argc, argv);

  CLI::App app{
      "The paper's table and its released code's, and each with one rule or number as in the other, or a group of them. Sets of "
      "replicates go to OUT/from_paper/NAME and OUT/from_released/NAME; flip_table OUT says what each flip changes."};
  app.add_option("--from", options.from, "the table whose rules are flipped: paper, released or both (both)")
      ->check(CLI::IsMember({"paper", "released", "both"}));
  app.add_option("--backend", options.backend, "physics: kinematic, or mujoco in ablations_mujoco (kinematic)");
  app.add_option("--seed", options.study.plan.master_seed, "the seeds of all replicates follow from it (1)");
  app.add_option("--duration", options.study.duration_s, "length of each run, seconds of the ecology's clock (6000)");
  app.add_option("--replicates", options.replicates, "runs of each set (30; 10 with an engine)");
  app.add_option("--jobs", options.study.plan.jobs, "replicates at a time (1); results do not depend on it");
  app.add_option("--only", options.only, "these sets only; flip_table needs base")->check(CLI::IsMember(names()));
  app.add_flag("--shadow", options.study.shadow, "run each set's neutral shadow too, into its folder shadow");
  app.add_flag("--resume", options.study.plan.resume, "run only what OUT lacks");
  app.add_flag("--list", options.list, "list all sets, with what each changes, and stop");
  app.add_option("--out", options.study.plan.out, "folder for the sets' folders");
  return run_command(app, argc, argv, "ablations", [&] {
    if (options.list) {
      if (options.from != Released::name) list<Paper, Released>(std::cout);
      if (options.from != Paper::name) list<Released, Paper>(std::cout);
      return 0;
    }
    options.study.plan.count = options.replicates.value_or(options.backend == trophic::backend::Kinematic::name ? 30 : 10);
    options.study.plan.check();
    if (run_on_backend(options)) return 0;
    std::cerr << "the same command with --resume runs what is missing and no more\n";
    return run_error;
  });
}
