// SPDX-License-Identifier: MIT
// Definitions of sweep_file.hpp.
#include <tools/command/read_parameters.hpp>
#include <tools/command/words.hpp>
#include <tools/sweep/sweep_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::sweep {

namespace detail {

/// A node of a table under its path, with its place in the file.
struct Leaf {
  std::string path;
  const toml::node* node = nullptr;
};

[[nodiscard]] inline bool stands_before(const Leaf& a, const Leaf& b) {
  const auto place = [](const Leaf& leaf) {
    const toml::source_position& begin = leaf.node->source().begin;
    return std::pair{begin.line, begin.column};
  };
  return place(a) < place(b);
}

inline void append_leaves(const toml::table& table, const std::string& prefix, std::vector<Leaf>& leaves) {
  for (const auto& [key, node] : table) {
    const std::string path = join_path(prefix, key.str());
    if (const toml::table* nested = node.as_table()) {
      append_leaves(*nested, path, leaves);
    } else {
      leaves.push_back({path, &node});
    }
  }
}

/// All values of a table that are not tables, in the order of the file.
[[nodiscard]] inline std::vector<Leaf> leaves_of(const toml::table& table) {
  std::vector<Leaf> leaves;
  append_leaves(table, "", leaves);
  std::ranges::stable_sort(leaves, stands_before);
  return leaves;
}

/// A number, text or switch. Throws std::invalid_argument for anything else.
[[nodiscard]] inline Json value_of(const toml::node& node, const std::string& path) {
  if (const auto flag = node.value_exact<bool>()) return *flag;
  if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
  if (const auto text = node.value_exact<std::string>()) return *text;
  const auto number = node.value_exact<double>();
  if (!number || !std::isfinite(*number)) command::reject_value(path, node, "a finite number, a text, true or false");
  return *number;
}

[[nodiscard]] inline Settings settings_of(const toml::table& table) {
  Settings settings = Settings::object();
  for (const Leaf& leaf : leaves_of(table)) settings[leaf.path] = value_of(*leaf.node, leaf.path);
  return settings;
}

[[nodiscard]] inline std::vector<Axis> axes_of(const toml::table& table, const std::string& section) {
  std::vector<Axis> axes;
  for (const Leaf& leaf : leaves_of(table)) {
    const toml::array* values = leaf.node->as_array();
    const std::string where = "[" + section + "] " + leaf.path;
    if (values == nullptr) command::reject_value(where, *leaf.node, "a list of values; what is the same in all runs is in [set]");
    if (values->empty()) throw std::invalid_argument{where + " = []: must have a value"};
    Axis axis{leaf.path, {}};
    for (const toml::node& value : *values) axis.values.push_back(value_of(value, where));
    axes.push_back(std::move(axis));
  }
  if (axes.empty()) throw std::invalid_argument{"[" + section + "]: is empty"};
  return axes;
}

/// Removes a section from a table and passes it to `read`.
template <class Read>
void take_section(toml::table& table, const std::string& name, Read&& read) {
  const toml::node* node = table.get(name);
  if (node == nullptr) return;
  if (!node->is_table()) throw std::invalid_argument{name + ": must be a section, [" + name + "]"};
  read(*node->as_table());
  table.erase(name);
}

inline void take_runs(toml::table& table, std::vector<Settings>& runs) {
  const toml::node* node = table.get("runs");
  if (node == nullptr) return;
  const toml::array* all = node->as_array();
  if (all == nullptr || all->empty() || !all->is_homogeneous(toml::node_type::table)) {
    throw std::invalid_argument{"runs: must be sections, [[runs]]"};
  }
  for (const toml::node& one : *all) runs.push_back(settings_of(*one.as_table()));
  table.erase("runs");
}

/// Throws std::invalid_argument for a key that more than one section sets, and for sections that do not fit each other.
inline void check(const SweepFile& sweep) {
  if (sweep.grid.empty() && sweep.zip.empty() && sweep.runs.empty()) {
    throw std::invalid_argument{"has neither [grid] nor [zip] nor [[runs]]: nothing varies"};
  }
  std::vector<std::pair<std::string, std::string>> seen;
  const auto see = [&](const std::string& key, const std::string& section) {
    const auto other = std::ranges::find(seen, key, &std::pair<std::string, std::string>::first);
    if (other == seen.end()) {
      seen.emplace_back(key, section);
    } else if (other->second != section || section != "[[runs]]") {
      throw std::invalid_argument{key + ": is in " + other->second + " and in " + section};
    }
    for (const char* no_setting : {"seed", "backend.threads"}) {
      if (key == no_setting) throw std::invalid_argument{section + " " + key + ": is not a setting of a sweep"};
    }
  };
  for (const auto& [key, value] : sweep.set.items()) see(key, "[set]");
  for (const Axis& axis : sweep.grid) see(axis.key, "[grid]");
  for (const Axis& axis : sweep.zip) see(axis.key, "[zip]");
  for (const Settings& run : sweep.runs) {
    for (const auto& [key, value] : run.items()) see(key, "[[runs]]");
  }
  for (const Axis& axis : sweep.zip) {
    const Axis& first = sweep.zip.front();
    if (axis.values.size() == first.values.size()) continue;
    throw std::invalid_argument{"[zip] " + axis.key + ": has " + std::to_string(axis.values.size()) + " values: must have " +
                                std::to_string(first.values.size()) + ", as " + first.key};
  }
  std::size_t runs = sweep.params.replicates * (sweep.params.shadow ? 2 : 1);
  const auto multiply = [&](std::size_t by) {
    runs *= by;
    if (runs <= most_runs) return;
    throw std::invalid_argument{"makes more than " + std::to_string(most_runs) + " runs (cells x replicates): must be fewer"};
  };
  multiply(std::max<std::size_t>(1, sweep.runs.size()));
  if (!sweep.zip.empty()) multiply(sweep.zip.front().values.size());
  for (const Axis& axis : sweep.grid) multiply(axis.values.size());
}

/// Throws std::invalid_argument for a misspelt section or parameter, with the nearest one.
inline void check_keys(const toml::table& table, const ParamRefs& params) {
  std::vector<std::string> known{"set", "grid", "zip", "runs", "rule_table", "engine"};
  for (const ParamRef& param : params) known.push_back(param.path);
  if (table.contains("neutral")) {
    throw std::invalid_argument{"neutral: a sweep makes no neutral nulls; run a cell's settings with --replicates and --neutral"};
  }
  for (const auto& [key, node] : table) {
    const auto nearest = command::nearest_word(key.str(), known);
    if (!nearest) continue;
    const std::string name = node.is_table() ? "[" + std::string{key.str()} + "]" : std::string{key.str()};
    throw std::invalid_argument{name + ": unknown key" + command::did_you_mean(nearest)};
  }
}

[[nodiscard]] inline SweepFile sweep_of(toml::table table) {
  SweepFile sweep;
  take_section(table, "set", [&](const toml::table& section) { sweep.set = settings_of(section); });
  take_section(table, "grid", [&](const toml::table& section) { sweep.grid = axes_of(section, "grid"); });
  take_section(table, "zip", [&](const toml::table& section) { sweep.zip = axes_of(section, "zip"); });
  take_runs(table, sweep.runs);
  for (const char* choice : {"rule_table", "engine"}) {
    const auto name = command::take_choice(table, choice);
    if (name && sweep.set.contains(choice)) throw std::invalid_argument{std::string{choice} + ": is there twice"};
    if (name) sweep.set[choice] = *name;
  }
  check_keys(table, param_refs(sweep.params));
  command::read_parameters(sweep.params, table);
  validate(sweep.params, "");
  constexpr std::array rates{0.0, 5.0, 10.0, 30.0};
  if (std::ranges::find(rates, sweep.params.replay_hz) == rates.end()) {
    throw std::invalid_argument{"replay_hz = " + number_text(sweep.params.replay_hz) + ": must be 0, 5, 10 or 30"};
  }
  check(sweep);
  return sweep;
}

inline void join(Settings& to, const Settings& from) {
  for (const auto& [key, value] : from.items()) to[key] = value;
}

}  // namespace detail

