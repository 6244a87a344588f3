// SPDX-License-Identifier: MIT
// Parameters from a configuration file, which may be for a different table or backend, and from --set.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <tools/command/read_parameters.hpp>
#include <tools/command/words.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::command {

/// Parameters of --config and --set, and those of the run that --from names.
struct Config {
  toml::table origin;  ///< read before the file: all parameters of the run that --from names
  std::string file;    ///< empty if none was named; errors begin with it
  toml::table parameters;
  std::optional<std::string> rule_table;
  std::optional<std::string> engine;
  std::vector<std::string> assignments;
};

/// Reads the configuration file, if one is named. Throws as parse_toml_file does.
[[nodiscard]] inline Config read_config(const std::string& file, std::vector<std::string> assignments) {
  Config config{
      .origin = {}, .file = file, .parameters = {}, .rule_table = {}, .engine = {}, .assignments = std::move(assignments)};
  if (file.empty()) return config;
  config.parameters = parse_toml_file(file);
  config.rule_table = take_choice(config.parameters, "rule_table");
  config.engine = take_choice(config.parameters, "engine");
  return config;
}

/// Throws std::invalid_argument if the file has parameters of a backend or of a rule table that is not the chosen one.
inline void check_made_for(const Config& config, const std::string& rule_table, const std::string& engine) {
  const auto check = [&](const std::optional<std::string>& there, const std::string& here, const std::string& key,
                         const std::string& option, const std::string& section) {
    const toml::table* parameters = config.parameters[section].as_table();
    if (!there || *there == here || parameters == nullptr || parameters->empty()) return;
    throw std::invalid_argument{config.file + ": is for " + key + " = \"" + *there + "\", whose parameters are in [" + section +
                                "], not for " + here + "; use " + option + " " + *there + ", or a file without " + key +
                                " and [" + section + "]"};
  };
  check(config.engine, engine, "engine", "--backend", "backend");
  check(config.rule_table, rule_table, "rule_table", "--rules", "rules");
}

/// The parameter that an unknown path probably means: one with the same ending ("mutation.sd" for "rules.mutation.sd"), or the
/// nearest of those that share most of its leading sections.
[[nodiscard]] inline std::optional<std::string> nearest_path(const std::string& path, const ParamRefs& params) {
  std::vector<std::string> ending;
  for (const ParamRef& param : params) {
    if (param.path.ends_with("." + path)) ending.push_back(param.path);
  }
  if (ending.size() == 1) return ending.front();

  std::string shared;
  std::vector<std::string> rests;
  for (std::size_t dot = path.rfind('.'); rests.empty(); dot = dot == 0 ? std::string::npos : path.rfind('.', dot - 1)) {
    shared = dot == std::string::npos ? "" : path.substr(0, dot + 1);
    for (const ParamRef& param : params) {
      if (param.path.starts_with(shared)) rests.push_back(param.path.substr(shared.size()));
    }
    if (shared.empty()) break;
  }
  const auto rest = nearest_word(std::string_view{path}.substr(shared.size()), rests);
  return rest ? std::optional{shared + *rest} : std::nullopt;
}

namespace detail {

inline void check_keys(const toml::table& table, const std::string& prefix, const ParamRefs& params, const std::string& where) {
  for (const auto& [key, node] : table) {
    const std::string path = join_path(prefix, key.str());
    const bool known = std::ranges::any_of(params, [&](const ParamRef& param) { return param.path == path; });
    if (known) continue;
    if (const toml::table* nested = node.as_table()) {
      check_keys(*nested, path, params, where);
      continue;
    }
    const auto meant = nearest_path(path, params);
    if (meant) throw std::invalid_argument{where + path + ": unknown key" + did_you_mean(meant)};
  }
}

}  // namespace detail

/// Throws std::invalid_argument "WHERE PATH: unknown key; did you mean ...?" for the first unknown key of a table that is similar
/// to one of these parameters. read_parameters refuses the other unknown keys.
inline void check_keys(const toml::table& table, const ParamRefs& params, const std::string& where) {
  detail::check_keys(table, "", params, where);
}

/// Sets the parameters of the file, then each assignment. Throws std::invalid_argument for an unknown or invalid one, with the
/// file's name if the error is in the file.
inline void apply_config(const ParamRefs& params, const Config& config) {
  read_parameters(params, config.origin);
  if (!config.parameters.empty()) {
    const std::string where = config.file.empty() ? "" : config.file + ": ";
    check_keys(config.parameters, params, where);
    try {
      read_parameters(params, config.parameters);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument{where + error.what()};
    }
  }
  for (const std::string& assignment : config.assignments) {
    const toml::table table = read_assignment(assignment);
    check_keys(table, params, "--set ");
    read_parameters(params, table);
  }
}

}  // namespace trophic::command
