// SPDX-License-Identifier: MIT
// What happens to individuals, as observers are told.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <trophic/population/individual.hpp>

namespace trophic::observe {

enum class EventKind { birth, activation, tag_switch, capture, death };
[[nodiscard]] constexpr std::array<std::string_view, 5> enum_names(EventKind) {
  return {"birth", "activation", "tag_switch", "catch", "death"};
}

/// One thing that happened to one individual. `individual` is as it was when it happened: a newborn after its mutation, a dying
/// one before its body is handed on, a switching one with its new tag.
struct Event {
  EventKind kind = EventKind::birth;
  BodyIndex body = 0;
  const Individual& individual;       ///< valid during the call
  std::optional<Cause> cause;         ///< of a death
  std::optional<IndividualId> other;  ///< catch: the victim; death by being caught: the killer
};

}  // namespace trophic::observe
