// SPDX-License-Identifier: MIT
// What was observed, as tables in memory: one row per event, one row per robot and tick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <trophic/observe/event.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/population/individual.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// A row of events.csv; see observe::EventLog. Rows are in the order in which things happened.
struct EventRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  observe::EventKind kind = observe::EventKind::birth;
  IndividualId id = 0;
  Species species = 0;
  BodyIndex body = 0;
  bool active = true;
  Origin origin = Origin::random;
  std::optional<Cause> cause;
  std::optional<IndividualId> victim;
  double x_m = 0.0;
  double y_m = 0.0;
};

/// A row of agents.csv; see observe::AgentLog. Rows are sorted by tick.
struct AgentRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  BodyIndex body = 0;
  IndividualId id = 0;
  Species species = 0;
  Origin origin = Origin::random;
  int tag = 1;
  double x_m = 0.0;
  double y_m = 0.0;
  std::optional<IndividualId> adversary;
  std::optional<std::int64_t> hunger_ticks;
};

using Events = std::span<const EventRow>;
using Agents = std::span<const AgentRow>;

/// The members of a species that a metric is about.
enum class Group { all, random, inherited };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Group) {
  return {"all", "random", "inherited"};
}
[[nodiscard]] constexpr bool belongs(Origin origin, Group group) {
  return group == Group::all || (group == Group::random) == (origin == Origin::random);
}

/// The rows of each tick, in order. Views of `agents`, which must outlive them.
[[nodiscard]] inline std::vector<Agents> by_tick(Agents agents) {
  std::vector<Agents> moments;
  for (auto first = agents.begin(); first != agents.end();) {
    const auto last = std::find_if(first, agents.end(), [&](const AgentRow& row) { return row.tick != first->tick; });
    moments.emplace_back(first, last);
    first = last;
  }
  return moments;
}

/// Rows of one tick, found by individual or by body.
class Moment {
 public:
  explicit Moment(Agents rows) : rows_{rows} {
    for (const AgentRow& row : rows) by_id_.emplace_back(row.id, &row);
    std::ranges::sort(by_id_);
  }
  /// None if nobody of that number is alive.
  [[nodiscard]] const AgentRow* find(IndividualId id) const {
    const auto found = std::ranges::lower_bound(by_id_, id, {}, &std::pair<IndividualId, const AgentRow*>::first);
    return found != by_id_.end() && found->first == id ? found->second : nullptr;
  }
  /// None if no row of this tick has that body.
  [[nodiscard]] const AgentRow* find_body(BodyIndex body) const {
    // A log lists bodies by their numbers: the first place to look at is nearly always the right one.
    if (body < rows_.size() && rows_[body].body == body) return &rows_[body];
    const auto found = std::ranges::find(rows_, body, &AgentRow::body);
    return found != rows_.end() ? &*found : nullptr;
  }

 private:
  Agents rows_;
  std::vector<std::pair<IndividualId, const AgentRow*>> by_id_;
};

/// A share of a whole; none of an empty whole.
[[nodiscard]] constexpr std::optional<double> share(double part, double whole) {
  return whole > 0.0 ? std::optional{part / whole} : std::nullopt;
}

}  // namespace trophic::analysis
