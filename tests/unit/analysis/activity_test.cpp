// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/activity.hpp>
#include <unit/reading/forests.hpp>
#include <vector>

using namespace trophic::analysis;
using doctest::Approx;
using trophic::test::one;

TEST_CASE("activity: presence -> each type once at each time at which a bearer lives") {
  const Forest forest{one({}, 0.0, 20.0), one(0, 10.0, 30.0), one({}, 10.0, 11.0, 0.0, 1)};
  CHECK(presence_of(forest, 0, std::vector<Type>{4, 4, 9}, std::vector{0.0, 10.0, 20.0, 30.0}) == Presence{{4}, {4}, {4}, {}});
  CHECK(presence_of(forest, 0, std::vector<Type>{4, 2, 9}, std::vector{0.0, 10.0, 20.0, 30.0}) == Presence{{4}, {2, 4}, {2}, {}});
}

TEST_CASE("activity: three times with one null -> diversity, mean, excess and new activity as by hand") {
  const Presence ours{{0, 1}, {0}, {0, 2}};
  const std::vector<Presence> nulls{{{0}, {0}, {1}}};  // type 0 reaches 2, type 1 reaches 1
  const auto activity = activity_of(ours, nulls);
  REQUIRE(activity.size() == 3);
  CHECK(activity[0].diversity == 2.0);
  CHECK(activity[0].mean == Approx(1.0));
  CHECK(activity[0].excess == Approx(0.5));  // of type 1, which the null lacks
  CHECK(activity[0].fresh == 0.0);
  CHECK(activity[1].mean == Approx(2.0));
  CHECK(activity[1].excess == Approx(0.0));
  CHECK(activity[2].mean == Approx((3.0 + 1.0) / 2.0));
  CHECK(activity[2].excess == Approx((1.0 + 1.0) / 2.0));
  CHECK(activity[2].fresh == 1.0);  // type 0 exceeds 2
}
