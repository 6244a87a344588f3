// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <trophic/habitat/pose.hpp>
#include <trophic/perception/heading/forward_axis_heading.hpp>

using namespace trophic;

TEST_CASE("forward axis heading: robot upright, on its back or on a slope -> direction of its forward axis") {
  const perception::heading::ForwardAxisHeading rule;
  constexpr double quarter = std::numbers::pi / 2.0;
  const auto heading_rad = [&](const Eigen::Quaterniond& orientation) {
    return rule.heading_rad({.position_m = {}, .orientation = orientation}, quarter / 2.0);
  };
  const auto about = [](double angle_rad, const Eigen::Vector3d& axis) {
    return Eigen::Quaterniond{Eigen::AngleAxisd{angle_rad, axis.normalized()}};
  };
  CHECK(heading_rad(Eigen::Quaterniond::Identity()) == doctest::Approx(quarter / 2.0));
  CHECK(heading_rad(about(0.3, Eigen::Vector3d::UnitZ())) == doctest::Approx(quarter / 2.0 + 0.3));
  // on its back, turned over about x: (c, s, 0) becomes (c, -s, 0)
  CHECK(heading_rad(about(std::numbers::pi, Eigen::Vector3d::UnitX())) == doctest::Approx(-quarter / 2.0));
  // turned over about the forward axis itself: it stays
  CHECK(heading_rad(about(std::numbers::pi, {1.0, 1.0, 0.0})) == doctest::Approx(quarter / 2.0));
}
