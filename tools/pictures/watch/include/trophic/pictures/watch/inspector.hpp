// SPDX-License-Identifier: MIT
// Texts of a window: the moment, and the data of the selected robot.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <trophic/observe/progress.hpp>
#include <trophic/pictures/watch/controls.hpp>
#include <trophic/pictures/watch/live_footage.hpp>

namespace trophic::watch {

/// Two columns, lines separated by \n.
struct Columns {
  std::string left;
  std::string right;

  void add(const std::string& name, const std::string& value) {
    if (!left.empty()) {
      left += '\n';
      right += '\n';
    }
    left += name;
    right += value;
  }
};

/// "robot 17", "robot 17 (dead)"; empty if none is selected.
[[nodiscard]] inline std::string chosen_text(const Controls& controls, const LiveFootage& footage) {
  if (!controls.selected()) return {};
  return "robot " + std::to_string(*controls.selected()) + (controls.selected_body(footage) ? "" : " (dead)");
}

/// "60.0 s, 10x, robot 17".
[[nodiscard]] inline std::string moment_text(const Controls& controls, const LiveFootage& footage, bool has_ended) {
  std::string text = controls.clock().text();
  if (controls.seeks_catch()) return text + ", on to the next catch";
  if (controls.scene()) {
    return controls.clock().time_text() + ", 1x, " + controls.scene()->text(controls.clock().time_s());
  }
  if (has_ended && controls.clock().time_s() >= footage.newest_s()) text += ", the run has ended";
  const std::string chosen = chosen_text(controls, footage);
  return chosen.empty() ? text : text + ", " + chosen;
}

/// The row of the selected robot in agents.csv, and its parent and age.
[[nodiscard]] inline Columns inspected(const Controls& controls, const LiveFootage& footage) {
  Columns columns;
  if (!controls.selected()) return columns;
  columns.add("robot", std::to_string(*controls.selected()));
  const auto body = controls.selected_body(footage);
  if (!body) {
    columns.add("", "dead");
    return columns;
  }
  const double time_s = controls.clock().time_s();
  const io::AgentRow& row = footage.rows_at(time_s)[*body];
  const Ancestry& ancestry = footage.ancestry(time_s, *body);
  const auto degrees = [](double rad) { return observe::short_text(rad * 180.0 / std::numbers::pi) + " deg"; };
  columns.add("species", footage.species(row.species));
  columns.add("tag", (row.tag > 0 ? "+" : "") + std::to_string(row.tag));
  columns.add("age", observe::short_text(ancestry.age_s) + " s");
  if (!row.active) columns.add("", "not active yet");
  if (row.hunger_ticks) columns.add("hunger", std::to_string(*row.hunger_ticks) + " ticks");
  columns.add("origin", row.origin == Origin::random ? "random" : "inherited");
  columns.add("parent", ancestry.parent ? std::to_string(*ancestry.parent) : "none");
  columns.add("sees", row.adversary ? std::to_string(*row.adversary) : "none");
  if (row.adversary_distance_m) columns.add("at", observe::short_text(*row.adversary_distance_m) + " m");
  columns.add("turns by", degrees(row.target_angle_rad));
  columns.add("body", std::to_string(row.body));
  return columns;
}

}  // namespace trophic::watch
