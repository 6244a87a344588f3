// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <tools/command/toml_writer.hpp>
#include <tools/trophic/convert/foreign_body.hpp>
#include <tools/trophic/convert/yaml.hpp>
#include <trophic/habitat/load/foreign_format.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/plain_text.hpp>

namespace trophic::convert {

namespace {

using body::Face;
using body::ModuleType;

/// A key of a robot file has at most 32 parts, of which the first is the core.
constexpr std::size_t most_depth = 31;

[[nodiscard]] ModuleType type_of(std::string_view name) {
  for (const std::string_view core : {"core", "Core", "CoreComponent", "CoreComponentNoIMU", "CoreV1", "E", "N"}) {
    if (name == core) return ModuleType::core;
  }
  for (const std::string_view hinge : {"hinge", "active_hinge", "ActiveHinge", "ActiveHingeV1", "I"}) {
    if (name == hinge) return ModuleType::hinge;
  }
  for (const std::string_view brick : {"brick", "Brick", "FixedBrick", "BrickV1", "F"}) {
    if (name == brick) return ModuleType::brick;
  }
  throw std::invalid_argument{"is of type " + std::string{name} + ": must be a core, an active hinge or a brick"};
}

[[nodiscard]] std::string plain_name(const std::string& name) {
  if (!is_plain(name)) throw std::invalid_argument{"its name must be text without control characters"};
  if (!is_utf8(name)) throw std::invalid_argument{"its name must be UTF-8"};
  return name;
}

/// Adds modules, parents first, to a body.
class Assembly {
 public:
  explicit Assembly(std::string format) { body_.format = std::move(format); }

  void name_core(const std::string& name) { body_.names.assign(1, plain_name(name)); }

  /// Returns the number of the module.
  std::size_t attach(std::size_t parent, std::size_t depth, Face face, ModuleType type, int turns, const std::string& name) {
    if (depth > most_depth) throw std::invalid_argument{"is more than " + std::to_string(most_depth) + " modules from the core"};
    const std::size_t added = body_.modules.attach(parent, face, type, turns);
    body_.names.push_back(plain_name(name));
    return added;
  }

  [[nodiscard]] const body::Module& module(std::size_t i) const { return body_.modules.modules()[i]; }

  /// Quarter turns of a module on a face after which its axis (0, 1, 2: x, y, z) has a direction in the core's frame.
  [[nodiscard]] int turns_towards(std::size_t parent, Face face, Eigen::Index axis, const Eigen::Vector3i& direction) const {
    const Eigen::Matrix3i towards = module(parent).orientation * body::face_rotation(face);
    for (int turns = 0; turns < 4; ++turns) {
      if ((towards * body::roll_rotation(turns)).col(axis) == direction) return turns;
    }
    throw std::invalid_argument{"cannot lie flat here"};
  }

  [[nodiscard]] ForeignBody take(std::string name) {
    body_.name = plain_name(name);
    return std::move(body_);
  }

 private:
  ForeignBody body_;
};

// Revolve and revolve2

enum class Dialect { revolve, revolve2 };

[[nodiscard]] std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : json_text(value);
}

[[nodiscard]] int quarter_turns(const std::string& key, const std::string& text, double quarter) {
  std::size_t used = 0;
  double value = std::nan("");
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {  // below
  }
  const double turns = std::round(value / quarter);
  if (used != text.size() || !(std::abs(turns) <= 16.0) || std::abs(value - turns * quarter) > 1e-3 * quarter) {
    throw std::invalid_argument{key + " = " + text + ": must be a multiple of " + (quarter > 2.0 ? "90 degrees" : "pi / 2")};
  }
  return static_cast<int>(turns);
}

/// The face of a key of `children`.
[[nodiscard]] Face face_of(Dialect dialect, ModuleType type, const std::string& key) {
  using Slots = std::span<const std::optional<Face>>;
  static constexpr std::array<std::optional<Face>, 4> revolve_core{Face::back, Face::front, Face::right, Face::left};
  static constexpr std::array<std::optional<Face>, 4> revolve_brick{std::nullopt, Face::front, Face::right, Face::left};
  static constexpr std::array<std::optional<Face>, 2> revolve_hinge{std::nullopt, Face::front};
  static constexpr std::array<std::optional<Face>, 4> core{Face::front, Face::right, Face::back, Face::left};
  static constexpr std::array<std::optional<Face>, 3> brick{Face::front, Face::right, Face::left};
  static constexpr std::array<std::optional<Face>, 1> hinge{Face::front};
  const bool old = dialect == Dialect::revolve;
  const Slots slots = type == ModuleType::core    ? Slots{old ? Slots{revolve_core} : Slots{core}}
                      : type == ModuleType::brick ? Slots{old ? Slots{revolve_brick} : Slots{brick}}
                                                  : Slots{old ? Slots{revolve_hinge} : Slots{hinge}};
  if (key.size() == 1 && key[0] >= '0' && key[0] < '0' + static_cast<int>(slots.size())) {
    if (const auto face = slots[static_cast<std::size_t>(key[0] - '0')]) return *face;
  } else if (!old && type == ModuleType::hinge && key == "attachment") {
    return Face::front;
  } else if (!old) {
    for (const Face face : body::all_faces) {
      if (key == enum_name(face) && body::has_face(type, face)) return face;
    }
  }
  throw std::invalid_argument{"children." + key + ": a " + std::string{enum_name(type)} + " has no such place"};
}

class ModuleReader {
 public:
  ModuleReader(Dialect dialect, std::string format) : dialect_{dialect}, assembly_{std::move(format)} {}

