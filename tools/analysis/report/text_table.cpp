// SPDX-License-Identifier: MIT
// Definitions of text_table.hpp.
#include <tools/analysis/report/text_table.hpp>

#include <algorithm>
#include <cmath>
#include <tools/analysis/report/columns.hpp>
#include <tools/analysis/report/reading.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

namespace {

constexpr std::size_t most_findings = 5;
constexpr std::size_t most_inconclusive = 3;

/// No individual died from it in any run: not worth a line.
bool is_idle_cause(const MetricName& name, const std::optional<double>& mean) {
  return name.metric == "deaths" && name.group != "all" && mean == 0.0;
}

/// A tested difference with the cells that come before it in a line.
struct Tested {
  std::vector<std::string> cells;
  MetricName name;
  const Difference* difference;
};

std::vector<std::string> line_of(const Tested& test, const std::string& last) {
  const Difference& d = *test.difference;
  std::vector<std::string> line = test.cells;
  line.push_back(Reading{test.name}.with_interval(d.value, d.interval, true));
  line.push_back(p_text(d.adjusted));
  if (!last.empty()) line.push_back(last);
  return line;
}

/// The clearest significant differences, and how many more there are. `head`: of the cells before the difference.
void print_clearest(std::ostream& out, std::vector<Tested> tests, const std::vector<std::string>& head,
                    const std::string& difference) {
  std::erase_if(tests, [](const Tested& test) { return !test.difference->p; });
  std::vector<Tested> found;
  std::vector<std::pair<std::size_t, Tested>> open;
  for (const Tested& test : tests) {
    if (test.difference->differs()) {
      found.push_back(test);
    } else {
      open.emplace_back(test.difference->runs_needed().value_or(std::numeric_limits<std::size_t>::max()), test);
    }
  }
  out << found.size() << " of " << tests.size() << " comparisons are significant (p <= 0.05, corrected for all of them: Holm)\n";
  const auto strength = [](const Tested& test) {
    const Difference& d = *test.difference;
    return d.scatter && d.scatter->variance > 0.0 ? -std::abs(*d.value) / std::sqrt(d.scatter->variance)
                                                  : -std::numeric_limits<double>::infinity();
  };
  std::ranges::stable_sort(found, {}, [&](const Tested& test) { return std::pair{*test.difference->p, strength(test)}; });
  const auto headed = [&](const std::string& first, const std::string& last) {
    std::vector<std::string> cells = head;
    cells.front() = first;
    cells.insert(cells.end(), {difference + " [95 %]", "p"});
    if (!last.empty()) cells.push_back(last);
    return Columns{cells};
  };
  if (!found.empty()) {
    Columns columns = headed("significant", "");
    for (std::size_t i = 0; i < std::min(most_findings, found.size()); ++i) columns.add(line_of(found[i], ""));
    columns.print(out, "  ");
    if (found.size() > most_findings) out << "  and " << found.size() - most_findings << " more (--all)\n";
  }
  if (open.empty()) return;
  std::ranges::stable_sort(open, {}, [](const auto& each) { return each.first; });
  Columns columns = headed("inconclusive", "runs needed");
  for (std::size_t i = 0; i < std::min(most_inconclusive, open.size()); ++i) {
    columns.add(line_of(open[i].second, runs_needed_text(*open[i].second.difference)));
  }
  columns.print(out, "  ");
  if (open.size() > most_inconclusive) out << "  and " << open.size() - most_inconclusive << " more (--all)\n";
  out << "runs needed: in each set, to find a difference of this size in 80 % of studies. Inconclusive does not mean equal\n";
}

std::vector<Tested> tests_of(std::span<const SummaryRow> rows) {
  std::vector<Tested> tests;
  for (const SummaryRow& row : rows) {
    if (row.same_as) continue;
    const Reading reading{row.name};
    for (const Comparison& other : row.comparisons) {
      if (other.role != Role::null) continue;
      tests.push_back({{metric_title(row.name), reading.of(row.ours), other.baseline, reading(other.value),
                        std::to_string(row.ours.runs) + "+" + std::to_string(other.runs)},
                       row.name,
                       &other.difference});
    }
  }
  return tests;
}

void print_heading(std::ostream& out, const ShadowedSet& set) {
  out << described(set.ours) << ", fingerprint " << set.ours.manifests.front().fingerprint << "\n";
  if (set.shadow) {
    out << "shadow: " << described(*set.shadow) << "\n";
  } else {
    out << "no shadow: attribution and velocity have no null (--replicates with --shadow makes one)\n";
  }
}

void print_too_few(std::ostream& out, const ShadowedSet& set) {
  print_too_few(out, set.ours);
  if (set.shadow) print_too_few(out, *set.shadow);
}

std::string conclusion_of(const Difference& difference) {
  if (!difference.adjusted) return "";
  if (!difference.differs()) return "inconclusive, " + runs_needed_text(difference) + " runs needed";
  return *difference.value > 0.0 ? "above" : "below";
}

}  // namespace

void print_too_few(std::ostream& out, const RunSet& set) {
  if (set.runs.size() >= min_runs_for_test) return;
  out << "too few runs for a test: " << min_runs_for_test << " are needed, " << set.label << " has " << set.runs.size() << "\n";
}

std::string described(const RunSet& set) {
  const RunManifest& manifest = set.manifests.front();
  return set.label + " on " + manifest.backend + ", " + std::to_string(set.runs.size()) +
         (set.runs.size() == 1 ? " run" : " runs") + " of " + number_text(manifest.until_s) + " s";
}

