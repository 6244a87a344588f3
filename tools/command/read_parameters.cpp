// SPDX-License-Identifier: MIT
// Definitions of read_parameters.hpp.
#include <algorithm>
#include <stdexcept>
#include <tools/command/read_parameters.hpp>
#include <trophic/params/toml_text.hpp>

namespace trophic::command {

namespace {

/// The enumerator that a text names.
[[nodiscard]] std::int64_t read_choice(const WholeRef& target, const toml::node& node, const std::string& path) {
  const auto name = node.value_exact<std::string>();
  std::string choices;
  for (std::size_t index = 0; index < target.names.size(); ++index) {
    if (name && *name == target.names[index]) return static_cast<std::int64_t>(index);
    choices += (index == 0 ? "" : " or ") + std::string{target.names[index]};
  }
  reject_value(path, node, choices);
}

[[nodiscard]] std::int64_t read_whole(const WholeRef& target, const toml::node& node, const std::string& path) {
  const auto value = node.value_exact<std::int64_t>();
  if (!value) reject_value(path, node, "a whole number");
  if (*value < target.lowest) reject_value(path, node, ">= " + number_text(target.lowest));
  if (std::cmp_greater(*value, target.largest)) reject_value(path, node, "<= " + number_text(target.largest));
  return *value;
}

/// The kinds of a parameter's target, each read in its own way.
struct ReadValue {
  const toml::node& node;
  const std::string& path;

  void operator()(std::monostate) const {}
  void operator()(bool* target) const {
    const auto value = node.value_exact<bool>();
    if (!value) reject_value(path, node, "true or false");
    *target = *value;
  }
  void operator()(double* target) const {
    if (!node.is_number()) reject_value(path, node, "a number");
    const auto value = node.value<double>();
    if (!value) reject_value(path, node, "from -2^53 to 2^53, or have a decimal point");
    *target = *value;
  }
  void operator()(std::string* target) const {
    const auto value = node.value_exact<std::string>();
    if (!value) reject_value(path, node, "a text");
    *target = *value;
  }
  void operator()(const WholeRef& target) const {
    target.set(target.value, target.names.empty() ? read_whole(target, node, path) : read_choice(target, node, path));
  }
};

[[nodiscard]] bool is_group(const ParamRef& param) {
  return std::holds_alternative<std::monostate>(param.target);
}

/// "known here: a, b": the keys directly below a path that ends with its dot.
[[nodiscard]] std::string known_below(const ParamRefs& params, const std::string& prefix) {
  std::string keys;
  std::string last;
  for (const ParamRef& param : params) {
    if (!param.path.starts_with(prefix)) continue;
    std::string key = param.path.substr(prefix.size());
    key.resize(std::min(key.find('.'), key.size()));
    if (key.empty() || key == last) continue;
    keys += (keys.empty() ? "" : ", ") + key;
    last = std::move(key);
  }
  return keys.empty() ? "this rule has no parameters" : "known here: " + keys;
}

void read_below(const ParamRefs& params, const toml::table& table, const std::string& prefix) {
  for (const auto& [key, node] : table) {
    const std::string path = prefix + std::string{key.str()};
    const auto exact = std::ranges::find(params, path, &ParamRef::path);
    if (exact != params.end() && !is_group(*exact)) {
      std::visit(ReadValue{node, path}, exact->target);
      continue;
    }
    const auto below = std::ranges::any_of(params, [&](const ParamRef& param) { return param.path.starts_with(path + "."); });
    if (exact == params.end() && !below) throw std::invalid_argument{path + ": unknown key; " + known_below(params, prefix)};
    if (!node.is_table()) reject_value(path, node, "a table of parameters");
    read_below(params, *node.as_table(), path + ".");
  }
}

}  // namespace

void reject_value(const std::string& path, const toml::node& value, std::string_view must) {
  throw std::invalid_argument{path + " = " + toml_text(value) + ": must be " + std::string{must}};
}

void read_parameters(const ParamRefs& params, const toml::table& table) {
  read_below(params, table, "");
}

std::optional<std::string> take_choice(toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto name = node->value_exact<std::string>();
  if (!name) throw std::invalid_argument{std::string{key} + ": must be a text"};
  table.erase(key);
  return name;
}

toml::table read_assignment(std::string_view assignment) {
  const auto equals = assignment.find('=');
  const auto bad = [&] {
    const std::string said = assignment.size() <= 80 ? std::string{assignment} : std::string{assignment.substr(0, 77)} + "...";
    return std::invalid_argument{"\"" + said + "\": must be PATH=VALUE, e.g. rules.mutation.sd=0.1"};
  };
  if (equals == std::string_view::npos || equals == 0) throw bad();
  try {
    return parse_toml(assignment);
  } catch (const TomlError&) {
    try {
      const toml::value<std::string> text{std::string{assignment.substr(equals + 1)}};
      return parse_toml(std::string{assignment.substr(0, equals + 1)} + toml_text(text));
    } catch (const TomlError&) {
      throw bad();
    }
  }
}

}  // namespace trophic::command
