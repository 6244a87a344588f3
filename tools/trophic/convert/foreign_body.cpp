// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
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
constexpr std::size_t most_parts = 1000;  ///< of a list that names parents

enum class Dialect { robogen, revolve, revolve2 };

/// A part as its file has it, with all that is attached to it.
struct Part {
  std::string where;  ///< FILE:LINE, and its name or the way to it
  std::string line;
  std::string type;
  std::string name;
  std::string place;  ///< on its parent
  std::string own_place = "0";
  std::string turns;  ///< empty for none
  std::vector<Part> children;
};

[[noreturn]] void refuse(const Part& part, const std::string& why) {
  throw std::invalid_argument{part.where + ": " + why};
}

[[nodiscard]] std::optional<ModuleType> type_of(const Part& part) {
  using Names = std::span<const std::string_view>;
  static constexpr std::array<std::string_view, 7> core{"core", "Core", "CoreComponent", "CoreComponentNoIMU", "CoreV1",
                                                        "E",    "N"};
  static constexpr std::array<std::string_view, 5> hinge{"hinge", "active_hinge", "ActiveHinge", "ActiveHingeV1", "I"};
  static constexpr std::array<std::string_view, 5> brick{"brick", "Brick", "FixedBrick", "BrickV1", "F"};
  for (const auto& [type, names] :
       {std::pair{ModuleType::core, Names{core}}, {ModuleType::hinge, Names{hinge}}, {ModuleType::brick, Names{brick}}}) {
    if (std::ranges::find(names, part.type) != names.end()) return type;
  }
  return {};
}

/// "TYPE NAME (line N)"
[[nodiscard]] std::string label(const Part& part) {
  return part.type + (part.name.empty() ? "" : " " + part.name) + " (line " + part.line + ")";
}

/// The first module at or below a part; null if there is none.
[[nodiscard]] const Part* module_of(const Part& part) {
  if (type_of(part)) return &part;
  for (const Part& child : part.children) {
    if (const Part* const found = module_of(child)) return found;
  }
  return nullptr;
}

[[nodiscard]] int one_digit(const Part& part, const char* what, const std::string& text, int most) {
  if (text.size() != 1 || text[0] < '0' || text[0] > '9') refuse(part, what + (" = " + json_text(text)) + ": must be one digit");
  if (text[0] - '0' > most) refuse(part, what + (" = " + text) + ": must be 0 to " + std::to_string(most));
  return text[0] - '0';
}

[[nodiscard]] int quarter_turns(Dialect dialect, const Part& part) {
  if (part.turns.empty()) return 0;
  if (dialect == Dialect::robogen) return one_digit(part, "turns", part.turns, 3);
  const double quarter = dialect == Dialect::revolve ? 90.0 : std::numbers::pi / 2.0;
  std::size_t used = 0;
  double value = std::nan("");
  try {
    value = std::stod(part.turns, &used);
  } catch (const std::exception&) {  // below
  }
  const double turns = std::round(value / quarter);
  if (used != part.turns.size() || !(std::abs(turns) <= 16.0) || std::abs(value - turns * quarter) > 1e-3 * quarter) {
    refuse(part, (dialect == Dialect::revolve ? "orientation = " : "rotation = ") + part.turns + ": must be a multiple of " +
                     (dialect == Dialect::revolve ? "90 degrees" : "pi / 2"));
  }
  return static_cast<int>(turns);
}

/// A face, and the direction in the frame of its module with which the axis of a hinge of RoboGen agrees that is not turned.
struct Slot {
  Face face;
  Eigen::Vector3i tangent;
};

