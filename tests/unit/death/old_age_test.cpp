// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/death/senescence/old_age.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("old age: age of exactly max_age or more -> dies") {
  HandPopulation robots{{{.species = prey, .age_from_s = 100.0}}};
  Rng rng{1, Stream::senescence};
  const auto dies = [&](std::int64_t tick, const death::senescence::OldAge& rule) {
    robots.at_tick(tick);
    return rule.dies(robots.individuals[0], robots.view(), rng);
  };
  CHECK_FALSE(dies(349, {}));
  CHECK(dies(350, {}));
  CHECK(dies(351, {}));
  CHECK_FALSE(dies(54, {{.max_age_s = 10.0}}));
  CHECK(dies(55, {{.max_age_s = 10.0}}));
}
