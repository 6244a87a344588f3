// SPDX-License-Identifier: MIT
// What flips change: flips.csv, and Markdown tables of what is decided.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <tools/analysis/report/flips.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <trophic/observe/column.hpp>
#include <trophic/params/params.hpp>
#include <tuple>

namespace trophic::analysis {

/// flips.csv: one row an effect.
struct FlipRow {
  std::string flip = {};
  std::string direction = {};
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::string compared = {};
  std::size_t runs_base = 0;
  std::size_t runs_flipped = 0;
  std::optional<double> base = {};
  std::optional<double> flipped = {};
  std::optional<double> difference = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::string decided = {};

  static constexpr auto columns() {
    using observe::column;
    return std::tuple{column("flip", &FlipRow::flip, "", "the slot or group of slots that was flipped"),
                      column("direction", &FlipRow::direction, "", "the set of flips, or from which table to which"),
                      column("metric", &FlipRow::metric, "", "what was measured"),
                      column("species", &FlipRow::species, "", "of whom; of a metric of two: prey+predator"),
                      column("group", &FlipRow::group, "", "as in metrics.csv"),
                      column("unit", &FlipRow::unit, "", "of base, flipped, difference and its interval"),
                      column("compared", &FlipRow::compared, "", "raw, or over_shadow: each set over its shadow first"),
                      column("runs_base", &FlipRow::runs_base, "", "runs in which nothing was flipped"),
                      column("runs_flipped", &FlipRow::runs_flipped, "", "runs with the flip"),
                      column("base", &FlipRow::base, "", "their mean, not over a shadow"),
                      column("flipped", &FlipRow::flipped, "", "their mean, not over a shadow"),
                      column("difference", &FlipRow::difference, "", "raw: flipped - base; over_shadow: of each less its shadow"),
                      column("lower", &FlipRow::lower, "", "of the difference's 95 % interval"),
                      column("upper", &FlipRow::upper, "", "of the difference's 95 % interval"),
                      column("p", &FlipRow::p, "", "of this comparison alone"),
                      column("p_holm", &FlipRow::p_holm, "", "corrected for all flips and metrics of the direction"),
                      column("decided", &FlipRow::decided, "", "yes where p_holm <= 0.05, else no; empty without a p value")};
  }
};

[[nodiscard]] inline FlipRow row_of(const FlipEffect& effect, const std::string& direction) {
  const Difference& d = effect.difference;
  return {.flip = effect.flip,
          .direction = direction,
          .metric = effect.name.metric,
          .species = effect.name.species,
          .group = effect.name.group,
          .unit = effect.name.unit,
          .compared = effect.over_shadow ? "over_shadow" : "raw",
          .runs_base = effect.base.runs,
          .runs_flipped = effect.flipped.runs,
          .base = effect.base.mean,
          .flipped = effect.flipped.mean,
          .difference = d.value,
          .lower = lower_of(d.interval),
          .upper = upper_of(d.interval),
          .p = d.p,
          .p_holm = d.adjusted,
          .decided = decided_text(d)};
}

/// A Markdown table of the effects that are decided, in the units that people read.
inline void print_decided(std::ostream& out, std::span<const FlipEffect> effects) {
  out << "| flip | metric | base | flipped | difference [95 %] | p (Holm) |\n|---|---|---|---|---|---|\n";
  for (const FlipEffect& effect : effects) {
    if (!effect.difference.differs()) continue;
    const Reading reading{effect.name};
    const double p = *effect.difference.adjusted;
    out << "| " << effect.flip << " | " << metric_title(effect.name) << (effect.over_shadow ? ", over shadow" : "") << " | "
        << reading(effect.base.mean) << " | " << reading(effect.flipped.mean) << " | "
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
    const Reading reading{all.name};
    out << "| " << metric_title(all.name) << (all.over_shadow ? ", over shadow" : "") << " | " << reading(all.base.mean) << " | "
        << reading(all.flipped.mean) << " | " << reading.with_interval(all.difference.value, all.difference.interval, true)
        << " |";
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