/// The place of a part on its parent; nothing if the parent has no such place.
[[nodiscard]] std::optional<Slot> slot_of(Dialect dialect, const Part& parent, ModuleType type, const std::string& place) {
  using Direction = Eigen::Vector3i;
  if (dialect == Dialect::revolve2) {
    static constexpr std::array<Face, 4> core{Face::front, Face::right, Face::back, Face::left};
    static constexpr std::array<Face, 3> brick{Face::front, Face::right, Face::left};
    const std::span<const Face> faces = type == ModuleType::core ? std::span<const Face>{core} : std::span<const Face>{brick};
    for (const Face face : faces) {
      const bool is_named = place == enum_name(face) || place == std::to_string(std::ranges::find(faces, face) - faces.begin());
      if (body::has_face(type, face) && (is_named || (type == ModuleType::hinge && place == "attachment"))) return Slot{face, {}};
    }
    return {};
  }
  if (place.size() != 1) return {};
  if (dialect == Dialect::revolve) {
    constexpr std::string_view around = "0213";  // slots of a core and a brick, counterclockwise from the back
    constexpr std::array<Face, 4> faces{Face::back, Face::right, Face::front, Face::left};
    if (place == parent.own_place && type != ModuleType::core) return {};
    if (type == ModuleType::hinge) return place == "0" || place == "1" ? std::optional{Slot{Face::front, {}}} : std::nullopt;
    const std::size_t at = around.find(place);
    if (at == std::string_view::npos) return {};
    return Slot{faces.at(type == ModuleType::core ? at : (at + 4 - around.find(parent.own_place)) % 4), {}};
  }
  // The core's front faces its -y, and its slots are named as seen from there.
  const std::array<Slot, 4> core{Slot{Face::right, -Direction::UnitX()}, Slot{Face::left, -Direction::UnitX()},
                                 Slot{Face::front, Direction::UnitZ()}, Slot{Face::back, Direction::UnitZ()}};
  const std::array<Slot, 3> brick{Slot{Face::front, Direction::UnitY()}, Slot{Face::right, Direction::UnitZ()},
                                  Slot{Face::left, Direction::UnitZ()}};
  const std::span<const Slot> slots = type == ModuleType::core ? std::span<const Slot>{core} : std::span<const Slot>{brick};
  const auto at = static_cast<std::size_t>(place[0] - '0');
  return at < (type == ModuleType::hinge ? 1 : slots.size()) ? std::optional{slots[at]} : std::nullopt;
}

/// Adds modules, parents first, to a body.
class Assembly {
 public:
  explicit Assembly(Dialect dialect) : dialect_{dialect} {}

  [[nodiscard]] ForeignBody assemble(const Part& core) {
    if (type_of(core) != ModuleType::core) refuse(core, "must begin with a core");
    if (dialect_ != Dialect::robogen && quarter_turns(dialect_, core) % 4 != 0) refuse(core, "must not be turned");
    body_.names.push_back(core.name);
    attach_children(core, 0, ModuleType::core, 0);
    const auto is_hinge = [](const body::Module& module) { return module.type == ModuleType::hinge; };
    if (!left_out_.empty()) {
      if (std::ranges::none_of(body_.modules.modules(), is_hinge)) {
        refuse(core, "has no hinge without " + left_out_ + ", which trophic does not have");
      }
      body_.remarks.push_back("omitted, because trophic does not have it: " + left_out_);
    }
    if (!reversed_.empty())
      body_.remarks.push_back("turned around, because they are attached by their far end there: " + reversed_);
    if (dialect_ == Dialect::robogen) {
      body_.remarks.emplace_back(
          "slot 0, which RoboGen calls left, is on the right of its front and becomes right; slot 1 becomes left");
    }
    return std::move(body_);
  }

