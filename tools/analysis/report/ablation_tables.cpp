// SPDX-License-Identifier: MIT
// Definitions of flip_tables.hpp.
#include <tools/analysis/report/flip_tables.hpp>

#include <cmath>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

FlipRow row_of(const FlipEffect& effect, const std::string& direction) {
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

void print_decided(std::ostream& out, std::span<const FlipEffect> effects) {
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

void print_shares(std::ostream& out, std::span<const FlipEffect> whole, std::span<const FlipEffect> forward,
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
