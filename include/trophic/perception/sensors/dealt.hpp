// SPDX-License-Identifier: MIT
// A null model for a sensor: each robot senses what a random other robot would.
#pragma once

#include <trophic/perception/sensors/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::perception::sensors {

/// Rule: the values of `Sensed` for a random living robot of self's species, redrawn at each tick. Inputs have the same
/// distribution as with Sensed, but carry no information about self. If robots do as well with it, they do not use that sensor.
/// Sensed must not read the sighting or have a State. Reads: what Sensed reads.   Random draws: 1, and those of Sensed.
template <class Sensed>
struct Dealt {
  static_assert(!Stateful<Sensed>, "sensors::Dealt takes a sensor without a State");
  static constexpr std::string_view name = prefixed_name<"dealt", Sensed>;
  static constexpr std::string_view source = "control";
  static constexpr std::size_t size = Sensed::size;
  static constexpr bool needs_joints = perception::needs_joints<Sensed>;
  struct Params {
    ParamsOf<Sensed> sensed;
    static constexpr auto fields() { return std::tuple{field("sensed", &Params::sensed)}; }
  };
  Params params;

  [[nodiscard]] std::array<double, size> sense(BodyIndex self, const std::optional<Sighting>&, const View& view, Rng& rng) const {
    const Species own = view.robots[self].species;
    std::size_t left = rng.index(view.count(own));
    BodyIndex other = 0;
    while (view.robots[other].species != own || left-- > 0) ++other;
    return make_policy<Sensed>(params.sensed).sense(other, std::nullopt, view, rng);
  }
};

}  // namespace trophic::perception::sensors
