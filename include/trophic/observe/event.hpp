// SPDX-License-Identifier: MIT
// The events in the life of individuals, as observers get them.
#pragma once

#include <trophic/population/individual.hpp>

namespace trophic::observe {

enum class EventKind { birth, activation, tag_switch, capture, death };
[[nodiscard]] constexpr std::array<std::string_view, 5> enum_names(EventKind) {
  return {"birth", "activation", "tag_switch", "catch", "death"};
}

/// One event of one individual. `individual` is its state at the event: a newborn after mutation, a dying individual before its
/// body is replaced, a switching one with its new tag.
struct Event {
  EventKind kind = EventKind::birth;
  BodyIndex body = 0;
  const Individual& individual;       ///< valid during the call
  std::optional<Cause> cause;         ///< cause of a death
  std::optional<IndividualId> other;  ///< catch: the victim; death by being caught: the killer
};

}  // namespace trophic::observe