 private:
  void attach_children(const Part& parent, std::size_t on, ModuleType parent_type, std::size_t depth) {
    for (const Part& part : parent.children) {
      const std::optional<ModuleType> type = type_of(part);
      if (!type) {
        if (const Part* const below = module_of(part)) {
          refuse(part,
                 "is of type " + part.type + ": must be a core, an active hinge or a brick, because it carries " + label(*below));
        }
        left_out_ += (left_out_.empty() ? "" : ", ") + label(part);
        continue;
      }
      const std::optional<Slot> slot = slot_of(dialect_, parent, parent_type, part.place);
      if (!slot)
        refuse(part, "place = " + json_text(part.place) + ": a " + std::string{enum_name(parent_type)} + " has no such place");
      if (depth == most_depth) refuse(part, "is more than " + std::to_string(most_depth) + " modules from the core");
      if (*type == ModuleType::hinge && part.own_place == "1") reversed_ += (reversed_.empty() ? "" : ", ") + label(part);
      std::size_t added = 0;
      try {
        added = body_.modules.attach(on, slot->face, *type, turns_of(part, on, *slot, *type));
      } catch (const std::invalid_argument& error) {
        refuse(part, error.what());
      }
      body_.names.push_back(part.name);
      attach_children(part, added, *type, depth + 1);
    }
  }

  [[nodiscard]] int turns_of(const Part& part, std::size_t on, const Slot& slot, ModuleType type) const {
    const int turns = quarter_turns(dialect_, part);
    if (dialect_ != Dialect::robogen || type == ModuleType::core) return turns;
    if (type == ModuleType::brick) return turns_towards(on, slot.face, 2, Eigen::Vector3i::UnitZ());  // bricks lie flat
    return turns_towards(on, slot.face, 1, body_.modules.modules()[on].orientation * slot.tangent) - turns;
  }

  /// Quarter turns of a module on a face after which its axis (0, 1, 2: x, y, z) has a direction in the core's frame.
  [[nodiscard]] int turns_towards(std::size_t parent, Face face, Eigen::Index axis, const Eigen::Vector3i& direction) const {
    const Eigen::Matrix3i towards = body_.modules.modules()[parent].orientation * body::face_rotation(face);
    for (int turns = 0; turns < 4; ++turns) {
      if ((towards * body::roll_rotation(turns)).col(axis) == direction) return turns;
    }
    throw std::invalid_argument{"cannot lie flat here"};
  }

  Dialect dialect_;
  ForeignBody body_;
  std::string left_out_;
  std::string reversed_;
};

/// Makes parts of what a file says of them.
class PartReader {
 public:
  explicit PartReader(const std::string& file) : file_{file} {}

  /// Throws for a name that cannot be printed.
  [[nodiscard]] Part part(const std::string& line, const std::string& type, const std::string& name,
                          const std::string& way) const {
    const std::string at = file_ + ":" + line;
    for (const std::string& text : {type, name, way}) {
      if (!is_plain(text)) throw std::invalid_argument{at + ": its name must be text without control characters"};
      if (!is_utf8(text)) throw std::invalid_argument{at + ": its name must be UTF-8"};
    }
    Part made;
    made.where = at + (name.empty() && way.empty() ? "" : ": " + (name.empty() ? way : name));
    made.line = line;
    made.type = type;
    made.name = name;
    return made;
  }

  /// A tree of modules of Revolve or revolve2.
  [[nodiscard]] Part read_tree(Dialect dialect, const Json& module, const std::string& line, const std::string& way) const {
    if (!module.is_object()) refuse(part(line, "", "", way), "must be a module with a type");
    std::string name = text_at(module, "id");
    for (const char* const key : {"name", "uuid"}) {
      if (name.empty()) name = text_at(module, key);
    }
    Part made = part(line_of(module), text_at(module, "type"), name, way);
    if (made.type.empty()) refuse(made, "type: missing");
    const auto [angle, other] =
        dialect == Dialect::revolve ? std::pair{"orientation", "rotation"} : std::pair{"rotation", "orientation"};
    if (module.contains(other)) refuse(made, std::string{other} + ": is an unknown key here; " + angle + " turns a module");
    made.turns = text_at(module, angle);
    if (dialect == Dialect::revolve && module.contains("slot")) {
      made.own_place = text_at(module, "slot");
      const int most = type_of(made) == ModuleType::brick ? 3 : type_of(made) == ModuleType::hinge ? 1 : 9;
      static_cast<void>(one_digit(made, "slot", made.own_place, most));
    }
    if (!module.contains("children") || module.at("children").is_null()) return made;
    const Json& children = module.at("children");
    if (!children.is_structured()) refuse(made, "children: must be modules by their places");
    std::size_t index = 0;
    for (const auto& [key, child] : children.items()) {
      if (key == line_key) continue;
      const std::string place = children.is_array() ? std::to_string(index++) : key;
      if (child.is_null()) continue;
      made.children.push_back(read_tree(dialect, child, made.line, way + "." + place));
      made.children.back().place = place;
    }
    return made;
  }

