// SPDX-License-Identifier: MIT
// A glTF 2.0 file in the making: nodes, boxes, colours and motion, which programs that draw open.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstring>
#include <span>
#include <tools/recording/species_colour.hpp>
#include <tools/trophic/replay/base64.hpp>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::command::replay {

/// Grows by parts, each of which is known by its number from then on. Metres, seconds, quaternions x, y, z, w. The format's y
/// axis points up, so what is added in trophic's axes (z up) hangs below `upright()`.
class GltfFile {
 public:
  GltfFile();

  /// The node in whose frame z points up.
  [[nodiscard]] static std::size_t upright() { return 0; }

  std::size_t add_node(std::size_t parent, std::string name, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                       const Eigen::Vector3d& scale = Eigen::Vector3d::Ones());
  /// A node that shows a mesh.
  std::size_t add_shape(std::size_t parent, std::size_t mesh, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                        const Eigen::Vector3d& scale);
  /// Further data of a node.
  void describe(std::size_t node, Json what) { nodes_[node]["extras"] = std::move(what); }
  void describe(Json what) { extras_ = std::move(what); }

  std::size_t add_material(std::string name, const Colour& colour);

  /// A box from -1 to 1 along each axis.
  std::size_t add_box(std::string name, std::size_t material);

  /// Triangles: three numbers a place, three a normal, three places a triangle.
  std::size_t add_surface(std::string name, std::size_t material, std::span<const float> places, std::span<const float> normals,
                          std::span<const std::uint32_t> corners);

  /// Moments, which several motions may share. Strictly increasing.
  std::size_t add_times(std::span<const float> times_s) { return accessor(times_s, "SCALAR", 1, true, 0); }

  /// Lets a node move, turn or grow: "translation", "rotation" or "scale". `jumps`: a value holds until the next one.
  void move(std::size_t node, const char* path, std::size_t times, std::span<const float> values, bool jumps = false);

  /// One file of text, the numbers in base64.
  [[nodiscard]] std::string gltf() const { return json_text(document("data:application/octet-stream;base64," + base64(bytes_))); }

  /// One file of bytes.
  [[nodiscard]] std::string glb() const;

 private:
  static constexpr int vertices = 34962;  ///< ARRAY_BUFFER
  static constexpr int indices = 34963;   ///< ELEMENT_ARRAY_BUFFER
  static constexpr int floats = 5126;     ///< FLOAT
  static constexpr int whole = 5125;      ///< UNSIGNED_INT

  template <class Number>
  std::size_t view(std::span<const Number> values, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size_bytes()}};
    if (target != 0) view["target"] = target;
    views_.push_back(std::move(view));
    const std::size_t at = bytes_.size();
    bytes_.resize(at + values.size_bytes());
    std::memcpy(bytes_.data() + at, values.data(), values.size_bytes());
    return views_.size() - 1;
  }

  std::size_t accessor(std::span<const float> values, const char* type, std::size_t width, bool bounded, int target);

  Json primitive(std::span<const float> places, std::span<const float> normals, std::span<const std::uint32_t> corners);

  std::size_t add_mesh(std::string name, Json primitive, std::size_t material);

  [[nodiscard]] Json document(const std::string& uri) const;

  Json nodes_ = Json::array();
  std::vector<std::vector<std::size_t>> children_;
  Json meshes_ = Json::array();
  Json materials_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  Json samplers_ = Json::array();
  Json channels_ = Json::array();
  Json extras_;
  Json box_;
  std::string bytes_;
};

}  // namespace trophic::command::replay
