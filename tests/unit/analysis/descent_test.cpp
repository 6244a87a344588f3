// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/descent.hpp>
#include <unit/reading/forests.hpp>

using namespace trophic::analysis;
using doctest::Approx;
using trophic::test::alive;
using trophic::test::one;

TEST_CASE("descent: two trees -> roots, clades, depths, common ancestors and branches as by hand") {
  const auto descent = descent_of(trophic::test::two_trees(), 0, 100.0);  // 1, 3, 4 and 5 live
  REQUIRE(descent);
  CHECK(descent->roots == 2.0);
  CHECK(descent->largest_clade == Approx(3.0 / 4.0));
  CHECK(descent->mean_depth == Approx((1.0 + 2.0 + 0.0 + 2.0) / 4.0));
  CHECK(descent->greatest_depth == 2.0);
  CHECK(*descent->related_pairs == Approx(3.0 / 6.0));                         // 1-3, 1-5, 3-5
  CHECK(*descent->common_ancestor_s == Approx((100.0 + 90.0 + 100.0) / 3.0));  // 0, 1, 0
  CHECK(descent->diversity_s == Approx((20.0 + 90.0 + 20.0 + 60.0 + 70.0 + 30.0) / 4.0));
}

TEST_CASE("descent: at an earlier time, of another species, of a single individual -> only those alive then count") {
  const Forest forest = trophic::test::two_trees();
  const auto early = descent_of(forest, 0, 15.0);  // 0 and its offspring 1
  REQUIRE(early);
  CHECK(early->roots == 1.0);
  CHECK(*early->related_pairs == 1.0);
  CHECK(*early->common_ancestor_s == Approx(15.0));
  CHECK(early->diversity_s == Approx((15.0 + 5.0) / 2.0));
  CHECK_FALSE(descent_of(forest, 1, 100.0));
  const auto alone = descent_of({one({}, 0.0, alive)}, 0, 10.0);
  REQUIRE(alone);
  CHECK_FALSE(alone->related_pairs);
  CHECK_FALSE(alone->common_ancestor_s);
  CHECK(alone->largest_clade == 1.0);
}
