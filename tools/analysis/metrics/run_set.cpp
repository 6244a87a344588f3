// SPDX-License-Identifier: MIT
// Definitions of run_set.hpp.
#include <tools/analysis/metrics/run_set.hpp>

#include <atomic>
#include <exception>
#include <initializer_list>
#include <mutex>
#include <stdexcept>
#include <tools/analysis/metrics/body_metrics.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <tools/reading/read_run.hpp>
#include <tools/reading/shadow.hpp>
#include <tools/replicates/parallel.hpp>
#include <utility>

namespace trophic::analysis {

namespace {

std::vector<RunMetrics*> pointers(std::initializer_list<RunSet*> sets) {
  std::vector<RunMetrics*> all;
  for (RunSet* set : sets) {
    for (RunMetrics& run : set->runs) all.push_back(&run);
  }
  return all;
}

}  // namespace

void measure_users(const Measuring& how, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks) {
  for (const OwnColumn& column : how.columns) measure_column(column, run, result, remarks);
}

RunSet read_set(std::span<const std::filesystem::path> paths, const Measuring& how) {
  PooledRuns pooled = pooled_runs(paths, how.until_s.has_value(), how.any_build);
  RunSet set{pooled.manifests.front().rules, std::move(pooled.manifests), {}, std::move(pooled.remarks)};
  std::vector<std::vector<std::string>> remarks(set.manifests.size());
  std::vector<std::exception_ptr> errors(set.manifests.size());
  std::atomic<bool> has_failed = false;
  std::mutex one_at_a_time;
  set.runs.resize(set.manifests.size());
  const auto measure = [&](std::size_t i) {
    RunManifest& manifest = set.manifests[i];
    if (how.lineages) {
      set.runs[i] = measure_lineages(manifest, *how.lineages);
      const std::scoped_lock lock{one_at_a_time};
      if (how.on_run) how.on_run();
      return;
    }
    RunData run = read_run(manifest.folder);
    if (how.until_s) cut_to(run, *how.until_s);
    manifest.until_s = run.manifest.until_s;
    if (how.until_s) manifest.reached_s = run.manifest.until_s;
    remarks[i] = run.remarks;
    if (const std::string lost = lost_to_thinning(manifest.agents_every_ticks); !lost.empty()) {
      remarks[i].push_back(manifest.folder.string() + "/" + lost);
    }
    set.runs[i] = measure_shipped(run, how.bodies);
    measure_users(how, run, set.runs[i], remarks[i]);
    const std::scoped_lock lock{one_at_a_time};
    if (how.on_run) how.on_run();
  };
  const auto attempt = [&](std::size_t i) {
    try {
      measure(i);
    } catch (...) {
      errors[i] = std::current_exception();
      has_failed = true;
    }
  };
  static_cast<void>(replicates::in_parallel(set.manifests.size(), how.jobs, attempt, [&] { return !has_failed; }));
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
  for (const auto& of_run : remarks) set.remarks.insert(set.remarks.end(), of_run.begin(), of_run.end());
  give_all_the_same_columns(pointers({&set}));
  return set;
}

std::span<const RunMetrics> ShadowedSet::shadow_runs() const {
  return shadow ? std::span<const RunMetrics>{shadow->runs} : std::span<const RunMetrics>{};
}

ShadowedSet read_shadowed_set(std::span<const std::filesystem::path> paths, const std::optional<std::filesystem::path>& elsewhere,
                              const Measuring& how) {
  ShadowedSet set{read_set(paths, how), {}};
  const auto folders = elsewhere ? std::vector{*elsewhere} : shadow_folders(paths);
  if (folders.empty()) return set;
  set.shadow = read_set(folders, how);
  const RunManifest& ours = set.ours.manifests.front();
  const RunManifest& shadow = set.shadow->manifests.front();
  check_shadow(ours, shadow);
  if (ours.builds != shadow.builds && !how.any_build) {
    throw std::invalid_argument{shadow.folder.string() + ": made by " + builds_text(shadow.builds) + ": must be made by " +
                                builds_text(ours.builds) + ", as " + ours.folder.string() + " (--accept-other-build takes it)"};
  }
  give_all_the_same_columns(pointers({&set.ours, &*set.shadow}));
  return set;
}

}  // namespace trophic::analysis
