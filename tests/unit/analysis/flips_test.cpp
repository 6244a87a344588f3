// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <trophic/analysis/report/flips.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

/// Six runs: two metrics around these values.
RunSet set_around(double attribution, double hunger) {
  RunSet set;
  for (int i = 0; i < 6; ++i) {
    const double shift = i % 2 == 0 ? 0.01 : -0.01;
    set.runs.push_back({.measurements = {{{"attribution_caught", "prey", "all", "1"}, attribution + shift, {}},
                                         {{"hunger", "predator", "all", "ticks"}, hunger + shift, {}}},
                        .curves = {}});
  }
  return set;
}

const ShadowedSet base{set_around(0.5, 10.0), set_around(0.4, 9.0)};

}  // namespace

TEST_CASE("attribution and velocity are compared over the shadows, the others as they are") {
  const ShadowedSet flipped{set_around(0.7, 12.0), set_around(0.6, 11.0)};
  const auto effects = effects_of("f", compare_sets(base, flipped));
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

TEST_CASE("p values are corrected for all flips and metrics, not for those of one flip") {
  std::vector<FlipEffect> all;
  for (const double hunger : {10.01, 10.02, 10.0}) {
    for (const auto& e : effects_of("f", compare_sets(base, {set_around(0.5, hunger), base.shadow}))) all.push_back(e);
  }
  for (const FlipEffect& effect : all) CHECK_FALSE(effect.difference.adjusted);
  adjust_together(all);
  REQUIRE(all.size() == 6);
  CHECK(*all[3].difference.adjusted == doctest::Approx(6.0 * *all[3].difference.p));
  CHECK(*all[0].difference.adjusted == 1.0);
}

TEST_CASE("the table has what is decided and nothing else") {
  auto effects = effects_of("wide", compare_sets(base, {set_around(0.5, 12.0), base.shadow}));
  adjust_together(effects);
  std::ostringstream out;
  print_decided(out, effects);
  CHECK(out.str().find("| wide | hunger predator | 10.0 | 12.0 | +2.0 [") != std::string::npos);
  CHECK(out.str().find("attribution") == std::string::npos);
}

TEST_CASE("shares: flips into the first table, and out of the second with the sign turned, and what is lacking has no sum") {
  const ShadowedSet second{set_around(0.5, 14.0), base.shadow};
  const auto effects = [](const std::string& flip, const ShadowedSet& from, double hunger) {
    auto found = effects_of(flip, compare_sets(from, {set_around(0.5, hunger), base.shadow}));
    adjust_together(found);
    return found;
  };
  const auto whole = effects("second", base, 14.0);
  std::vector<FlipEffect> forward = effects("a", base, 11.0);
  for (const auto& effect : effects("b", base, 12.0)) forward.push_back(effect);
  std::vector<FlipEffect> backward = effects("a", second, 12.5);
  const std::vector<std::string> names{"a", "b"};
  std::ostringstream out;
  print_shares(out, whole, forward, backward, names);
  CHECK(out.str().find("| +1.0* | +1.5* | +2.0* | missing | +3.0 | missing |") != std::string::npos);
  CHECK(out.str().find("attribution") == std::string::npos);
}
