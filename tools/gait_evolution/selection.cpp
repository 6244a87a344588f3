// SPDX-License-Identifier: MIT
// Definitions of selection.hpp.
#include <tools/gait_evolution/selection.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace trophic::gait_evolution::detail {

void check_count(std::string_view policy, std::size_t count, std::size_t individuals) {
  if (count <= individuals) return;
  throw std::invalid_argument{std::string{policy} + ": " + std::to_string(count) +
                              " distinct individuals wanted: must be <= " + std::to_string(individuals)};
}

}  // namespace trophic::gait_evolution::detail

namespace trophic::gait_evolution {

std::vector<std::size_t> RoundRobin::select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
  detail::check_count(name, count, fitness.size());
  std::vector<std::size_t> wins(fitness.size());
  for (std::size_t self = 0; self < fitness.size(); ++self) {
    std::vector<std::size_t> others(fitness.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(self));
    if (params.opponents != 0 && params.opponents < others.size()) {
      rng.shuffle(std::span{others});
      others.resize(params.opponents);
    }
    wins[self] = static_cast<std::size_t>(
        std::ranges::count_if(others, [&](std::size_t other) { return fitness[self] > fitness[other]; }));
  }
  std::vector<std::size_t> order(fitness.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return wins[a] != wins[b] ? wins[a] > wins[b] : fitness[a] > fitness[b]; });
  order.resize(count);
  return order;
}

}  // namespace trophic::gait_evolution

namespace trophic::gait_evolution::detail {

std::size_t tournament(std::span<const double> fitness, std::span<const std::size_t> candidates, std::size_t size, Rng& rng) {
  std::size_t best = rng.index(candidates.size());
  for (std::size_t drawn = 1; drawn < size; ++drawn) {
    const std::size_t other = rng.index(candidates.size());
    if (fitness[candidates[other]] > fitness[candidates[best]]) best = other;
  }
  return best;
}

std::vector<std::size_t> all_of(std::span<const double> fitness) {
  std::vector<std::size_t> all(fitness.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace trophic::gait_evolution::detail

namespace trophic::gait_evolution {

std::vector<std::size_t> Tournament::select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
  detail::check_count(name, count, fitness.size());
  std::vector<std::size_t> candidates = detail::all_of(fitness);
  std::vector<std::size_t> selected;
  while (selected.size() < count) {
    const std::size_t best = detail::tournament(fitness, candidates, params.size, rng);
    selected.push_back(candidates[best]);
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return selected;
}

std::vector<std::size_t> TournamentCouples::select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
  if (fitness.size() < 2) {
    throw std::invalid_argument{"tournament_couples: " + std::to_string(fitness.size()) + " individuals: must be >= 2"};
  }
  if (count % 2 != 0) throw std::invalid_argument{"tournament_couples: " + std::to_string(count) + " parents: must be even"};
  const std::vector<std::size_t> everybody = detail::all_of(fitness);
  std::vector<std::size_t> selected;
  while (selected.size() < count) {
    const std::size_t first = detail::tournament(fitness, everybody, params.size, rng);
    std::size_t second = first;
    while (second == first) second = detail::tournament(fitness, everybody, params.size, rng);
    selected.insert(selected.end(), {first, second});
  }
  return selected;
}

}  // namespace trophic::gait_evolution
