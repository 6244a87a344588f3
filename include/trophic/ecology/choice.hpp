// SPDX-License-Identifier: MIT
// The sighting of a robot at a tick, and the decision of its brain.
#pragma once

#include <trophic/ecology/population.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/perception/adversary.hpp>

namespace trophic {

/// A robot's sighting and its brain's decision; no decision if a robot without a target keeps its last one.
template <class Rules>
struct Choice {
  using Inputs = typename Population<Rules>::Sensors::Values;

  std::optional<Sighting> sighting;
  std::optional<control::Decision> decision;
  Inputs inputs{};
  typename Population<Rules>::Outputs outputs{};
};

/// One moment of an ecology at which robots perceive and decide.
template <class Rules>
class Moment {
 public:
  /// All arguments must outlive it.
  Moment(const Policies<Rules>& rules, Population<Rules>& population, std::uint64_t seed, const View& now)
      : rules_{rules}, population_{population}, seed_{seed}, now_{now} {}

  /// Applies the Visibility rule.
  [[nodiscard]] bool sees(BodyIndex self, BodyIndex other) const {
    Rng rng{seed_, Stream::visibility, population_[self].id, tick(), population_[other].id};
    return perception::ask::perceives(rules_.visibility, population_.states().visibility[self], self, other, now_, rng);
  }

  /// The adversary that a robot perceives.
  [[nodiscard]] std::optional<Sighting> sighting(BodyIndex body) const {
    const auto horizon = perception::ask::horizon(rules_.visibility, population_[body]);
    return perception::adversary(body, now_, std::bind_front(&Moment::sees, this), horizon);
  }

  /// The choice of a robot as far as it perceives. `common`: the values of sensors that are the same for all robots.
  template <class Common>
  [[nodiscard]] Choice<Rules> perception(BodyIndex body, const Common& common, WithoutTarget without_target) const {
    Choice<Rules> choice{.sighting = sighting(body), .decision = std::nullopt};
    if (!choice.sighting && without_target == WithoutTarget::keeps_decision) return choice;
    const auto rng_of = [&](std::size_t sensor) { return Rng{seed_, Stream::sensors, population_[body].id, tick(), sensor}; };
    choice.inputs = rules_.sensors.sense(population_.states().sensors[body], body, choice.sighting, now_, common, rng_of);
    return choice;
  }

  /// Adds the brain's decision.
  void decide(BodyIndex body, Choice<Rules>& choice, WithoutTarget without_target) const {
    if (!choice.sighting && without_target == WithoutTarget::keeps_decision) return;
    const std::size_t size = Population<Rules>::Sensors::size_of(population_[body].species);
    choice.decision = population_.decide(body, std::span{choice.inputs}.first(size), choice.outputs);
  }

 private:
  [[nodiscard]] std::uint64_t tick() const { return static_cast<std::uint64_t>(now_.tick); }

  const Policies<Rules>& rules_;
  Population<Rules>& population_;
  std::uint64_t seed_;
  const View& now_;
};

}  // namespace trophic
