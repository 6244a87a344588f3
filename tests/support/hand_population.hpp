// SPDX-License-Identifier: MIT
// Populations written by hand or drawn from a seed, so that a rule can be asked without an ecology and without physics.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::test {

inline constexpr Species prey = 0;
inline constexpr Species predator = 1;
[[nodiscard]] inline FoodWeb predator_prey_web() {
  return {{"prey", "predator"}, {{.hunter = predator, .victim = prey}}};
}

inline constexpr Species plant = 0;
inline constexpr Species grazer = 1;
inline constexpr Species hunter = 2;
/// A food chain: the hunter eats the grazer, the grazer eats the plant.
[[nodiscard]] inline FoodWeb chain_web() {
  return {{"plant", "grazer", "hunter"}, {{.hunter = grazer, .victim = plant}, {.hunter = hunter, .victim = grazer}}};
}

/// One robot of a hand-written population: name what matters, leave out the rest.
struct Robot {
  Species species = prey;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
  int tag = 1;
  bool active = true;
  std::int64_t fed_tick = 0;
  double age_from_s = 0.0;
  double tag_since_s = 0.0;
  std::optional<IndividualId> id = {};  ///< none: the number of its body
};

/// Individuals and poses with all that a View refers to. Unless changed: tick 0, 20 m x 20 m. Each genome has the individual's id
/// and that id as its only weight.
class HandPopulation {
 public:
  explicit HandPopulation(const std::vector<Robot>& robots, FoodWeb food_web = predator_prey_web()) : web{std::move(food_web)} {
    for (const Robot& robot : robots) {
      Individual one;
      one.id = robot.id.value_or(individuals.size());
      one.genome = std::make_shared<Genome>(Genome{.id = one.id, .weights = {static_cast<double>(one.id)}});
      one.species = robot.species;
      one.active = robot.active;
      one.fed_tick = robot.fed_tick;
      one.age_from_s = robot.age_from_s;
      one.tag = robot.tag;
      one.tag_since_s = robot.tag_since_s;
      individuals.push_back(std::move(one));
      poses.push_back({.x_m = robot.x_m, .y_m = robot.y_m, .heading_rad = robot.heading_rad});
    }
  }

  /// The same at another tick of 2 s.
  HandPopulation& at_tick(std::int64_t number) {
    tick = number;
    time_s = 2.0 * static_cast<double>(number);
    return *this;
  }

  /// As rules see it. Refers to this object.
  [[nodiscard]] View view() const {
    return {.time_s = time_s,
            .tick = tick,
            .web = web,
            .arena = arena,
            .robots = individuals,
            .poses = poses,
            .foods = foods,
            .traits = traits};
  }

  /// Perception unless a test sets another: active individuals of its own tag. Refers to this object.
  [[nodiscard]] perception::Perceives perceives() const {
    return [this](BodyIndex self, BodyIndex other) {
      return individuals[self].tag == individuals[other].tag && individuals[other].active;
    };
  }

  /// The same individuals in other bodies: body i of the result holds who was in body order[i].
  [[nodiscard]] HandPopulation reordered(std::span<const std::size_t> order) const {
    HandPopulation result = *this;
    for (std::size_t i = 0; i < order.size(); ++i) {
      result.individuals[i] = individuals[order[i]];
      result.poses[i] = poses[order[i]];
    }
    return result;
  }

  FoodWeb web;
  Arena arena{};
  std::vector<Individual> individuals;
  std::vector<GroundPose> poses;
  std::vector<ResourceField> foods = {};
  std::vector<std::string_view> traits = {};  ///< names; a test gives genomes theirs
  std::int64_t tick = 0;
  double time_s = 0.0;
};

/// The first `predators` of so many robots are predators, the others prey.
[[nodiscard]] inline HandPopulation with_predators(std::size_t predators, std::size_t robots = 30) {
  std::vector<Robot> list(robots);
  for (std::size_t i = 0; i < predators; ++i) list[i].species = predator;
  return HandPopulation{list};
}

/// A dead individual. The genome is made as that of a HandPopulation's individuals.
[[nodiscard]] inline Ancestor ancestor(IndividualId id, Species species) {
  return {
      .id = id, .species = species, .genome = std::make_shared<Genome>(Genome{.id = id, .weights = {static_cast<double>(id)}})};
}

/// A population drawn from a seed at tick 100: species, tags, activity, ages, hunger and places within +- half_side_m at
/// random, energies from -1 to 250 J. Ids run against the order of bodies. No two distances are equal.
[[nodiscard]] inline HandPopulation random_population(std::uint64_t seed, std::size_t robots, FoodWeb web = predator_prey_web(),
                                                      double half_side_m = 9.0) {
  Rng rng{seed, Stream::user};
  std::vector<Robot> drawn;
  for (std::size_t body = 0; body < robots; ++body) {
    Robot robot;
    robot.species = rng.index(web.size());
    robot.x_m = rng.uniform(-half_side_m, half_side_m);
    robot.y_m = rng.uniform(-half_side_m, half_side_m);
    robot.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    robot.tag = rng.chance(0.5) ? 1 : -1;
    robot.active = !web.is_hunted(robot.species) || rng.chance(0.8);
    robot.fed_tick = static_cast<std::int64_t>(rng.index(100));
    robot.age_from_s = 2.0 * static_cast<double>(rng.index(101));
    robot.tag_since_s = 2.0 * static_cast<double>(rng.index(101));
    robot.id = 1000 - body;
    drawn.push_back(robot);
  }
  HandPopulation population{drawn, std::move(web)};
  Rng energies{seed, Stream::user, 2};
  for (Individual& one : population.individuals) one.energy_J = energies.uniform(-1.0, 250.0);
  return population.at_tick(100);
}

/// A random order of 0, ..., size - 1.
[[nodiscard]] inline std::vector<std::size_t> random_order(std::uint64_t seed, std::size_t size) {
  std::vector<std::size_t> order(size);
  for (std::size_t i = 0; i < size; ++i) order[i] = i;
  Rng rng{seed, Stream::user, 1};
  rng.shuffle(std::span{order});
  return order;
}

}  // namespace trophic::test
