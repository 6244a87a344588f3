// SPDX-License-Identifier: MIT
// The tables of a run in memory: one row per event, one row per robot and tick.
#pragma once

#include <span>
#include <trophic/io/tables.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::analysis {

using io::AgentRow;  ///< sorted by tick
using io::EventRow;  ///< in the order in which things happened
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
[[nodiscard]] bool belongs(const AgentRow& row, Group group);

/// The rows of each tick, in order. Views of `agents`, which must outlive them.
[[nodiscard]] std::vector<Agents> by_tick(Agents agents);

/// Rows of one tick, found by individual or by body.
class Moment {
 public:
  explicit Moment(Agents rows);
  /// Null if no individual of that number is alive.
  [[nodiscard]] const AgentRow* find(IndividualId id) const;
  /// None if no row of this tick has that body.
  [[nodiscard]] const AgentRow* find_body(BodyIndex body) const;

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
[[nodiscard]] std::vector<Stretch> stretches(Agents agents, std::int64_t ticks);

}  // namespace trophic::analysis