SweepFile read_sweep(const std::filesystem::path& path) {
  const std::string text = read_whole_file(path);
  try {
    SweepFile sweep = detail::sweep_of(parse_toml(text));
    sweep.path = path;
    sweep.text = text;
    return sweep;
  } catch (const TomlError& error) {
    throw std::invalid_argument{path.string() + ":" + std::to_string(error.line()) + ": " + error.what()};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument{path.string() + ": " + error.what()};
  }
}

std::vector<Settings> cells_of(const SweepFile& sweep) {
  std::vector<Settings> cells{sweep.set};
  /// Every cell with each of some settings.
  const auto times = [&](const std::vector<Settings>& each) {
    std::vector<Settings> product;
    product.reserve(cells.size() * each.size());
    for (const Settings& cell : cells) {
      for (const Settings& settings : each) {
        product.push_back(cell);
        detail::join(product.back(), settings);
      }
    }
    cells = std::move(product);
  };
  if (!sweep.runs.empty()) times(sweep.runs);
  if (!sweep.zip.empty()) {
    std::vector<Settings> rows(sweep.zip.front().values.size(), Settings::object());
    for (const Axis& axis : sweep.zip) {
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i][axis.key] = axis.values[i];
    }
    times(rows);
  }
  for (const Axis& axis : sweep.grid) {
    std::vector<Settings> values;
    for (const auto& value : axis.values) values.push_back(Settings{{axis.key, value}});
    times(values);
  }
  return cells;
}

std::string text_of(const Settings& cell, const SweepFile& sweep) {
  std::string text;
  for (const auto& [key, value] : cell.items()) {
    if (sweep.set.contains(key)) continue;
    text += (text.empty() ? "" : " ") + key + "=" + (value.is_string() ? value.get<std::string>() : json_text(value));
  }
  return text;
}

}  // namespace trophic::sweep
