// SPDX-License-Identifier: MIT
// A glTF 2.0 file in the making: nodes, boxes, colours and motion, which programs that draw open.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tools/trophic/replay/base64.hpp>
#include <trophic/population/species_colour.hpp>
#include <trophic/support/json.hpp>
#include <utility>
#include <vector>

namespace trophic::command::replay {

/// Grows by parts, each of which is known by its number from then on. Metres, seconds, quaternions x, y, z, w. The format's y
/// axis points up, so what is added in trophic's axes (z up) hangs below `upright()`.
class GltfFile {
 public:
  GltfFile() {
    Json root = {{"name", "trophic"}, {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}}};
    nodes_.push_back(std::move(root));
    children_.emplace_back();
  }

  /// The node in whose frame z points up.
  [[nodiscard]] static std::size_t upright() { return 0; }

  std::size_t add_node(std::size_t parent, std::string name, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                       const Eigen::Vector3d& scale = Eigen::Vector3d::Ones()) {
    Json node;
    if (!name.empty()) node["name"] = std::move(name);
    node["translation"] = {at_m.x(), at_m.y(), at_m.z()};
    node["rotation"] = {turn.x(), turn.y(), turn.z(), turn.w()};
    if (scale != Eigen::Vector3d::Ones()) node["scale"] = {scale.x(), scale.y(), scale.z()};
    nodes_.push_back(std::move(node));
    children_.emplace_back();
    children_[parent].push_back(nodes_.size() - 1);
    return nodes_.size() - 1;
  }
  /// A node that shows a mesh.
  std::size_t add_shape(std::size_t parent, std::size_t mesh, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                        const Eigen::Vector3d& scale) {
    const std::size_t node = add_node(parent, {}, at_m, turn, scale);
    nodes_[node]["mesh"] = mesh;
    return node;
  }
  /// What else is known of a node.
  void describe(std::size_t node, Json what) { nodes_[node]["extras"] = std::move(what); }
  void describe(Json what) { extras_ = std::move(what); }

  std::size_t add_material(std::string name, const Colour& colour) {
    Json rgba = Json::array();
    for (const float part : colour) {  // the format wants linear light, screens are told otherwise
      rgba.push_back(part <= 0.04045F ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    rgba.push_back(1.0);
    materials_.push_back(
        {{"name", std::move(name)},
         {"pbrMetallicRoughness", {{"baseColorFactor", rgba}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
         {"doubleSided", true}});
    return materials_.size() - 1;
  }

  /// A box from -1 to 1 along each axis.
  std::size_t add_box(std::string name, std::size_t material) {
    if (box_.is_null()) {
      std::vector<float> places;
      std::vector<float> normals;
      std::vector<std::uint32_t> corners;
      for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0F, 1.0F}) {
          const auto first = static_cast<std::uint32_t>(places.size() / 3);
          for (const auto& [u, v] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
            std::array<float, 3> place{};
            place[static_cast<std::size_t>(axis)] = side;
            place[static_cast<std::size_t>((axis + 1) % 3)] = u * side;
            place[static_cast<std::size_t>((axis + 2) % 3)] = v;
            places.insert(places.end(), place.begin(), place.end());
            for (int i = 0; i < 3; ++i) normals.push_back(i == axis ? side : 0.0F);
          }
          for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) corners.push_back(first + i);
        }
      }
      box_ = primitive(places, normals, corners);
    }
    return add_mesh(std::move(name), box_, material);
  }

  /// Triangles: three numbers a place, three a normal, three places a triangle.
  std::size_t add_surface(std::string name, std::size_t material, std::span<const float> places, std::span<const float> normals,
                          std::span<const std::uint32_t> corners) {
    return add_mesh(std::move(name), primitive(places, normals, corners), material);
  }

  /// Moments, which several motions may share. Strictly increasing.
  std::size_t add_times(std::span<const float> times_s) { return accessor(times_s, "SCALAR", 1, true, 0); }

