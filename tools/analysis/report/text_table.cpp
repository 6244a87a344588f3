// SPDX-License-Identifier: MIT
// Definitions of text_table.hpp.
#include <tools/analysis/report/text_table.hpp>

#include <algorithm>
#include <cstdio>
#include <tools/analysis/report/reading.hpp>
#include <trophic/params/params.hpp>
#include <utility>

namespace trophic::analysis {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

void print_too_few(std::ostream& out, const RunSet& set) {
  if (set.runs.size() >= min_runs_for_test) return;
  out << "too few runs for a conclusion: " << min_runs_for_test << " are needed, " << set.label << " has " << set.runs.size()
      << "\n";
}

std::string described(const RunSet& set) {
  const RunManifest& manifest = set.manifests.front();
  return set.label + " on " + manifest.backend + ", " + std::to_string(set.runs.size()) +
         (set.runs.size() == 1 ? " run" : " runs") + " of " + number_text(manifest.until_s) + " s";
}

namespace {

/// Nobody died of it in any run: not worth a line.
bool is_idle_cause(const MetricName& name, const std::optional<double>& mean) {
  return name.metric == "deaths" && name.group != "all" && mean == 0.0;
}

}  // namespace

void print_table(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows) {
  out << described(set.ours) << ", fingerprint " << set.ours.manifests.front().fingerprint << "\n";
  if (set.shadow) {
    out << "shadow: " << described(*set.shadow) << "\n";
  } else {
    out << "no shadow: attribution and velocity have no null (--replicates with --shadow makes one)\n";
  }
  out << padded("metric", 42) << padded("ours [95 %]", 30) << padded("published", 12) << "ours - null [95 %]\n";
  for (const SummaryRow& row : rows) {
    if (is_idle_cause(row.name, row.ours.mean)) continue;
    const Reading reading{row.name};
    const std::string fewer =
        row.ours.runs != 0 && row.ours.runs < set.ours.runs.size()
            ? "  (" + std::to_string(row.ours.runs) + " of " + std::to_string(set.ours.runs.size()) + " runs)"
            : "";
    out << padded(metric_title(row.name), 42) << padded(reading.of(row.ours), 30)
        << (row.published ? reading(*row.published) : "-") << fewer << "\n";
    for (const Comparison& other : row.comparisons) {
      const std::string mark = other.role == Role::paper ? "* " : other.role == Role::null ? "= " : "  ";
      out << padded("    " + mark + other.baseline, 42) << reading(other.value);
      if (other.role == Role::null) {
        out << std::string(42 - std::min<std::size_t>(41, reading(other.value).size()), ' ')
            << padded(reading.with_interval(other.difference, other.interval, true), 28) << enum_name(other.test_result());
      }
      out << "\n";
    }
  }
  out << "= a null: what the rules give without the effect   * the paper's own baseline, shown for reference: no null, no "
         "conclusion\n";
  out << "conclusions are of single metrics: one in twenty finds something where there is nothing\n";
  print_too_few(out, set.ours);
  if (set.shadow) print_too_few(out, *set.shadow);
}

namespace {

std::string tested(const Reading& reading, const Difference& difference) {
  std::string text = padded(reading.with_interval(difference.value, difference.interval, true), 30);
  if (!difference.adjusted) return text + "          ";
  std::string p(16, '\0');
  p.resize(static_cast<std::size_t>(std::snprintf(p.data(), p.size(), "%.3f", *difference.adjusted)));
  if (*difference.adjusted < 0.0005) p = "<0.001";
  return text + padded(p, 7) + (difference.differs() ? "* " : "  ");
}

}  // namespace

void print_differences(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b,
                       std::span<const SetDifference> differences) {
  for (const auto& [letter, set] : {std::pair{"a: ", &a}, std::pair{"b: ", &b}}) {
    out << letter << described(set->ours);
    if (set->shadow) out << "; shadow: " << set->shadow->runs.size() << " runs";
    out << "\n";
  }
  const bool have_shadows = a.shadow && b.shadow;
  out << padded("metric", 42) << padded("a", 12) << padded("b", 12) << padded("raw: b - a [95 %]", 30) << padded("p", 10)
      << (have_shadows ? "over shadows: (b - shadow) - (a - shadow) [95 %], p" : "") << "\n";
  std::size_t tests = 0;
  for (const SetDifference& d : differences) {
    if (d.raw.p) ++tests;
    if (d.name.metric == "deaths" && d.a.mean == 0.0 && d.b.mean == 0.0) continue;
    const Reading reading{d.name};
    out << padded(metric_title(d.name), 42) << padded(reading(d.a.mean), 12) << padded(reading(d.b.mean), 12)
        << tested(reading, d.raw) << (have_shadows ? tested(reading, d.over_shadow) : "") << "\n";
  }
  out << "p: corrected for " << tests << " comparisons (Holm); * differs, p <= 0.05; intervals are those of single comparisons\n"
      << "raw differences also show how the populations are composed; ";
  if (have_shadows) {
    out << "those over the shadows show what inheritance does\n";
  } else {
    out << "without a shadow of each set no difference can be put down to inheritance\n";
  }
  for (const ShadowedSet* set : {&a, &b}) {
    print_too_few(out, set->ours);
    if (set->shadow) print_too_few(out, *set->shadow);
  }
}

}  // namespace trophic::analysis
