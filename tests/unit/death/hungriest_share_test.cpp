// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <trophic/death/starvation/choice/hungriest_share.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using death::starvation::choice::HungriestShare;
using Chosen = std::vector<BodyIndex>;

namespace {

const auto none_exempt = [](BodyIndex) { return false; };

/// Chosen 1 to 4 are predators, the hungriest first; body 0 is a hungrier prey.
const HandPopulation hungry{{{.species = prey, .fed_tick = 0},
                             {.species = predator, .fed_tick = 10},
                             {.species = predator, .fed_tick = 20},
                             {.species = predator, .fed_tick = 30},
                             {.species = predator, .fed_tick = 40}}};

}  // namespace

TEST_CASE("hungriest share: share of the predators -> rounded up, the hungriest first") {
  CHECK(HungriestShare{{.share = 0.0}}.victims(hungry.view(), none_exempt).empty());
  CHECK(HungriestShare{{.share = 0.01}}.victims(hungry.view(), none_exempt) == Chosen{1});
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), none_exempt) == Chosen{1, 2});
  CHECK(HungriestShare{{.share = 0.51}}.victims(hungry.view(), none_exempt) == Chosen{1, 2, 3});
  CHECK(HungriestShare{{.share = 1.0}}.victims(hungry.view(), none_exempt) == Chosen{1, 2, 3, 4});
}

TEST_CASE("hungriest share: exempt predators -> skipped") {
  const auto exempt = [](BodyIndex body) { return body == 1 || body == 3; };
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), exempt) == Chosen{2, 4});
  CHECK(HungriestShare{{.share = 0.5}}.victims(hungry.view(), [](BodyIndex) { return true; }).empty());
}

TEST_CASE("hungriest share: default, up to 14 predators -> one, as hungriest nonexempt") {
  for (const std::size_t predators : {0U, 1U, 13U, 14U}) {
    CAPTURE(predators);
    const HandPopulation robots = with_predators(predators);
    CHECK(HungriestShare{}.victims(robots.view(), none_exempt) ==
          death::starvation::choice::HungriestNonexempt{}.victims(robots.view(), none_exempt));
  }
  CHECK(HungriestShare{}.victims(with_predators(15).view(), none_exempt).size() == 2);
}
