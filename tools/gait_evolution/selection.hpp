// SPDX-License-Identifier: MIT
// Who becomes a parent, and who survives.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>
#include <tuple>
#include <vector>

namespace trophic::gait_evolution {

/// `select(fitness, count, rng)`: the indices of `count` selected individuals; `fitness` has one number each, older individuals
/// first, -infinity for one whose trial diverged. Throws std::invalid_argument where it cannot select so many.
template <class P>
concept Selection = requires(const P policy, std::span<const double> fitness, std::size_t count, Rng& rng) {
  { policy.select(fitness, count, rng) } -> std::same_as<std::vector<std::size_t>>;
};

/// A selection that pairs: individuals 2i and 2i + 1 of the result are a couple. Those of any other selection are paired at
/// random.
template <class P>
concept Couples = Selection<P> && P::couples;

namespace detail {

inline void check_count(std::string_view policy, std::size_t count, std::size_t individuals) {
  if (count <= individuals) return;
  throw std::invalid_argument{std::string{policy} + ": " + std::to_string(count) +
                              " distinct individuals wanted: must be <= " + std::to_string(individuals)};
}

}  // namespace detail

/// Round-robin tournament (Sec. "Targeted Steering"; as in evolutionary programming [eiben2015]).
/// Rule: every individual meets `opponents` others drawn without repetition, or with 0 (the literal
/// round robin; the paper gives no number) each other one; it wins a meeting where its fitness is higher. Those with the most
/// wins are selected, each once, in this order; equal wins are ordered by fitness, then by age, older first.
/// Random draws: none where everybody is met, else size - 2 shuffling draws an individual.
struct RoundRobin {
  static constexpr std::string_view name = "round_robin";

  struct Params {
    std::size_t opponents = 0;
    static constexpr auto fields() {
      return std::tuple{field("opponents", &Params::opponents, at_least(0), "whom each individual meets; 0: everybody")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
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
};
static_assert(Selection<RoundRobin>);

namespace detail {

/// The fittest of `size` candidates drawn with repetition, the first drawn among equals: its place in `candidates`. size draws.
[[nodiscard]] inline std::size_t tournament(std::span<const double> fitness, std::span<const std::size_t> candidates,
                                            std::size_t size, Rng& rng) {
  std::size_t best = rng.index(candidates.size());
  for (std::size_t drawn = 1; drawn < size; ++drawn) {
    const std::size_t other = rng.index(candidates.size());
    if (fitness[candidates[other]] > fitness[candidates[best]]) best = other;
  }
  return best;
}

[[nodiscard]] inline std::vector<std::size_t> all_of(std::span<const double> fitness) {
  std::vector<std::size_t> all(fitness.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace detail

/// Tournament. Rule: the fittest of `size` individuals drawn with repetition is selected, the first drawn among equals; again
/// until there are enough. Whoever was selected is out of the next tournaments.   Random draws: size a tournament.
struct Tournament {
  static constexpr std::string_view name = "tournament";

  struct Params {
    std::size_t size = 2;
    static constexpr auto fields() {
      return std::tuple{field("size", &Params::size, at_least(1), "individuals in a tournament")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
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
};
static_assert(Selection<Tournament>);

/// Couples by tournaments, as in the released code. Rule: both parents of a child are the winners of tournaments among all; the
/// second tournament is held again while its winner is the first parent. Nobody is barred from several couples.
/// Random draws: size a tournament; at least two tournaments a couple.
struct TournamentCouples {
  static constexpr std::string_view name = "tournament_couples";
  static constexpr bool couples = true;

  struct Params {
    std::size_t size = 2;
    static constexpr auto fields() {
      return std::tuple{field("size", &Params::size, between(1, 16), "individuals in a tournament")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
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
};
static_assert(Couples<TournamentCouples>);

}  // namespace trophic::gait_evolution
