// SPDX-License-Identifier: MIT
// A null of senses: each robot senses what another one does.
#pragma once

#include <trophic/perception/sensors/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::perception::sensors {

/// Rule: the values of `Sensed` at a random living robot of self's species, drawn at each tick: inputs as in the table with
/// Sensed, that say nothing about self. Robots that do as well with it do not use that sensor. Sensed reads no sighting and has
/// no State. Reads: what Sensed reads.   Random draws: 1, and those of Sensed.
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
