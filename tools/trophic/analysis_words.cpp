// SPDX-License-Identifier: MIT
// Definitions of analysis_words.hpp.
#include <tools/trophic/analysis_words.hpp>

#include <algorithm>
#include <tools/analysis/report/metrics_table.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/summary.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::command {

namespace {

using analysis::Reading;

/// The first null of a metric: the shadow where there is one.
const analysis::Comparison* null_of(const analysis::SummaryRow& row) {
  const auto found = std::ranges::find(row.comparisons, analysis::Role::null, &analysis::Comparison::role);
  return found == row.comparisons.end() ? nullptr : &*found;
}

/// A difference from a null that has an interval, and how far it is from zero in halves of that.
struct Finding {
  double strength = 0.0;
  bool differs = false;
  std::string sentence;
};

std::string baseline_words(const std::string& name) {
  return name == analysis::shadow_name ? "the neutral shadow" : "its null, " + name;
}

std::optional<Finding> finding_of(const analysis::ShadowedSet& set, const analysis::SummaryRow& row, bool says_set) {
  const analysis::Comparison* null = null_of(row);
  if (null == nullptr || !null->difference.value || !null->difference.interval || !row.ours.mean) return std::nullopt;
  const Reading reading{row.name};
  const double half = 0.5 * (null->difference.interval->upper - null->difference.interval->lower);
  if (!(half > 0.0)) return std::nullopt;
  Finding finding;
  finding.strength = std::abs(*null->difference.value) / half;
  finding.differs = null->test_result() == analysis::TestResult::above || null->test_result() == analysis::TestResult::below;
  std::string title = analysis::metric_title(row.name);
  std::ranges::replace(title, '_', ' ');
  const std::size_t comma = title.rfind(", ");  // "velocity prey, cm/s": the unit goes to the values
  const std::string unit = comma == std::string::npos ? "" : " " + title.substr(comma + 2);
  title.resize(std::min(comma, title.size()));
  finding.sentence = (says_set ? set.ours.label + ": " : "") + title + ": " + reading(*row.ours.mean) + unit + ", " +
                     reading(std::abs(*null->difference.value)) + unit +
                     (*null->difference.value >= 0.0 ? " above " : " below ") + baseline_words(null->baseline) +
                     " (95 % interval of the difference " + reading(null->difference.interval->lower, true) + " to " +
                     reading(null->difference.interval->upper, true) + unit + "; " + std::to_string(row.ours.runs) + " runs).";
  return finding;
}

void add_findings(AnalysisPage& page, std::span<const analysis::ShadowedSet> sets,
                  const std::vector<std::vector<analysis::SummaryRow>>& rows) {
  constexpr std::size_t most = 3;
  std::vector<Finding> found;
  std::size_t tests = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (sets[i].ours.runs.size() < analysis::min_runs_for_test) {
      page.findings.push_back(sets[i].ours.label +
                              ": too few runs for intervals and tests: " + std::to_string(analysis::min_runs_for_test) +
                              " are needed, there are " + std::to_string(sets[i].ours.runs.size()) + ".");
    }
    for (const analysis::SummaryRow& row : rows[i]) {
      const auto finding = finding_of(sets[i], row, sets.size() > 1);
      if (!finding) continue;
      ++tests;
      if (finding->differs) found.push_back(*finding);
    }
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &Finding::strength);
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) page.findings.push_back(found[i].sentence);
  if (tests == 0) {
    if (page.findings.empty()) page.findings.emplace_back("No metric has a null to compare it with.");
    return;
  }
  const std::string all = std::to_string(tests) + " metrics";
  if (found.empty()) {
    page.findings.push_back("None of " + all + " differs significantly from its null. This does not show that they are equal.");
  } else {
    page.findings.push_back(std::to_string(found.size()) + " of " + all +
                            " differ from their null, at the 5 % level and uncorrected: one in twenty does so by chance alone.");
  }
}

