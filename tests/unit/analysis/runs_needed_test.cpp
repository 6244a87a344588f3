// SPDX-License-Identifier: MIT
// The number of runs that a difference is said to need, by simulated studies of that many runs.
#include <doctest/doctest.h>

#include <optional>
#include <tools/analysis/statistics/difference.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

std::vector<double> normal(Rng& rng, double mean, double deviation, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = rng.normal(mean, deviation);
  return values;
}

/// Share of studies with so many runs in each set in which a difference of 1 has p <= level.
double found(std::span<const double> deviations, std::size_t runs, double level) {
  constexpr int studies = 3000;
  Rng rng{runs, Stream::user};
  int count = 0;
  for (int study = 0; study < studies; ++study) {
    std::vector<std::vector<double>> sets;
    for (std::size_t i = 0; i < deviations.size(); ++i) sets.push_back(normal(rng, i == 0 ? 1.0 : 0.0, deviations[i], runs));
    const auto of = sets.size() == 2 ? contrast({{1.0, sets[0]}, {-1.0, sets[1]}})
                                     : contrast({{1.0, sets[0]}, {-1.0, sets[1]}, {-1.0, sets[2]}, {1.0, sets[3]}});
    count += *p_value(of) <= level ? 1 : 0;
  }
  return static_cast<double>(count) / studies;
}

}  // namespace

TEST_CASE("runs_needed: simulated studies of so many runs -> 80 % find the difference, of half as many far fewer") {
  const std::array<std::vector<double>, 3> cases{{{1.0, 1.0}, {2.0, 0.5}, {1.0, 1.0, 1.5, 0.5}}};
  for (const std::vector<double>& deviations : cases) {
    for (const double level : {0.05, 0.001}) {
      CAPTURE(deviations.size());
      CAPTURE(level);
      Scatter scatter{0.0, 0.0};
      double squares = 0.0;
      for (const double deviation : deviations) {
        scatter.variance += deviation * deviation;
        squares += deviation * deviation * deviation * deviation;
      }
      scatter.freedom = scatter.variance * scatter.variance / squares;
      const Difference difference{.value = 1.0, .adjusted = 0.9, .scatter = scatter, .level = level};
      REQUIRE(difference.runs_needed());
      const std::size_t runs = *difference.runs_needed();
      CHECK(found(deviations, runs, level) == doctest::Approx(0.80).epsilon(0.04));
      CHECK(found(deviations, runs / 2, level) < 0.65);
    }
  }
}

TEST_CASE("runs_needed: significant, untested or unknown scatter -> none") {
  const Scatter scatter{1.0, 1.0};
  CHECK_FALSE(Difference{.value = 1.0, .adjusted = 0.01, .scatter = scatter, .level = 0.05}.runs_needed());
  CHECK_FALSE(Difference{.value = 1.0, .scatter = scatter}.runs_needed());
  CHECK_FALSE(Difference{.value = 1.0, .adjusted = 0.9, .level = 0.05}.runs_needed());
}

TEST_CASE("adjust_together: the level of one of so many comparisons") {
  Difference a{.value = 1.0, .p = 0.02};
  Difference b{.value = 1.0, .p = 0.5};
  Difference constant{.value = 0.0};
  const std::array all{&a, &b, &constant};
  adjust_together(all);
  CHECK(*a.level == 0.025);
  CHECK(*b.level == 0.025);
  CHECK_FALSE(constant.level);
}
