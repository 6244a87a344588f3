// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

/// Six runs with two metrics: x around `x`, y around 1 whatever x is.
RunSet set_near(double x, double spread = 0.01) {
  RunSet set;
  for (int i = 0; i < 6; ++i) {
    const double shift = (i % 2 == 0 ? 1.0 : -1.0) * spread;
    set.runs.push_back({.measurements = {{{"x", "prey", "all", "1"}, x + shift, {}},
                                         {{"y", "prey", "all", "1"}, 1.0 + (i < 3 ? 0.1 : -0.1), {}},
                                         {{"constant", "prey", "all", "1"}, 0.0, {}}},
                        .curves = {}});
  }
  return set;
}

}  // namespace

TEST_CASE("a difference that the shadows have too is raw, and none over the shadows") {
  const ShadowedSet a{set_near(0.5), set_near(0.4)};
  const ShadowedSet b{set_near(0.7), set_near(0.6)};
  const auto x = compare_sets(a, b).front();
  CHECK(*x.raw.value == doctest::Approx(0.2));
  CHECK(x.raw.differs());
  CHECK(*x.over_shadow.value == doctest::Approx(0.0));
  CHECK_FALSE(x.over_shadow.differs());
  const ShadowedSet c{set_near(0.7), set_near(0.4)};
  CHECK(*compare_sets(a, c).front().over_shadow.value == doctest::Approx(0.2));
  CHECK(compare_sets(a, c).front().over_shadow.differs());
}

TEST_CASE("without a shadow of both there is only the raw difference") {
  const auto x = compare_sets({set_near(0.5), set_near(0.4)}, {set_near(0.7), {}}).front();
  CHECK(x.raw.differs());
  CHECK_FALSE(x.over_shadow.value);
  CHECK_FALSE(x.over_shadow.interval);
}

TEST_CASE("p values are corrected for the number of metrics that vary") {
  const auto all = compare_sets({set_near(0.5), {}}, {set_near(0.51), {}});
  REQUIRE(all.size() == 3);
  CHECK(*all[0].raw.adjusted == doctest::Approx(2.0 * *all[0].raw.p));
  CHECK(*all[1].raw.adjusted == 1.0);
  CHECK_FALSE(all[2].raw.p);
  CHECK_FALSE(all[2].raw.differs());
}

TEST_CASE("a metric that one set lacks is left out, five runs have no interval") {
  ShadowedSet a{set_near(0.5), {}};
  ShadowedSet b{set_near(0.7), {}};
  for (RunMetrics& run : b.ours.runs) run.measurements[0].name.species = "wolf";
  CHECK(compare_sets(a, b).size() == 2);
  a.ours.runs.pop_back();
  const auto y = compare_sets(a, b).front();
  CHECK(y.raw.value);
  CHECK_FALSE(y.raw.interval);
  CHECK_FALSE(y.raw.p);
  CHECK_FALSE(y.raw.differs());
}

TEST_CASE("sets of different duration are not compared") {
  RunManifest a;
  a.folder = "a";
  a.until_s = 6000.0;
  a.status = "complete";
  RunManifest b = a;
  CHECK_NOTHROW(check_comparable(a, b));
  b.folder = "b";
  b.until_s = 6500.0;
  CHECK(test::message_of<std::invalid_argument>([&] { check_comparable(a, b); }) ==
        "b: status \"complete\" at 6500 of 6500 s, but a has status \"complete\" at 6000 of 6000 s; runs of different length are "
        "not compared: use --until");
  b.until_s = 6000.0;
  b.status = "stopped";
  b.reached_s = 4000.0;
  CHECK(
      test::message_of<std::invalid_argument>([&] { check_comparable(a, b); }).starts_with("b: status \"stopped\" at 4000 of "));
  a.status = b.status = "running";
  a.reached_s = b.reached_s = {};
  CHECK(test::message_of<std::invalid_argument>([&] { check_comparable(a, b); }).find("an unknown time") != std::string::npos);
}
