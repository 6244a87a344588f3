// SPDX-License-Identifier: MIT
// The bytes of replay.trp: its blocks, and poses as whole numbers. docs/recording.md describes them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <trophic/habitat/pose.hpp>
#include <tuple>

namespace trophic::io::recording {

/// The first bytes of every recording. As in PNG, they are not text and are damaged by a conversion of line ends.
inline constexpr std::string_view magic{"\x89TRP\r\n\x1a\n", 8};
inline constexpr int version = 1;
inline constexpr int version_of_bodies = 2;  ///< for a run whose bodies differ, with BODY and WHO blocks

/// After the magic come blocks: length of the data (4 bytes), kind (4 letters), data, CRC-32 of kind and data. Whole numbers are
/// unsigned, 4 bytes, little-endian.
inline constexpr std::string_view head_kind =
    "HEAD";  ///< JSON: the recorded quantities and their units; in later blocks: the run
inline constexpr std::string_view frames_kind =
    "POSE";  ///< first frame, number of frames, in version 2 number of channels, then zlib
inline constexpr std::string_view body_kind = "BODY";  ///< JSON: a body; bodies are numbered from 0 in the order of these blocks
inline constexpr std::string_view who_kind = "WHO ";   ///< a frame, then for each body set down before it: robot, body
inline constexpr std::string_view end_kind = "DONE";  ///< the number of frames, when the run ended; missing if the run was killed

inline void append_u32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>((value >> shift) & 0xFFU));
}

/// Returns the whole number that begins at a byte.
[[nodiscard]] constexpr std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// The numbers of one robot in one frame, in this order: position x, y, z; yaw; tilt x, y; then the angle of each joint. A block
/// of n frames has for each channel, for each robot, n 16-bit numbers: the first frame's value, then differences, modulo 2^16;
/// each written as 2 d for d >= 0 and as -2 d - 1 for d < 0; first the low bytes of all of them, then the high bytes.
inline constexpr std::size_t pose_channels = 6;

/// Units of the whole numbers. An angle unit is a millimetre at the end of a leg of 0.3 m.
struct Units {
  double position_m = 0.001;
  double yaw_rad = 2.0 * std::numbers::pi / 2048.0;
  double tilt_rad = std::numbers::pi / 1024.0;
  double joint_rad = std::numbers::pi / 1024.0;

  static constexpr auto saved() { return std::tuple{&Units::position_m, &Units::yaw_rad, &Units::tilt_rad, &Units::joint_rad}; }

  /// For an arena that robots cannot leave: 1 mm up to 32 m from its centre.
  [[nodiscard]] static Units for_extent(double extent_m) { return {.position_m = std::max(0.001, extent_m / 32000.0)}; }
};

/// A signed difference as a small number, so that the high bytes are nearly all 0; and back.
[[nodiscard]] constexpr std::uint16_t folded(std::uint16_t difference) {
  const std::uint32_t wide = difference;
  return static_cast<std::uint16_t>((wide << 1U) ^ (wide >> 15U ? 0xFFFFU : 0U));
}
[[nodiscard]] constexpr std::uint16_t unfolded(std::uint16_t number) {
  const std::uint32_t wide = number;
  return static_cast<std::uint16_t>((wide >> 1U) ^ (wide & 1U ? 0xFFFFU : 0U));
}

[[nodiscard]] inline std::int16_t whole(double value, double unit) {
  return static_cast<std::int16_t>(std::clamp(std::round(value / unit), -32768.0, 32767.0));
}

/// The orientation is decomposed into a rotation about the vertical axis after a tilt about a horizontal one: q = yaw * tilt,
/// where tilt is the rotation by hypot(x, y) about (x, y, 0). A yaw that jumps by a whole turn does not change it.
[[nodiscard]] inline std::array<std::int16_t, pose_channels> whole(const Pose& pose, const Units& units) {
  const Eigen::Vector3d& at = pose.position_m;
  const Eigen::Quaterniond q = pose.orientation.normalized();
  const double half_yaw_rad = std::atan2(q.z(), q.w());
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  if (q.x() != 0.0 || q.y() != 0.0) {
    const double c = std::cos(half_yaw_rad);
    const double s = std::sin(half_yaw_rad);
    const Eigen::Vector2d axis{c * q.x() + s * q.y(), c * q.y() - s * q.x()};
    const double sine = axis.norm();
    const double tilt_rad = 2.0 * std::atan2(sine, std::hypot(q.w(), q.z()));
    if (sine > 1e-12) tilt = tilt_rad / sine * axis;
  }
  return {whole(at.x(), units.position_m),          whole(at.y(), units.position_m), whole(at.z(), units.position_m),
          whole(2.0 * half_yaw_rad, units.yaw_rad), whole(tilt.x(), units.tilt_rad), whole(tilt.y(), units.tilt_rad)};
}

[[nodiscard]] inline Pose pose(const std::array<std::int16_t, pose_channels>& values, const Units& units) {
  const double half_yaw_rad = 0.5 * units.yaw_rad * values[3];
  const Eigen::Vector3d axis{units.tilt_rad * values[4], units.tilt_rad * values[5], 0.0};
  const Eigen::Quaterniond yaw{std::cos(half_yaw_rad), 0.0, 0.0, std::sin(half_yaw_rad)};
  const Eigen::Quaterniond tilt{Eigen::AngleAxisd{axis.norm(), axis.stableNormalized()}};
  return {.position_m = {units.position_m * values[0], units.position_m * values[1], units.position_m * values[2]},
          .orientation = (yaw * tilt).normalized()};
}

}  // namespace trophic::io::recording
