// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <tools/analysis/report/swaps.hpp>
#include <unit/analysis/swap_sets.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::base;
using test::set_around;

TEST_CASE("attribution and velocity are compared over the shadows, the others as they are") {
  const ShadowedSet swapped{set_around(0.7, 12.0), set_around(0.6, 11.0)};
  const auto effects = effects_of("f", compare_sets(base, swapped));
  REQUIRE(effects.size() == 2);
  CHECK(effects[0].over_shadow);
  CHECK(*effects[0].difference.value == doctest::Approx(0.0));
  CHECK_FALSE(effects[1].over_shadow);
  CHECK(*effects[1].difference.value == doctest::Approx(2.0));
  CHECK(needs_shadow({"velocity_stored", "prey", "all", "m/s"}));
  CHECK_FALSE(needs_shadow({"wall_sticking", "prey", "all", "1"}));
}

TEST_CASE("without shadows the raw difference stands, and says so") {
  const auto effects = effects_of("f", compare_sets({base.ours, {}}, {set_around(0.7, 12.0), {}}));
  CHECK_FALSE(effects[0].over_shadow);
  CHECK(*effects[0].difference.value == doctest::Approx(0.2));
}

TEST_CASE("p values are corrected for all swaps and metrics, not for those of one swap") {
  std::vector<SwapEffect> all;
  for (const double hunger : {10.01, 10.02, 10.0}) {
    for (const auto& e : effects_of("f", compare_sets(base, {set_around(0.5, hunger), base.shadow}))) all.push_back(e);
  }
  for (const SwapEffect& effect : all) CHECK_FALSE(effect.difference.adjusted);
  adjust_together(all);
  REQUIRE(all.size() == 6);
  CHECK(*all[3].difference.adjusted == doctest::Approx(6.0 * *all[3].difference.p));
  CHECK(*all[0].difference.adjusted == 1.0);
}
