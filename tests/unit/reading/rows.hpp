// SPDX-License-Identifier: MIT
// Short ways to write events and agents by hand: a web of prey (0) and predators (1).
#pragma once

#include <tools/reading/tables.hpp>

namespace trophic::test {

inline constexpr Species prey = 0;
inline constexpr Species predator = 1;
inline const FoodWeb prey_and_predators{{"prey", "predator"}, {{.hunter = predator, .victim = prey}}};

inline analysis::EventRow birth(double time_s, IndividualId id, Species species, BodyIndex body, Origin origin,
                                bool active = true) {
  return {.time_s = time_s,
          .kind = observe::EventKind::birth,
          .id = id,
          .species = species,
          .body = body,
          .active = active,
          .origin = origin,
          .cause = {},
          .victim = {}};
}
inline analysis::EventRow activation(double time_s, IndividualId id, Species species, BodyIndex body, Origin origin) {
  return {.time_s = time_s,
          .kind = observe::EventKind::activation,
          .id = id,
          .species = species,
          .body = body,
          .origin = origin,
          .cause = {},
          .victim = {}};
}
inline analysis::EventRow capture(double time_s, IndividualId id, Species species, BodyIndex body, Origin origin,
                                  IndividualId victim) {
  return {.time_s = time_s,
          .kind = observe::EventKind::capture,
          .id = id,
          .species = species,
          .body = body,
          .origin = origin,
          .cause = {},
          .victim = victim};
}
inline analysis::EventRow death(double time_s, IndividualId id, Species species, BodyIndex body, Origin origin, Cause cause) {
  return {.time_s = time_s,
          .kind = observe::EventKind::death,
          .id = id,
          .species = species,
          .body = body,
          .origin = origin,
          .cause = cause,
          .victim = {}};
}

/// A robot at a tick of 2 s; its body has the number of its individual.
inline analysis::AgentRow robot(std::int64_t tick, IndividualId id, Species species, double x_m, double y_m,
                                std::optional<IndividualId> adversary = {}, Origin origin = Origin::inherited, int tag = 1) {
  return {.time_s = 2.0 * static_cast<double>(tick),
          .tick = tick,
          .body = id,
          .id = id,
          .species = species,
          .origin = origin,
          .tag = tag,
          .x_m = x_m,
          .y_m = y_m,
          .adversary = adversary,
          .hunger_ticks = {}};
}

}  // namespace trophic::test
