// SPDX-License-Identifier: MIT
// Random positions and headings, nobody on top of another.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/initialization/placement/contract.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::initialization::placement {

/// Rule: positions uniform over the flat floor, one bounding radius from the walls, drawn again while closer than two
/// bounding radii to a robot already placed; headings uniform. The paper says "random positions" (Sec. "Initialization")
/// and is silent about headings and overlap.   Reads: arena, radius.   Random draws: 3 per attempt.
struct Scattered {
  static constexpr std::string_view name = "scattered";
  static constexpr std::string_view source = "paper, Sec. \"Initialization\"; silent on headings and overlap";
  static constexpr int max_attempts_per_robot = 1000;

  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double radius_m, Rng& rng) const {
    const double reach_m = arena.half_side_m - radius_m;
    if (reach_m < 0.0) {
      throw std::invalid_argument{"robot bounding radius = " + number_text(radius_m) +
                                  " m: must be <= " + number_text(arena.half_side_m) + ", the arena's half side"};
    }
    std::vector<GroundPose> placed;
    Squares squares{reach_m, radius_m, robots};
    while (placed.size() < robots) {
      if (!place_one(placed, squares, reach_m, radius_m, rng)) {
        throw std::invalid_argument{"ecology.robots = " + std::to_string(robots) + ": must be <= about " +
                                    std::to_string(placed.size()) + " to stand apart in a square of half side " +
                                    number_text(arena.half_side_m) + " m"};
      }
    }
    return placed;
  }

 private:
  /// Who stands in each square of a grid: whoever is closer than two radii to a pose is in its square or in one beside it.
  class Squares {
   public:
    Squares(double reach_m, double radius_m, std::size_t robots)
        : reach_m_{reach_m},
          // Room for rounding, and no more squares than robots.
          square_m_{std::max({2.001 * radius_m, 2.0 * reach_m / std::ceil(std::sqrt(static_cast<double>(robots))), 1e-6})},
          side_{place_of(reach_m) + 1},
          standing_(side_ * side_) {}

    void add(const GroundPose& pose) { standing_[place_of(pose.y_m) * side_ + place_of(pose.x_m)].push_back(pose); }

    /// Whether `holds(other)` for everybody near a pose.
    template <class Holds>
    [[nodiscard]] bool all_near(const GroundPose& pose, const Holds& holds) const {
      const std::size_t column = place_of(pose.x_m);
      const std::size_t row = place_of(pose.y_m);
      for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, side_ - 1); ++y) {
        for (std::size_t x = column - std::min<std::size_t>(column, 1); x <= std::min(column + 1, side_ - 1); ++x) {
          if (!std::ranges::all_of(standing_[y * side_ + x], holds)) return false;
        }
      }
      return true;
    }

   private:
    [[nodiscard]] std::size_t place_of(double offset_m) const {
      return static_cast<std::size_t>((offset_m + reach_m_) / square_m_);
    }

    double reach_m_;
    double square_m_;
    std::size_t side_;
    std::vector<std::vector<GroundPose>> standing_;
  };

  static bool place_one(std::vector<GroundPose>& placed, Squares& squares, double reach_m, double radius_m, Rng& rng) {
    for (int attempt = 0; attempt < max_attempts_per_robot; ++attempt) {
      GroundPose pose;
      pose.x_m = rng.uniform(-reach_m, reach_m);
      pose.y_m = rng.uniform(-reach_m, reach_m);
      pose.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
      if (squares.all_near(pose, [&](const GroundPose& other) { return distance_m(other, pose) >= 2.0 * radius_m; })) {
        placed.push_back(pose);
        squares.add(pose);
        return true;
      }
    }
    return false;
  }
};
static_assert(Placement<Scattered>);

}  // namespace trophic::initialization::placement
