// SPDX-License-Identifier: MIT
// Ears: the loudest signal from each direction.
#pragma once

#include <trophic/control/acts/list.hpp>
#include <trophic/control/acts/signal.hpp>
#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: one value for each of `sectors` of equal angle, clockwise from straight behind: the loudest signal * (1 - distance /
/// range) of the other robots there on this channel, as of their last decision. Walls do not attenuate signals. The range is a
/// free parameter.   Reads: positions, the act Signal.   Random draws: 0.
template <std::size_t channel, std::size_t sectors = 4>
struct Hearing {
  static constexpr std::string_view name = "hearing";
  static constexpr std::string_view source = "not in the paper";
  static constexpr std::size_t size = sectors;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  using ReadsActs = control::acts::List<control::acts::Signal<channel>>;

  struct Params {
    double range_m = 8.0;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, above(0.0), "distance beyond which a signal is not heard")};
    }
  };
  Params params;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng&) const {
    std::array<double, size> values{};
    const GroundPose& from = view.poses[self];
    view.for_each_near(from, params.range_m, [&](BodyIndex other) {
      if (other == self || !view.robots[other].lives()) return;
      const double loudness =
          view.act<control::acts::Signal<channel>>(other) * (1.0 - view.distance_m(self, other) / params.range_m);
      if (loudness <= 0.0) return;
      const auto [x_m, y_m] = view.space.way_m(from, view.poses[other]);
      const double bearing_rad = -wrap_angle(std::atan2(y_m, x_m) - from.heading_rad);
      const double turn = (bearing_rad + std::numbers::pi) / (2.0 * std::numbers::pi);
      double& loudest = values[std::min(sectors - 1, static_cast<std::size_t>(turn * static_cast<double>(sectors)))];
      loudest = std::max(loudest, loudness);
    });
    return values;
  }
};
static_assert(OwnSensor<Hearing<0>>);

}  // namespace trophic::perception::sensors
