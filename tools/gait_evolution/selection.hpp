// SPDX-License-Identifier: MIT
// Selection of parents and of survivors.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>
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

void check_count(std::string_view policy, std::size_t count, std::size_t individuals);

}  // namespace detail

/// Round-robin tournament (Sec. "Targeted Steering"; as in evolutionary programming [eiben2015]).
/// Rule: every individual meets `opponents` others drawn without repetition, or with 0 (the literal
/// round robin; the paper gives no number) each other one; it wins a meeting where its fitness is higher. Those with the most
/// wins are selected, each once, in this order; equal wins are ordered by fitness, then by age, older first.
/// Random draws: none if all are met, else size - 2 shuffling draws an individual.
struct RoundRobin {
  static constexpr std::string_view name = "round_robin";

  struct Params {
    std::size_t opponents = 0;
    static constexpr auto fields() {
      return std::tuple{field("opponents", &Params::opponents, at_least(0), "number of opponents of each individual; 0: all")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const;
};
static_assert(Selection<RoundRobin>);

namespace detail {

/// The fittest of `size` candidates drawn with repetition, the first drawn among equals: its place in `candidates`. size draws.
[[nodiscard]] std::size_t tournament(std::span<const double> fitness, std::span<const std::size_t> candidates, std::size_t size,
                                     Rng& rng);

[[nodiscard]] std::vector<std::size_t> all_of(std::span<const double> fitness);

}  // namespace detail

/// Tournament. Rule: the fittest of `size` individuals drawn with repetition is selected, the first drawn among equals; again
/// until there are enough. A selected individual is out of the next tournaments.   Random draws: size a tournament.
struct Tournament {
  static constexpr std::string_view name = "tournament";

  struct Params {
    std::size_t size = 2;
    static constexpr auto fields() {
      return std::tuple{field("size", &Params::size, at_least(1), "individuals in a tournament")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const;
};
static_assert(Selection<Tournament>);

/// Couples by tournaments, as in the released code. Rule: both parents of a child are the winners of tournaments among all; the
/// second tournament is held again while its winner is the first parent. An individual may be in several couples.
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

  [[nodiscard]] std::vector<std::size_t> select(std::span<const double> fitness, std::size_t count, Rng& rng) const;
};
static_assert(Couples<TournamentCouples>);

}  // namespace trophic::gait_evolution
