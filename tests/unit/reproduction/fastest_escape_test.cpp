// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/fastest_escape.hpp>
#include <vector>

#include "unit/reproduction/walks.hpp"

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::FastestEscape;

TEST_CASE("fastest escape: greatest gain of distance within the window -> parent") {
  Walks<FastestEscape> walks{2, FastestEscape{{.window_ticks = 2}}};
  walks.to({1.0, 5.0});
  CHECK(walks.parent() == std::nullopt);
  walks.to({4.0, 5.5});
  CHECK(walks.parent() == 1);  // 3 m against 0.5 m
  walks.to({4.0, 6.0});
  CHECK(walks.parent() == 1);
  walks.to({4.0, 6.5});
  CHECK(walks.parent() == 2);  // 0 m against 1 m
  CHECK(walks.states()[1].x_m == std::vector<double>{4.0, 4.0, 4.0});
  walks.to({3.0, 1.0});
  walks.to({3.0, 1.0});
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("fastest escape: a prey younger than the window -> its gain since birth") {
  Walks<FastestEscape> walks{1};
  walks.to({2.0});
  walks.to({3.0});
  CHECK(walks.parent() == 1);
}
