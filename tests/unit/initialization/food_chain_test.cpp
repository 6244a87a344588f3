// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/initialization/community/food_chain.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using initialization::community::FoodChain;

TEST_CASE("food chain: web -> apex eat hunters, hunters eat grazers, no other link") {
  const FoodWeb web = FoodChain{}.web();
  REQUIRE(web.size() == 3);
  CHECK(web.name(FoodChain::grazer) == "grazer");
  CHECK(web.name(FoodChain::hunter) == "hunter");
  CHECK(web.name(FoodChain::apex) == "apex");
  const std::set<std::pair<Species, Species>> links{{FoodChain::hunter, FoodChain::grazer}, {FoodChain::apex, FoodChain::hunter}};
  for (Species one = 0; one < 3; ++one) {
    for (Species other = 0; other < 3; ++other) CHECK(web.eats(one, other) == links.contains({one, other}));
  }
}

TEST_CASE("food chain: counts -> grazers first, then hunters, then apex predators") {
  struct Case {
    std::size_t robots, hunters, apex;
  };
  for (const auto& [robots, hunters, apex] : {Case{30, 9, 7}, Case{5, 0, 0}, Case{5, 2, 3}, Case{300, 100, 1}, Case{4, 0, 4}}) {
    CAPTURE(robots);
    const std::vector<Species> founders = FoodChain{{.hunters = hunters, .apex = apex}}.founders(robots);
    CHECK(founders.size() == robots);
    CHECK(std::ranges::is_sorted(founders));
    CHECK(std::ranges::count(founders, FoodChain::hunter) == static_cast<std::ptrdiff_t>(hunters));
    CHECK(std::ranges::count(founders, FoodChain::apex) == static_cast<std::ptrdiff_t>(apex));
  }
}

TEST_CASE("food chain: more founders than robots -> error with the count and its bound") {
  CHECK_THROWS_WITH_AS(static_cast<void>(FoodChain{{.hunters = 31}}.founders(30)),
                       "rules.community.hunters = 31: must be <= 30, the number of robots", std::invalid_argument);
  CHECK_THROWS_WITH_AS(static_cast<void>(FoodChain{{.hunters = 9, .apex = 22}}.founders(30)),
                       "rules.community.apex = 22: must be <= 21, the number of robots that are not hunters",
                       std::invalid_argument);
}

TEST_CASE("food chain: 600 s with the paper's other rules -> all three species survive") {
  using Chain = with_community<rules::Paper, FoodChain>;
  Ecology<Chain> ecology{{.seed = 1}, backend::Kinematic::Params{}};
  ecology.run_until(600.0);
  for (const std::size_t members : {ecology.view().count(FoodChain::grazer), ecology.view().count(FoodChain::hunter),
                                    ecology.view().count(FoodChain::apex)}) {
    CHECK(members > 0);
  }
}
