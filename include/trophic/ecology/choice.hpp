// SPDX-License-Identifier: MIT
// What a robot perceives at a tick, and the outputs of its brain.
#pragma once

#include <trophic/ecology/population.hpp>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/perception/adversary.hpp>

namespace trophic {

/// A robot's sighting, the inputs of its brain and the outputs; a robot without a target that keeps its last decision has
/// neither.
template <class Rules>
struct Choice {
  using Inputs = typename Population<Rules>::Sensors::Values;

  std::optional<Sighting> sighting;
  bool is_asked = false;  ///< whether the brain decides
  Inputs inputs{};
  typename Population<Rules>::Outputs outputs{};
};

/// One moment of an ecology at which robots perceive.
template <class Rules>
class Moment {
 public:
  /// All arguments must outlive it.
  Moment(const Policies<Rules>& rules, const Population<Rules>& population, std::uint64_t seed, const View& now)
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

  /// Sets a robot's sighting, whether its brain decides, and its inputs. `common`: the values of sensors that are the same for
  /// all robots. Throws RuleError for an input that is not finite.
  template <class Common>
  void perceive(BodyIndex body, const Common& common, WithoutTarget without_target, Choice<Rules>& choice) const {
    choice.sighting = sighting(body);
    choice.is_asked = choice.sighting || without_target == WithoutTarget::decides;
    if (!choice.is_asked) return;
    const auto rng_of = [&](std::size_t sensor) { return Rng{seed_, Stream::sensors, population_[body].id, tick(), sensor}; };
    choice.inputs = rules_.sensors.sense(population_.states().sensors[body], body, choice.sighting, now_, common, rng_of);
    check_finite("sensors", "inputs", population_.inputs_of(body, choice.inputs));
  }

 private:
  [[nodiscard]] std::uint64_t tick() const { return static_cast<std::uint64_t>(now_.tick); }

  const Policies<Rules>& rules_;
  const Population<Rules>& population_;
  std::uint64_t seed_;
  const View& now_;
};

}  // namespace trophic
