// SPDX-License-Identifier: MIT
// The same rules on two engines: which metrics are equivalent.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>
#include <tools/trophic/cross_check/report.hpp>

namespace trophic::command::cross_check {

/// A metric of the paper and the difference between engines that would still leave its conclusion alone: shares (attribution, tag
/// symmetry) by 0.05 and wall sticking by 0.1, a fraction of what separates the published values from their baselines; velocities
/// by 0.5 cm/s, a fraction of the published ones; deaths by a fifth of the first set's.
struct Margin {
  std::string_view metric;
  std::string_view group;
  double margin;
  bool is_share_of_first = false;
};
inline constexpr std::array margins{Margin{"attribution_caught", "all", 0.05},   Margin{"attribution_catches", "all", 0.05},
                                    Margin{"attribution_catchers", "all", 0.05}, Margin{"velocity", "all", 0.005},
                                    Margin{"velocity", "inherited", 0.005},      Margin{"velocity", "random", 0.005},
                                    Margin{"wall_sticking", "all", 0.1},         Margin{"wall_sticking_gap", "all", 0.1},
                                    Margin{"tag_symmetry", "inherited", 0.05},   Margin{"deaths", "all", 0.2, true}};

/// Two sets of replicates that may be compared.
struct Ecologies {
  analysis::RunSet first;
  analysis::RunSet second;
};

/// Reads two folders of replicates. Throws std::invalid_argument if their rules, their parameters but for the engine's, or their
/// durations differ, and as analysis::read_set does.
[[nodiscard]] Ecologies read_ecologies(const std::filesystem::path& first, const std::filesystem::path& second);

/// Prints a conclusion per metric and adds a line per metric and engine to the CSV.
void compare_ecologies(const Ecologies& sets, Csv& csv);

}  // namespace trophic::command::cross_check
