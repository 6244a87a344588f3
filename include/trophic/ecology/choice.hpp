// SPDX-License-Identifier: MIT
// The sighting of a robot at a tick, and the decision of its brain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <trophic/control/brain/contract.hpp>
#include <trophic/ecology/population.hpp>
#include <trophic/perception/adversary.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/population/sighting.hpp>
#include <trophic/population/view.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>

namespace trophic {

/// A robot's sighting and its brain's decision; no decision if a robot without a target keeps its last one.
template <class Rules>
struct Choice {
  using Inputs = typename Population<Rules>::Sensors::Values;

  std::optional<Sighting> sighting;
  std::optional<control::Decision> decision;
  Inputs inputs{};
  typename Population<Rules>::Outputs outputs{};  ///< only if an observer wants decision records
};

/// Applies the Visibility rule.
template <class Rules>
[[nodiscard]] bool sees(const Policies<Rules>& rules, const Population<Rules>& population, std::uint64_t seed, BodyIndex self,
                        BodyIndex other, const View& now) {
  Rng rng{seed, Stream::visibility, population[self].id, static_cast<std::uint64_t>(now.tick), population[other].id};
  return perception::ask::perceives(rules.visibility, population.states().visibility[self], self, other, now, rng);
}

/// The choice of one robot. `common`: the sensors that are the same for all robots.
template <class Rules>
[[nodiscard]] Choice<Rules> choice_of(const Policies<Rules>& rules, Population<Rules>& population, std::uint64_t seed,
                                      BodyIndex body, const View& now, const typename Choice<Rules>::Inputs& common,
                                      bool keeps_decision_without_target, bool is_observed) {
  const auto sighting = perception::adversary(
      body, now, [&](BodyIndex self, BodyIndex other) { return sees(rules, population, seed, self, other, now); },
      perception::ask::horizon(rules.visibility, population[body]));
  Choice<Rules> choice{.sighting = sighting, .decision = std::nullopt};
  if (!sighting && keeps_decision_without_target) return choice;
  choice.inputs = rules.sensors.sense(population.states().sensors[body], body, sighting, now, common, [&](std::size_t sensor) {
    return Rng{seed, Stream::sensors, population[body].id, static_cast<std::uint64_t>(now.tick), sensor};
  });
  if (is_observed) choice.outputs = population.outputs(body, choice.inputs);
  choice.decision = population.decide(body, choice.inputs);
  return choice;
}

}  // namespace trophic