  [[nodiscard]] ForeignBody read(const Json& core) {
    where_ = "core";
    check_keys(core);
    if (type(core) != ModuleType::core) throw std::invalid_argument{"must begin with a core"};
    if (turns(core) % 4 != 0) throw std::invalid_argument{"must not be turned"};
    assembly_.name_core(name(core));
    read_children(core, 0, ModuleType::core, 0);
    return assembly_.take({});
  }

  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  void check_keys(const Json& module) const {
    if (!module.is_object()) throw std::invalid_argument{"must be a module with a type"};
    const char* const angle = dialect_ == Dialect::revolve ? "orientation" : "rotation";
    for (const auto& [key, value] : module.items()) {
      bool known = key == angle;
      for (const char* other : {"id", "name", "uuid", "type", "children", "params", "slot", "color"}) known |= key == other;
      if (!known) throw std::invalid_argument{key + ": is not a key that is read here; " + angle + " turns a module"};
    }
  }

  [[nodiscard]] static ModuleType type(const Json& module) {
    if (!module.contains("type")) throw std::invalid_argument{"type: missing"};
    return type_of(text_of(module.at("type")));
  }
  [[nodiscard]] static std::string name(const Json& module) {
    for (const char* key : {"id", "name", "uuid"}) {
      if (module.contains(key) && !module.at(key).is_null()) return text_of(module.at(key));
    }
    return {};
  }
  [[nodiscard]] int turns(const Json& module) const {
    const std::string key = dialect_ == Dialect::revolve ? "orientation" : "rotation";
    if (!module.contains(key) || module.at(key).is_null()) return 0;
    return quarter_turns(key, text_of(module.at(key)), dialect_ == Dialect::revolve ? 90.0 : std::numbers::pi / 2.0);
  }

  void read_children(const Json& module, std::size_t parent, ModuleType parent_type, std::size_t depth) {
    if (!module.contains("children")) return;
    const Json& children = module.at("children");
    if (children.is_null()) return;
    const std::string above = where_;
    if (!children.is_structured()) throw std::invalid_argument{"children: must be modules by their places"};
    std::size_t index = 0;
    for (const auto& [key, child] : children.items()) {
      const std::string place = children.is_array() ? std::to_string(index++) : key;
      if (child.is_null()) continue;
      where_ = above;
      const Face face = face_of(dialect_, parent_type, place);
      where_ = above + "." + place;
      check_keys(child);
      const ModuleType child_type = type(child);
      const std::size_t added = assembly_.attach(parent, depth + 1, face, child_type, turns(child), name(child));
      read_children(child, added, child_type, depth + 1);
    }
  }

  Dialect dialect_;
  Assembly assembly_;
  std::string where_;
};

[[nodiscard]] ForeignBody read_modules(const Json& whole, bool has_body, const std::string& format, const std::string& file) {
  ModuleReader reader{has_body ? Dialect::revolve : Dialect::revolve2, format};
  try {
    return reader.read(whole);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{file + ": " + reader.where() + ": " + error.what()};
  }
}

// RoboGen

struct RobogenLine {
  std::size_t depth;
  std::size_t slot;
  std::string type;
  std::string name;
  int turns;
};

/// TABS SLOT TYPE NAME TURNS
[[nodiscard]] RobogenLine robogen_line(std::string_view line) {
  const std::size_t depth = std::min(line.find_first_not_of('\t'), line.size());
  std::vector<std::string> words;
  for (std::size_t at = depth; at < line.size();) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    if (end > at) words.emplace_back(line.substr(at, end - at));
    at = end + 1;
  }
  const auto is_digit = [&](std::size_t i) { return words[i].size() == 1 && words[i][0] >= '0' && words[i][0] <= '9'; };
  if (words.size() < 4) {
    throw std::invalid_argument{"must be SLOT TYPE NAME TURNS behind a tab for each module above it"};
  }
  for (const auto& [place, what] : {std::pair{0U, "slot"}, {3U, "turns"}}) {
    if (!is_digit(place)) throw std::invalid_argument{what + (" = " + json_text(words[place])) + ": must be one digit"};
  }
  if (words.size() > 4) static_cast<void>(type_of(words[1]));  // a type with parameters is none of ours
  if (words.size() > 4) throw std::invalid_argument{words[4] + ": a " + words[1] + " has no parameters"};
  if (words[3][0] > '3') throw std::invalid_argument{"turns = " + words[3] + ": must be 0 to 3"};
  return {depth, static_cast<std::size_t>(words[0][0] - '0'), words[1], words[2], words[3][0] - '0'};
}

