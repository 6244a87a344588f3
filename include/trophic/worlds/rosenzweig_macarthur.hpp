// SPDX-License-Identifier: MIT
// Rosenzweig and MacArthur's predators and prey: a well-mixed world of points.
#pragma once

#include <array>
#include <trophic/control/brain/turns_by_input.hpp>
#include <trophic/death/capture/one_within_reach.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <trophic/perception/sensors/random_turn.hpp>
#include <trophic/perception/visibility/within_range.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::worlds {

namespace well_mixed {

/// Rule: at each tick a prey has an offspring with probability r (1 - N / K), where N is the number of prey; a predator has one
/// with probability e if it has just caught a prey.   Reads: species, numbers, hunger.   Random draws: 1 per individual after the
/// first tick.
struct Births {
  static constexpr std::string_view name = "logistic_and_by_catches";
  using NamesOneParent = Births;
  struct Params {
    std::size_t spare_bodies = 0;
    double r = 0.05;
    double K = 600.0;
    double e = 0.5;
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("r", &Params::r, between(0.0, 1.0), "per-tick birth probability of prey at low density"),
          field("K", &Params::K, above(0.0), "number of prey at which births stop (carrying capacity)"),
          field("e", &Params::e, between(0.0, 1.0), "probability of a birth after a catch")};
    }
  };
  Params params;
  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<reproduction::Recruit> recruits(const View& view, Rng& rng) const {
    const double of_prey = params.r * std::max(0.0, 1.0 - static_cast<double>(view.count(0)) / params.K);
    std::vector<reproduction::Recruit> births;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& one = view.robots[body];
      if (!one.lives() || !rng.chance(one.species == 0 ? of_prey : view.hunger_ticks(one) == 0 ? params.e : 0.0)) continue;
      births.push_back({.species = one.species, .parents = {one.as_ancestor()}, .place = view.poses[body]});
    }
    return births;
  }
};
static_assert(reproduction::Recruitment<Births>);

/// Rule: a predator dies with probability m per tick; a prey dies only if it is caught. Reads: species.   Random draws: 1 per
/// predator.
struct Deaths {
  static constexpr std::string_view name = "deaths_of_predators";
  struct Params {
    double m = 0.02;
    static constexpr auto fields() {
      return std::tuple{field("m", &Params::m, between(0.0, 1.0), "probability of death at each tick")};
    }
  };
  Params params;
  [[nodiscard]] bool dies(const Individual& self, const View& view, Rng& rng) const {
    return view.web.hunts(self.species) && rng.chance(params.m);
  }
};
static_assert(death::Senescence<Deaths>);

}  // namespace well_mixed

/// Rules: prey grow logistically, and predators handle each caught prey for h ticks. In a tick each free predator catches the
/// nearest prey within reach; then predators die; then prey, and predators that caught one, have offspring.   Source:
/// [rosenzweig1963]. With the attack rate a = pi reach^2 / area the equilibrium is N* = m / (a (e - m h)), P* = r (1 - N* / K) (1
/// + a h N*) / a; it is stable as long as N* > (K - 1 / (a h)) / 2. So population sizes stay near it at K = 600 and cycle at K =
/// 1600, until a species dies out.   Units: a tick is 1 s.   Runs only on the backend `torus`, where all positions are random
/// after each tick.
struct RosenzweigMacArthur final {
  static constexpr std::string_view name = "rosenzweig_macarthur";
  static constexpr std::array<std::string_view, 1> backends{"torus"};

  using Community = initialization::community::PredatorPrey;
  using Placement = initialization::placement::UniformSquare;
  using Visibility = perception::visibility::WithinRange;  // they meet by chance
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = perception::sensors::List<perception::sensors::RandomTurn>;
  using Brain = control::brain::TurnsByInput;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;
  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using Heredity = reproduction::heredity::OwnCopy;
  using Capture = death::capture::OneWithinReach;
  using Senescence = well_mixed::Deaths;
  using Recruitment = well_mixed::Births;

  static TableParams<RosenzweigMacArthur> params() {
    return TableParams<RosenzweigMacArthur>{.community = {.predators = 180},
                                            .placement = {.half_extent_m = 0.05},
                                            .visibility = {.range_m = 0.0},
                                            .brain = {.turn_rad = 2.0 * std::numbers::pi},
                                            .recruitment = {.spare_bodies = 1960, .r = 0.05, .K = 600.0, .e = 0.5},
                                            .capture = {.reach_m = 0.001, .handling_ticks = 12},
                                            .senescence = {.m = 0.02}};
  }
  static EcologyParams ecology() {
    EcologyParams own = rules::Paper::ecology();
    own.robots = 2400;
    own.duration_s = 3000.0;
    own.tick_s = 1.0;
    own.control_hz = 1.0;
    own.arena = "stirred_square";
    return own;
  }
  static Physics physics() { return rules::Paper::physics(); }
};

}  // namespace trophic::worlds
