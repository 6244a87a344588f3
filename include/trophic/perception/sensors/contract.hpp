// SPDX-License-Identifier: MIT
// The contract of a slot: the inputs of the brain.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_SensorList                                                                                              \
  "to be a perception::sensors::List<...>; each sensor needs a name, static constexpr std::size_t size, and std::array<double, " \
  "size> sense(BodyIndex self, const std::optional<Sighting>&, const View&, Rng&) const or, about the whole population, "        \
  "sense(const View&) const; see trophic/perception/sensors/contract.hpp"

namespace trophic::perception {

namespace detail {

template <class P>
concept Sized = requires {
  typename std::integral_constant<std::size_t, P::size>;
};
template <class P>
concept NamedSensor = requires {
  { P::name } -> std::convertible_to<std::string_view>;
};

}  // namespace detail

/// A sensor of `size` numbers about one robot: `sense(self, sighting, view, rng)`, where `sighting` is its adversary if it
/// perceives one. It is called when the robot decides. Each sensor defines its values without an adversary. A sensor with a State
/// may take `const State& own` last; the State is as it was before this tick's on_sighting.
template <class P>
concept OwnSensor = detail::Sized<P> &&(
    requires(const P policy, BodyIndex self, const std::optional<Sighting>& sighting, const View& view, Rng& rng) {
      { policy.sense(self, sighting, view, rng) } -> std::same_as<std::array<double, P::size>>;
    } ||
    requires(const P policy, BodyIndex self, const std::optional<Sighting>& sighting, const View& view, Rng& rng,
             const StateOf<P> own) {
      { policy.sense(self, sighting, view, rng, own) } -> std::same_as<std::array<double, P::size>>;
    });

/// Whether a sensor reads joints, tilt or touch, declared by `static constexpr bool needs_joints = true;`. Then `view.bodies`
/// exists, and backends without joints are refused.
template <class P>
inline constexpr bool needs_joints = false;
template <class P>
requires requires {
  requires P::needs_joints;
}
inline constexpr bool needs_joints<P> = true;

namespace ask {

template <class P>
[[nodiscard]] std::array<double, P::size> sense(const P& policy, [[maybe_unused]] const StateOf<P>& own, BodyIndex self,
                                                const std::optional<Sighting>& sighting, const View& view, Rng& rng) {
  if constexpr (requires { policy.sense(self, sighting, view, rng, own); }) {
    return policy.sense(self, sighting, view, rng, own);
  } else {
    return policy.sense(self, sighting, view, rng);
  }
}

}  // namespace ask

/// A sensor of `size` numbers that are the same for all robots: `sense(view)`. It is called once per tick, before the first robot
/// decides.
template <class P>
concept CommonSensor = detail::Sized<P> && requires(const P policy, const View& view) {
  { policy.sense(view) } -> std::same_as<std::array<double, P::size>>;
};

/// One sensor of a robot. Optional: the bounds of its values, `static constexpr double least = 0.0, most = 1.0;`, for programs
/// that decide from outside. The brain's inputs are the numbers of all sensors, in the order of the list.
template <class P>
concept Sensor = detail::NamedSensor<P> &&(OwnSensor<P> || CommonSensor<P>);

/// The slot holds a `sensors::List<...>`; `size` is the number of all its values.
template <class P>
concept SensorList = detail::Sized<P> && P::is_sensor_list;

}  // namespace trophic::perception
