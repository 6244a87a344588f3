// SPDX-License-Identifier: MIT
// --dry-run and --sbatch: how long a sweep takes, by short runs.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <system_error>
#include <tools/command/output.hpp>
#include <tools/command/shell_text.hpp>
#include <tools/command/this_program.hpp>
#include <tools/experiment/sweep_runner.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::command::detail::sweeps {

/// A new folder that goes when this does.
struct PassingFolder {
  std::filesystem::path path;
  /// If two programs want the same name, one makes it and the other takes the next.
  explicit PassingFolder(const std::filesystem::path& name) {
    do path = io::next_free_folder(name);
    while (!std::filesystem::create_directory(path));
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  ~PassingFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
};

/// Core-seconds for one unit of a run's `work`: a short run into a folder that is removed again, longer until it takes half a
/// second. Nothing that is true after a signal.
[[nodiscard]] inline double probe(const Runner& runner, const PlannedRun& run, const std::filesystem::path& beside) {
  std::ofstream nowhere;
  replicates::JointProgress quiet{1, run.until_s, nowhere, false};
  for (double until_s = std::min(run.until_s, 60.0);; until_s = std::min(run.until_s, 4.0 * until_s)) {
    const PassingFolder folder{beside};
    const observe::Stopwatch watch;
    runner.run(run, folder.path / "run", quiet, until_s);
    const double wall_s = watch.elapsed_s();
    if (wall_s > 0.5 || until_s >= run.until_s) return wall_s / (run.work * until_s / run.until_s);
  }
}

/// How long a plan takes: core-seconds for one unit of `work`, by table and engine.
struct Estimates {
  std::map<std::pair<std::string, std::string>, double> rates;
  std::size_t probes = 0;

  [[nodiscard]] double core_s(const PlannedRun& run) const { return run.work * rates.at({run.rule_table, run.engine}); }
  [[nodiscard]] double core_s(const std::vector<PlannedRun>& runs) const {
    double sum = 0.0;
    for (const PlannedRun& run : runs) sum += core_s(run);
    return sum;
  }
};

/// By short runs of up to three cells of each table and engine. None if a signal came.
[[nodiscard]] inline std::optional<Estimates> estimates_of(const ExperimentOptions& options, const std::vector<PlannedRun>& plan,
                                                           const Runner& runner) {
  constexpr std::size_t most_probes = 3;
  std::map<std::pair<std::string, std::string>, std::vector<const PlannedRun*>> kinds;
  for (const PlannedRun& run : plan) {
    if (run.replicate == 0 && !run.shadow) kinds[{run.rule_table, run.engine}].push_back(&run);
  }
  Estimates estimates;
  for (const auto& [kind, runs] : kinds) {
    const std::size_t count = std::min(most_probes, runs.size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::filesystem::path beside = std::filesystem::temp_directory_path() / (options.program + "-probe");
      estimates.rates[kind] +=
          probe(runner, *runs[i * (runs.size() - 1) / std::max<std::size_t>(1, count - 1)], beside) / static_cast<double>(count);
      if (replicates::StopOnSignal::caught() != 0) return std::nullopt;
      ++estimates.probes;
    }
  }
  return estimates;
}

/// "400 runs in 20 cells, about 3 h of one core (3.2 core-hours) by 3 short runs of this machine".
[[nodiscard]] inline std::string estimate_text(const sweep::SweepFile& file, const std::vector<PlannedRun>& plan,
                                               const Estimates& estimates) {
  const double core_s = estimates.core_s(plan);
  return std::to_string(plan.size()) + " runs in " + std::to_string(sweep::cells_of(file).size()) + " cells, about " +
         observe::duration_text(core_s) + " of one core (" + number_text(std::ceil(core_s / 36.0) / 100.0) + " core-hours) by " +
         std::to_string(estimates.probes) + (estimates.probes == 1 ? " short run" : " short runs") + " of this machine";
}

/// Prints the cells, and how long all of it will take on one core.
[[nodiscard]] inline int dry_run(const ExperimentOptions& options, const sweep::SweepFile& file,
                                 const std::vector<PlannedRun>& plan, const Runner& runner) {
  const auto cells = sweep::cells_of(file);
  for (const PlannedRun& run : plan) {
    if (run.replicate > 0 || run.shadow) continue;
    std::cout << cell_name(run.cell) << "  " << file.params.replicates << " x " << number_text(run.until_s) << " s, "
              << run.rule_table << " on " << run.engine << ", " << sweep::text_of(cells[run.cell], file) << "\n";
  }
  const auto estimates = estimates_of(options, plan, runner);
  if (!estimates) return stopped;
  return print_text(estimate_text(file, plan, *estimates) + "\n");
}

/// Prints a job script for Slurm, each of whose N array tasks makes every N-th run. Any N indices in a row will do.
[[nodiscard]] inline int print_sbatch(const ExperimentOptions& options, const sweep::SweepFile& file,
                                      const std::vector<PlannedRun>& plan, const Runner& runner) {
  const auto estimates = estimates_of(options, plan, runner);
  if (!estimates) return stopped;
  const std::uint64_t count = std::min<std::uint64_t>(*options.sbatch, plan.size());
  std::vector<double> task_s(count);
  for (const PlannedRun& run : plan) task_s[run.index % count] += estimates->core_s(run);
  const double longest_s = *std::ranges::max_element(task_s);
  // Nodes differ, and checkpoints and start take time.
  const auto minutes = static_cast<std::uint64_t>(std::ceil((1.5 * longest_s + 600.0) / 60.0));
  ::rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const long megabytes = std::max(512L, 2 * used.ru_maxrss / 1024);
  std::array<char, 32> time{};
  std::snprintf(time.data(), time.size(), "%llu:%02llu:00", static_cast<unsigned long long>(minutes / 60),
                static_cast<unsigned long long>(minutes % 60));
  const auto one_line = [](std::string text) {  // in a comment
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
  };
  const auto quoted = [](const std::string& text) { return command::detail::shell_text(text); };
  const std::string tasks = std::to_string(count);
  return print_text(
      "#!/bin/bash\n# " + estimate_text(file, plan, *estimates) +
      ". The time limit is 1.5 times the longest task's, plus ten minutes.\n"
      "# Submit it again to finish what was interrupted; `" +
      one_line(options.program) + " --status --out " + one_line(options.out) +
      "` lists it.\n"
      "#SBATCH --job-name=" +
      quoted(one_line(options.program)) + "\n#SBATCH --array=1-" + tasks +
      "\n#SBATCH --cpus-per-task=1\n#SBATCH --time=" + time.data() + "\n#SBATCH --mem=" + std::to_string(megabytes) +
      "M\n#SBATCH --output=slurm-%A_%a.log\n#SBATCH --signal=B:TERM@120\ncd " + quoted(std::filesystem::current_path().string()) +
      " || exit 2\nexec " + quoted(program_path().string()) + " --sweep " + quoted(options.sweep) + " --out " +
      quoted(options.out) + " --jobs 1 --run $(seq $((SLURM_ARRAY_TASK_ID % " + tasks + ")) " + tasks + " " +
      std::to_string(plan.size() - 1) + ")\n");
}

}  // namespace trophic::command::detail::sweeps
