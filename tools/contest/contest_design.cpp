// SPDX-License-Identifier: MIT
// Definitions of contest_design.hpp.
#include <tools/contest/contest_design.hpp>

#include <numeric>
#include <trophic/support/rng.hpp>

namespace trophic::contest {

namespace {

/// The purposes of the design's random numbers.
enum class Drawn : std::uint64_t { team, partner, places };

Rng stream(std::uint64_t seed, Drawn what, std::uint64_t first, std::uint64_t second = 0) {
  return Rng{seed, Stream::contest, static_cast<std::uint64_t>(what), first, second};
}

}  // namespace

ContestDesign::ContestDesign(std::uint64_t seed, std::size_t replicates, std::size_t teams)
    : seed_{seed}, replicates_{replicates}, teams_{teams} {}

std::vector<std::size_t> ContestDesign::members(const TeamName& team, bool shadow, std::size_t living, std::size_t size) const {
  const std::uint64_t population = 2 * team.replicate + (shadow ? 1 : 0);
  Rng rng = stream(seed_, Drawn::team, population, (team.epoch * 64 + team.species) * teams_ + team.team);
  std::vector<std::size_t> order(living);
  std::vector<std::size_t> drawn;
  while (drawn.size() < size && living > 0) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    rng.shuffle(std::span{order});
    for (std::size_t i = 0; i < living && drawn.size() < size; ++i) drawn.push_back(order[i]);
  }
  return drawn;
}

std::size_t ContestDesign::partner(std::size_t replicate, std::size_t team) const {
  if (replicates_ < 2) throw std::invalid_argument{"--against others: needs at least two replicates"};
  // Shifts of a random order, another one for each team as long as there are.
  std::vector<std::size_t> order(replicates_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Rng rng = stream(seed_, Drawn::partner, 0);
  rng.shuffle(std::span{order});
  std::size_t place = 0;
  while (order[place] != replicate) ++place;
  return order[(place + 1 + team % (replicates_ - 1)) % replicates_];
}

std::uint64_t ContestDesign::places(std::size_t replicate, std::size_t team) const {
  Rng rng = stream(seed_, Drawn::places, replicate, team);
  return rng.bits() >> 16U;
}

}  // namespace trophic::contest
