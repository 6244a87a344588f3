// SPDX-License-Identifier: MIT
// Many sets of runs, each with something flipped, against the one set in which nothing is.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <trophic/analysis/metrics/run_metrics.hpp>
#include <trophic/analysis/report/compare_sets.hpp>
#include <trophic/analysis/report/summary.hpp>
#include <trophic/analysis/report/text_table.hpp>
#include <trophic/analysis/statistics/holm.hpp>
#include <vector>

namespace trophic::analysis {

/// What a flip changes in one metric.
struct FlipEffect {
  std::string flip;
  MetricName name;
  bool over_shadow = false;  ///< both sets were set over their shadows before they were compared
  Estimate base;
  Estimate flipped;
  Difference difference;
};

/// Whether a metric moves with the composition of the population alone, so that only a shadow tells what inheritance does.
[[nodiscard]] inline bool needs_shadow(const MetricName& name) {
  return name.metric.starts_with("attribution") || name.metric.starts_with("velocity");
}

/// One effect a metric: over the shadows where the metric needs it and both sets have one, else raw. The p values are not yet
/// adjusted: `adjust_together` does it for all flips at once.
[[nodiscard]] inline std::vector<FlipEffect> effects_of(const std::string& flip, std::span<const SetDifference> differences) {
  std::vector<FlipEffect> effects;
  for (const SetDifference& d : differences) {
    const bool over_shadow = needs_shadow(d.name) && d.over_shadow.value.has_value();
    Difference difference = over_shadow ? d.over_shadow : d.raw;
    difference.adjusted.reset();
    effects.push_back({flip, d.name, over_shadow, d.a, d.b, difference});
  }
  return effects;
}

/// Holm's correction over all flips and metrics of a list. A metric in which nothing varies is no comparison.
inline void adjust_together(std::vector<FlipEffect>& effects) {
  std::vector<double> p_values;
  for (const FlipEffect& effect : effects) {
    if (effect.difference.p) p_values.push_back(*effect.difference.p);
  }
  const std::vector<double> adjusted = holm(p_values);
  std::size_t k = 0;
  for (FlipEffect& effect : effects) {
    effect.difference.adjusted.reset();
    if (effect.difference.p) effect.difference.adjusted = adjusted[k++];
  }
}

/// A Markdown table of the effects that are decided, in the units that people read.
inline void print_decided(std::ostream& out, std::span<const FlipEffect> effects) {
  out << "| flip | metric | base | flipped | difference [95 %] | p (Holm) |\n|---|---|---|---|---|---|\n";
  for (const FlipEffect& effect : effects) {
    if (!effect.difference.differs()) continue;
    const detail::Reading reading{effect.name};
    const double p = *effect.difference.adjusted;
    out << "| " << effect.flip << " | " << detail::metric_title(effect.name) << (effect.over_shadow ? ", over shadow" : "")
        << " | " << reading(effect.base.mean) << " | " << reading(effect.flipped.mean) << " | "
        << reading.with_interval(effect.difference.value, effect.difference.interval, true) << " | "
        << (p < 0.0005 ? std::string{"<0.001"} : number_text(std::round(p * 1000.0) / 1000.0)) << " |\n";
  }
}

/// How much of the difference between two tables the flips of some names make: one line per metric, each flip's effect with its
/// interval. `forward`: flips from the first table towards the second. `backward`: from the second towards the first, whose
/// effects are shown with the sign turned, so that both say what the second table's rules do. Only metrics whose `whole` differs.
inline void print_shares(std::ostream& out, std::span<const FlipEffect> whole, std::span<const FlipEffect> forward,
                         std::span<const FlipEffect> backward, std::span<const std::string> names) {
  const auto find = [](std::span<const FlipEffect> in, const std::string& flip, const FlipEffect& like) -> const FlipEffect* {
    for (const FlipEffect& effect : in) {
      if (effect.flip == flip && effect.name == like.name && effect.over_shadow == like.over_shadow) return &effect;
    }
    return nullptr;
  };
  out << "| metric | first | second | whole difference [95 %] |";
  for (const std::string& name : names) out << " " << name << " into first | " << name << " out of second |";
  out << " sum into first | sum out of second |\n|---|---|---|---|";
  for (std::size_t i = 0; i < 2 * names.size() + 2; ++i) out << "---|";
  out << "\n";
  for (const FlipEffect& all : whole) {
    if (!all.difference.differs()) continue;
    const detail::Reading reading{all.name};
    out << "| " << detail::metric_title(all.name) << (all.over_shadow ? ", over shadow" : "") << " | " << reading(all.base.mean)
        << " | " << reading(all.flipped.mean) << " | "
        << reading.with_interval(all.difference.value, all.difference.interval, true) << " |";
    std::optional<double> into = 0.0;
    std::optional<double> out_of = 0.0;
    for (const std::string& name : names) {
      const auto show = [&](const FlipEffect* effect, double sign, std::optional<double>& sum) {
        if (effect == nullptr || !effect->difference.value) {
          sum.reset();
          out << " missing |";
          return;
        }
        const double value = sign * *effect->difference.value;
        if (sum) *sum += value;
        out << " " << reading(value, true) << (effect->difference.differs() ? "* |" : " |");
      };
      show(find(forward, name, all), 1.0, into);
      show(find(backward, name, all), -1.0, out_of);
    }
    out << " " << reading(into, true) << " | " << reading(out_of, true) << " |\n";
  }
}

}  // namespace trophic::analysis
