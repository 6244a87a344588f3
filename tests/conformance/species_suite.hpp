// SPDX-License-Identifier: MIT
// Species that see, walk and starve by themselves: TEST_CASE_TEMPLATE_INVOKE(trophic_species_suite, MyBackend);
#pragma once

#include <doctest/doctest.h>

#include <trophic/control/acts/effort.hpp>
#include <trophic/control/pace/constant_pace.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/initialization/community/food_chain.hpp>
#include <trophic/perception/sensors/rays.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>

namespace trophic::conformance {

/// Walks straight ahead as hard as it can while a ray hits an enemy or food, else stands.
struct Lookout {
  static constexpr std::string_view name = "lookout";
  [[nodiscard]] std::size_t genome_size(std::size_t, std::size_t) const { return 1; }
  [[nodiscard]] std::vector<int> tags() const { return {1}; }
  void evaluate(std::span<const double> inputs, std::span<const double>, std::span<double> outputs) const {
    const bool sees = std::ranges::any_of(inputs, [](double value) { return value > 0.0; });
    std::ranges::copy(std::array{0.0, 1.0, sees ? 1.0 : -1.0}, outputs.begin());
  }
};

/// Three robots in a column, all with the same heading.
struct Column {
  static constexpr std::string_view name = "column";
  [[nodiscard]] std::vector<GroundPose> place(std::size_t, const Arena&, double, Rng&) const {
    return {{.x_m = -3.0, .y_m = -6.0}, {.x_m = -3.0, .y_m = -3.0}, {.x_m = -3.0, .y_m = 0.0}};
  }
};

namespace of_species {
using namespace control::acts;
using perception::sensors::Sees;
using Seeing = with_sensors<rules::Paper, perception::sensors::List<perception::sensors::Rays<64, Sees::victims, Sees::hunters>>>;
using Acting = with_acts<with_brain<Seeing, Lookout>, List<Turn, Tag, Effort>>;
using Chained = with_placement<with_community<Acting, initialization::community::FoodChain>, Column>;
using Paced = with_pace<Chained, rules::by_species<control::pace::ConstantPace>>;
using Hungry = with_starvation_interval<Paced, rules::by_species<death::starvation::interval::DelayedCrowdingInterval>>;
using Table = with_starvation_exemption<with_minimum_predators<Hungry, death::minimum_predators::NoMinimum>,
                                        death::starvation::exemption::NoExemption>;
}  // namespace of_species

/// Distances that the members of each species walked, and the number of those that starved.
struct OfSpecies {
  void on_event(const observe::Event& event, const View&) {
    if (event.kind == observe::EventKind::death && event.cause == Cause::starved) ++starved.at(event.individual.species);
  }
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < before.size(); ++body)
      walked_m.at(view.robots[body].species) += view.distance_m(before[body], view.poses[body]);
    before.assign(view.poses.begin(), view.poses.end());
  }
  std::vector<GroundPose> before = {};
  std::array<double, 3> walked_m{};
  std::array<int, 3> starved{};
};

/// A grazer, a hunter and an apex predator for a while; the grazer stands.
template <Backend B>
[[nodiscard]] OfSpecies lived(double duration_s, const std::vector<Obstacle>& walls, std::array<std::int64_t, 2> base_ticks) {
  Experiment<of_species::Table> experiment;
  experiment.ecology.robots = 3;
  experiment.rules.community = {.hunters = 1, .apex = 1};
  experiment.rules.sensors.get<0>().range_m = 8.0;
  experiment.rules.pace.get<0>().factor = 0.0;
  experiment.rules.pace.get<2>().factor = JointDriven<B> ? 1.4 : 1.3;
  experiment.rules.starvation.interval.get<1>().base_ticks = base_ticks[0];
  experiment.rules.starvation.interval.get<2>().base_ticks = base_ticks[1];
  Habitat habitat = load_habitat(experiment.ecology);
  habitat.arena.obstacles = walls;
  Ecology<of_species::Table> ecology{experiment, typename B::Params{}, habitat};
  OfSpecies species;
  ecology.run_until(duration_s, species);
  return species;
}

}  // namespace trophic::conformance

TEST_CASE_TEMPLATE_DEFINE("species", B, trophic_species_suite) {
  using namespace trophic;
  using conformance::lived;
  const double still_m = JointDriven<B> ? 0.2 : 1e-9;  // servos take their first targets all the same
  SUBCASE("predators walk 1.3 times as far as their prey by one parameter, a species with pace 0 stands") {
    const auto species = lived<B>(60.0, {}, {1000, 1000});
    CHECK(species.walked_m[0] < still_m);
    CHECK(species.walked_m[1] > 2.0);
    const double ratio = species.walked_m[2] / species.walked_m[1];
    CHECK(std::abs(ratio - (JointDriven<B> ? 1.4 : 1.3)) < (JointDriven<B> ? 0.2 : 1e-9));
    CHECK(species.starved == std::array{0, 0, 0});
  }
  SUBCASE("a wall hides what is behind it, and robots that see none rest without effort") {
    if constexpr (requires { B::is_periodic; }) return;  // without walls
    const auto hidden = lived<B>(20.0, {{-9.0, -4.5, 9.0, -4.5}, {-9.0, -1.5, 9.0, -1.5}}, {1000, 1000});
    CHECK(std::ranges::max(hidden.walked_m) < still_m);
  }
  SUBCASE("each species that hunts starves by its own interval") {
    CHECK(lived<B>(20.0, {}, {1000, 6}).starved == std::array{0, 0, 1});
    CHECK(lived<B>(20.0, {}, {6, 1000}).starved == std::array{0, 1, 0});
  }
}
