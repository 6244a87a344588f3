// SPDX-License-Identifier: MIT
// A program that swaps the differences between two rule tables, in replicates. `trophic ablation-table` reads the result.
#pragma once

#include <iostream>
#include <ostream>
#include <tools/ablations/swaps.hpp>
#include <tools/command/backends.hpp>
#include <tools/command/option.hpp>
#include <tools/command/provenance.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/words.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::command {

namespace detail::ablations {

struct Options {
  std::string from = "both";
  std::string backend{backend::Kinematic::name};
  std::uint64_t seed = 1;
  double duration_s = 6000.0;
  std::optional<std::uint64_t> replicates;
  std::uint64_t jobs = 1;
  std::vector<std::string> only;
  bool shadow = false;
  bool resume = false;
  bool list = false;
  std::string out;
};

/// Every swap of one table, with the same seeds. Stops at the first with an unfinished replicate.
template <class Base, class Other>
[[nodiscard]] bool run_from(const Options& options, Study study) {
  study.plan.out /= std::string{direction_prefix} + table_name<Base>();
  for (const Swap& swap : swaps<Base, Other>()) {
    if (!options.only.empty() && std::ranges::find(options.only, swap.name) == options.only.end()) continue;
    const auto unfinished = run_swap<Base, Other>(swap.name, study);
    for (const std::string& sentence : unfinished) {
      std::cerr << "unfinished: " << direction_prefix << table_name<Base>() << "/" << sentence << "\n";
    }
    if (!unfinished.empty()) return false;
  }
  return true;
}

template <class Base, class Other>
void list(std::ostream& out) {
  for (const Swap& swap : swaps<Base, Other>()) {
    out << direction_prefix << table_name<Base>() << "/" << swap.name << "  " << swap.change << "\n";
  }
}

template <class Base, class Other>
[[nodiscard]] std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& swaps : {swaps<Base, Other>(), swaps<Other, Base>()}) {
    for (const Swap& swap : swaps) {
      if (std::ranges::find(all, swap.name) == all.end()) all.push_back(swap.name);
    }
  }
  return all;
}

template <class Base, class Other>
[[nodiscard]] int run(const Options& options, const io::Provenance& provenance) {
  const bool forth = options.from != table_name<Other>();
  const bool back = options.from != table_name<Base>();
  if (options.list) {
    if (forth) list<Base, Other>(std::cout);
    if (back) list<Other, Base>(std::cout);
    return 0;
  }
  const bool is_kinematic = options.backend == backend::Kinematic::name;
  const auto backends = built_backends();
  const auto chosen = std::ranges::find(backends, options.backend, &BackendChoice::name);
  if (chosen == backends.end()) {
    throw std::invalid_argument{about_missing_backend(options.backend, backend_names(built_backends()))};
  }
  // There are hundreds of runs, which are not watched, so they are not recorded.
  const Study study{.plan = {.out = options.out,
                             .master_seed = options.seed,
                             .count = options.replicates.value_or(is_kinematic ? 30 : 10),
                             .jobs = options.jobs,
                             .resume = options.resume,
                             .output = {.replay_hz = 0.0}},
                    .backend = *chosen,
                    .duration_s = options.duration_s,
                    .shadow = options.shadow,
                    .provenance = provenance};
  study.plan.check();
  if ((!forth || run_from<Base, Other>(options, study)) && (!back || run_from<Other, Base>(options, study))) return 0;
  std::cerr << "the same command with --resume runs what is missing and no more\n";
  return replicates::StopOnSignal::caught() != 0 ? stopped : run_error;
}

}  // namespace detail::ablations

/// The command line of a study of two tables, on every backend that the program is linked with. It needs run_swap in both
/// directions: include tools/ablations/run_swap.hpp and instantiate them explicitly, in files of their own, as they take long to
/// compile.
template <class Base, class Other>
[[nodiscard]] int ablations(int argc, const char* const* argv) {
  return guarded(argv[0], [&] {
    detail::ablations::Options options;
    const std::string base = table_name<Base>();
    const std::string other = table_name<Other>();
    const auto backends = backend_names(built_backends());
    return run_command(
        argc, argv,
        {.name = {},
         .about = "The tables " + base + " and " + other +
                  ", and each with one rule or number as in the other, or a group of them. Sets of replicates go to OUT/from_" +
                  base + "/NAME and OUT/from_" + other + "/NAME; trophic ablation-table OUT says what each swap changes.",
         .options = {{"--from",
                      &options.from,
                      "the table whose rules are swapped: " + one_of(std::vector{base, other, std::string{"both"}}) + " (both)",
                      {base, other, "both"}},
                     {"--backend", &options.backend, "physics: " + one_of(backends) + " (kinematic)"},
                     {"--seed", &options.seed, "the seeds of all replicates follow from it (1)"},
                     {"--duration", &options.duration_s, "length of each run, seconds of the ecology's clock (6000)"},
                     {"--replicates", &options.replicates, "runs of each set (30; 10 with an engine)"},
                     {"--jobs", &options.jobs, "replicates at a time (1); results do not depend on it"},
                     {"--only", &options.only, "these sets only; trophic ablation-table needs base",
                      detail::ablations::names<Base, Other>()},
                     {"--shadow", &options.shadow, "run each set's neutral shadow too, into its folder shadow"},
                     {"--resume", &options.resume, "run only what OUT lacks"},
                     {"--list", &options.list, "list all sets, with what each changes, and stop"},
                     {"--out", &options.out, "folder for the sets' folders"}},
         .work = [&] { return detail::ablations::run<Base, Other>(options, provenance(argc, argv)); },
         .subcommands = {},
         .version = version_text(backend_versions(built_backends()))});
  });
}

}  // namespace trophic::command
