// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/measure/published.hpp>

using trophic::measure::published;

TEST_CASE("the paper's numbers, in SI units, positive towards the adversary, none for what it did not publish") {
  CHECK(*published({"attribution_catches", "predator", "all", "1"}) == 0.725);
  CHECK(*published({"attribution_caught", "prey", "all", "1"}) == 0.65);
  CHECK(*published({"velocity", "prey", "all", "m/s"}) == -0.0067);
  CHECK(*published({"tag_symmetry", "prey+predator", "inherited", "1"}) == 0.43);
  CHECK_FALSE(published({"attribution_catchers", "predator", "all", "1"}));
  CHECK_FALSE(published({"velocity", "prey", "random", "m/s"}));
  CHECK_FALSE(published({"wall_sticking", "wolf", "all", "1"}));
}
