// SPDX-License-Identifier: MIT
// Mating zones that move once they were used, and food that all share.
#pragma once

#include <trophic/energy/resource/contract.hpp>
#include <trophic/population/mating_zones.hpp>

namespace trophic::energy::resource {

/// Rule: there are `zones` circles of `radius` on the floor, around centres of cells. A zone that holds all living parents of a
/// newborn moves at once. A new centre is a random cell, drawn again up to 100 times while it is nearer than `apart` to that of
/// another zone; distances here do not cross edges. Food comes at the rate `food`: in a tick of length t each of n living
/// individuals finds food * t / n in its cell. What is not eaten in a tick is lost.   Source: mating zones with event-driven
/// relocation [peterson2026], centres and `apart` as in its authors' code; food is not in that paper.   Reads: positions,
/// parents. Random draws: 1 per attempt.
struct MovingZones {
  static constexpr std::string_view name = "moving_zones";
  static constexpr std::string_view source = "not in the paper; [peterson2026]";

  struct Params {
    std::size_t zones = 15;
    double radius_m = 2.0;
    double apart_m = 4.0;
    std::size_t cells_in_a_row = 25;
    double food_W = 0.0;
    static constexpr auto fields() {
      return std::tuple{
          field("zones", &Params::zones, between(0, 1000), "number of zones").read_at_start(),
          field("radius_m", &Params::radius_m, above(0.0), "radius of a zone"),
          field("apart_m", &Params::apart_m, at_least(0.0), "distance between the centres of zones, if there is room"),
          field("cells_in_a_row", &Params::cells_in_a_row, between(1, 1000), "number of cells along a side of the arena")
              .read_at_start(),
          field("food_W", &Params::food_W, at_least(0.0), "rate at which food comes for all individuals together")};
    }
  };
  Params params;

  /// Throws std::invalid_argument for more zones than cells.
  [[nodiscard]] ResourceField start(const Arena& arena, Rng& rng) const {
    ResourceField field{arena, params.cells_in_a_row};
    if (params.zones > field.cells()) {
      throw std::invalid_argument{"rules.resource.zones = " + std::to_string(params.zones) +
                                  ": must be <= " + std::to_string(field.cells()) + ", the number of cells"};
    }
    for (std::size_t zone = 0; zone < params.zones; ++zone) place_zone(field, rng);
    return field;
  }

  void grow(ResourceField& field, const View& view, Rng&) const {
    for (std::size_t cell = 0; cell < field.cells(); ++cell) field.food_J(cell) = 0.0;
    const auto living = static_cast<double>(std::ranges::count_if(view.robots, &Individual::lives));
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives()) field.food_J(field.cell_at(view.poses[body])) += params.food_W * view.tick_s / living;
    }
  }

  void on_birth(ResourceField& field, std::span<const BodyIndex> parents, const View& view, Rng& rng) const {
    for (const MatingZone& zone : zones_in(field)) {
      if (parents.empty() || !std::ranges::all_of(parents, [&](BodyIndex one) { return is_in(zone, view.poses[one], view); }))
        continue;
      place_zone(field, rng);
      field.set_zone(zone.cell, 0.0);
    }
  }

 private:
  void place_zone(ResourceField& field, Rng& rng) const {
    const auto others = zones_in(field);
    if (others.size() >= field.cells()) return;
    std::size_t cell = 0;
    for (int attempt = 0; attempt < 100 || field.zone_m(cell) > 0.0; ++attempt) {
      cell = rng.index(field.cells());
      const auto is_clear = [&](const MatingZone& other) {
        return distance_m(other.centre, field.centre(cell)) >= params.apart_m;
      };
      if (field.zone_m(cell) == 0.0 && std::ranges::all_of(others, is_clear)) break;
    }
    field.set_zone(cell, params.radius_m);
  }
};
static_assert(Resource<MovingZones>);

}  // namespace trophic::energy::resource
