// SPDX-License-Identifier: MIT
// Sets of runs to compare, written by hand.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>

namespace trophic::test {

/// Six runs: two metrics around these values.
inline analysis::RunSet set_around(double attribution, double hunger_ticks) {
  analysis::RunSet set;
  for (int i = 0; i < 6; ++i) {
    const double shift = i % 2 == 0 ? 0.01 : -0.01;
    set.runs.push_back({.measurements = {{{"attribution_caught", "prey", "all", "1"}, attribution + shift, {}},
                                         {{"hunger", "predator", "all", "ticks"}, hunger_ticks + shift, {}}},
                        .curves = {}});
  }
  return set;
}

inline const analysis::ShadowedSet base{set_around(0.5, 10.0), set_around(0.4, 9.0)};

}  // namespace trophic::test
