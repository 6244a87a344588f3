// SPDX-License-Identifier: MIT
// Effects of axes: by hand on a grid of two axes, and with the nominal error rate.
#include <doctest/doctest.h>

#include <string>
#include <tools/analysis/report/axis_effects.hpp>
#include <trophic/support/rng.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

const AxisEffect& effect_of(const std::vector<AxisEffect>& effects, const std::string& axis, const std::string& value) {
  for (const AxisEffect& effect : effects) {
    if (effect.axis == axis && effect.value == value) return effect;
  }
  FAIL("no effect of " << axis << " = " << value);
  return effects.front();
}

}  // namespace

TEST_CASE("an axis' effect is the mean difference over the other axes' values, with an interval over seeds") {
  const auto plan = test::plan_of_two_axes(6);
  // 10 a + 3 b a + the seed's own number: b does nothing at a = 0, 3 at a = 1 and 6 at a = 2.
  const auto values = test::values_of_plan(plan, test::hunger, [](const sweep::PlannedRun& run) {
    const auto a = static_cast<double>(run.cell / 2);
    const auto b = static_cast<double>(run.cell % 2);
    return 10.0 * a + 3.0 * b * a + static_cast<double>(run.replicate) * (1.0 + a);
  });
  const std::array names{test::hunger};
  const auto effects = axis_effects(grid_of(plan), values, 0, names);
  REQUIRE(effects.size() == 3);
  const AxisEffect a1 = effect_of(effects, "a", "1");
  CHECK(a1.reference == "0");
  CHECK(a1.settings == 2);
  CHECK(a1.seeds == 6);
  // 10 + the mean of 0 and 3 + the mean of the seeds' 0, ..., 5, whose standard error is sqrt(3.5 / 6).
  CHECK(*a1.difference.value == doctest::Approx(10.0 + 1.5 + 2.5));
  const double half = 2.570581835636314 * std::sqrt(3.5 / 6.0);
  CHECK(a1.difference.interval->lower == doctest::Approx(14.0 - half));
  CHECK(a1.difference.interval->upper == doctest::Approx(14.0 + half));
  CHECK(*effect_of(effects, "a", "2").difference.value == doctest::Approx(20.0 + 3.0 + 5.0));
  const AxisEffect b1 = effect_of(effects, "b", "1");
  CHECK(b1.settings == 3);
  CHECK(*b1.difference.value == doctest::Approx(3.0));
  CHECK(*b1.mean_reference == doctest::Approx(10.0 + 2.5 * 2.0));
}

TEST_CASE("only settings at which both values were run are averaged, and seeds that all of their cells have") {
  auto plan = test::plan_of_two_axes(6);
  auto values = test::values_of_plan(plan, test::hunger, [](const sweep::PlannedRun& run) {
    return static_cast<double>(run.cell) + static_cast<double>(run.replicate);
  });
  values.of_run[3] = {};  // replicate 3 of a = 0, b = 0
  const std::array names{test::hunger};
  const auto effects = axis_effects(grid_of(plan), values, 1, names);
  CHECK(effect_of(effects, "a", "1").seeds == 5);
  CHECK_FALSE(effect_of(effects, "a", "1").difference.interval);
  std::erase_if(plan, [](const sweep::PlannedRun& run) { return run.cell == 3; });
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].index = i;
  const auto fewer = test::values_of_plan(plan, test::hunger, [](const sweep::PlannedRun& run) {
    return static_cast<double>(run.cell) + static_cast<double>(run.replicate);
  });
  const auto without = axis_effects(grid_of(plan), fewer, 0, names);
  CHECK(effect_of(without, "a", "1").settings == 1);
  CHECK(effect_of(without, "b", "1").settings == 2);
}

TEST_CASE("a metric that needs it is compared over the shadow, cells with seeds of their own have no effects of axes") {
  const auto plan = test::plan_of_two_axes(6, true);
  const auto values = test::values_of_plan(plan, test::velocity, [](const sweep::PlannedRun& run) {
    return (run.shadow ? 1.0 : 4.0) * static_cast<double>(run.cell / 2) + static_cast<double>(run.replicate);
  });
  const std::array names{test::velocity};
  const AxisEffect effect = effect_of(axis_effects(grid_of(plan), values, 0, names), "a", "1");
  CHECK(effect.over_shadow);
  CHECK(*effect.difference.value == doctest::Approx(3.0));
  const auto unpaired = test::plan_of_two_axes(6, true, false);
  CHECK(axis_effects(grid_of(unpaired), values, 0, names).empty());
}

TEST_CASE("without an effect any axis is significant in at most 5 % of sweeps, within 1.5 points") {
  constexpr int trials = 1000;
  const auto plan = test::plan_of_two_axes(8);
  const SweepGrid grid = grid_of(plan);
  const std::array names{test::hunger};
  int wrong = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Rng rng{3, Stream::user, static_cast<std::uint64_t>(trial)};
    const auto values = test::values_of_plan(
        plan, test::hunger, [&](const sweep::PlannedRun& run) { return rng.normal(0.0, run.cell < 2 ? 1.0 : 2.0); });
    bool significant = false;
    for (const AxisEffect& effect : axis_effects(grid, values, 0, names))
      significant = significant || effect.difference.differs();
    wrong += significant ? 1 : 0;
  }
  MESSAGE("significant in " << wrong << " of " << trials << " sweeps");
  CHECK(wrong <= 65);
  CHECK(wrong >= 10);  // it can find something
}
