// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/visibility/same_tag.hpp>
#include <trophic/perception/visibility/within_range.hpp>

using namespace trophic;
using namespace trophic::test;

namespace {

/// As the population sees itself, with a tree.
View with_tree(const HandPopulation& robots, const SearchTree& tree) {
  View view = robots.view();
  view.tree = &tree;
  return view;
}

/// Robots on the crossings of a grid: many are equally far from one another.
HandPopulation on_crossings(std::uint64_t seed, std::size_t robots) {
  HandPopulation population = random_population(seed, robots);
  Rng rng{seed, Stream::user, 2};
  for (GroundPose& pose : population.poses) {
    pose.x_m = 2.0 * static_cast<double>(rng.index(9));
    pose.y_m = 2.0 * static_cast<double>(rng.index(9));
  }
  return population;
}

}  // namespace

TEST_CASE("search tree: any bounds -> result of an exhaustive search, ties included") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const std::size_t size = 1 + 7 * seed;
    for (const HandPopulation& robots : {random_population(seed, size, chain_web()), on_crossings(seed, size)}) {
      const SearchTree tree{robots.poses, robots.individuals};
      View plain = robots.view();
      View fast = with_tree(robots, tree);
      plain.space.period_m = fast.space.period_m = seed % 2 == 0 ? 0.0 : 18.0;  // a torus
      for (BodyIndex self = 0; self < size; ++self) {
        for (const double within_m : {0.0, 1.0, 3.7, 1e9}) {
          CHECK(fast.within(robots.poses[self], within_m) == plain.within(robots.poses[self], within_m));
          for (const std::optional<int> tag : {std::optional<int>{}, std::optional{1}, std::optional{-1}}) {
            for (const bool only_active : {false, true}) {
              const auto opponent = [&](Species other) { return plain.web.opponents(plain.robots[self].species, other); };
              const auto accepts = [&](const Individual& other) {
                return opponent(other.species) && other.tag == tag.value_or(other.tag) && (other.active || !only_active);
              };
              const Search search{.within_m = within_m, .among = plain.marks(opponent, tag, only_active)};
              CHECK(fast.closest(self, accepts, search) == plain.closest(self, accepts, {.within_m = within_m}));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("search tree: torus with robots on its seam -> result of an exhaustive search, ties included, few visited") {
  constexpr double period_m = 16.0;
  std::size_t crossing = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    HandPopulation robots = random_population(seed, 2 + 9 * seed);
    Rng rng{seed, Stream::user, 3};
    for (GroundPose& pose : robots.poses) {  // every crossing, so both edges of the square, or anywhere
      const auto place_m = [&] { return seed % 3 == 0 ? rng.uniform(-8.0, 8.0) : static_cast<double>(rng.index(9)) * 2.0 - 8.0; };
      pose = {.x_m = place_m(), .y_m = place_m()};
    }
    const SearchTree tree{robots.poses, robots.individuals};
    View plain = robots.view();
    View fast = with_tree(robots, tree);
    plain.space.period_m = fast.space.period_m = period_m;
    for (BodyIndex self = 0; self < robots.poses.size(); ++self) {
      for (const Species wanted : {prey, predator}) {
        const auto accepts = [&](const Individual& other) { return other.species == wanted; };
        const auto found = fast.closest(self, accepts, {.among = marks_of(wanted)});
        CHECK(found == plain.closest(self, accepts));
        if (found && distance_m(robots.poses[self], robots.poses[*found]) > plain.distance_m(self, *found)) ++crossing;
      }
      for (const double radius_m : {0.0, 2.0, 5.0, 30.0})
        CHECK(fast.within(robots.poses[self], radius_m) == plain.within(robots.poses[self], radius_m));
    }
  }
  CHECK(crossing > 100);

  HandPopulation many = random_population(2, 20'000, predator_prey_web(), 250.0);
  for (Individual& one : many.individuals) one.species = prey;
  many.individuals[7].species = predator;
  const SearchTree tree{many.poses, many.individuals};
  View view = with_tree(many, tree);
  view.space.period_m = 500.0;
  std::size_t asked = 0;
  const auto count = [&](Species wanted) {
    return [&asked, wanted](const Individual& other) { return ++asked, other.species == wanted; };
  };
  for (BodyIndex self = 0; self < 1000; ++self) CHECK(view.closest(self, count(prey), {.among = marks_of(prey)}));
  CHECK(asked < 10'000);
  asked = 0;
  CHECK(view.closest(19'999, count(predator), {.among = marks_of(predator)}) == 7);
  CHECK(asked < 10);
  for (BodyIndex self = 0; self < 1000; ++self) view.for_each_near(view.poses[self], 2.0, [&](BodyIndex) { ++asked; });
  CHECK(asked < 5000);
}

TEST_CASE("search tree: at exactly the bound -> found, beyond -> not found") {
  const HandPopulation robots{{{}, {.x_m = 3.0, .y_m = 4.0}, {.x_m = -3.0, .y_m = 4.0}}};
  const SearchTree tree{robots.poses, robots.individuals};
  const auto anybody = [](const Individual&) { return true; };
  for (const View& view : {robots.view(), with_tree(robots, tree)}) {
    CHECK(view.closest(0, anybody, {.within_m = 5.0}) == 1);
    CHECK(view.closest(0, anybody, {.within_m = 4.999}) == std::nullopt);
  }
}

TEST_CASE("search tree: rare or missing mark -> few bodies visited") {
  HandPopulation robots = random_population(1, 20'000, predator_prey_web(), 250.0);
  for (Individual& one : robots.individuals) {
    one.species = prey;
    one.tag = 1;
    one.active = true;
  }
  robots.individuals[7].species = predator;
  robots.individuals[8].tag = -1;
  const SearchTree tree{robots.poses, robots.individuals};
  const View view = with_tree(robots, tree);
  std::size_t asked = 0;
  const auto look = [&](auto accepts, const Search& search) {
    asked = 0;
    return view.closest(
        19'999,
        [&](const Individual& other) {
          ++asked;
          return accepts(other);
        },
        search);
  };
  CHECK(look([](const Individual& other) { return other.species == predator; }, {.among = marks_of(predator)}) == 7);
  CHECK(asked < 50);
  CHECK(look([](const Individual& other) { return other.tag == -1; }, {.among = marks_of(prey, -1)}) == 8);
  CHECK(asked < 50);
  CHECK(look([](const Individual& other) { return !other.active; }, {.among = marks_of(2)}) == std::nullopt);
  CHECK(asked == 0);
  CHECK(look([](const Individual& other) { return !other.active; }, {.within_m = 5.0}) == std::nullopt);
  CHECK(asked < 200);
}

TEST_CASE("search tree: mark changed -> found after update") {
  HandPopulation robots = random_population(3, 500);
  for (Individual& one : robots.individuals) one.species = prey;
  SearchTree tree{robots.poses, robots.individuals};
  const auto is_predator = [](const Individual& other) { return other.species == predator; };
  CHECK(with_tree(robots, tree).closest(0, is_predator, {.among = marks_of(predator)}) == std::nullopt);
  robots.individuals[400].species = predator;
  tree.mark(400, robots.poses[400], robots.individuals[400]);
  CHECK(with_tree(robots, tree).closest(0, is_predator, {.among = marks_of(predator)}) == 400);
}

TEST_CASE("view: members given -> not counted") {
  const HandPopulation robots = with_predators(14);
  const std::vector<std::size_t> members{5, 25};
  View view = robots.view();
  view.members = members;
  CHECK(view.count(prey) == 5);
  CHECK(view.count_hunters() == 25);
  CHECK(view.count(2) == 0);
}

TEST_CASE("horizon: inherited declaration -> ignored") {
  struct Sharp : perception::visibility::SameTag {};
  Individual self;
  self.tag = -1;
  CHECK(perception::ask::horizon(perception::visibility::SameTag{}, self).tag == -1);
  CHECK(perception::ask::horizon(perception::visibility::WithinRange{{.range_m = 3.0}}, self).within_m == 3.0);
  CHECK_FALSE(perception::ask::horizon(Sharp{}, self).tag);
}

TEST_CASE("view: within -> bodies in a circle, ascending, with or without tree") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const HandPopulation robots = on_crossings(seed, 5 + 11 * seed);
    const SearchTree tree{robots.poses, robots.individuals};
    const View plain = robots.view();
    for (const GroundPose point : {GroundPose{.x_m = 4.0, .y_m = 4.0}, GroundPose{.x_m = -20.0, .y_m = 8.5}}) {
      for (const double radius_m : {0.0, 1.0, 2.5, 100.0}) {
        std::vector<BodyIndex> expected;
        for (BodyIndex body = 0; body < robots.poses.size(); ++body) {
          if (distance_m(point, robots.poses[body]) <= radius_m) expected.push_back(body);
        }
        CHECK(plain.within(point, radius_m) == expected);
        CHECK(with_tree(robots, tree).within(point, radius_m) == expected);
      }
    }
  }
}
