// SPDX-License-Identifier: MIT
// The contracts of control rules: the brain decides where to go, steering turns the gait.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <trophic/perception/concept.hpp>
#include <vector>

namespace trophic::control {

/// What a brain decides at a tick.
struct Decision {
  double target_angle_rad = 0.0;  ///< where it wants to go: positive to the right
  int tag = 1;                    ///< which tag it wants to show: -1 or +1
};

/// `genome_size()`: number of weights; `tags()`: every tag that it may choose; `decide(inputs, weights)`: pure function of both.
template <class P>
concept Brain = requires(const P policy, const perception::BrainInputs& inputs, std::span<const double> weights) {
  { policy.genome_size() } -> std::same_as<std::size_t>;
  { policy.tags() } -> std::same_as<std::vector<int>>;
  { policy.decide(inputs, weights) } -> std::same_as<Decision>;
};

/// `in_turn()`: whether robots decide one after the other, by body, each seeing the tags that earlier ones have taken at this
/// tick; otherwise all perceive the same moment.
template <class P>
concept DecisionOrder = requires(const P policy) {
  { policy.in_turn() } -> std::same_as<bool>;
};

/// Which side of a robot's axis of symmetry a hinge is on.
enum class Side { left, right, middle };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Side) {
  return {"left", "right", "middle"};
}

/// `steer(target_angle_rad, sides, targets_rad)`: changes the joint targets of one robot in place; one side and one target per
/// hinge.
template <class P>
concept Steering = requires(const P policy, double target_angle_rad, std::span<const Side> sides, std::span<double> targets_rad) {
  { policy.steer(target_angle_rad, sides, targets_rad) } -> std::same_as<void>;
};

}  // namespace trophic::control
