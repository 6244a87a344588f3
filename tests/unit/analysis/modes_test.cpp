// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <tools/analysis/metrics/modes.hpp>
#include <unit/reading/forests.hpp>
#include <vector>

using namespace trophic::analysis;
using doctest::Approx;
using trophic::test::one;

TEST_CASE("modes: filter -> the most recent ancestors, at the start, of those alive at the end") {
  const Forest forest = trophic::test::two_trees();
  using Places = std::vector<std::size_t>;
  CHECK(persistent(forest, 0, 0.0, 25.0) == Places{0});
  CHECK(persistent(forest, 0, 25.0, 100.0) == Places{1, 2});  // 0 is alive at 25 s, but 1 and 2 are more recent
  CHECK(persistent(forest, 0, 55.0, 100.0) == Places{1, 3, 4});
  CHECK(persistent(forest, 1, 0.0, 100.0).empty());
}

TEST_CASE("modes: types of two trees -> change, novelty, ecology and complexity as by hand") {
  const std::vector<Type> types{7, 7, 8, 9, 8, 5};
  const auto windows = modes_of(trophic::test::two_trees(), 0, types, std::vector{0.0, 25.0, 55.0, 100.0},
                                [](std::size_t place) { return static_cast<double>(place); });
  REQUIRE(windows.size() == 3);
  CHECK_FALSE(windows[0].change);
  CHECK_FALSE(windows[0].novelty);
  CHECK(*windows[0].ecology == 0.0);
  CHECK(*windows[1].change == 1.0);
  CHECK(*windows[1].novelty == 1.0);
  CHECK(*windows[1].ecology == Approx(1.0));  // 7 and 8
  CHECK(*windows[1].complexity == 2.0);
  CHECK(*windows[2].change == 1.0);
  CHECK(*windows[2].ecology == Approx(std::log2(3.0)));  // 7, 9 and 8
  CHECK(*windows[2].complexity == 4.0);
}

TEST_CASE("modes: a type that returns -> a change, not a novelty") {
  const Forest forest{one({}, 0.0, 12.0), one(0, 10.0, 22.0), one(1, 20.0, 32.0)};
  const auto windows =
      modes_of(forest, 0, std::vector<Type>{1, 2, 1}, std::vector{5.0, 11.0, 21.0, 31.0}, [](std::size_t) { return 0.0; });
  REQUIRE(windows.size() == 3);
  CHECK(*windows[1].change == 1.0);
  CHECK(*windows[1].novelty == 1.0);
  CHECK(*windows[2].change == 1.0);
  CHECK(*windows[2].novelty == 0.0);
}
