// SPDX-License-Identifier: MIT
// The heading of a robot that walks backwards while it lies on its back.
#pragma once

#include <numbers>
#include <trophic/habitat/pose.hpp>
#include <trophic/perception/heading/contract.hpp>
#include <trophic/support/joined_text.hpp>
#include <trophic/support/units.hpp>

namespace trophic::perception::heading {

/// Rule: like `Rule`, but reversed while the root's z axis points down. On its back a spider walks against its forward axis, and
/// a hinge of its left side lies on the right. With this rule its front is where it walks, and it turns to the side that its
/// brain chooses. The paper is silent on tilted bodies.   Reads: root pose.   Random draws: 0.
template <Heading Rule>
struct ReversedOnBack {
  static constexpr std::string_view name = prefixed_name<"reversed_on_back", Rule>;
  static constexpr std::string_view source = "not in the paper";
  static constexpr bool acts_on_tilt_alone = requires { requires Rule::acts_on_tilt_alone; };
  [[nodiscard]] double heading_rad(const Pose& root, double forward_rad) const {
    const bool on_back = (root.orientation * Eigen::Vector3d::UnitZ()).z() < 0.0;
    return wrap_angle(Rule{}.heading_rad(root, forward_rad) + (on_back ? std::numbers::pi : 0.0));
  }
};

}  // namespace trophic::perception::heading
