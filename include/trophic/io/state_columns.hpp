// SPDX-License-Identifier: MIT
// States of rules as columns of a table.
#pragma once

#include <optional>
#include <trophic/io/csv.hpp>
#include <trophic/params/params.hpp>
#include <trophic/rules/rule_states.hpp>

namespace trophic::io {

namespace detail {

template <class State>
void append_names(const State& state, const std::string& path, StateColumns& columns) {
  for_each_field(state, [&]<class Value>(const auto& f, const Value& value) {
    const std::string name = join_path(path, f.name);
    if constexpr (HasFields<Value>) {
      append_names(value, name, columns);
    } else if constexpr (!std::is_empty_v<Value>) {
      constexpr bool is_ancestor = std::same_as<Value, Ancestor> || std::same_as<Value, std::optional<Ancestor>>;
      columns.columns.emplace_back(name, is_ancestor ? "int64" : type_name<Value>);
    }
  });
}

template <class State>
void append_state(const State& state, std::string& row) {
  for_each_field(state, [&]<class Value>(const auto&, const Value& value) {
    if constexpr (HasFields<Value>) {
      append_state(value, row);
    } else if constexpr (!std::is_empty_v<Value>) {
      row.push_back(',');
      if constexpr (std::same_as<Value, Ancestor>) {
        append_cell(row, value.id);
      } else if constexpr (std::same_as<Value, std::optional<Ancestor>>) {
        append_cell(row, value ? std::optional{value->id} : std::nullopt);
      } else if constexpr (requires { value.begin(); }) {
        std::string text;
        for (const auto& one : value) text += (text.empty() ? "" : " ") + number_text(one);
        append_cell(row, text);
      } else {
        append_cell(row, value);
      }
    }
  });
}

}  // namespace detail

/// The columns SLOT.MEMBER of all States of a table. Refers to them.
template <class Rules>
[[nodiscard]] StateColumns state_columns(const RuleStates<Rules>& states) {
  StateColumns columns;
  for_each_state(states, [&]<class P>(std::string_view slot, const BodyStates<P>&) {
    detail::append_names(StateOf<P>{}, std::string{slot}, columns);
  });
  columns.append = [&states](BodyIndex body, std::string& row) {
    for_each_state(states, [&](std::string_view, const auto& of_slot) { detail::append_state(of_slot[body], row); });
  };
  return columns;
}

}  // namespace trophic::io
