// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <tools/contest/contest_design.hpp>
#include <vector>

using trophic::contest::ContestDesign;

TEST_CASE("contest design: members -> all living before any twice, other ones for each replicate, epoch, team and shadow") {
  const ContestDesign design{1, 30, 2};
  const auto few = design.members({.replicate = 3}, false, 4, 10);
  REQUIRE(few.size() == 10);
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::ranges::count(few, i) >= 2);
  const auto many = design.members({.replicate = 3}, false, 100, 15);
  CHECK(std::set<std::size_t>(many.begin(), many.end()).size() == 15);
  CHECK(design.members({.replicate = 3}, false, 0, 10).empty());

  std::set<std::vector<std::size_t>> drawn;
  for (std::size_t replicate = 0; replicate < 30; ++replicate) {
    for (const std::size_t epoch : {0U, 1U}) {
      for (const std::size_t team : {0U, 1U}) {
        for (const std::size_t species : {0U, 1U}) {
          for (const bool shadow : {false, true}) {
            drawn.insert(design.members({replicate, epoch, species, team}, shadow, 100, 15));
          }
        }
      }
    }
  }
  CHECK(drawn.size() == 30 * 16);
  CHECK(design.members({.replicate = 3}, false, 100, 15) == many);
  CHECK(ContestDesign{2, 30, 2}.members({.replicate = 3}, false, 100, 15) != many);
}

TEST_CASE("contest design: partners -> another replicate, each once, another one for each team") {
  const ContestDesign design{5, 7, 3};
  for (const std::size_t team : {0U, 1U, 2U}) {
    std::set<std::size_t> partners;
    for (std::size_t replicate = 0; replicate < 7; ++replicate) {
      const std::size_t partner = design.partner(replicate, team);
      CHECK(partner != replicate);
      CHECK(partner < 7);
      partners.insert(partner);
      if (team > 0) CHECK(partner != design.partner(replicate, team - 1));
    }
    CHECK(partners.size() == 7);
  }
  const ContestDesign two{5, 2, 3};
  for (const std::size_t team : {0U, 1U, 2U}) CHECK(two.partner(0, team) == 1);
  const ContestDesign one{5, 1, 3};
  CHECK_THROWS_AS(static_cast<void>(one.partner(0, 0)), std::invalid_argument);
}

TEST_CASE("contest design: places -> other ones for each replicate and team") {
  const ContestDesign design{5, 30, 2};
  std::set<std::uint64_t> places;
  for (std::size_t replicate = 0; replicate < 30; ++replicate) {
    for (const std::size_t team : {0U, 1U}) places.insert(design.places(replicate, team));
  }
  CHECK(places.size() == 60);
}
