// SPDX-License-Identifier: MIT
// Effects of swaps: ablations.csv, and Markdown tables of the significant ones.
#pragma once

#include <ostream>
#include <span>
#include <tools/analysis/report/swaps.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// ablations.csv: one row an effect.
struct SwapRow {
  std::string swap = {};
  std::string direction = {};
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::string compared = {};
  std::size_t runs_base = 0;
  std::size_t runs_swapped = 0;
  std::optional<double> base = {};
  std::optional<double> swapped = {};
  std::optional<double> difference = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::string significant = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("swap", &SwapRow::swap, "", "the slot or group of slots that was swapped"),
        column("direction", &SwapRow::direction, "", "the set of swaps, or from which table to which"),
        column("metric", &SwapRow::metric, "", "what was measured"),
        column("species", &SwapRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &SwapRow::group, "", "as in metrics.csv"),
        column("unit", &SwapRow::unit, "", "of base, swapped, difference and its interval"),
        column("compared", &SwapRow::compared, "", "raw, or over_shadow: each set over its shadow first"),
        column("runs_base", &SwapRow::runs_base, "", "runs in which nothing was swapped"),
        column("runs_swapped", &SwapRow::runs_swapped, "", "runs with the swap"),
        column("base", &SwapRow::base, "", "their mean, not over a shadow"),
        column("swapped", &SwapRow::swapped, "", "their mean, not over a shadow"),
        column("difference", &SwapRow::difference, "", "raw: swapped - base; over_shadow: of each less its shadow"),
        column("lower", &SwapRow::lower, "", "of the difference's 95 % interval"),
        column("upper", &SwapRow::upper, "", "of the difference's 95 % interval"),
        column("p", &SwapRow::p, "", "of this comparison alone"),
        column("p_holm", &SwapRow::p_holm, "", "corrected for all swaps and metrics of the direction"),
        column("significant", &SwapRow::significant, "", "yes where p_holm <= 0.05, else no; empty without a p value")};
  }
};

[[nodiscard]] SwapRow row_of(const SwapEffect& effect, const std::string& direction);

/// A Markdown table of the significant effects, in the units that people read.
void print_significant(std::ostream& out, std::span<const SwapEffect> effects);

/// How much of the difference between two tables the swaps of some names make: one line per metric, each swap's effect with its
/// interval. `forward`: swaps from the first table towards the second. `backward`: from the second towards the first, whose
/// effects are shown with the sign turned, so that both say what the second table's rules do. Only metrics whose `whole` differs.
void print_shares(std::ostream& out, std::span<const SwapEffect> whole, std::span<const SwapEffect> forward,
                  std::span<const SwapEffect> backward, std::span<const std::string> names);

}  // namespace trophic::analysis