/// A face, and the direction in the frame of its module with which the axis of a hinge agrees that is not turned.
struct RobogenSlot {
  Face face;
  Eigen::Vector3i tangent;
};

[[nodiscard]] RobogenSlot robogen_slot(ModuleType type, std::size_t slot) {
  using Direction = Eigen::Vector3i;
  const std::size_t slots = type == ModuleType::core ? 4 : type == ModuleType::brick ? 3 : 1;
  if (slot >= slots) {
    throw std::invalid_argument{"slot = " + std::to_string(slot) + ": a " + std::string{enum_name(type)} + " has " +
                                std::to_string(slots) + (slots == 1 ? " slot" : " slots")};
  }
  if (type == ModuleType::hinge) return {Face::front, Direction::UnitY()};
  if (type == ModuleType::brick) {
    if (slot == 0) return {Face::front, Direction::UnitY()};
    return {slot == 1 ? Face::right : Face::left, Direction::UnitZ()};
  }
  // The core's front faces its -y, and its slots are named as seen from there.
  if (slot < 2) return {slot == 0 ? Face::right : Face::left, -Direction::UnitX()};
  return {slot == 2 ? Face::front : Face::back, Direction::UnitZ()};
}

[[nodiscard]] ForeignBody read_robogen(std::string_view text, const std::string& format, const std::string& file) {
  Assembly assembly{format};
  std::vector<std::size_t> above;  // of the last line: the modules from the core to it
  std::string where = file;
  std::size_t number = 0;
  try {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      where = file + ":" + std::to_string(++number);
      while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == '\t')) line.remove_suffix(1);
      if (line.empty() && above.empty()) continue;
      if (line.empty()) break;  // the brain follows
      const RobogenLine read = robogen_line(line);
      const ModuleType type = type_of(read.type);
      if (above.empty()) {
        if (type != ModuleType::core || read.depth != 0) throw std::invalid_argument{"must begin with a core"};
        assembly.name_core(read.name);
        above.push_back(0);
        continue;
      }
      if (read.depth == 0 || read.depth > above.size()) {
        throw std::invalid_argument{std::to_string(read.depth) + " tabs: must be 1 to " + std::to_string(above.size())};
      }
      above.resize(read.depth);
      const body::Module parent = assembly.module(above.back());
      const RobogenSlot slot = robogen_slot(parent.type, read.slot);
      int turns = 0;
      if (type == ModuleType::hinge) {
        turns = assembly.turns_towards(above.back(), slot.face, 1, parent.orientation * slot.tangent) - read.turns;
      } else if (type == ModuleType::brick) {
        turns = assembly.turns_towards(above.back(), slot.face, 2, Eigen::Vector3i::UnitZ());
      }
      above.push_back(assembly.attach(above.back(), read.depth, slot.face, type, turns, read.name));
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{where + ": " + error.what()};
  }
  return assembly.take({});
}

}  // namespace

bool is_utf8(const std::string& text) {
  try {
    static_cast<void>(Json(text).dump());
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

namespace {

[[nodiscard]] ForeignBody read_any_body(std::string_view text, const std::string& file) {
  const std::string format{detail::foreign_format(text)};
  if (format == detail::robogen_text) return read_robogen(text, format, file);
  const bool is_json = format == detail::revolve2_json;
  if (!is_json && format != detail::revolve2_yaml) {
    throw std::invalid_argument{file + ": is " + (format.empty() ? "in no format that is known" : format) +
                                ": must be a body of revolve2 or Revolve (JSON, YAML) or RoboGen's text"};
  }
  Json whole;
  try {
    whole = is_json ? parse_json(text) : read_yaml(std::string{text}, file);
  } catch (const Json::exception& error) {
    throw std::invalid_argument{file + ": " + error.what()};
  }
  const bool has_body = whole.is_object() && whole.contains("body");
  return read_modules(has_body ? whole.at("body") : whole, has_body, format, file);
}

}  // namespace

ForeignBody read_foreign_body(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  ForeignBody body = read_any_body(text, file);
  if (body.modules.modules().size() < 2) throw std::invalid_argument{file + ": is a core alone: must have a hinge or a brick"};
  return body;
}

std::string robot_file(const ForeignBody& body, const std::string& name) {
  TomlWriter writer;
  writer.put("name", name, "from " + body.format + ", with the parts of models/README.md; without its brain");
  writer.put("forward_deg", 0.0, "the core's front");
  const std::vector<body::Module>& modules = body.modules.modules();
  for (std::size_t i = 1; i < modules.size(); ++i) {
    writer.table("core." + body.modules.path(i));
    writer.put("module", enum_name(modules[i].type), body.names[i]);
    writer.put("rotation_deg", 90 * modules[i].quarter_turns);
  }
  return writer.text();
}

}  // namespace trophic::convert
