// SPDX-License-Identifier: MIT
// Definitions of progress_table.hpp.
#include <tools/analysis/report/progress_table.hpp>

#include <ostream>
#include <tools/analysis/report/columns.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/table_file.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

/// Seconds with one decimal.
const Reading seconds{MetricName{.metric = "progress", .species = "", .group = "", .unit = "ticks"}};

ProgressRow row_of(const Progress& one) {
  const auto& over = one.over_shadow;
  return {.against = one.against,
          .species = one.species(),
          .role = one.of_hunters ? "hunter" : "victim",
          .opponent = one.of_hunters ? one.victim : one.hunter,
          .period = one.period,
          .from_s = one.from_s,
          .to_s = one.to_s,
          .runs = one.ours.runs,
          .mean_s = one.ours.mean,
          .lower_s = lower_of(one.ours.interval),
          .upper_s = upper_of(one.ours.interval),
          .shadow_runs = one.shadow.runs,
          .shadow_s = one.shadow.mean,
          .over_shadow_s = over.value,
          .over_shadow_lower_s = lower_of(over.interval),
          .over_shadow_upper_s = upper_of(over.interval),
          .p = over.p,
          .p_holm = over.adjusted};
}

std::string conclusion_of(const Progress& one) {
  if (one.shadow.runs == 0) return "no shadow";
  if (!one.over_shadow.interval) return "not tested";
  if (!one.over_shadow.differs()) return "no significant difference";
  return *one.over_shadow.value > 0.0 ? "above the shadow" : "below the shadow";
}

}  // namespace

void write_contests(const std::filesystem::path& path, std::span<const ContestRow> contests) {
  TableFile<ContestRow> file{path};
  for (const ContestRow& row : contests) file.write(row);
  file.finish();
}

void write_progress(const std::filesystem::path& path, std::span<const Progress> progress) {
  TableFile<ProgressRow> file{path};
  for (const Progress& one : progress) file.write(row_of(one));
  file.finish();
}

void print_progress(std::ostream& out, std::span<const Progress> progress) {
  Columns table{
      {"progress of", "against", "from", "to", "mean, s", "shadow", "over the shadow [95 %]", "p (Holm)", "conclusion"}};
  std::size_t fewest = progress.empty() ? min_runs_for_test : progress.front().ours.runs;
  for (const Progress& one : progress) {
    const std::string opponent = one.of_hunters ? one.victim : one.hunter;
    const std::string whose = one.against == Against::own ? "own " : "others' ";
    table.add({one.species(), whose + opponent, number_text(one.from_s), number_text(one.to_s), seconds.of(one.ours),
               seconds.of(one.shadow), seconds.with_interval(one.over_shadow.value, one.over_shadow.interval, true),
               p_text(one.over_shadow.adjusted), conclusion_of(one)});
    fewest = std::min(fewest, one.shadow.runs > 0 ? std::min(one.ours.runs, one.shadow.runs) : one.ours.runs);
  }
  table.print(out);
  if (fewest < min_runs_for_test) {
    out << fewest << " replicates: no intervals and no conclusions; a test needs " << min_runs_for_test << "\n";
  }
}

}  // namespace trophic::analysis
