// SPDX-License-Identifier: MIT
// The robot as a tree of modules (core, active hinge, brick) on a grid, and the dimensions of their parts.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::body {

enum class ModuleType { core, hinge, brick };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(ModuleType) {
  return {"core", "hinge", "brick"};
}

/// The attachment faces of a module, in the canonical order of every list of children, links and hinges. Seen from above, x
/// forward: front 0, left 90, back 180, right 270 degrees about z.
enum class Face { front, back, left, right };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Face) {
  return {"front", "back", "left", "right"};
}
inline constexpr std::array<Face, 4> all_faces{Face::front, Face::back, Face::left, Face::right};

/// The faces to which modules can be attached. Hinge and brick are themselves attached by their back; a hinge carries one
/// module.
[[nodiscard]] constexpr bool has_face(ModuleType type, Face face) {
  switch (type) {
    case ModuleType::core:
      return true;
    case ModuleType::hinge:
      return face == Face::front;
    case ModuleType::brick:
      return face != Face::back;
  }
  return false;
}

/// Full box extents and distances of the module parts, m; x points out of the face to which the module is attached.
namespace parts {
inline const Eigen::Vector3d core_extents_m{0.089, 0.089, 0.0603};
inline const Eigen::Vector3d hinge_frame_extents_m{0.018, 0.053, 0.0165891};
inline const Eigen::Vector3d servo_body_extents_m{0.0583, 0.0512, 0.020};
inline const Eigen::Vector3d servo_plate_extents_m{0.002, 0.053, 0.053};
inline const Eigen::Vector3d brick_extents_m{0.06288625, 0.06288625, 0.0603};
inline constexpr double core_face_m = 0.0445;                       ///< core centre to each of its faces
inline constexpr double brick_face_m = 0.06288625 / 2.0;            ///< brick centre to each of its faces
inline constexpr double hinge_frame_m = 0.009;                      ///< attachment face to the frame's centre
inline constexpr double servo_body_m = 0.04525 / 2.0 + 0.0299;      ///< attachment face to the servo body's centre
inline constexpr double joint_from_servo_body_m = 0.0119 - 0.0299;  ///< servo body's centre to the joint, along x
inline constexpr double servo_plate_from_servo_body_m = 0.03015;    ///< servo body's centre to the plate's centre
inline constexpr double hinge_face_from_servo_body_m = 0.03115;     ///< servo body's centre to the hinge's own front face
}  // namespace parts

/// Mass of each part, kg.
struct PartMasses {
  double core = 0.250;
  double hinge_frame = 0.011;
  double servo_body = 0.058;
  double servo_plate = 0.020;
  double brick = 0.030;

  static constexpr auto fields() {
    return std::tuple{field("core", &PartMasses::core, above(0.0)), field("hinge_frame", &PartMasses::hinge_frame, above(0.0)),
                      field("servo_body", &PartMasses::servo_body, above(0.0)),
                      field("servo_plate", &PartMasses::servo_plate, above(0.0)), field("brick", &PartMasses::brick, above(0.0))};
  }
};

/// One module of a tree. Its frame is its parent's, turned towards `face` about z, then by `quarter_turns` about its own x.
struct Module {
  ModuleType type = ModuleType::core;
  std::optional<std::size_t> parent;                          ///< index in the tree; none for the core
  Face face = Face::front;                                    ///< the parent's face to which it is attached
  int quarter_turns = 0;                                      ///< 0 to 3, about the attachment axis
  Eigen::Vector3i cell = Eigen::Vector3i::Zero();             ///< grid cell relative to the core; every module fills one
  Eigen::Matrix3i orientation = Eigen::Matrix3i::Identity();  ///< module frame to core frame, hinges at angle 0
  std::array<std::optional<std::size_t>, all_faces.size()> children;
};

/// A quarter turn about z or x as an exact matrix.
[[nodiscard]] Eigen::Matrix3i face_rotation(Face face);
[[nodiscard]] Eigen::Matrix3i roll_rotation(int quarter_turns);

/// A core with modules attached to it; every state is a robot that can be built, as far as the grid shows.
class ModuleTree {
 public:
  ModuleTree() : modules_(1) {}

  /// Attaches a module and returns its index. Throws std::invalid_argument, naming the path, for a second core, a face that the
  /// parent lacks or that is taken, and a grid cell that is already occupied; the tree is then unchanged.
  std::size_t attach(std::size_t parent, Face face, ModuleType type, int quarter_turns = 0);

  /// All modules, parents before children; the core is number 0.
  [[nodiscard]] const std::vector<Module>& modules() const { return modules_; }

  [[nodiscard]] std::optional<std::size_t> child(std::size_t module, Face face) const {
    return modules_.at(module).children.at(static_cast<std::size_t>(face));
  }

  /// The faces from the core to the module, e.g. "back.front.left"; "core" for the core.
  [[nodiscard]] std::string path(std::size_t module) const;

  /// Number of attachments between two modules.
  [[nodiscard]] std::size_t distance(std::size_t a, std::size_t b) const;

 private:
  std::vector<Module> modules_;
};

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/module.ipp>
#endif
