// SPDX-License-Identifier: MIT
// Definitions of arena.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/habitat/physics.hpp>
#include <utility>

namespace trophic {

TROPHIC_INLINE double flat_half_side_m(const HeightField& field) {
  const double spacing_m = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
  for (std::size_t ring = 0; 2 * ring + 1 < field.nodes; ++ring) {
    bool flat = true;
    for (std::size_t iy = ring; iy < field.nodes - ring; ++iy) {
      for (std::size_t ix = ring; ix < field.nodes - ring; ++ix) flat = flat && field.height_m[iy * field.nodes + ix] == 0.0;
    }
    if (flat) return field.half_extent_m - static_cast<double>(ring) * spacing_m;
  }
  return 0.0;
}

namespace detail {

inline constexpr double largest_arena_m = 1e6;

/// Half side of the floor, m, which excludes the rings of nodes at the edge that are each higher than all nodes inside.
[[nodiscard]] inline double floor_half_side_m(const HeightField& field) {
  const double spacing_m = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
  const std::size_t rings = (field.nodes + 1) / 2;
  std::vector<double> lowest_m(rings, std::numeric_limits<double>::infinity());
  std::vector<double> highest_m(rings, 0.0);
  for (std::size_t iy = 0; iy < field.nodes; ++iy) {
    for (std::size_t ix = 0; ix < field.nodes; ++ix) {
      const std::size_t ring = std::min({ix, iy, field.nodes - 1 - ix, field.nodes - 1 - iy});
      lowest_m[ring] = std::min(lowest_m[ring], field.height_m[iy * field.nodes + ix]);
      highest_m[ring] = std::max(highest_m[ring], field.height_m[iy * field.nodes + ix]);
    }
  }
  std::size_t floor = 0;
  const auto is_slope = [&](std::size_t ring) {
    return std::ranges::all_of(std::span{highest_m}.subspan(ring + 1),
                               [&](double inside_m) { return inside_m < lowest_m[ring]; });
  };
  while (floor + 1 < rings && is_slope(floor)) ++floor;
  return field.half_extent_m - static_cast<double>(floor) * spacing_m;
}

/// A wall extends to `to_x_m`, `to_y_m`; without them the obstacle is a pillar.
[[nodiscard]] inline Obstacle obstacle_of(const TomlTable& table, double half_extent_m) {
  const Bound inside = between(-half_extent_m, half_extent_m);
  Obstacle one{.x_m = table.number("x_m", inside), .y_m = table.number("y_m", inside)};
  one.to_x_m = table.has("to_x_m") ? table.number("to_x_m", inside) : one.x_m;
  one.to_y_m = table.has("to_y_m") ? table.number("to_y_m", inside) : one.y_m;
  one.radius_m = table.number("radius_m", above_to(0.0, half_extent_m));
  one.height_m = table.number("height_m", above_to(0.0, half_extent_m));
  table.no_other_keys();
  return one;
}

[[nodiscard]] inline Zone zone_of(const TomlTable& table, double half_extent_m) {
  const Bound inside = between(-half_extent_m, half_extent_m);
  Zone zone{.name = table.text("name"), .x_m = table.number("x_m", inside), .y_m = table.number("y_m", inside)};
  zone.radius_m = table.number("radius_m", above_to(0.0, 2.0 * half_extent_m));
  table.no_other_keys();
  return zone;
}

/// Obstacles and zones of an arena whose size is known.
inline void read_things(const TomlTable& file, Arena& arena) {
  const double half_extent_m = arena.extent_m / 2.0;
  if (file.has("obstacle")) {
    for (const TomlTable& table : file.tables("obstacle")) arena.obstacles.push_back(obstacle_of(table, half_extent_m));
  }
  if (file.has("zone")) {
    for (const TomlTable& table : file.tables("zone")) arena.zones.push_back(zone_of(table, half_extent_m));
  }
}

/// Whether a height field rises at every node of its edge.
[[nodiscard]] inline bool has_rim(const HeightField& field) {
  for (std::size_t i = 0; i < field.nodes; ++i) {
    const std::size_t last = field.nodes - 1;
    for (const std::size_t node : {i, last * field.nodes + i, i * field.nodes, i * field.nodes + last}) {
      if (!(field.height_m[node] > 0.0)) return false;
    }
  }
  return true;
}

}  // namespace detail

TROPHIC_INLINE Arena load_arena(std::string_view name_or_path, std::string_view installed, std::size_t robots) {
  const auto file = detail::TomlTable::read(find_model(ModelKind::arena, name_or_path, installed));
  Arena arena;
  arena.name = file.text("name");
  arena.friction = file.has("friction") ? file.number("friction", between(0.0, most_friction)) : 1.0;
  if (!file.has("height_m")) {
    if (file.has("robots_per_m2")) {
      arena.extent_m = std::sqrt(static_cast<double>(robots) / file.number("robots_per_m2", above_to(0.0, 1e6)));
    } else {
      arena.extent_m = file.number("side_m", above_to(0.0, detail::largest_arena_m));
    }
    arena.half_side_m = arena.extent_m / 2.0;
    detail::read_things(file, arena);
    file.no_other_keys();
    return arena;
  }
  HeightField field;
  field.half_extent_m = file.number("half_extent_m", above_to(0.0, detail::largest_arena_m / 2.0));
  const auto rows = file.rows("height_m");
  field.nodes = rows.size();
  if (field.nodes < 2) file.fail("height_m", ": " + std::to_string(field.nodes) + " rows: must be >= 2");
  constexpr std::size_t most_nodes = 1024;  // derived data grow with their third power
  if (field.nodes > most_nodes) {
    file.fail("height_m", ": " + std::to_string(field.nodes) + " rows: must be <= " + std::to_string(most_nodes));
  }
  for (std::size_t iy = 0; iy < rows.size(); ++iy) {
    if (rows[iy].size() != field.nodes) {
      file.fail("height_m", ": row " + std::to_string(iy) + " has " + std::to_string(rows[iy].size()) + " numbers: must have " +
                                std::to_string(field.nodes) + ", one a row");
    }
    for (const double height_m : rows[iy]) {
      if (!std::isfinite(height_m) || height_m < 0.0) file.fail("height_m", " = " + number_text(height_m) + ": must be >= 0");
    }
    field.height_m.insert(field.height_m.end(), rows[iy].begin(), rows[iy].end());
  }
  arena.extent_m = 2.0 * field.half_extent_m;
  arena.half_side_m = file.has("floor_side_m") ? file.number("floor_side_m", above_to(0.0, arena.extent_m)) / 2.0
                                               : detail::floor_half_side_m(field);
  detail::read_things(file, arena);
  file.no_other_keys();
  if (!(arena.half_side_m > 0.0)) file.fail("height_m", ": must have a floor, but the heights rise from the centre to the edge");
  if (!file.has("floor_side_m") && arena.half_side_m == field.half_extent_m)
    file.fail("height_m", ": must be higher at its edge than anywhere inside, or floor_side_m must give the extent of the floor");
  if (!detail::has_rim(field))
    file.fail("height_m", ": is 0 somewhere at its edge: must be > 0 all around, or robots walk off it");
  arena.height_field = std::move(field);
  return arena;
}

}  // namespace trophic