  /// The parts and connections of RoboGen's results.
  [[nodiscard]] Part read_connected(const Json& body) const {
    std::vector<Part> parts;
    std::map<std::string, std::size_t> by_name;
    std::optional<std::size_t> root;
    for (const Json& one : list_at(body, "part")) {
      Part made = part(line_of(one), text_at(one, "type"), text_at(one, "id"), "");
      made.turns = text_at(one, "orientation");
      if (parts.size() == most_parts) refuse(made, "more than " + std::to_string(most_parts) + " parts");
      if (!by_name.emplace(made.name, parts.size()).second) refuse(made, "two parts have this id");
      if (text_at(one, "root") == "true" && root) refuse(made, "is a second root");
      if (text_at(one, "root") == "true") root = parts.size();
      parts.push_back(std::move(made));
    }
    if (!root) throw std::invalid_argument{file_ + ": no part has \"root\": true"};
    std::vector<std::vector<std::size_t>> below(parts.size());
    std::vector<std::size_t> above(parts.size(), *root);
    for (const Json& one : list_at(body, "connection")) {
      const Part at = part(line_of(one), "", "", "connection");
      const auto find = [&](const char* key) {
        const auto found = by_name.find(text_at(one, key));
        if (found == by_name.end()) refuse(at, key + (" = " + json_text(text_at(one, key))) + ": is not the id of a part");
        return found->second;
      };
      const std::size_t parent = find("src");
      const std::size_t child = find("dest");
      if (text_at(one, "destSlot") != "0") refuse(at, "destSlot must be 0");
      const auto has_child = [&](const auto& children) { return std::ranges::find(children, child) != children.end(); };
      if (child == *root || std::ranges::any_of(below, has_child)) refuse(at, parts[child].name + " is attached already");
      const int slot = one_digit(at, "srcSlot", text_at(one, "srcSlot"), 9);
      parts[child].place = std::to_string(type_of(parts[parent]) == ModuleType::core ? slot : slot - 1);  // slot 0 is its own
      below[parent].push_back(child);
      above[child] = parent;
    }
    std::vector<std::size_t> order{*root};  // parents first
    for (std::size_t i = 0; i < order.size(); ++i) order.insert(order.end(), below[order[i]].begin(), below[order[i]].end());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (std::ranges::find(order, i) == order.end()) refuse(parts[i], "is not attached to the root");
    }
    for (; order.size() > 1; order.pop_back()) {
      std::vector<Part>& children = parts[above[order.back()]].children;
      children.insert(children.begin(), std::move(parts[order.back()]));
    }
    return std::move(parts[*root]);
  }

  /// A line for each part, TABS SLOT TYPE NAME TURNS [PARAMETERS], until an empty line.
  [[nodiscard]] Part read_lines(std::string_view text) const {
    std::vector<Part> above;  // from the core to the part of the last line
    const auto close = [&](std::size_t depth) {
      for (; above.size() > depth; above.pop_back()) above[above.size() - 2].children.push_back(std::move(above.back()));
    };
    for (std::size_t number = 1; !text.empty(); ++number) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      const std::size_t depth = std::min(line.find_first_not_of('\t'), line.size());
      const std::vector<std::string> words = words_of(line.substr(depth));
      if (words.empty() && above.empty()) continue;
      if (words.empty()) break;  // the brain follows
      Part made = part(std::to_string(number), words.size() > 1 ? words[1] : "", words.size() > 2 ? words[2] : "", "");
      if (words.size() < 4) refuse(made, "must be SLOT TYPE NAME TURNS after one tab for each module above it");
      made.place = std::to_string(one_digit(made, "slot", words[0], 9));
      made.turns = words[3];
      static_cast<void>(one_digit(made, "turns", made.turns, 3));
      if (words.size() > 4 && type_of(made)) refuse(made, words[4] + ": a " + made.type + " has no parameters");
      if (above.empty() ? depth != 0 : depth == 0 || depth > above.size()) {
        refuse(made, std::to_string(depth) + " tabs: must be " + (above.empty() ? "0" : "1 to " + std::to_string(above.size())));
      }
      close(std::max<std::size_t>(depth, 1));
      above.push_back(std::move(made));
    }
    if (above.empty()) throw std::invalid_argument{file_ + ": must begin with a core"};
    close(1);
    return std::move(above.front());
  }

 private:
  [[nodiscard]] static std::string text_at(const Json& object, const std::string& key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (found == object.end() || found->is_null()) return {};
    return found->is_string() ? found->get<std::string>() : json_text(*found);
  }
  [[nodiscard]] static std::string line_of(const Json& object) { return text_at(object, line_key); }

  [[nodiscard]] static std::vector<std::string> words_of(std::string_view line) {
    std::istringstream stream{std::string{line}};
    return {std::istream_iterator<std::string>{stream}, {}};
  }

  [[nodiscard]] const Json& list_at(const Json& body, const std::string& key) const {
    static const Json none = Json::array();
    if (!body.contains(key)) return none;
    const Json& list = body.at(key);
    const auto is_object = [](const Json& one) { return one.is_object(); };
    if (!list.is_array() || !std::ranges::all_of(list, is_object))
      throw std::invalid_argument{file_ + ": " + key + ": must be a list of objects"};
    return list;
  }

  std::string file_;
};

