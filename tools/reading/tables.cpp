// SPDX-License-Identifier: MIT
// Definitions of tables.hpp.
#include <tools/reading/tables.hpp>

namespace trophic::analysis {

bool belongs(const AgentRow& row, Group group) {
  return belongs(row.origin, row.active, group);
}

std::vector<Agents> by_tick(Agents agents) {
  std::vector<Agents> moments;
  for (auto first = agents.begin(); first != agents.end();) {
    const auto last = std::find_if(first, agents.end(), [&](const AgentRow& row) { return row.tick != first->tick; });
    moments.emplace_back(first, last);
    first = last;
  }
  return moments;
}

Moment::Moment(Agents rows) : rows_{rows} {
  for (const AgentRow& row : rows) by_id_.emplace_back(row.id, &row);
  std::ranges::sort(by_id_);
}

const AgentRow* Moment::find(IndividualId id) const {
  const auto found = std::ranges::lower_bound(by_id_, id, {}, &std::pair<IndividualId, const AgentRow*>::first);
  return found != by_id_.end() && found->first == id ? found->second : nullptr;
}

const AgentRow* Moment::find_body(BodyIndex body) const {
  // A log lists bodies by their numbers: the first place to look at is nearly always the right one.
  if (body < rows_.size() && rows_[body].body == body) return &rows_[body];
  const auto found = std::ranges::find(rows_, body, &AgentRow::body);
  return found != rows_.end() ? &*found : nullptr;
}

std::vector<Stretch> stretches(Agents agents, std::int64_t ticks) {
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
