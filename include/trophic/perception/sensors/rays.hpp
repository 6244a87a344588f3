// SPDX-License-Identifier: MIT
// Eyes: the first thing on each of several rays around a robot.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// The kinds of things on a ray: those that self eats, those that eat it, its own species, walls, and food of the resource.
enum class Sees { victims, hunters, kin, walls, food };

/// Rule: `count` rays from left to right, spread over `field` about the heading. A ray ends at the first body (the circle of its
/// robot) or wall within `range`; its value for each of the `kinds` is 1 - distance / range if the ray ends at that kind, else 0.
/// For food, the distance is that of the first cell with at least `food` of one kind before the ray's end. Bodies and walls hide
/// what is behind them; several things at the same distance are all visible. Tags do not matter. All parameters are free. Reads:
/// positions, species, arena, resource.   Random draws: 0.
template <std::size_t count, Sees... kinds>
struct Rays {
  static_assert(count > 0 && sizeof...(kinds) > 0,
                "sensors::Rays needs a number of rays and what they show: Rays<16, Sees::walls>");
  static constexpr std::string_view name = "rays";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = count * sizeof...(kinds);
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;

  struct Params {
    double range_m = 3.0;
    double field_rad = 2.0 * std::numbers::pi;
    double food_J = 0.5;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, above(0.0), "length of a ray, from the robot's centre"),
                        field("field_rad", &Params::field_rad, between(0.0, 6.283185307179587), "angle that the rays span"),
                        field("food_J", &Params::food_J, above(0.0), "energy above which a cell of the resource counts as food")};
    }
  };
  Params params;

  /// Ray by ray, its kinds in their order.
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    const std::array<Ray, count> rays = cast(self, view);
    std::array<double, size> values{};
    std::size_t place = 0;
    for (const Ray& ray : rays) {
      ((values[place++] = kinds == Sees::food ? food_on(ray, view.poses[self], view) : closeness(ray, kinds)), ...);
    }
    return values;
  }

 private:
  static constexpr bool sees_food = ((kinds == Sees::food) || ...);
  struct Ray {
    double cos = 0.0;  ///< direction of the ray in the world
    double sin = 0.0;
    double end_m = 0.0;
    std::uint32_t shows = 0;  ///< bits of Sees
  };
  [[nodiscard]] static std::uint32_t bit(Sees kind) { return std::uint32_t{1} << static_cast<unsigned>(kind); }

  [[nodiscard]] double closeness(const Ray& ray, Sees kind) const {
    return (ray.shows & bit(kind)) != 0 ? 1.0 - ray.end_m / params.range_m : 0.0;
  }

  [[nodiscard]] std::array<Ray, count> cast(BodyIndex self, const View& view) const {
    const GroundPose& from = view.poses[self];
    const double step_rad = params.field_rad / static_cast<double>(count);
    const double first_rad = from.heading_rad + 0.5 * (params.field_rad - step_rad);
    const double cos = std::cos(step_rad);
    const double sin = std::sin(step_rad);
    std::array<Ray, count> rays;
    rays[0] = {.cos = std::cos(first_rad), .sin = std::sin(first_rad)};
    for (std::size_t i = 1; i < count; ++i) {
      rays[i].cos = rays[i - 1].cos * cos + rays[i - 1].sin * sin;
      rays[i].sin = rays[i - 1].sin * cos - rays[i - 1].cos * sin;
    }
    const bool has_walls = view.space.has_edges() && std::max(std::abs(from.x_m), std::abs(from.y_m)) + params.range_m >
                                                         view.arena.half_side_m;  // in range
    for (Ray& ray : rays) {
      ray.end_m = params.range_m;
      if (has_walls || !view.arena.obstacles.empty()) hit_walls(ray, from, view);
    }
    const double radius_m = view.robot_radius_m;
    const Species own = view.robots[self].species;
    view.for_each_near(from, params.range_m + radius_m, [&](BodyIndex other) {
      const Individual& there = view.robots[other];
      if (other == self || !there.lives()) return;
      const auto [x_m, y_m] = view.space.way_m(from, view.poses[other]);
      const double distance2 = x_m * x_m + y_m * y_m;
      if (distance2 > (params.range_m + radius_m) * (params.range_m + radius_m)) return;
      const std::uint32_t shows = (view.web.eats(own, there.species) ? bit(Sees::victims) : 0) |
                                  (view.web.eats(there.species, own) ? bit(Sees::hunters) : 0) |
                                  (own == there.species ? bit(Sees::kin) : 0);
      for (Ray& ray : rays) {
        const double ahead_m = x_m * ray.cos + y_m * ray.sin;
        const double chord2 = radius_m * radius_m - distance2 + ahead_m * ahead_m;
        if (chord2 < 0.0 || (ahead_m < 0.0 && distance2 > radius_m * radius_m)) continue;
        const double hit_m = std::max(0.0, ahead_m - std::sqrt(chord2));
        if (hit_m > ray.end_m) continue;
        ray.shows = shows | (hit_m == ray.end_m ? ray.shows : 0);
        ray.end_m = hit_m;
      }
    });
    return rays;
  }

  /// Ends a ray at the walls around the arena and at its obstacles.
  void hit_walls(Ray& ray, const GroundPose& from, const View& view) const {
    const auto end = [&](double hit_m) {
      if (hit_m < ray.end_m) ray.end_m = hit_m, ray.shows = bit(Sees::walls);
    };
    if (view.space.has_edges()) {
      const double half_m = view.arena.half_side_m;
      if (ray.cos != 0.0) end(std::max(0.0, (std::copysign(half_m, ray.cos) - from.x_m) / ray.cos));
      if (ray.sin != 0.0) end(std::max(0.0, (std::copysign(half_m, ray.sin) - from.y_m) / ray.sin));
    }
    for (const Obstacle& obstacle : view.arena.obstacles) {
      const auto hit_m = ray_m(obstacle, from, ray.cos, ray.sin);
      if (hit_m) end(*hit_m);
    }
  }

  /// The nearest food of any kind.
  [[nodiscard]] double food_on(const Ray& ray, const GroundPose& from, const View& view) const {
    double nearest = 0.0;
    for (const ResourceField& food : view.foods)
      if (sees_food) nearest = std::max(nearest, food_on(ray, from, view, food));
    return nearest;
  }

  /// Visits the cells that a ray crosses up to its end.
  [[nodiscard]] double food_on(const Ray& ray, const GroundPose& from, const View& view, const ResourceField& food) const {
    const double cell_m = food.cell_m();
    const auto next_m = [&](double at_m, double start_m, double along) {  // where it crosses the next line of the grid
      const double place = (start_m + at_m * along + view.arena.half_side_m) / cell_m;
      const double line = along > 0.0 ? std::floor(place) + 1.0 : std::ceil(place) - 1.0;
      return along == 0.0 ? params.range_m : at_m + (line - place) * cell_m / along;
    };
    for (double at_m = 0.0; at_m < ray.end_m;) {
      const double crossing_m = std::min(next_m(at_m, from.x_m, ray.cos), next_m(at_m, from.y_m, ray.sin));
      const double leaves_m = std::max(crossing_m, at_m + 1e-9 * cell_m);
      const double middle_m = 0.5 * (at_m + leaves_m);
      const std::size_t cell =
          food.cell_at(view.space.shortest(from.x_m + middle_m * ray.cos), view.space.shortest(from.y_m + middle_m * ray.sin));
      if (food.food_J(cell) >= params.food_J) return 1.0 - at_m / params.range_m;
      at_m = leaves_m;
    }
    return 0.0;
  }
};
static_assert(OwnSensor<Rays<16, Sees::victims, Sees::hunters, Sees::walls>>);

}  // namespace trophic::perception::sensors
