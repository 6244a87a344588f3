// SPDX-License-Identifier: MIT
// The contract of a slot: the heading of a robot.
#pragma once

#include <concepts>
#include <trophic/support/cpp20.hpp>

#define TROPHIC_SENTENCE_Heading \
  "double heading_rad(const Pose& root, double forward_rad) const; see trophic/perception/heading/contract.hpp"

namespace trophic {
struct Pose;  // trophic/habitat/pose.hpp
}

namespace trophic::perception {

/// `heading_rad(root, forward_rad)`: returns the heading of a robot on the floor, counter-clockwise from x, given its root
/// frame and the direction of its forward axis in that frame. Left and right are relative to it. A rule that differs from the
/// forward axis only for tilted robots declares `static constexpr bool acts_on_tilt_alone = true;`; runs on a backend without
/// joints then print a remark.
template <class P>
concept Heading = requires(const P policy, const Pose& root, double forward_rad) {
  { policy.heading_rad(root, forward_rad) } -> std::same_as<double>;
};

}  // namespace trophic::perception
