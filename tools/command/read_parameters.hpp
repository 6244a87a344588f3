// SPDX-License-Identifier: MIT
// Reads parameters from TOML tables and from "path=value" texts; unknown keys are errors.
#pragma once

#include <optional>
#include <trophic/params/named_params.hpp>
#include <trophic/params/parse_toml.hpp>

namespace trophic::command {

/// Sets the parameters that a table names. Throws std::invalid_argument "PATH: unknown key ..." or "PATH = VALUE: must be ...".
/// Bounds are checked by `validate`, not here.
void read_parameters(const ParamRefs& params, const toml::table& table);

template <class P>
void read_parameters(P& params, const toml::table& table) {
  read_parameters(param_refs(params), table);
}

/// Throws std::invalid_argument "PATH = VALUE: must be MUST".
[[noreturn]] void reject_value(const std::string& path, const toml::node& value, std::string_view must);

/// Removes the choice under `key` from a configuration file and returns it. Throws std::invalid_argument if it is not a text.
[[nodiscard]] std::optional<std::string> take_choice(toml::table& table, std::string_view key);

/// Returns the table of an assignment such as "rules.mutation.sd=0.1". A value that is not a TOML value is read as text:
/// "ecology.robot=gecko". Throws std::invalid_argument if the text is not an assignment.
[[nodiscard]] toml::table read_assignment(std::string_view assignment);

}  // namespace trophic::command
