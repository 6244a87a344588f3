// SPDX-License-Identifier: MIT
// states.csv: what rules with a State keep for every robot at every tick.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <trophic/observe/csv.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/rule_states.hpp>
#include <type_traits>

namespace trophic::observe {

/// One row per robot and tick, after that tick's rules: `StateLog log{path, ecology.states()};`. Refers to the states.
/// Columns: time_s, tick, body, id, then SLOT.MEMBER for each member of each State of the table: numbers exact, an Ancestor by
/// its id, a vector's numbers with spaces between, nothing as an empty cell.
template <class Rules>
class StateLog {
 public:
  static constexpr std::string_view section = "states.csv";

  StateLog(const std::filesystem::path& path, const RuleStates<Rules>& states, Opening opening = Opening::made_new)
      : states_{states}, file_{path, header(), opening} {}

  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      cell(view.time_s);
      cell(view.tick);
      cell(body);
      cell(view.robots[body].id);
      for_each_state(states_, [&](std::string_view, const auto& states) { write(states[body]); });
      file_.buffer().back() = '\n';
    }
    file_.flush();
  }

  void persist(Archive& archive) { archive(file_); }

 private:
  static std::string header() {
    std::string text = "time_s,tick,body,id";
    for_each_state(RuleStates<Rules>{}, [&]<class P>(std::string_view slot, const BodyStates<P>&) {
      append_names(StateOf<P>{}, std::string{slot}, text);
    });
    return text + "\n";
  }

  template <class State>
  static void append_names(const State& state, const std::string& path, std::string& text) {
    for_each_field(state, [&](const auto& f, const auto& value) {
      const std::string name = join_path(path, f.name);
      if constexpr (HasFields<std::remove_cvref_t<decltype(value)>>) {
        append_names(value, name, text);
      } else if constexpr (!std::is_empty_v<std::remove_cvref_t<decltype(value)>>) {
        text += "," + name;
      }
    });
  }

  template <class Value>
  void cell(const Value& value) {
    detail::append_cell(file_.buffer(), value);
    file_.buffer().push_back(',');
  }

  template <class State>
  void write(const State& state) {
    for_each_field(state, [&](const auto&, const auto& value) {
      using T = std::remove_cvref_t<decltype(value)>;
      if constexpr (HasFields<T>) {
        write(value);
      } else if constexpr (std::same_as<T, Ancestor>) {
        cell(value.id);
      } else if constexpr (std::same_as<T, std::optional<Ancestor>>) {
        cell(value ? std::optional{value->id} : std::nullopt);
      } else if constexpr (requires { value.begin(); }) {
        std::string text;
        for (const auto& one : value) text += (text.empty() ? "" : " ") + number_text(one);
        cell(text);
      } else if constexpr (!std::is_empty_v<T>) {
        cell(value);
      }
    });
  }

  const RuleStates<Rules>& states_;
  LineFile file_;
};

}  // namespace trophic::observe
