// SPDX-License-Identifier: MIT
// NetLogo's wolves, sheep and grass: points on a torus of patches.
#pragma once

#include <trophic/death/activation/always_active.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::worlds {

/// NetLogo's model Wolf Sheep Predation with grass [wilensky1997], and with its numbers: 100 sheep and 50 wolves on a torus of 51
/// x 51 patches. A tick: all turn at random and walk one patch, which costs 1; sheep eat a grown patch, worth 4, which is bare
/// for 30 ticks; a wolf eats a sheep on its patch and gains 20; who has less than 0 dies; each sheep bears with 4 %, each wolf
/// with 5 %, and halves its energy. For the backend `torus`. The gain of a wolf comes from outside, as in NetLogo, whatever its
/// sheep had.
namespace wolf_sheep {

struct Community {
  static constexpr std::string_view name = "wolves_and_sheep";
  static constexpr std::array<std::string_view, 2> species_names{"sheep", "wolf"};
  struct Params {
    std::size_t wolves = 50;
    static constexpr auto fields() {
      return std::tuple{field("wolves", &Params::wolves, at_least(0), "founders that are wolves")};
    }
  };
  Params params;
  [[nodiscard]] FoodWeb web() const { return {{"sheep", "wolf"}, {{.hunter = 1, .victim = 0}}}; }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    std::vector<Species> species(robots, 0);
    for (std::size_t i = 0; i < std::min(params.wolves, robots); ++i) species[i] = 1;
    return species;
  }
};

/// Anywhere, in any direction.
struct Anywhere {
  static constexpr std::string_view name = "anywhere";
  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double, Rng& rng) const {
    std::vector<GroundPose> places(robots);
    for (GroundPose& at : places) {
      at.x_m = rng.uniform(-arena.half_side_m, arena.half_side_m);
      at.y_m = rng.uniform(-arena.half_side_m, arena.half_side_m);
      at.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    }
    return places;
  }
};

/// NetLogo's wiggle: right by up to 50 degrees and left by up to 50 degrees.
struct Wiggle {
  static constexpr std::string_view name = "wiggle";
  static constexpr std::size_t size = 1;
  [[nodiscard]] std::array<double, 1> sense(BodyIndex, const std::optional<Sighting>&, const View&, Rng& rng) const {
    return {rng.uniform() - rng.uniform()};
  }
};
struct Wanders {
  static constexpr std::string_view name = "wanders";
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 0; }
  [[nodiscard]] std::vector<int> tags() const { return {1}; }
  [[nodiscard]] control::Decision decide(std::span<const double> inputs, std::span<const double>) const {
    return {.target_angle_rad = inputs[0] * 50.0 * std::numbers::pi / 180.0, .tag = 1};
  }
};
/// Wolves find sheep by chance.
struct SeesNone {
  static constexpr std::string_view name = "sees_none";
  [[nodiscard]] bool perceives(BodyIndex, BodyIndex, const View&, Rng&) const { return false; }
  [[nodiscard]] perception::Horizon horizon(const Individual&) const { return {.within_m = 0.0}; }
};

/// A wolf eats one sheep on its patch; wolves in random order.
struct OnItsPatch {
  static constexpr std::string_view name = "on_its_patch";
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng& rng) const {
    std::vector<std::vector<BodyIndex>> sheep(view.field->cells());
    std::vector<BodyIndex> wolves;
    for (BodyIndex body = 0; view.tick > 0 && body < view.robots.size(); ++body) {
      if (view.robots[body].species == 0) sheep[view.field->cell_at(view.poses[body])].push_back(body);
      if (view.robots[body].species == 1) wolves.push_back(body);
    }
    rng.shuffle(std::span{wolves});
    std::vector<death::Capture> captures;
    for (const BodyIndex wolf : wolves) {
      auto& here = sheep[view.field->cell_at(view.poses[wolf])];
      if (here.empty()) continue;
      const std::size_t one = rng.index(here.size());
      captures.push_back({.hunter = wolf, .victim = here[one]});
      here.erase(here.begin() + static_cast<std::ptrdiff_t>(one));
    }
    return captures;
  }
};

