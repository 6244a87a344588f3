// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <trophic/io/recording_format.hpp>

using namespace trophic;
namespace recording = trophic::io::recording;

TEST_CASE("recording format: every 16-bit difference -> folded and back") {
  for (std::uint32_t number = 0; number < 65536; ++number) {
    REQUIRE(recording::unfolded(recording::folded(static_cast<std::uint16_t>(number))) == number);
  }
  CHECK(recording::folded(0) == 0);
  CHECK(recording::folded(static_cast<std::uint16_t>(-1)) == 1);
  CHECK(recording::folded(1) == 2);
}

TEST_CASE("recording format: poses in any orientation -> read back within their units") {
  const recording::Units units;
  for (int i = 0; i < 2000; ++i) {
    const double u = 0.001 * i;
    const Eigen::Vector3d axis = Eigen::Vector3d{std::sin(7.0 * u), std::cos(11.0 * u), std::sin(3.0 * u + 1.0)}.normalized();
    const Pose was{.position_m = {9.0 * std::sin(u), -9.0 * std::cos(5.0 * u), 0.1 * u},
                   .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{2.0 * std::numbers::pi * std::sin(13.0 * u), axis}}};
    const Pose is = recording::pose(recording::whole(was, units), units);
    REQUIRE((is.position_m - was.position_m).cwiseAbs().maxCoeff() <= 0.5001 * units.position_m);
    REQUIRE(is.orientation.angularDistance(was.orientation) < 0.005);
  }
}

TEST_CASE("recording format: large arena -> coarser units") {
  const auto units = recording::Units::for_extent(3200.0);
  CHECK(units.position_m == doctest::Approx(0.1));
  CHECK(recording::whole(-3200.0, units.position_m) == -32000);
  CHECK(recording::Units::for_extent(10.0).position_m == 0.001);
}
