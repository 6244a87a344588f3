// SPDX-License-Identifier: MIT
// All that a rule may read: a snapshot of the population and of where everybody stands. Read-only, engine-free.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/spatial_grid.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// The world as rules see it at one tick. `robots` and `poses` have one element per body, in the same order. Spans refer to the
/// ecology's own data: within a tick a view shows each birth and death as soon as it has happened.
struct View {
  double time_s = 0.0;    ///< the ecology's clock
  std::int64_t tick = 0;  ///< number of this decision step; 0 at the start
  double tick_s = 2.0;    ///< length of a decision step
  const FoodWeb& web;
  const Arena& arena;
  std::span<const Individual> robots;
  std::span<const GroundPose> poses;
  const SpatialGrid* grid = nullptr;  ///< over the poses; without one, searches look at everybody

  [[nodiscard]] std::size_t count(Species species) const {
    return static_cast<std::size_t>(std::ranges::count(robots, species, &Individual::species));
  }
  /// Number of individuals whose species eats somebody (the paper's p, the number of predators).
  [[nodiscard]] std::size_t count_hunters() const {
    return static_cast<std::size_t>(std::ranges::count_if(robots, [&](const Individual& i) { return web.hunts(i.species); }));
  }
  [[nodiscard]] double distance_m(BodyIndex a, BodyIndex b) const { return trophic::distance_m(poses[a], poses[b]); }
  [[nodiscard]] double age_s(const Individual& individual) const { return time_s - individual.age_from_s; }
  /// Ticks since birth or last catch (Sec. "Predator Death").
  [[nodiscard]] std::int64_t hunger_ticks(const Individual& individual) const { return tick - individual.fed_tick; }

  /// The body closest to `self` among those for which `accepts(individual)` or `accepts(body)` holds, itself excluded; on equal
  /// distance the lower index. None if nobody is accepted.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, Accepts&& accepts) const {
    if constexpr (std::predicate<Accepts&, const Individual&>) {
      return closest_body(self, [&](BodyIndex other) { return accepts(robots[other]); });
    } else {
      return closest_body(self, accepts);
    }
  }

 private:
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest_body(BodyIndex self, Accepts&& accepts) const {
    if (grid != nullptr) return grid->closest(self, poses, accepts);
    std::optional<BodyIndex> best;
    double best_m = std::numeric_limits<double>::infinity();
    for (BodyIndex other = 0; other < robots.size(); ++other) {
      if (other == self || !accepts(other)) continue;
      const double d = distance_m(self, other);
      if (d < best_m) {
        best_m = d;
        best = other;
      }
    }
    return best;
  }
};

}  // namespace trophic
