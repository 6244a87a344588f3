// SPDX-License-Identifier: MIT
// Definitions of ablation_tables.hpp.
#include <tools/analysis/report/ablation_tables.hpp>

#include <cmath>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

SwapRow row_of(const SwapEffect& effect, const std::string& direction) {
  const Difference& d = effect.difference;
  return {.swap = effect.swap,
          .direction = direction,
          .metric = effect.name.metric,
          .species = effect.name.species,
          .group = effect.name.group,
          .unit = effect.name.unit,
          .compared = effect.over_shadow ? "over_shadow" : "raw",
          .runs_base = effect.base.runs,
          .runs_swapped = effect.swapped.runs,
          .base = effect.base.mean,
          .swapped = effect.swapped.mean,
          .difference = d.value,
          .lower = lower_of(d.interval),
          .upper = upper_of(d.interval),
          .p = d.p,
          .p_holm = d.adjusted,
          .significant = significance_text(d)};
}

void print_significant(std::ostream& out, std::span<const SwapEffect> effects) {
  out << "| swap | metric | base | swapped | difference [95 %] | p (Holm) |\n|---|---|---|---|---|---|\n";
  for (const SwapEffect& effect : effects) {
    if (!effect.difference.differs()) continue;
    const Reading reading{effect.name};
    const double p = *effect.difference.adjusted;
    out << "| " << effect.swap << " | " << metric_title(effect.name) << (effect.over_shadow ? ", over shadow" : "") << " | "
        << reading(effect.base.mean) << " | " << reading(effect.swapped.mean) << " | "
        << reading.with_interval(effect.difference.value, effect.difference.interval, true) << " | "
        << (p < 0.0005 ? std::string{"<0.001"} : number_text(std::round(p * 1000.0) / 1000.0)) << " |\n";
  }
}

void print_shares(std::ostream& out, std::span<const SwapEffect> whole, std::span<const SwapEffect> forward,
                  std::span<const SwapEffect> backward, std::span<const std::string> names) {
  const auto find = [](std::span<const SwapEffect> in, const std::string& swap, const SwapEffect& like) -> const SwapEffect* {
    for (const SwapEffect& effect : in) {
      if (effect.swap == swap && effect.name == like.name && effect.over_shadow == like.over_shadow) return &effect;
    }
    return nullptr;
  };
  out << "| metric | first | second | whole difference [95 %] |";
  for (const std::string& name : names) out << " " << name << " into first | " << name << " out of second |";
  out << " sum into first | sum out of second |\n|---|---|---|---|";
  for (std::size_t i = 0; i < 2 * names.size() + 2; ++i) out << "---|";
  out << "\n";
  for (const SwapEffect& all : whole) {
    if (!all.difference.differs()) continue;
    const Reading reading{all.name};
    out << "| " << metric_title(all.name) << (all.over_shadow ? ", over shadow" : "") << " | " << reading(all.base.mean) << " | "
        << reading(all.swapped.mean) << " | " << reading.with_interval(all.difference.value, all.difference.interval, true)
        << " |";
    std::optional<double> into = 0.0;
    std::optional<double> out_of = 0.0;
    for (const std::string& name : names) {
      const auto show = [&](const SwapEffect* effect, double sign, std::optional<double>& sum) {
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