  /// Lets a node move, turn or grow: "translation", "rotation" or "scale". `jumps`: a value holds until the next one.
  void move(std::size_t node, const char* path, std::size_t times, std::span<const float> values, bool jumps = false) {
    const bool turns = std::string_view{path} == "rotation";
    const std::size_t output = accessor(values, turns ? "VEC4" : "VEC3", turns ? 4 : 3, false, 0);
    samplers_.push_back({{"input", times}, {"interpolation", jumps ? "STEP" : "LINEAR"}, {"output", output}});
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  /// One file of text, the numbers in base64.
  [[nodiscard]] std::string gltf() const { return json_text(document("data:application/octet-stream;base64," + base64(bytes_))); }

  /// One file of bytes.
  [[nodiscard]] std::string glb() const {
    std::string text = json_text(document({}));
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string binary = bytes_;
    binary.append((4 - binary.size() % 4) % 4, '\0');
    std::string file = "glTF";
    const auto number = [&](std::size_t value) {
      for (unsigned i = 0; i < 4; ++i) file.push_back(static_cast<char>(value >> 8U * i & 0xFFU));
    };
    number(2);
    number(12 + 8 + text.size() + 8 + binary.size());
    number(text.size());
    file += "JSON" + text;
    number(binary.size());
    file += std::string{"BIN\0", 4} + binary;
    return file;
  }

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

  std::size_t accessor(std::span<const float> values, const char* type, std::size_t width, bool bounded, int target) {
    Json accessor = {
        {"bufferView", view(values, target)}, {"componentType", floats}, {"count", values.size() / width}, {"type", type}};
    if (bounded) {
      std::vector<float> low(width, std::numeric_limits<float>::infinity());
      std::vector<float> high(width, -std::numeric_limits<float>::infinity());
      for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % width] = std::min(low[i % width], values[i]);
        high[i % width] = std::max(high[i % width], values[i]);
      }
      accessor["min"] = low;
      accessor["max"] = high;
    }
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }

  Json primitive(std::span<const float> places, std::span<const float> normals, std::span<const std::uint32_t> corners) {
    const std::size_t position = accessor(places, "VEC3", 3, true, vertices);
    const std::size_t normal = accessor(normals, "VEC3", 3, false, vertices);
    accessors_.push_back(
        {{"bufferView", view(corners, indices)}, {"componentType", whole}, {"count", corners.size()}, {"type", "SCALAR"}});
    return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", accessors_.size() - 1}};
  }

  std::size_t add_mesh(std::string name, Json primitive, std::size_t material) {
    primitive["material"] = material;
    meshes_.push_back({{"name", std::move(name)}, {"primitives", Json::array({std::move(primitive)})}});
    return meshes_.size() - 1;
  }

  [[nodiscard]] Json document(const std::string& uri) const {
    Json nodes = nodes_;
    for (std::size_t i = 0; i < children_.size(); ++i) {
      if (!children_[i].empty()) nodes[i]["children"] = children_[i];
    }
    Json buffer = {{"byteLength", (bytes_.size() + 3) / 4 * 4}};
    if (!uri.empty()) buffer = {{"uri", uri}, {"byteLength", bytes_.size()}};
    Json document = {{"asset", {{"version", "2.0"}, {"generator", "trophic"}}},
                     {"scene", 0},
                     {"scenes", Json::array({{{"nodes", {upright()}}}})},
                     {"nodes", std::move(nodes)},
                     {"meshes", meshes_},
                     {"materials", materials_},
                     {"accessors", accessors_},
                     {"bufferViews", views_},
                     {"buffers", Json::array({std::move(buffer)})}};
    if (!extras_.is_null()) document["scenes"][0]["extras"] = extras_;
    if (!channels_.empty()) {
      document["animations"] = Json::array({{{"name", "run"}, {"channels", channels_}, {"samplers", samplers_}}});
    }
    return document;
  }

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
