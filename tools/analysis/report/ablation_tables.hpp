// SPDX-License-Identifier: MIT
// What flips change: flips.csv, and Markdown tables of what is decided.
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <tools/analysis/report/flips.hpp>
#include <trophic/io/column.hpp>
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
    using io::column;
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

[[nodiscard]] FlipRow row_of(const FlipEffect& effect, const std::string& direction);

/// A Markdown table of the effects that are decided, in the units that people read.
void print_decided(std::ostream& out, std::span<const FlipEffect> effects);

/// How much of the difference between two tables the flips of some names make: one line per metric, each flip's effect with its
/// interval. `forward`: flips from the first table towards the second. `backward`: from the second towards the first, whose
/// effects are shown with the sign turned, so that both say what the second table's rules do. Only metrics whose `whole` differs.
void print_shares(std::ostream& out, std::span<const FlipEffect> whole, std::span<const FlipEffect> forward,
                  std::span<const FlipEffect> backward, std::span<const std::string> names);

}  // namespace trophic::analysis
