// SPDX-License-Identifier: MIT
// Definitions of sweep_values.hpp.
#include <tools/analysis/metrics/sweep_values.hpp>

#include <atomic>
#include <mutex>
#include <tools/analysis/metrics/body_metrics.hpp>
#include <tools/analysis/metrics/metric_choice.hpp>
#include <tools/reading/read_run.hpp>
#include <tools/replicates/parallel.hpp>

namespace trophic::analysis {

std::size_t SweepValues::place_of(const MetricName& name) const {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

std::optional<double> SweepValues::value(std::optional<std::size_t> run, std::size_t metric) const {
  return run && !of_run[*run].empty() ? of_run[*run][metric] : std::nullopt;
}

std::vector<MetricName> metric_names(std::span<const FoodWeb> webs, bool bodies) {
  std::vector<MetricName> names;
  for (const FoodWeb& web : webs) {
    RunData nothing;
    nothing.manifest.web = web;
    nothing.manifest.half_side_m = 1.0;
    for (const Measurement& measurement : measure_shipped(nothing, bodies).measurements) {
      if (std::ranges::find(names, measurement.name) == names.end()) names.push_back(measurement.name);
    }
  }
  return names;
}

void check_names(std::span<const FoodWeb> webs, const Measuring& how, std::span<const std::string> choices) {
  if (how.lineages) {
    static_cast<void>(chosen(lineage_metric_names(webs.front()), choices));
    return;
  }
  std::vector<MetricName> known = metric_names(webs, how.bodies);
  std::vector<std::string> taken;
  for (const MetricName& name : known) taken.push_back(name.metric);
  const std::size_t shipped = taken.size();
  for (const OwnColumn& column : how.columns) {
    if (std::ranges::find(taken, column.column) != taken.end()) {
      throw std::invalid_argument{"--column " + column.file + ":" + column.column +
                                  ": there is a metric of this name; rename the column"};
    }
    taken.push_back(column.column);
  }
  // The species and groups of a user's metric are known once it is measured.
  const std::span<const std::string> own = std::span{taken}.subspan(shipped);
  std::vector<std::string> others;
  for (const std::string& choice : choices) {
    if (std::ranges::find(own, choice.substr(0, choice.find(':'))) == own.end()) others.push_back(choice);
  }
  for (const std::string& name : own) known.push_back({name, "", "all", "1"});
  static_cast<void>(chosen(known, others));
}

SweepValues measure_sweep(const SweepRuns& sweep, const Measuring& how) {
  SweepValues values{metric_names(sweep.webs, how.bodies), std::vector<std::vector<std::optional<double>>>(sweep.plan.size())};
  std::vector<std::vector<Measurement>> own(sweep.plan.size());
  std::vector<std::vector<std::string>> remarks(sweep.plan.size());
  std::vector<std::string> thrown(sweep.plan.size());
  std::atomic<bool> has_failed = false;
  std::mutex one_at_a_time;
  const auto measure = [&](std::size_t i) {
    if (!sweep.is_there[i]) return;
    try {
      RunData run = read_run(sweep.folder_of(i));
      if (!run.remarks.empty()) throw std::runtime_error{run.remarks.front()};
      if (how.until_s) cut_to(run, *how.until_s);
      const RunMetrics measured = measure_shipped(run, how.bodies);
      std::vector<std::optional<double>> numbers(values.names.size());
      for (const Measurement& measurement : measured.measurements) numbers[values.place_of(measurement.name)] = measurement.value;
      values.of_run[i] = std::move(numbers);
      RunMetrics users;
      try {
        measure_users(how, run, users, remarks[i]);
      } catch (const std::runtime_error& error) {
        thrown[i] = error.what();
        throw;
      }
      own[i] = std::move(users.measurements);
      const std::scoped_lock lock{one_at_a_time};
      if (how.on_run) how.on_run();
    } catch (...) {
      has_failed = true;
      throw;
    }
  };
  const auto attempts = replicates::in_parallel(sweep.plan.size(), how.jobs, measure, [&] { return !has_failed; });
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (!thrown[i].empty()) throw std::runtime_error{thrown[i]};
    if (!attempts[i].error.empty()) throw std::invalid_argument{"run " + std::to_string(i) + ": " + attempts[i].error};
  }
  for (const auto& of_run : remarks) values.remarks.insert(values.remarks.end(), of_run.begin(), of_run.end());
  for (const auto& of_run : own) {
    for (const Measurement& each : of_run) {
      if (values.place_of(each.name) == values.names.size()) values.names.push_back(each.name);
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (values.of_run[i].empty()) continue;
    values.of_run[i].resize(values.names.size());
    for (const Measurement& each : own[i]) values.of_run[i][values.place_of(each.name)] = each.value;
  }
  return values;
}

CellValues cell_values(const GridCell& cell, const SweepValues& values, std::size_t metric) {
  CellValues of;
  for (const GridReplicate& replicate : cell.replicates) {
    const auto run = values.value(replicate.run, metric);
    const auto shadow = values.value(replicate.shadow, metric);
    if (run) of.raw[replicate.seed] = *run;
    if (shadow) of.shadow[replicate.seed] = *shadow;
    if (run && shadow) of.over_shadow[replicate.seed] = *run - *shadow;
  }
  return of;
}

}  // namespace trophic::analysis
