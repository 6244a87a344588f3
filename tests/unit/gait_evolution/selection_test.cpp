// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <support/temporary_folder.hpp>
#include <tools/gait_evolution/selection.hpp>

namespace gait_evolution = trophic::gait_evolution;
using Indices = std::vector<std::size_t>;
using trophic::test::message_of;

namespace {

trophic::Rng rng(std::uint64_t event = 0) {
  return {5, trophic::Stream::gait_selection, 0, event};
}

}  // namespace

TEST_CASE("round robin: against all -> most wins first, equals by age") {
  auto random = rng();
  const std::vector<double> fitness{3.0, 1.0, 2.0, 5.0, 3.0, -std::numeric_limits<double>::infinity()};
  const gait_evolution::RoundRobin round_robin;
  CHECK(round_robin.select(fitness, 3, random) == Indices{3, 0, 4});
  CHECK(round_robin.select(fitness, 6, random) == Indices{3, 0, 4, 2, 1, 5});
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(round_robin.select(fitness, 7, random)); }) ==
        "round_robin: 7 distinct individuals wanted: must be <= 6");
}

TEST_CASE("round robin against one opponent: the best always wins, the second best in two of three meetings") {
  const gait_evolution::RoundRobin round_robin{{.opponents = 1}};
  const std::vector<double> fitness{1.0, 4.0, 2.0, 3.0};
  int third_before_second = 0;
  constexpr int rounds = 3000;
  for (int i = 0; i < rounds; ++i) {
    auto random = rng(static_cast<std::uint64_t>(i));
    const Indices order = round_robin.select(fitness, 4, random);
    CHECK(order.front() == 1);
    third_before_second += std::ranges::find(order, 2) < std::ranges::find(order, 3) ? 1 : 0;
  }
  // The third passes the second where it wins (1 of 3) and the second loses (1 of 3).
  CHECK(third_before_second / static_cast<double>(rounds) == doctest::Approx(1.0 / 9.0).epsilon(0.15));
}

TEST_CASE("tournaments of 2 select each rank with its probability, and never one individual as both parents") {
  const gait_evolution::TournamentCouples couples;
  const std::vector<double> fitness{1.0, 4.0, 2.0, 3.0};
  auto random = rng();
  constexpr std::size_t count = 40000;
  const Indices selected = couples.select(fitness, 2 * count, random);
  REQUIRE(selected.size() == 2 * count);
  const std::array<double, 4> wins{1.0 / 16.0, 7.0 / 16.0, 3.0 / 16.0, 5.0 / 16.0};
  std::array<std::array<double, 4>, 4> share{};  // of couples, by first and second parent
  for (std::size_t i = 0; i < 2 * count; i += 2) share.at(selected[i]).at(selected[i + 1]) += 1.0 / count;
  for (std::size_t first = 0; first < 4; ++first) {
    CHECK(share[first][first] == 0.0);
    for (std::size_t second = 0; second < 4; ++second) {
      if (second == first) continue;
      const double expected = wins[first] * wins[second] / (1.0 - wins[first]);
      CHECK(std::abs(share[first][second] - expected) < 4.0 * std::sqrt(expected / count));
    }
  }
}

TEST_CASE("couples need two individuals and two places each") {
  const gait_evolution::TournamentCouples couples;
  auto random = rng();
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(couples.select(std::vector{1.0}, 2, random)); }) ==
        "tournament_couples: 1 individuals: must be >= 2");
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(couples.select(std::vector{1.0, 2.0}, 3, random));
        }) == "tournament_couples: 3 parents: must be even");
}

TEST_CASE("tournament: any draw -> no individual is selected twice") {
  const gait_evolution::Tournament tournament;
  const std::vector<double> fitness{1.0, 4.0, 2.0, 3.0};
  auto random = rng();
  Indices all = tournament.select(fitness, 4, random);
  std::ranges::sort(all);
  CHECK(all == Indices{0, 1, 2, 3});
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(tournament.select(fitness, 5, random)); }) ==
        "tournament: 5 distinct individuals wanted: must be <= 4");
}
