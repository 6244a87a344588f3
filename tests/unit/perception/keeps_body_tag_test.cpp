// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <trophic/perception/newborn_tag/keeps_body_tag.hpp>

using namespace trophic;

TEST_CASE("keeps body tag: newborn -> the body's tag, founder -> +1 or as set") {
  Rng rng{1, Stream::newborn_tag};
  const std::array tags{-1, 1};
  const perception::newborn_tag::KeepsBodyTag rule;
  CHECK(rule.tag(1, tags, rng) == 1);
  CHECK(rule.tag(-1, tags, rng) == -1);
  CHECK(rule.tag(std::nullopt, tags, rng) == 1);
  const perception::newborn_tag::KeepsBodyTag negative{{.founder_tag = -1}};
  CHECK(negative.tag(1, tags, rng) == 1);
  CHECK(negative.tag(-1, tags, rng) == -1);
  CHECK(negative.tag(std::nullopt, tags, rng) == -1);
}

TEST_CASE("keeps body tag: any newborn -> no draws") {
  Rng rng{1, Stream::newborn_tag};
  Rng untouched = rng;
  CHECK(perception::newborn_tag::KeepsBodyTag{}.tag(std::nullopt, std::array{-1, 1}, rng) == 1);
  CHECK(rng.bits() == untouched.bits());
}