struct Metabolism {
  static constexpr std::string_view name = "wolf_sheep_energy";
  struct Params {
    double sheep_gain_J = 4.0;
    double wolf_gain_J = 20.0;
    static constexpr auto fields() {
      return std::tuple{field("sheep_gain_J", &Params::sheep_gain_J, at_least(0.0), "from a patch"),
                        field("wolf_gain_J", &Params::wolf_gain_J, at_least(0.0), "from a sheep")};
    }
  };
  Params params;
  [[nodiscard]] double first_J(const Individual& newborn, Rng& rng) const {
    return std::floor(rng.uniform(0.0, 2.0 * (newborn.species == 0 ? params.sheep_gain_J : params.wolf_gain_J)));
  }
  [[nodiscard]] double upkeep_J(BodyIndex, double, const View&) const { return 1.0; }
  [[nodiscard]] double bite_J(BodyIndex self, double there_J, const View& view) const {
    return view.robots[self].species == 0 ? there_J : 0.0;
  }
  [[nodiscard]] double meal_J(BodyIndex, BodyIndex, const View&) const { return 0.0; }
  [[nodiscard]] double bonus_J(BodyIndex, BodyIndex, const View&) const { return params.wolf_gain_J; }
  [[nodiscard]] bool starves(BodyIndex self, const View& view) const { return view.robots[self].energy_J < 0.0; }
};

/// Births by chance, one step away from the parent in a random direction.
struct ByChance {
  static constexpr std::string_view name = "by_chance";
  struct Params {
    std::size_t spare_bodies = 1850;
    double sheep = 0.04;
    double wolf = 0.05;
    static constexpr auto fields() {
      return std::tuple{field("spare_bodies", &Params::spare_bodies, at_least(0), "bodies without an individual at the start"),
                        field("sheep", &Params::sheep, between(0.0, 1.0), "chance of a sheep at each tick"),
                        field("wolf", &Params::wolf, between(0.0, 1.0), "chance of a wolf at each tick")};
    }
  };
  Params params;
  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<reproduction::Recruit> recruits(const View& view, Rng& rng) const {
    std::vector<reproduction::Recruit> births;
    for (BodyIndex body = 0; view.tick > 0 && body < view.robots.size(); ++body) {
      const Individual& one = view.robots[body];
      if (!one.lives() || !rng.chance(one.species == 0 ? params.sheep : params.wolf)) continue;
      GroundPose place = view.poses[body];
      place.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
      place.x_m = std::remainder(place.x_m + std::cos(place.heading_rad), view.period_m);
      place.y_m = std::remainder(place.y_m + std::sin(place.heading_rad), view.period_m);
      births.push_back(
          {.species = one.species, .parents = {one.as_ancestor()}, .endowment_J = one.energy_J / 2.0, .place = place});
    }
    return births;
  }
};

}  // namespace wolf_sheep

struct WolfSheep final {
  static constexpr std::string_view name = "wolf_sheep";

  using Community = wolf_sheep::Community;
  using Placement = wolf_sheep::Anywhere;
  using Visibility = wolf_sheep::SeesNone;
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = perception::sensors::List<wolf_sheep::Wiggle>;
  using Brain = wolf_sheep::Wanders;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;
  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using Heredity = reproduction::heredity::OwnCopy;
  using Activation = death::activation::AlwaysActive;
  using Capture = wolf_sheep::OnItsPatch;
  using Resource = energy::resource::DelayedPatches;
  using Metabolism = wolf_sheep::Metabolism;
  using Recruitment = wolf_sheep::ByChance;

  static TableParams<WolfSheep> params() {
    return TableParams<WolfSheep>{.resource = {.patches_in_a_row = 51, .patch_J = 4.0, .delay_ticks = 30, .grown = 0.5}};
  }
  static EcologyParams ecology() {
    EcologyParams own = rules::Paper::ecology();
    own.robots = 2000;
    own.duration_s = 2000.0;
    own.tick_s = 1.0;
    own.arena = "square_51";
    return own;
  }
  static Physics physics() { return rules::Paper::physics(); }
};

}  // namespace trophic::worlds