[[nodiscard]] ForeignBody read_any_body(std::string_view text, const std::string& file) {
  const std::string_view format = detail::foreign_format(text);
  const PartReader reader{file};
  const auto finish = [](std::string name, Dialect dialect, const Part& core) {
    ForeignBody body = Assembly{dialect}.assemble(core);
    body.format = std::move(name);
    return body;
  };
  if (format == detail::robogen_text) return finish(std::string{format}, Dialect::robogen, reader.read_lines(text));
  const std::string must = ": must be a body of revolve2 or Revolve (JSON, YAML) or of RoboGen (text, JSON)";
  if (format != "JSON" && format != "YAML") {
    throw std::invalid_argument{file + ": is " + (format.empty() ? "in an unknown format" : std::string{format}) + must};
  }
  std::string yaml{text};
  if (format == "JSON") {
    try {
      static_cast<void>(parse_json(text));
    } catch (const Json::exception& error) {
      throw std::invalid_argument{file + ": " + error.what()};
    }
    std::ranges::replace(yaml, '\t', ' ');  // JSON is YAML whose white space has no tabs; no text of JSON contains one
  }
  const Json whole = read_yaml(yaml, file);
  if (whole.is_object() && whole.contains("body")) {
    const Json& body = whole.at("body");
    if (body.is_object() && body.contains("part")) return finish("RoboGen's JSON", Dialect::robogen, reader.read_connected(body));
    return finish("Revolve's " + std::string{format}, Dialect::revolve, reader.read_tree(Dialect::revolve, body, "1", "core"));
  }
  if (!whole.is_object() || !whole.contains("type"))
    throw std::invalid_argument{file + ": is " + std::string{format} + " without body or type" + must};
  return finish("revolve2's " + std::string{format}, Dialect::revolve2, reader.read_tree(Dialect::revolve2, whole, "1", "core"));
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

ForeignBody read_foreign_body(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  ForeignBody body = read_any_body(text, file);
  if (body.modules.modules().size() < 2) throw std::invalid_argument{file + ": has only a core: must have a hinge or a brick"};
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
