// SPDX-License-Identifier: MIT
// Definitions of gltf_file.hpp.
#include <tools/trophic/replay/gltf_file.hpp>

#include <array>
#include <cmath>

namespace trophic::command::replay {

GltfFile::GltfFile() {
  Json root = {{"name", "trophic"}, {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}}};
  nodes_.push_back(std::move(root));
  children_.emplace_back();
}

std::size_t GltfFile::add_node(std::size_t parent, std::string name, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                               const Eigen::Vector3d& scale) {
  Json node(Json::value_t::object);  // a null value that becomes one crashes without memory
  if (!name.empty()) node["name"] = std::move(name);
  node["translation"] = {at_m.x(), at_m.y(), at_m.z()};
  node["rotation"] = {turn.x(), turn.y(), turn.z(), turn.w()};
  if (scale != Eigen::Vector3d::Ones()) node["scale"] = {scale.x(), scale.y(), scale.z()};
  nodes_.push_back(std::move(node));
  children_.emplace_back();
  children_[parent].push_back(nodes_.size() - 1);
  return nodes_.size() - 1;
}

std::size_t GltfFile::add_shape(std::size_t parent, std::size_t mesh, const Eigen::Vector3d& at_m, const Eigen::Quaterniond& turn,
                                const Eigen::Vector3d& scale) {
  const std::size_t node = add_node(parent, {}, at_m, turn, scale);
  nodes_[node]["mesh"] = mesh;
  return node;
}

std::size_t GltfFile::add_material(std::string name, const Colour& colour) {
  Json rgba = Json::array();
  for (const float part : colour) {  // the format has linear light, colours of screens are not linear
    rgba.push_back(part <= 0.04045F ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  rgba.push_back(1.0);
  materials_.push_back({{"name", std::move(name)},
                        {"pbrMetallicRoughness", {{"baseColorFactor", rgba}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
                        {"doubleSided", true}});
  return materials_.size() - 1;
}

std::size_t GltfFile::add_box(std::string name, std::size_t material) {
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

std::size_t GltfFile::add_surface(std::string name, std::size_t material, std::span<const float> places,
                                  std::span<const float> normals, std::span<const std::uint32_t> corners) {
  return add_mesh(std::move(name), primitive(places, normals, corners), material);
}

void GltfFile::move(std::size_t node, const char* path, std::size_t times, std::span<const float> values, bool jumps) {
  const bool turns = std::string_view{path} == "rotation";
  const std::size_t output = accessor(values, turns ? "VEC4" : "VEC3", turns ? 4 : 3, false, 0);
  samplers_.push_back({{"input", times}, {"interpolation", jumps ? "STEP" : "LINEAR"}, {"output", output}});
  channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

std::string GltfFile::glb() const {
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

std::size_t GltfFile::accessor(std::span<const float> values, const char* type, std::size_t width, bool bounded, int target) {
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

Json GltfFile::primitive(std::span<const float> places, std::span<const float> normals, std::span<const std::uint32_t> corners) {
  const std::size_t position = accessor(places, "VEC3", 3, true, vertices);
  const std::size_t normal = accessor(normals, "VEC3", 3, false, vertices);
  accessors_.push_back(
      {{"bufferView", view(corners, indices)}, {"componentType", whole}, {"count", corners.size()}, {"type", "SCALAR"}});
  return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", accessors_.size() - 1}};
}

std::size_t GltfFile::add_mesh(std::string name, Json primitive, std::size_t material) {
  primitive["material"] = material;
  meshes_.push_back({{"name", std::move(name)}, {"primitives", Json::array({std::move(primitive)})}});
  return meshes_.size() - 1;
}

Json GltfFile::document(const std::string& uri) const {
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

}  // namespace trophic::command::replay
