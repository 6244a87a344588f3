// SPDX-License-Identifier: MIT
// Definitions of means_table.hpp.
#include <tools/analysis/report/means_table.hpp>

#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/table_file.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <tools/experiment/escaped.hpp>

namespace trophic::analysis {

namespace {

std::string choice_of(const std::optional<MetricName>& name) {
  return name ? name->metric + ":" + name->species + ":" + name->group : "";
}

/// "+1.10 [+0.85, +1.35]" with minus signs, as mathematics.
std::string math(const std::string& text) {
  if (text.empty() || text == "missing") return "--";
  std::string spaced;
  for (const char letter : text) spaced += letter == ' ' ? "\\ " : std::string{letter};
  return "$" + spaced + "$";
}

/// A table of numbers behind a first column of names, which takes the rest of the line.
class LatexTable {
 public:
  explicit LatexTable(std::span<const std::string> head) {
    text_ = "{\\scriptsize\\setlength{\\tabcolsep}{3pt}%\n\\begin{tabularx}{\\linewidth}{@{}>{\\raggedright\\arraybackslash}X*{" +
            std::to_string(head.size() - 1) + "}{r}@{}}\n\\toprule\n";
    add(head);
    text_ += "\\midrule\n";
  }
  void add(std::span<const std::string> cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text_ += (i > 0 ? " & " : "") + cells[i];
    text_ += " \\\\\n";
  }
  [[nodiscard]] std::string finished() const { return text_ + "\\bottomrule\n\\end{tabularx}}\n"; }

 private:
  std::string text_;
};

std::string packages() {
  return "% \\usepackage{booktabs,tabularx}; \\input{} this file in a table, or in a table* of two columns.\n";
}

std::string p_math(const std::optional<double>& p) {
  return p ? math(p_text(p)) : "--";
}

}  // namespace

void write_means(const std::filesystem::path& path, std::span<const SummarizedSet> sets) {
  TableFile<MeanRow> file{path};
  for (const SummarizedSet& set : sets) {
    for (const SummaryRow& row : set.rows) {
      MeanRow line{.set = set.set->ours.label,
                   .metric = row.name.metric,
                   .species = row.name.species,
                   .group = row.name.group,
                   .unit = row.name.unit,
                   .n = row.ours.runs,
                   .mean = row.ours.mean,
                   .deviation = row.ours.deviation,
                   .lower = lower_of(row.ours.interval),
                   .upper = upper_of(row.ours.interval),
                   .published = row.published,
                   .same_as = choice_of(row.same_as)};
      bool any = false;
      for (const Comparison& other : row.comparisons) {
        if (other.role != Role::null) continue;
        any = true;
        line.null = other.baseline;
        line.null_n = other.runs;
        line.null_mean = other.value;
        line.difference = other.difference.value;
        line.difference_lower = lower_of(other.difference.interval);
        line.difference_upper = upper_of(other.difference.interval);
        line.p = other.difference.p;
        line.p_holm = other.difference.adjusted;
        line.runs_needed = other.difference.runs_needed();
        file.write(line);
      }
      if (!any) file.write(line);
    }
  }
  file.finish();
}

void write_differences(const std::filesystem::path& path, std::span<const SetDifference> differences) {
  TableFile<SetDifferenceRow> file{path};
  for (const SetDifference& d : differences) {
    for (const bool over : {true, false}) {
      const Difference& difference = over ? d.over_shadow : d.raw;
      if (over && !difference.value) continue;
      file.write({.metric = d.name.metric,
                  .species = d.name.species,
                  .group = d.name.group,
                  .unit = d.name.unit,
                  .compared = over ? "over_shadow" : "raw",
                  .n_a = d.a.runs,
                  .n_b = d.b.runs,
                  .mean_a = d.a.mean,
                  .mean_b = d.b.mean,
                  .difference = difference.value,
                  .lower = lower_of(difference.interval),
                  .upper = upper_of(difference.interval),
                  .p = difference.p,
                  .p_holm = difference.adjusted,
                  .runs_needed = difference.runs_needed(),
                  .same_as = choice_of(d.same_as)});
    }
  }
  file.finish();
}

std::string means_tex(const SummarizedSet& set) {
  const std::vector<std::string> head{"metric", "mean [95\\,\\%]", "null", "mean $-$ null [95\\,\\%]", "$p$", "$n$"};
  LatexTable table{head};
  for (const SummaryRow& row : set.rows) {
    if (row.same_as) continue;
    const Reading reading{row.name};
    for (const Comparison& other : row.comparisons) {
      if (other.role != Role::null || !other.difference.value) continue;
      const std::string null = other.baseline == shadow_name ? "" : " (null: " + other.baseline + ")";
      table.add(std::vector<std::string>{
          latex_text(metric_title(row.name) + null), math(reading.of(row.ours)), math(reading(other.value)),
          math(reading.with_interval(other.difference.value, other.difference.interval, true)), p_math(other.difference.adjusted),
          math(std::to_string(row.ours.runs) + "{+}" + std::to_string(other.runs))});
    }
  }
  return packages() + "% " + described(set.set->ours) + ". Null: the neutral shadow, unless another is named. p: Holm.\n" +
         table.finished();
}

std::string differences_tex(const ShadowedSet& a, const ShadowedSet& b, std::span<const SetDifference> differences) {
  const bool over = a.shadow && b.shadow;
  const std::vector<std::string> head{"metric",
                                      latex_text(a.ours.label),
                                      latex_text(b.ours.label),
                                      over ? "over shadows [95\\,\\%]" : "difference [95\\,\\%]",
                                      "$p$",
                                      "$n$"};
  LatexTable table{head};
  for (const SetDifference& d : differences) {
    const Difference& difference = over ? d.over_shadow : d.raw;
    if (d.same_as || !difference.value) continue;
    const Reading reading{d.name};
    table.add(std::vector<std::string>{latex_text(metric_title(d.name)), math(reading(d.a.mean)), math(reading(d.b.mean)),
                                       math(reading.with_interval(difference.value, difference.interval, true)),
                                       p_math(difference.adjusted),
                                       math(std::to_string(d.a.runs) + "{+}" + std::to_string(d.b.runs))});
  }
  return packages() + "% a: " + described(a.ours) + "; b: " + described(b.ours) +
         (over ? "; over shadows: (b - its shadow) - (a - its shadow)" : "; b - a") + ". p: Holm.\n" + table.finished();
}

}  // namespace trophic::analysis
