// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <trophic/perception/newborn_tag/keeps_body_tag.hpp>
#include <trophic/perception/newborn_tag/random_tag.hpp>

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

TEST_CASE("random tag: any body tag -> each tag with equal probability") {
  const perception::newborn_tag::RandomTag rule;
  constexpr int size = 100'000;
  for (const std::optional<int> body_tag : {std::optional<int>{}, std::optional{1}, std::optional{-1}}) {
    Rng rng{7, Stream::newborn_tag, static_cast<std::uint64_t>(body_tag.value_or(0) + 1)};
    int positive = 0;
    for (int i = 0; i < size; ++i) {
      const int tag = rule.tag(body_tag, std::array{-1, 1}, rng);
      REQUIRE((tag == 1 || tag == -1));
      if (tag == 1) ++positive;
    }
    CHECK(positive == doctest::Approx(size / 2).epsilon(4.0 / 316.0));  // 4 standard errors: sqrt(size) = 316
  }
}

TEST_CASE("random tag: one newborn -> one draw") {
  Rng rng{1, Stream::newborn_tag};
  Rng reference = rng;
  const int tag = perception::newborn_tag::RandomTag{}.tag(std::nullopt, std::array{4, 5, 6}, rng);
  CHECK(tag == 4 + static_cast<int>(3.0 * reference.uniform()));
  CHECK(rng.bits() == reference.bits());
}