AnalysisPage::Row row_of(const analysis::ShadowedSet& set, const analysis::SummaryRow& row) {
  const Reading reading{row.name};
  AnalysisPage::Row made{.set = set.ours.label,
                         .metric = analysis::metric_title(row.name),
                         .ours = reading.of(row.ours),
                         .baseline = {},
                         .difference = {},
                         .conclusion = {},
                         .mean = row.ours.mean.value_or(0.0),
                         .value = {}};
  const analysis::Comparison* null = null_of(row);
  if (null == nullptr) return made;
  made.baseline = null->baseline + " " + reading(null->value);
  made.difference = reading.with_interval(null->difference.value, null->difference.interval, true);
  switch (null->test_result()) {
    case analysis::TestResult::above:
      made.conclusion = "above";
      break;
    case analysis::TestResult::below:
      made.conclusion = "below";
      break;
    case analysis::TestResult::not_significant:
      made.conclusion = "no significant difference";
      break;
    case analysis::TestResult::unknown:
      made.conclusion = "too few runs";
      break;
  }
  if (!null->difference.value || !null->difference.interval) return made;
  made.value = null->difference.value;
  made.lower = null->difference.interval->lower;
  made.upper = null->difference.interval->upper;
  return made;
}

std::string table_csv(const std::vector<AnalysisPage::Row>& rows) {
  const auto quoted = [](const std::string& text) {
    return text.find_first_of(",\"") == std::string::npos ? text : '"' + text + '"';
  };
  std::string text = "set,metric,ours,null,difference,conclusion\n";
  for (const AnalysisPage::Row& row : rows) {
    text += quoted(row.set) + ',' + quoted(row.metric) + ',' + quoted(row.ours) + ',' + quoted(row.baseline) + ',' +
            quoted(row.difference) + ',' + quoted(row.conclusion) + '\n';
  }
  return text;
}

/// The command line that made a set's runs, as far as their manifest has it.
void add_command(AnalysisPage& page, const analysis::RunSet& set) {
  const auto manifest = parse_json_or_null(read_whole_file(set.manifests.front().folder / "manifest.json"));
  if (manifest.is_object() && manifest.contains("command_line") && manifest["command_line"].is_string()) {
    page.commands.push_back(manifest["command_line"].get<std::string>());
  }
}

}  // namespace

void describe(AnalysisPage& page, std::span<const analysis::ShadowedSet> sets, const std::string& command) {
  std::vector<std::vector<analysis::SummaryRow>> rows;
  for (const analysis::ShadowedSet& set : sets) {
    rows.push_back(analysis::summarize(set.ours.runs, set.shadow_runs()));
    for (const analysis::SummaryRow& row : rows.back()) {
      if (row.name.metric != "deaths" || row.name.group == "all" || row.ours.mean != 0.0) page.rows.push_back(row_of(set, row));
    }
    for (const auto& [slot, policy] : set.ours.manifests.front().policies.items()) {
      page.rules.emplace_back(sets.size() > 1 ? set.ours.label + ": " + slot : slot,
                              policy.is_string() ? policy.get<std::string>() : json_text(policy));
    }
    add_command(page, set.ours);
  }
  const bool has_shadow = std::ranges::any_of(sets, [](const analysis::ShadowedSet& set) { return set.shadow.has_value(); });
  page.question =
      sets.size() > 1 ? "In what do " + sets[0].ours.label + " and " + sets[1].ours.label + " differ?"
      : has_shadow
          ? "Does inheritance matter under the rules of " + sets[0].ours.label +
                "? Each metric is compared with the neutral shadow: the same rules and seeds, with nothing inherited."
          : "Runs of " + sets[0].ours.label + ". Without a neutral shadow no difference can be attributed to inheritance.";
  add_findings(page, sets, rows);
  page.commands.push_back(command);
  page.downloads.push_back({"table.csv", table_csv(page.rows)});
  page.downloads.push_back({"metrics.csv", analysis::metrics_text(sets)});
}

}  // namespace trophic::command
