// SPDX-License-Identifier: MIT
// What was observed, as tables in memory: one row per event, one row per robot and tick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <trophic/observe/tables.hpp>
#include <trophic/population/individual.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

using observe::AgentRow;  ///< sorted by tick
using observe::EventRow;  ///< in the order in which things happened
using Events = std::span<const EventRow>;
using Agents = std::span<const AgentRow>;

/// The members of a species that a metric is about: by the origin of their genome, or those that are active at that tick.
enum class Group { all, random, inherited, active, inherited_active };
[[nodiscard]] constexpr std::array<std::string_view, 5> enum_names(Group) {
  return {"all", "random", "inherited", "active", "inherited_active"};
}
[[nodiscard]] constexpr bool belongs(Origin origin, bool active, Group group) {
  switch (group) {
    case Group::all:
      return true;
    case Group::random:
      return origin == Origin::random;
    case Group::inherited:
      return origin == Origin::inherited;
    case Group::active:
      return active;
    case Group::inherited_active:
      return active && origin == Origin::inherited;
  }
  return false;
}
[[nodiscard]] inline bool belongs(const AgentRow& row, Group group) {
  return belongs(row.origin, row.active, group);
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

/// The rows of a tick, and those of the one `ticks` later: empty where the run has none.
struct Stretch {
  Agents start;
  Agents end;
};

/// One stretch from each tick, in order. `ticks` > 0.
[[nodiscard]] inline std::vector<Stretch> stretches(Agents agents, std::int64_t ticks) {
  const std::vector<Agents> moments = by_tick(agents);
  std::vector<Stretch> all;
  std::size_t later = 0;
  for (const Agents& now : moments) {
    const std::int64_t tick = now.front().tick + ticks;
    while (later < moments.size() && moments[later].front().tick < tick) ++later;
    const bool has_end = later < moments.size() && moments[later].front().tick == tick;
    all.push_back({now, has_end ? moments[later] : Agents{}});
  }
  return all;
}

}  // namespace trophic::analysis
