// SPDX-License-Identifier: MIT
// Results for people: a table on the terminal and the conclusions that change.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <trophic/measure/report.hpp>
#include <trophic/measure/summary.hpp>

namespace trophic::measure {

namespace detail {

/// A value in the unit that people read: velocities in cm/s, shares with three decimals, counts with one.
class Reading {
 public:
  explicit Reading(const MetricName& name)
      : factor_{name.unit == "m/s" ? 100.0 : 1.0},
        decimals_{name.unit == "m/s"                                                               ? 2
                  : name.unit == "ticks" || name.metric == "deaths" || name.metric == "population" ? 1
                                                                                                   : 3} {}

  [[nodiscard]] std::string operator()(double value, bool sign = false) const {
    std::string text(64, '\0');
    const int length = std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", decimals_, factor_ * value);
    text.resize(static_cast<std::size_t>(length));
    return text;
  }
  [[nodiscard]] std::string operator()(const std::optional<double>& value, bool sign = false) const {
    return value ? (*this)(*value, sign) : "missing";
  }
  [[nodiscard]] std::string with_interval(const std::optional<double>& value, const std::optional<Interval>& interval,
                                          bool sign = false) const {
    if (!value) return "missing";
    if (!interval) return (*this)(*value, sign) + " (no interval)";
    return (*this)(*value, sign) + " [" + (*this)(interval->lower, sign) + ", " + (*this)(interval->upper, sign) + "]";
  }

 private:
  double factor_;
  int decimals_;
};

[[nodiscard]] inline std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

[[nodiscard]] inline std::string title(const MetricName& name) {
  return name.metric + " " + name.species + (name.group == "all" ? "" : " (" + name.group + ")");
}

}  // namespace detail

/// One line per metric: ours with its 95 % interval over runs, and the paper's value; below it one line per baseline with the
/// difference to it; causes of which nobody died are left out. A star marks the baseline that the paper uses, an arrow the ones
/// that say something else than that one.
inline void print_table(std::ostream& out, const RunSet& set, std::span<const SummaryRow> rows) {
  out << set.label << " on " << set.facts.front().backend << ", " << set.runs.size() << (set.runs.size() == 1 ? " run" : " runs")
      << ", fingerprint " << set.facts.front().fingerprint << "\n";
  out << detail::padded("metric", 42) << detail::padded("ours [95 %]", 30) << detail::padded("published", 12)
      << "ours - baseline [95 %]\n";
  for (const SummaryRow& row : rows) {
    if (row.name.metric == "deaths" && row.name.group != "all" && row.ours.mean == 0.0) continue;
    const detail::Reading reading{row.name};
    const std::string fewer = row.ours.runs != 0 && row.ours.runs < set.runs.size()
                                  ? "  (" + std::to_string(row.ours.runs) + " of " + std::to_string(set.runs.size()) + " runs)"
                                  : "";
    out << detail::padded(detail::title(row.name) + (row.name.unit == "m/s" ? ", cm/s" : ""), 42)
        << detail::padded(reading.with_interval(row.ours.mean, row.ours.interval), 30)
        << (row.published ? reading(*row.published) : "-") << fewer << "\n";
    const auto contradicting = row.contradictions();
    for (const Comparison& comparison : row.comparisons) {
      out << detail::padded("    " + std::string{comparison.of_paper ? "* " : "  "} + comparison.baseline, 42)
          << detail::padded(reading(comparison.value), 42)
          << detail::padded(reading.with_interval(comparison.difference.mean, comparison.difference.interval, true), 28)
          << enum_name(comparison.verdict())
          << (std::ranges::find(contradicting, &comparison) != contradicting.end() ? "  <-" : "") << "\n";
    }
  }
  out << "* the paper's own baseline   <- says something else than the paper's baseline does\n";
}

/// A sentence for each null model that turns a conclusion around.
inline void print_conclusions(std::ostream& out, std::span<const SummaryRow> rows) {
  bool any = false;
  for (const SummaryRow& row : rows) {
    const auto paper = std::ranges::find(row.comparisons, true, &Comparison::of_paper);
    for (const Comparison* null : row.contradictions()) {
      if (!any) out << "Conclusions that change under another null model:\n";
      any = true;
      out << "  " << detail::title(row.name) << ": " << enum_name(paper->verdict())
          << (paper->verdict() == Verdict::not_distinguishable ? " from " : " ") << paper->baseline << ", but "
          << enum_name(null->verdict()) << (null->verdict() == Verdict::not_distinguishable ? " from " : " ") << null->baseline
          << "\n";
    }
  }
  if (!any) out << "No conclusion changes under another null model (or there are too few runs to tell).\n";
}

/// One line per metric: a, b, b - a with its 95 % interval.
inline void print_differences(std::ostream& out, const RunSet& a, const RunSet& b, std::span<const SetDifference> differences) {
  out << "a: " << a.label << " on " << a.facts.front().backend << ", " << a.runs.size() << " runs\nb: " << b.label << " on "
      << b.facts.front().backend << ", " << b.runs.size() << " runs\n";
  out << detail::padded("metric", 42) << detail::padded("a", 12) << detail::padded("b", 12) << "b - a [95 %]\n";
  for (const SetDifference& d : differences) {
    if (d.name.metric == "deaths" && d.a.mean == 0.0 && d.b.mean == 0.0) continue;
    const detail::Reading reading{d.name};
    out << detail::padded(detail::title(d.name) + (d.name.unit == "m/s" ? ", cm/s" : ""), 42)
        << detail::padded(reading(d.a.mean), 12) << detail::padded(reading(d.b.mean), 12)
        << detail::padded(reading.with_interval(d.difference, d.interval, true), 30)
        << (verdict(d.interval) == Verdict::above || verdict(d.interval) == Verdict::below ? "differs" : "") << "\n";
  }
}

}  // namespace trophic::measure
