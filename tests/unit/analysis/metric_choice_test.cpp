// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/metric_choice.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("metric choice: some parts of a name -> the metrics that share them") {
  const MetricName caught{"deaths", "prey", "caught", "1"};
  CHECK(chooses("deaths", caught));
  CHECK(chooses("deaths:prey", caught));
  CHECK(chooses("deaths:prey:caught", caught));
  CHECK_FALSE(chooses("death", caught));
  CHECK_FALSE(chooses("deaths:predator", caught));
  CHECK_FALSE(chooses("deaths:prey:caught:1", caught));
  CHECK_FALSE(chooses("", caught));
}

TEST_CASE("choices keep the order of the metrics, and one that names none is refused") {
  const std::vector<MetricName> names{
      {"deaths", "prey", "all", "1"}, {"deaths", "prey", "caught", "1"}, {"hunger", "predator", "all", "ticks"}};
  CHECK(chosen(names, std::vector<std::string>{"hunger", "deaths:prey:all"}) == std::vector<MetricName>{names[0], names[2]});
  CHECK(chosen(names, {}) == names);
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(chosen(names, std::vector<std::string>{"hungr"})); }) ==
        "metric hungr: must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of deaths, hunger; did you mean hunger?");
}
