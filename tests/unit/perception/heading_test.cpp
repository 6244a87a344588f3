// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <trophic/habitat/pose.hpp>
#include <trophic/perception/heading/forward_axis_heading.hpp>
#include <trophic/perception/heading/reversed_on_back.hpp>
#include <trophic/perception/heading/root_yaw_heading.hpp>
#include <trophic/support/rng.hpp>

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

namespace {

/// The released code's formula. It reads the quaternion (w, x, y, z) as (x, y, z, w), measures angles from -x clockwise and
/// subtracts pi/4; an adversary at bearing beta (from x, counter-clockwise) is on the right iff the second angle is positive.
double angle_to(const Eigen::Quaterniond& q, double beta_rad) {
  const double x = q.w();
  const double y = q.x();
  const double z = q.y();
  const double w = q.z();
  const double body_rad = wrap_angle(std::atan2(2.0 * (y * z + w * x), w * w - x * x - y * y + z * z) - std::numbers::pi / 4.0);
  const double standard_rad = std::atan2(std::sin(beta_rad), -std::cos(beta_rad));
  return wrap_angle(standard_rad - body_rad);
}

}  // namespace

TEST_CASE("root yaw heading: any tilt -> same side as in the released code's formula") {
  const perception::heading::RootYawHeading rule;
  Rng rng{1, Stream::user};
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0)}.normalized();
    const double beta_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    const double heading_rad = rule.heading_rad({.position_m = {}, .orientation = q}, std::numbers::pi / 4.0);
    const double bearing_rad = -wrap_angle(beta_rad - heading_rad);  // positive to the right
    CHECK(wrap_angle(bearing_rad - angle_to(q, beta_rad)) == doctest::Approx(0.0).epsilon(1e-9));
  }
}

TEST_CASE("root yaw heading: spider on its back -> 90 degrees off its forward axis") {
  const perception::heading::RootYawHeading rule;
  const Pose back{.position_m = {},
                  .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{std::numbers::pi, Eigen::Vector3d::UnitX()}}};
  CHECK(rule.heading_rad(back, std::numbers::pi / 4.0) == doctest::Approx(std::numbers::pi / 4.0));
}

TEST_CASE("reversed on back: upright -> the rule's heading, turned over about any axis -> the opposite of it") {
  const perception::heading::ForwardAxisHeading rule;
  const perception::heading::ReversedOnBack<perception::heading::ForwardAxisHeading> reversed;
  CHECK(reversed.name == "reversed_on_back_forward_axis_heading");
  for (const double tilt_rad : {0.0, 1.5, 1.6, std::numbers::pi}) {
    const Pose root{.position_m = {},
                    .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{tilt_rad, Eigen::Vector3d{1.0, 0.5, 0.0}.normalized()}}};
    const double off_rad = wrap_angle(reversed.heading_rad(root, 0.3) - rule.heading_rad(root, 0.3));
    CHECK(std::abs(off_rad) == doctest::Approx(tilt_rad > 1.58 ? std::numbers::pi : 0.0));
  }
}
