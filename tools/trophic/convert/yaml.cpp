// SPDX-License-Identifier: MIT
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <tools/trophic/convert/yaml.hpp>

namespace trophic::convert {

namespace {

constexpr std::size_t most_levels = 128;
const std::string too_deep = "nested more than " + std::to_string(most_levels) + " deep";
constexpr std::size_t most_keys = 100;        ///< of one object
constexpr std::size_t most_values = 100'000;  ///< with those that aliases repeat

class Reader {
 public:
  [[nodiscard]] Json read(const YAML::Node& node, std::size_t level = 0) {
    if (level > most_levels) throw YAML::Exception{node.Mark(), too_deep};
    if (++values_ > most_values) throw YAML::Exception{node.Mark(), "more than " + std::to_string(most_values) + " values"};
    if (node.IsScalar()) return node.Scalar();
    if (node.IsSequence()) {
      Json list = Json::array();
      for (const YAML::Node& one : node) list.push_back(read(one, level + 1));
      return list;
    }
    if (!node.IsMap()) return nullptr;
    Json object{{line_key, std::to_string(node.Mark().line + 1)}};
    for (const auto& entry : node) {
      const YAML::Node& key = entry.first;
      if (!key.IsScalar()) throw YAML::Exception{key.Mark(), "a key must be a text"};
      if (object.contains(key.Scalar())) throw YAML::Exception{key.Mark(), key.Scalar() + ": appears twice"};
      if (object.size() > most_keys) throw YAML::Exception{key.Mark(), "more than " + std::to_string(most_keys) + " keys"};
      object[key.Scalar()] = read(entry.second, level + 1);
    }
    return object;
  }

 private:
  std::size_t values_ = 0;
};

}  // namespace

Json read_yaml(const std::string& text, const std::string& file) {
  try {
    const YAML::Node whole = YAML::Load(text);
    if (!whole.IsMap() || !whole["body"]) return Reader{}.read(whole);
    return {{"body", Reader{}.read(whole["body"])}};
  } catch (const YAML::Exception& error) {
    const bool is_deep = dynamic_cast<const YAML::DeepRecursion*>(&error) != nullptr;
    throw std::invalid_argument{file + ":" + std::to_string(error.mark.line + 1) + ": " + (is_deep ? too_deep : error.msg)};
  }
}

}  // namespace trophic::convert
