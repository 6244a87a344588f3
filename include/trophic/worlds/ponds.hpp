// SPDX-License-Identifier: MIT
// The pond with refuges for prey, and with other conditions.
#pragma once

#include <trophic/control/pace/constant_pace.hpp>
#include <trophic/death/capture/catch_outside_refuges.hpp>
#include <trophic/death/floor/victim_floor.hpp>
#include <trophic/death/minimum_predators/sacrifice_random_victim.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>
#include <trophic/worlds/pond.hpp>

namespace trophic::worlds {

inline constexpr auto in_refuges = [](EcologyParams& ecology) { ecology.arena = "refuges"; };

/// Rules: like Pond, in the arena `refuges`, whose four zones named refuge cover an eighth of the floor; prey are not caught
/// there (CatchOutsideRefuges).   Source: not in the literature as such.
using PondWithRefuges =
    named<with_ecology<with_capture<Pond, death::capture::CatchOutsideRefuges>, in_refuges>, "pond_with_refuges">;

namespace conditions {

using reproduction::recruitment::AfterEscapes, reproduction::recruitment::AtEnergy;

/// Rule: births as in AtEnergy, but prey also need a number of `escapes` since their last offspring, as AfterEscapes counts them.
/// The body of a sacrificed prey becomes a predator's at once. Reads: as both.   Random draws: as AtEnergy.
struct AtEnergyAfterEscapes {
  using NamesOneParent = AtEnergyAfterEscapes;
  static constexpr std::string_view name = "at_energy_after_escapes";
  static constexpr std::string_view source = AfterEscapes::source;

  struct Params {
    AtEnergy::Params energy{};
    std::int64_t escapes = 0;
    static constexpr auto fields() {
      return std::tuple{field("energy", &Params::energy),
                        field("escapes", &Params::escapes, at_least(0), "number of escapes of a prey before each offspring")};
    }
  };
  Params params;
  using State = AfterEscapes::State;
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex self, double m, const View& view) const { AfterEscapes{}.on_walk(own, self, m, view); }
  void on_offspring(State& own, BodyIndex, BodyIndex, const View&) const { own.escapes = 0; }
  [[nodiscard]] std::size_t spare_bodies() const { return params.energy.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy& death, const View&) const { return death.cause != Cause::sacrificed; }
  [[nodiscard]] std::vector<reproduction::Recruit> recruits(const View& view, Rng& rng, std::span<const State> states) const {
    auto births = AtEnergy{params.energy}.recruits(view, rng);
    std::erase_if(births, [&](const reproduction::Recruit& birth) {
      const auto parent = std::ranges::find(view.robots, birth.parents.front().id, &Individual::id) - view.robots.begin();
      return !view.web.hunts(birth.species) && states[static_cast<std::size_t>(parent)].escapes < params.escapes;
    });
    return births;
  }
};
static_assert(reproduction::Recruitment<AtEnergyAfterEscapes>);

/// Rule: like ActiveAwayFromHunters, but only from the age `min_age_s` on; if `distance_m` is 0, only age protects the newborn.
/// Reads: as ActiveAwayFromHunters, ages.   Random draws: 0.
struct AwayFromHuntersAtAge {
  static constexpr std::string_view name = "away_from_hunters_at_age";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double distance_m = Pond::params().activation.distance_m;
    double min_age_s = 0.0;
    static constexpr auto fields() {
      return std::tuple{
          field("distance_m", &Params::distance_m, at_least(0.0), "a newborn activates farther than this from every hunter"),
          field("min_age_s", &Params::min_age_s, at_least(0.0), "age below which newborns stay inactive")};
    }
  };
  Params params;

  [[nodiscard]] death::Activates activates(BodyIndex body, const View& view) const {
    if (!view.passed(view.robots[body].age_from_s, params.min_age_s)) return death::Activates::no;
    return death::activation::ActiveAwayFromHunters{{params.distance_m}}.activates(body, view);
  }
};
static_assert(death::Activation<AwayFromHuntersAtAge>);

template <class Base>
using WithFloor =
    with_minimum_predators<with_floor<Base, death::floor::VictimFloor>, death::minimum_predators::SacrificeRandomVictim>;
inline constexpr auto as_the_pond = [](auto& params) {
  params.recruitment.energy = Pond::params().recruitment;
  params.floor.floor = params.minimum_predators.below = 0;
};
template <class Base>
using WithAges = with_activation<Base, AwayFromHuntersAtAge>;

}  // namespace conditions

/// Rules: exactly like Pond by default; parameters add the paper's floor (`rules.floor.floor`) and minimum number of predators
/// (`rules.minimum_predators.below`), a criterion for births of prey (`rules.recruitment.escapes`), an age of activation
/// (`rules.activation.min_age_s`), or a species' pace (`rules.pace.SPECIES.factor`).   Source: not in the literature as such.
using PondWithConditions = named<
    with_params<with_pace<conditions::WithAges<conditions::WithFloor<with_recruitment<Pond, conditions::AtEnergyAfterEscapes>>>,
                          rules::by_species<control::pace::ConstantPace>>,
                conditions::as_the_pond>,
    "pond_with_conditions">;

}  // namespace trophic::worlds
