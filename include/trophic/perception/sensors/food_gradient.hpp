// SPDX-License-Identifier: MIT
// Smell: the direction of more food.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: two values, (F front - F behind) / sum and (F right - F left) / sum, where F is the food, of all kinds, in the
/// cells at distance `reach` in front, behind, to the right and to the left; 0 if there is no food. The reach is a free
/// parameter.   Reads: own pose, resource.   Random draws: 0.
struct FoodGradient {
  static constexpr std::string_view name = "food_gradient";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = 2;
  static constexpr double least = -1.0;
  static constexpr double most = 1.0;

  struct Params {
    double reach_m = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("reach_m", &Params::reach_m, above(0.0), "distance between the compared cells")};
    }
  };
  Params params;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    if (view.foods.empty()) return {};
    const GroundPose& from = view.poses[self];
    const double x_m = params.reach_m * std::cos(from.heading_rad);
    const double y_m = params.reach_m * std::sin(from.heading_rad);
    const auto food_J = [&](double dx_m, double dy_m) {
      const auto inside_m = [&](double place_m) { return view.space.shortest(place_m); };
      double sum_J = 0.0;
      for (const ResourceField& food : view.foods)
        sum_J += food.food_J(food.cell_at(inside_m(from.x_m + dx_m), inside_m(from.y_m + dy_m)));
      return sum_J;
    };
    const double ahead_J = food_J(x_m, y_m);
    const double behind_J = food_J(-x_m, -y_m);
    const double right_J = food_J(y_m, -x_m);
    const double left_J = food_J(-y_m, x_m);
    const double sum_J = ahead_J + behind_J + right_J + left_J;
    if (sum_J <= 0.0) return {};
    return {(ahead_J - behind_J) / sum_J, (right_J - left_J) / sum_J};
  }
};
static_assert(OwnSensor<FoodGradient>);

}  // namespace trophic::perception::sensors
