// SPDX-License-Identifier: MIT
// Foragers written by hand: with rays they eat as much as by an exact computation, with another robot's rays they do not.
#include <doctest/doctest.h>

#include <trophic/backend/torus.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/perception/sensors/dealt.hpp>
#include <trophic/perception/sensors/rays.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
namespace sensors = perception::sensors;

namespace {

constexpr double range_m = 3.0;
constexpr std::size_t rays = 64;
using Eyes = sensors::Rays<rays, sensors::Sees::food>;

/// Whether another robot stands on the straight way to a place.
bool is_hidden(BodyIndex self, std::array<double, 2> way_m, const View& view) {
  const double length_m = std::hypot(way_m[0], way_m[1]);
  for (BodyIndex other = 0; other < view.robots.size(); ++other) {
    const auto [x_m, y_m] = view.space.way_m(view.poses[self], view.poses[other]);
    const double along_m = (x_m * way_m[0] + y_m * way_m[1]) / length_m;
    const double aside_m = std::abs(x_m * way_m[1] - y_m * way_m[0]) / length_m;
    if (other != self && along_m > 0.0 && along_m < length_m && aside_m < view.robot_radius_m) return true;
  }
  return false;
}

/// The bearing of the nearest full patch's centre if the patch is in range and not hidden, by a visit to all of them, and 1; 0
/// and 0 without one.
struct Exact {
  static constexpr std::string_view name = "exact";
  static constexpr std::size_t size = 2;
  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    const GroundPose& from = view.poses[self];
    const double half_m = 0.5 * view.foods.front().cell_m();
    double nearest_m = range_m;
    std::array<double, size> values{};
    for (std::size_t cell = 0; cell < view.foods.front().cells(); ++cell) {
      if (view.foods.front().food_J(cell) < 0.5) continue;
      const auto [x_m, y_m] = view.space.way_m(from, view.foods.front().centre(cell));
      const double near_x_m = std::clamp(0.0, x_m - half_m, x_m + half_m);
      const double near_y_m = std::clamp(0.0, y_m - half_m, y_m + half_m);
      const double d_m = std::hypot(near_x_m, near_y_m);
      if (d_m >= nearest_m || is_hidden(self, {x_m, y_m}, view)) continue;
      nearest_m = d_m;
      values = {d_m == 0.0 ? 0.0 : -wrap_angle(std::atan2(y_m, x_m) - from.heading_rad) / std::numbers::pi, 1.0};
    }
    return values;
  }
};

/// Turns to the nearest food, by its bearing or by the ray on which it is nearest; straight ahead without any.
struct Forager {
  static constexpr std::string_view name = "forager";
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 0; }
  [[nodiscard]] std::vector<int> tags() const { return {1}; }
  [[nodiscard]] control::Decision decide(std::span<const double> inputs, std::span<const double>) const {
    if (inputs.size() == Exact::size) return {.target_angle_rad = inputs[0] * std::numbers::pi, .tag = 1};
    // of several rays that end in the same distance, the one nearest to straight ahead
    std::size_t best = rays / 2;
    for (std::size_t i = 0; i < rays; ++i) {
      const auto off = [](std::size_t ray) { return std::abs(static_cast<double>(ray) - (rays - 1) / 2.0); };
      if (inputs[i] > inputs[best] || (inputs[i] == inputs[best] && off(i) < off(best))) best = i;
    }
    if (inputs[best] <= 0.0) return {.target_angle_rad = 0.0, .tag = 1};
    return {.target_angle_rad = 2.0 * std::numbers::pi * ((static_cast<double>(best) + 0.5) / rays - 0.5), .tag = 1};
  }
};

struct Eaten {
  void on_tick(const View& view) { eaten_J += view.resource.front().taken_J; }
  double eaten_J = 0.0;
};

/// What four grazers that turn at once eat in 300 s on a torus, over twenty seeds.
template <class Sensed>
double eaten_J() {
  using Sensing = with_sensors<rules::Paper, sensors::List<Sensed>>;
  using Hunterless =
      with_capture<with_minimum_predators<Sensing, death::minimum_predators::NoMinimum>, death::capture::NoCapture>;
  using Lasting = with_starvation<Hunterless, death::starvation::NoStarvation>;
  using Fed = with_resource<with_metabolism<with_brain<Lasting, Forager>, energy::metabolism::GrazingAndHunting>,
                            energy::resource::DelayedPatches>;
  double sum_J = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Experiment<Fed> experiment{.seed = seed};
    experiment.ecology.robots = 5;
    experiment.rules.community.predators = 1;
    experiment.rules.metabolism = {.capacity_J = 1e9, .resting_W = 0.0, .walking_J_per_m = 0.0, .bite_W = 2.0};
    experiment.rules.resource = {.patches_in_a_row = 40, .patch_J = 4.0, .delay_ticks = 20000, .grown = 0.05};
    Ecology<Fed> ecology{experiment, backend::Torus::Params{.speed_m_s = 0.1, .turn_1_s = 0.5, .timestep_s = 2.0}};
    Eaten eaten;
    ecology.run_until(300.0, eaten);
    sum_J += eaten.eaten_J;
  }
  return sum_J;
}

}  // namespace

TEST_CASE("foragers: rays -> as much food as by an exact computation, within 5 %, by another robot's rays -> much less") {
  const double exact_J = eaten_J<Exact>();
  const double with_rays_J = eaten_J<Eyes>();
  const double blinded_J = eaten_J<sensors::Dealt<Eyes>>();
  CAPTURE(exact_J);
  CAPTURE(blinded_J);
  CHECK(exact_J > 1000.0);
  CHECK(with_rays_J == doctest::Approx(exact_J).epsilon(0.05));
  CHECK(blinded_J < 0.7 * exact_J);
}
