// SPDX-License-Identifier: MIT
// The ground of an experiment, for any physics engine.
#pragma once

#include <cstddef>
#include <optional>
#include <trophic/habitat/obstacle.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic {

/// Heights on a regular square grid that spans [-half_extent_m, half_extent_m] in x and y; linear in between.
struct HeightField {
  std::size_t nodes = 0;  ///< nodes along each side, >= 2
  double half_extent_m = 0.0;
  std::vector<double> height_m;  ///< nodes * nodes values, y-major: height_m[iy * nodes + ix], >= 0

  static constexpr auto fields() {
    return std::tuple{field("nodes", &HeightField::nodes), field("half_extent_m", &HeightField::half_extent_m),
                      field("height_m", &HeightField::height_m)};
  }
};

/// A circle on the floor without effect on bodies; rules refer to it by its name.
struct Zone {
  std::string name;
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 1.0;

  [[nodiscard]] bool holds(const GroundPose& pose) const {
    return distance_m(pose, GroundPose{.x_m = x_m, .y_m = y_m}) <= radius_m;
  }
  static constexpr auto fields() {
    return std::tuple{field("name", &Zone::name), field("x_m", &Zone::x_m), field("y_m", &Zone::y_m),
                      field("radius_m", &Zone::radius_m, above_to(0.0, 1e6))};
  }
};

/// A square arena centred at the origin with its floor at z = 0, or rough above it.
struct Arena {
  std::string name;
  double half_side_m = 10.0;                ///< half side of the floor: walls or slopes begin at |x| or |y| = half_side_m
  double extent_m = 20.0;                   ///< largest terrain extent (the paper's "maximum terrain bounds")
  double friction = 1.0;                    ///< sliding friction coefficient of floor, walls and obstacles
  std::optional<HeightField> height_field;  ///< if empty, a plane with four vertical walls
  std::vector<Obstacle> obstacles = {};
  std::vector<Zone> zones = {};

  static constexpr auto fields() {
    return std::tuple{field("name", &Arena::name), field("half_side_m", &Arena::half_side_m), field("extent_m", &Arena::extent_m),
                      field("friction", &Arena::friction), field("height_field", &Arena::height_field)};
  }
};

/// Whether a circle on the floor is clear of all obstacles.
[[nodiscard]] inline bool is_clear(const Arena& arena, const GroundPose& at, double radius_m) {
  return std::ranges::all_of(arena.obstacles, [&](const Obstacle& one) { return distance_m(one, at.x_m, at.y_m) > radius_m; });
}

/// The greatest height of the ground below a circle, m.
[[nodiscard]] inline double highest_below_m(const Arena& arena, const GroundPose& at, double radius_m) {
  if (!arena.height_field) return 0.0;
  const HeightField& field = *arena.height_field;
  const double spacing_m = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
  const auto node = [&](double to_m) {
    return static_cast<std::size_t>(std::clamp(to_m / spacing_m, 0.0, static_cast<double>(field.nodes - 1)));
  };
  const auto first = [&](double at_m) {
    return node(std::floor((at_m - radius_m + field.half_extent_m) / spacing_m) * spacing_m);
  };
  const auto last = [&](double at_m) { return node(std::ceil((at_m + radius_m + field.half_extent_m) / spacing_m) * spacing_m); };
  double highest_m = 0.0;
  for (std::size_t iy = first(at.y_m); iy <= last(at.y_m); ++iy) {
    for (std::size_t ix = first(at.x_m); ix <= last(at.x_m); ++ix)
      highest_m = std::max(highest_m, field.height_m[iy * field.nodes + ix]);
  }
  return highest_m;
}

}  // namespace trophic
