// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <tools/analysis/metrics/repeated_metrics.hpp>
#include <vector>

namespace {

using namespace trophic::analysis;

MetricName named(const char* metric, const char* unit = "1") {
  return {metric, "prey", "all", unit};
}

const MetricName first = named("first");
const MetricName second = named("second");

std::optional<MetricName> repeats(const std::vector<std::optional<double>>& a, const std::vector<std::optional<double>>& b) {
  std::vector<RunMetrics> runs;
  for (std::size_t i = 0; i < a.size(); ++i)
    runs.push_back({.measurements = {{first, a[i], {}}, {second, b[i], {}}}, .curves = {}});
  const std::array<std::span<const RunMetrics>, 2> sets{std::span{runs}.first(a.size() / 2),
                                                        std::span{runs}.subspan(a.size() / 2)};
  return repeated_metrics(sets, std::array{first, second})[1];
}

}  // namespace

TEST_CASE("repeated_metrics: equal, shifted or reversed in every run -> the earlier one") {
  const std::vector<std::optional<double>> values{0.1, 0.7, 0.3, 0.2, 0.9, 0.4};
  CHECK(repeats(values, values) == first);
  CHECK(repeats({1, 5, 3, 2, 9, 4}, {29, 25, 27, 28, 21, 26}) == first);
  CHECK(repeats({1, 5, 3, 2, 9, 4}, {2, 6, 4, 3, 10, 5}) == first);
  CHECK(repeats({1, {}, 3, 2, 9, 4, 7}, {1, {}, 3, 2, 9, 4, 7}) == first);
}

TEST_CASE("repeated_metrics: another value in one run, other gaps, a constant or five runs -> none") {
  CHECK_FALSE(repeats({1, 5, 3, 2, 9, 4}, {1, 5, 3, 2, 9, 4.001}));
  CHECK_FALSE(repeats({1, 5, 3, 2, 9, 4}, {2, 10, 6, 4, 18, 8}));
  CHECK_FALSE(repeats({1, 5, 3, 2, 9, 4, 7}, {1, 5, 3, 2, 9, 4, {}}));
  CHECK_FALSE(repeats({1, 1, 1, 1, 1, 1}, {2, 2, 2, 2, 2, 2}));
  CHECK_FALSE(repeats({1, 5, 3, 2, 9}, {1, 5, 3, 2, 9}));
}

TEST_CASE("repeated_metrics: another reading of velocity repeats it, unless it stands alone") {
  const MetricName plain = named("velocity", "m/s");
  const MetricName stored = named("velocity_stored", "m/s");
  CHECK(repeated_metrics({}, std::array{plain, stored})[1] == plain);
  CHECK_FALSE(repeated_metrics({}, std::array{stored})[0]);
}
