// SPDX-License-Identifier: MIT
// NetLogo's wolves, sheep and grass: points on a torus of patches.
#pragma once

#include <algorithm>
#include <array>
#include <trophic/control/brain/turns_by_input.hpp>
#include <trophic/energy/metabolism/fixed_gains.hpp>
#include <trophic/energy/order/by_turns.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/perception/sensors/random_turn.hpp>
#include <trophic/perception/visibility/within_range.hpp>
#include <trophic/reproduction/recruitment/by_chance.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>
#include <unordered_map>

namespace trophic::worlds {

namespace wolf_sheep {

/// Sheep, and wolves that hunt them.
struct Community {
  static constexpr std::string_view name = "wolves_and_sheep";
  static constexpr std::array<std::string_view, 2> species_names{"sheep", "wolf"};
  using Params = initialization::community::PredatorPrey::Params;
  Params params;
  [[nodiscard]] FoodWeb web() const { return {{"sheep", "wolf"}, {{.hunter = 1, .victim = 0}}}; }
  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    return initialization::community::PredatorPrey{params}.founders(robots);
  }
};
static_assert(initialization::Community<Community>);

/// Rule: a wolf eats one sheep on its patch, wolves in random order.   Reads: positions, patches.   Random draws: the order of
/// the wolves, and 1 for each catch.
struct OnItsPatch {
  static constexpr std::string_view name = "on_its_patch";
  [[nodiscard]] std::vector<death::Capture> captures(const View& view, Rng& rng) const {
    std::vector<BodyIndex> wolves;
    std::vector<std::pair<std::size_t, BodyIndex>> sheep;  // with their patches
    for (BodyIndex body = 0; view.tick > 0 && body < view.robots.size(); ++body) {
      if (view.robots[body].species == 0) sheep.emplace_back(view.foods.front().cell_at(view.poses[body]), body);
      if (view.robots[body].species == 1) wolves.push_back(body);
    }
    std::ranges::sort(sheep);
    std::unordered_map<std::size_t, std::size_t> eaten;  // the number of sheep that are gone from a patch
    rng.shuffle(std::span{wolves});
    std::vector<death::Capture> captures;
    for (const BodyIndex wolf : wolves) {
      const std::size_t patch = view.foods.front().cell_at(view.poses[wolf]);
      const auto first = std::ranges::lower_bound(sheep, patch, {}, &std::pair<std::size_t, BodyIndex>::first);
      auto last = std::ranges::upper_bound(first, sheep.end(), patch, {}, &std::pair<std::size_t, BodyIndex>::first);
      if (const auto gone = eaten.find(patch); gone != eaten.end()) last -= static_cast<std::ptrdiff_t>(gone->second);
      if (first == last) continue;
      const auto one = first + static_cast<std::ptrdiff_t>(rng.index(static_cast<std::size_t>(last - first)));
      captures.push_back({.hunter = wolf, .victim = one->second});
      std::rotate(one, one + 1, last);  // behind those that are left
      ++eaten[patch];
    }
    return captures;
  }
};
static_assert(death::CaptureRule<OnItsPatch>);

}  // namespace wolf_sheep

/// Rules: 100 sheep and 50 wolves on a torus of 51 x 51 patches. In a tick all individuals turn at random and walk one patch,
/// which costs 1. Sheep eat a grown patch, worth 4; a sheep with less than 0 dies; each has an offspring with probability 4 % and
/// halves its energy. Then each wolf eats a sheep on its patch and gains 20, dies if it has less than 0, and has an offspring
/// with probability 5 %. Then patches regrow, 30 ticks after they were eaten. A wolf's gain comes from outside, whatever its
/// sheep had. `rules.order.acts = together` lets both species eat, die and reproduce together.   Source: NetLogo's model Wolf
/// Sheep Predation with grass, with its parameters [wilensky1997]. Units: a patch is 1 m, a tick 1 s.   Runs only on the backend
/// `torus`.
struct WolfSheep final {
  static constexpr std::string_view name = "wolf_sheep";
  static constexpr std::array<std::string_view, 1> backends{"torus"};

  using Community = wolf_sheep::Community;
  using Placement = initialization::placement::Scattered;
  using Visibility = perception::visibility::WithinRange;  // wolves find sheep by chance
  using NewbornTag = perception::newborn_tag::KeepsBodyTag;
  using Sensors = perception::sensors::List<perception::sensors::RandomTurn>;
  using Brain = control::brain::TurnsByInput;
  using Heading = perception::heading::ForwardAxisHeading;
  using Steering = control::steering::TargetedSteering;
  using InitialGenome = reproduction::initial_genome::UniformWeights;
  using Heredity = reproduction::heredity::OwnCopy;
  using Capture = wolf_sheep::OnItsPatch;
  using Resource = energy::resource::DelayedPatches;
  using Metabolism = rules::by_species<energy::metabolism::FixedGains>;
  using Recruitment = rules::by_species<reproduction::recruitment::ByChance>;
  using Order = energy::order::ByTurns;

  static TableParams<WolfSheep> params() {
    TableParams<WolfSheep> own{.community = {.predators = 50},
                               .visibility = {.range_m = 0.0},
                               .brain = {.turn_rad = 50.0 * std::numbers::pi / 180.0},
                               .resource = {.patches_in_a_row = 51, .patch_J = 4.0, .delay_ticks = 30, .grown = 0.5}};
    own.metabolism.get<0>() = {.gain_J = 4.0, .tick_J = 1.0};
    own.metabolism.get<1>() = {.gain_J = 20.0, .tick_J = 1.0};
    own.recruitment.get<0>() = {.spare_bodies = 1850, .chance = 0.04};
    own.recruitment.get<1>() = {.chance = 0.05};
    return own;
  }
  static EcologyParams ecology() {
    EcologyParams own = rules::Paper::ecology();
    own.robots = 2000;
    own.duration_s = 2000.0;
    own.tick_s = 1.0;
    own.control_hz = 1.0;
    own.arena = "square_51";
    return own;
  }
  static Physics physics() { return rules::Paper::physics(); }
};

}  // namespace trophic::worlds
