// SPDX-License-Identifier: MIT
// Definitions of own_metric.hpp.
#include <tools/analysis/metrics/own_metric.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <tools/analysis/metrics/sampled_metric.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

bool is_word(std::string_view text, std::string_view also = {}) {
  const auto is_allowed = [&](char c) {
    return letters.find(c) != std::string_view::npos || also.find(c) != std::string_view::npos;
  };
  return !text.empty() && std::ranges::all_of(text, is_allowed);
}

/// Calls the function; a text of what it throws is all that is kept of it.
std::vector<io::Sample> samples_of(const OwnMetric& metric, const io::RunTables& tables, const std::string& who) {
  try {
    return metric.samples(tables);
  } catch (const std::exception& error) {
    throw std::runtime_error{who + ": " + error.what()};
  } catch (...) {
    throw std::runtime_error{who + ": throws something that is not a std::exception"};
  }
}

}  // namespace

void check_own_metrics(std::span<const OwnMetric> metrics, std::span<const std::string> taken) {
  for (const OwnMetric& metric : metrics) {
    const auto refuse = [&](const std::string& why) { throw std::invalid_argument{"metric " + metric.name + ": " + why}; };
    if (!is_word(metric.name)) refuse("its name must be letters, digits and _");
    if (!is_word(metric.unit, "./^%-")) refuse("unit \"" + metric.unit + "\": must be letters, digits and _ . / ^ % -");
    if (!metric.samples) refuse("has no function");
    if (std::ranges::find(taken, metric.name) != taken.end()) refuse("trophic has a metric of this name; choose another");
    if (std::ranges::count(metrics, metric.name, &OwnMetric::name) > 1) refuse("is there twice");
  }
}

void measure_own(const OwnMetric& metric, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks) {
  const std::string folder = run.manifest.folder.string();
  const std::string who = "metric " + metric.name + ": " + folder;
  const io::RunTables tables{.events = run.events ? Events{*run.events} : Events{},
                             .agents = run.agents ? Agents{*run.agents} : Agents{},
                             .web = run.manifest.web,
                             .half_side_m = run.manifest.half_side_m,
                             .until_s = run.manifest.until_s,
                             .folder = run.manifest.folder};
  const std::vector<io::Sample> samples = samples_of(metric, tables, who);
  SampledMetric sampled{metric.name, metric.unit, samples.empty()};
  for (const io::Sample& sample : samples) {
    const auto refuse = [&](const std::string& why) { throw std::runtime_error{who + ": " + why}; };
    if (std::isinf(sample.value)) refuse("value = " + number_text(sample.value) + ": must be finite, or NaN if there is none");
    if (sample.time_s && !(*sample.time_s >= 0.0 && *sample.time_s <= tables.until_s)) {
      refuse("time_s = " + number_text(*sample.time_s) + ": must be >= 0 and <= " + number_text(tables.until_s));
    }
    if (sample.species && *sample.species >= tables.web.size()) {
      refuse("species = " + std::to_string(*sample.species) + ": must be < " + std::to_string(tables.web.size()));
    }
    if (!is_word(sample.group)) refuse("group \"" + sample.group + "\": must be letters, digits and _");
    sampled.add(sample.species ? tables.web.name(*sample.species) : "", sample.group, sample.time_s,
                std::isnan(sample.value) ? std::nullopt : std::optional{sample.value});
  }
  sampled.finish(who, folder, result, remarks);
}

}  // namespace trophic::analysis