void print_findings(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows) {
  const std::vector<Tested> tests = tests_of(rows);
  const bool any = std::ranges::any_of(tests, [](const Tested& test) { return test.difference->p.has_value(); });
  if (!set.shadow || !any) return print_table(out, set, rows);
  print_heading(out, set);
  print_clearest(out, tests, {"", "ours [95 %]", "null", "its mean", "runs"}, "ours - null");
  print_too_few(out, set);
}

void print_table(std::ostream& out, const ShadowedSet& set, std::span<const SummaryRow> rows) {
  print_heading(out, set);
  Columns columns{{"metric", "ours [95 %]", "published", "ours - null [95 %]", "p", "conclusion"}};
  std::size_t tests = 0;
  for (const SummaryRow& row : rows) {
    if (is_idle_cause(row.name, row.ours.mean)) continue;
    const Reading reading{row.name};
    std::string note;
    if (row.same_as) note = "same as " + metric_title(*row.same_as);
    if (row.ours.runs != 0 && row.ours.runs < set.ours.runs.size()) {
      note = "(" + std::to_string(row.ours.runs) + " of " + std::to_string(set.ours.runs.size()) + " runs)";
    }
    columns.add({metric_title(row.name), reading.of(row.ours), row.published ? reading(*row.published) : "-", "", "", note});
    for (const Comparison& other : row.comparisons) {
      const std::string mark = other.role == Role::paper ? "* " : other.role == Role::null ? "= " : "  ";
      std::vector<std::string> line{"    " + mark + other.baseline, reading(other.value)};
      if (other.role == Role::null) {
        const Difference& d = other.difference;
        line.insert(line.end(), {"", reading.with_interval(d.value, d.interval, true), p_text(d.adjusted), conclusion_of(d)});
        if (d.adjusted) ++tests;
      }
      columns.add(line);
    }
  }
  columns.print(out);
  out << "= a null: what the rules give without the effect   * the paper's own baseline, for reference: not tested against\n"
      << "p: corrected for " << tests << " comparisons (Holm); intervals are those of single comparisons\n";
  print_too_few(out, set);
}

namespace {

void print_sets(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b) {
  for (const auto& [letter, set] : {std::pair{"a: ", &a}, std::pair{"b: ", &b}}) {
    out << letter << described(set->ours);
    if (set->shadow) out << "; shadow: " << set->shadow->runs.size() << " runs";
    out << "\n";
  }
}

constexpr std::string_view over_title = "over shadows: (b - shadow) - (a - shadow)";

}  // namespace

void print_difference_findings(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b,
                               std::span<const SetDifference> differences) {
  print_sets(out, a, b);
  const bool over = a.shadow && b.shadow;
  if (over) {
    out << "the answer is the difference " << over_title
        << ": what inheritance does. Raw differences, which the rules alone can make, are in --all\n";
  } else {
    out << "the differences are raw: without a shadow of each set no difference can be attributed to inheritance\n";
  }
  std::vector<Tested> tests;
  for (const SetDifference& d : differences) {
    if (d.same_as) continue;
    const Reading reading{d.name};
    std::vector<std::string> cells{metric_title(d.name), reading(d.a.mean), reading(d.b.mean),
                                   std::to_string(d.a.runs) + "+" + std::to_string(d.b.runs)};
    tests.push_back({std::move(cells), d.name, over ? &d.over_shadow : &d.raw});
  }
  print_clearest(out, tests, {"", "a", "b", "runs"}, over ? "over shadows" : "b - a");
  for (const ShadowedSet* set : {&a, &b}) print_too_few(out, *set);
}

void print_differences(std::ostream& out, const ShadowedSet& a, const ShadowedSet& b,
                       std::span<const SetDifference> differences) {
  print_sets(out, a, b);
  const bool have_shadows = a.shadow && b.shadow;
  std::vector<std::string> head{"metric", "a", "b", "raw: b - a [95 %]", "p", ""};
  if (have_shadows) head.insert(head.end(), {std::string{over_title} + " [95 %]", "p", ""});
  Columns columns{head};
  std::size_t tests = 0;
  for (const SetDifference& d : differences) {
    if (d.raw.adjusted) ++tests;
    if (d.name.metric == "deaths" && d.a.mean == 0.0 && d.b.mean == 0.0) continue;
    const Reading reading{d.name};
    std::vector<std::string> line{metric_title(d.name), reading(d.a.mean), reading(d.b.mean)};
    std::vector<const Difference*> kinds{&d.raw};
    if (have_shadows) kinds.push_back(&d.over_shadow);
    for (const Difference* kind : kinds) {
      line.push_back(reading.with_interval(kind->value, kind->interval, true));
      line.push_back(p_text(kind->adjusted));
      line.push_back(kind->differs() ? "*" : kind->adjusted ? runs_needed_text(*kind) + " runs" : "");
    }
    if (d.same_as) line.push_back("same as " + metric_title(*d.same_as));
    columns.add(line);
  }
  columns.print(out);
  out << "p: corrected for " << tests
      << " comparisons (Holm); * significant, p <= 0.05, else the runs in each set that would find "
      << "a difference of this size in 80 % of studies; intervals are those of single comparisons\n"
      << "raw differences also show how the populations are composed; ";
  if (have_shadows) {
    out << "those over the shadows are the answer: what inheritance does\n";
  } else {
    out << "without a shadow of each set no difference can be attributed to inheritance\n";
  }
  for (const ShadowedSet* set : {&a, &b}) print_too_few(out, *set);
}

}  // namespace trophic::analysis
