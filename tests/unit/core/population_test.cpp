// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <support/hand_population.hpp>
#include <trophic/ecology/turnover.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using test::predator;
using test::prey;

namespace {

/// A population in bodies that stand in a row, and a view of it at any tick.
template <class Rules>
struct Row {
  explicit Row(const RuleParams<Rules>& numbers = {}, std::vector<Species> founders = {prey, prey, predator, predator},
               Null null = Null::none)
      : policies{make_policies<Rules>(numbers)}, population{policies, web, 99, founders, {.null = null}}, poses(founders.size()) {
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].x_m = static_cast<double>(i);
  }
  [[nodiscard]] View view(std::int64_t tick) const {
    return {.time_s = 2.0 * static_cast<double>(tick),
            .tick = tick,
            .web = web,
            .arena = arena,
            .robots = population.individuals(),
            .poses = poses};
  }
  /// The predator in body 2 catches the prey in body 0.
  void catch_first(std::int64_t tick) {
    const auto parentage = parentage_of(policies, population, {.body = 0, .cause = Cause::caught, .killer = 2}, view(tick));
    population.replace(0, predator, parentage, view(tick));
  }

  FoodWeb web = test::predator_prey_web();
  Arena arena{};
  Policies<Rules> policies;
  Population<Rules> population;
  std::vector<GroundPose> poses;
};

template <class Rules>
RuleParams<Rules> inheriting(double random_share) {
  RuleParams<Rules> numbers;
  numbers.genome_source.random_share = random_share;
  return numbers;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE("population: founders -> ids by body, random own genomes, hunted species inactive") {
  const Row<rules::Paper> row;
  const auto founders = row.population.individuals();
  REQUIRE(founders.size() == 4);
  std::set<std::uint64_t> genomes;
  for (std::size_t body = 0; body < 4; ++body) {
    const Individual& founder = founders[body];
    CHECK(founder.id == body);
    CHECK(founder.parent() == std::nullopt);
    CHECK(founder.origin == Origin::random);
    CHECK(founder.mutation_distance == 0.0);
    CHECK(founder.species == (body < 2 ? prey : predator));
    CHECK(founder.active == (body >= 2));
    CHECK(founder.tag == 1);
    CHECK(founder.fed_tick == 0);
    CHECK(founder.genome->weights.size() == 15);
    for (const double weight : founder.genome->weights) CHECK(std::abs(weight) <= 1.0);
    CHECK(genomes.insert(founder.genome->id).second);
    for (std::size_t other = 0; other < body; ++other) CHECK(founder.genome->weights != founders[other].genome->weights);
  }
  CHECK(row.population.next_id() == 4);
}

TEST_CASE("population: own copy -> mutated, parent's genome unchanged") {
  Row<rules::Paper> row{inheriting<rules::Paper>(0.0)};
  const auto parent_genome = row.population[2].genome;
  const std::vector<double> parent_weights = parent_genome->weights;
  row.catch_first(7);
  const Individual& born = row.population[0];
  CHECK(born.id == 4);
  CHECK(born.parent() == 2);
  CHECK(born.species == predator);
  CHECK(born.origin == Origin::inherited);
  CHECK(born.genome != parent_genome);
  CHECK(born.genome->id == 4);
  CHECK(row.population[2].genome == parent_genome);
  CHECK(parent_genome->weights == parent_weights);
  CHECK(born.mutation_distance > 0.0);
  CHECK(born.mutation_distance == doctest::Approx(distance(born.genome->weights, parent_weights)).epsilon(1e-14));
}

TEST_CASE("population: shared genome -> one object, mutation reaches parent and offspring") {
  Row<rules::Released> row{inheriting<rules::Released>(0.0)};
  const auto parent_genome = row.population[2].genome;
  const std::vector<double> before = parent_genome->weights;
  row.catch_first(7);
  const Individual& born = row.population[0];
  CHECK(born.genome == parent_genome);
  CHECK(born.genome->id == 2);
  CHECK(parent_genome->weights != before);
  CHECK(born.mutation_distance == doctest::Approx(distance(parent_genome->weights, before)).epsilon(1e-14));
  CHECK(born.mutation_distance <= 0.05 * std::sqrt(15.0));
}

TEST_CASE(
    "population: in the neutral shadow births have the same parents, labels and places, but genomes as founders have them") {
  Row<rules::Paper> row{inheriting<rules::Paper>(0.0)};
  Row<rules::Paper> shadow{inheriting<rules::Paper>(0.0), {prey, prey, predator, predator}, Null::shadow};
  row.catch_first(7);
  shadow.catch_first(7);
  const Individual& born = shadow.population[0];
  CHECK(born.id == row.population[0].id);
  CHECK(born.parent() == row.population[0].parent());
  CHECK(born.origin == row.population[0].origin);
  CHECK(born.species == row.population[0].species);
  CHECK(born.tag == row.population[0].tag);
  CHECK(born.genome != shadow.population[2].genome);
  CHECK(distance(born.genome->weights, shadow.population[2].genome->weights) > 0.5);
  for (const double weight : born.genome->weights) CHECK(std::abs(weight) <= 1.0);
  // the very genome that a newcomer without a parent would have been given
  Row<rules::Paper> newcomer{inheriting<rules::Paper>(1.0)};
  newcomer.catch_first(7);
  CHECK(born.genome->weights == newcomer.population[0].genome->weights);
}

TEST_CASE("population: random newcomer -> own genome, no parent") {
  Row<rules::Paper> row{inheriting<rules::Paper>(1.0)};
  row.catch_first(7);
  const Individual& born = row.population[0];
  CHECK(born.parent() == std::nullopt);
  CHECK(born.origin == Origin::random);
  CHECK(born.mutation_distance == 0.0);
  CHECK(distance(born.genome->weights, row.population[2].genome->weights) > 1.0);
}

TEST_CASE("population: no parent found -> random genome, labelled by the rule") {
  const auto orphan = [](auto row) {
    const reproduction::Vacancy vacancy{.body = 2, .cause = Cause::starved, .killer = {}};
    const auto parentage = parentage_of(row.policies, row.population, vacancy, row.view(3));
    CHECK(parentage.descent != reproduction::Descent::random);
    CHECK(parentage.parents.empty());
    row.population.replace(2, prey, parentage, row.view(3));
    CHECK(row.population[2].parent() == std::nullopt);
    CHECK(row.population[2].genome->id == 4);
    return row.population[2].origin;
  };
  CHECK(orphan(Row<rules::Paper>{inheriting<rules::Paper>(0.0)}) == Origin::random);
  CHECK(orphan(Row<rules::Released>{inheriting<rules::Released>(0.0)}) == Origin::inherited);
}

TEST_CASE("population: newborn -> clocks start now, keeps the body's tag and direction") {
  Row<rules::Paper> row;
  row.population.show_tag(2, -1);
  row.population.restart_tag_clock(2, 3.0);
  row.population.turn(2, -0.7);
  row.population.sight(2, Sighting{.self = 2, .adversary = 1, .distance_m = 1.0}, row.view(20));
  row.population.replace(2, prey, {}, row.view(21));
  const Individual& born = row.population[2];
  CHECK(born.born_s == 42.0);
  CHECK(born.age_from_s == 42.0);
  CHECK(born.tag_since_s == 42.0);
  CHECK(born.fed_tick == 21);
  CHECK_FALSE(born.active);
  CHECK(born.tag == -1);
  CHECK(born.target_angle_rad == -0.7);
  CHECK_FALSE(born.adversary);
  CHECK(std::isnan(born.adversary_distance_m));
}

TEST_CASE("population: each setter -> changes only its member") {
  Row<rules::Paper> row;
  row.population.activate(0, 8.0, false);
  row.population.activate(1, 8.0, true);
  CHECK(row.population[0].active);
  CHECK(row.population[0].age_from_s == 0.0);
  CHECK(row.population[1].age_from_s == 8.0);
  CHECK(row.population[1].born_s == 0.0);
  row.population.feed(2, 0, row.view(9));
  CHECK(row.population[2].fed_tick == 9);
  CHECK(row.population[0].fed_tick == 0);
  row.population.sight(3, Sighting{.self = 3, .adversary = 1, .distance_m = 2.0}, row.view(9));
  CHECK(row.population[3].adversary == 1);
  CHECK(row.population[3].adversary_distance_m == 2.0);
  row.population.sight(3, std::nullopt, row.view(10));
  CHECK_FALSE(row.population[3].adversary);
  CHECK(std::isnan(row.population[3].adversary_distance_m));
  row.population.turn(3, 0.4);
  row.population.show_tag(3, -1);
  row.population.restart_tag_clock(3, 20.0);
  CHECK(row.population[3].target_angle_rad == 0.4);
  CHECK(row.population[3].tag == -1);
  CHECK(row.population[3].tag_since_s == 20.0);
  CHECK(row.population[3].id == 3);
}

TEST_CASE("population: parentage called twice -> same result, nothing changed") {
  Row<rules::Paper> row;
  const reproduction::Vacancy vacancy{.body = 0, .cause = Cause::caught, .killer = 3};
  const auto first = parentage_of(row.policies, row.population, vacancy, row.view(1));
  const auto second = parentage_of(row.policies, row.population, vacancy, row.view(1));
  CHECK(first.descent == second.descent);
  CHECK(row.population.next_id() == 4);
  CHECK(row.population[0].id == 0);
}

TEST_CASE("population: many births -> two thirds inherit, by id, independent of earlier draws") {
  Row<rules::Paper> row;
  int inherited = 0;
  constexpr int births = 20'000;
  for (int i = 0; i < births; ++i) {
    row.catch_first(i);
    if (row.population[0].origin == Origin::inherited) ++inherited;
  }
  CHECK(inherited == doctest::Approx(births * 2.0 / 3.0).epsilon(4.0 * std::sqrt(0.5 / births)));
  CHECK(row.population.next_id() == 4 + births);

  Row<rules::Paper> fewer{{}, {prey, predator}};
  Row<rules::Paper> more;
  CHECK(fewer.population[1].genome->weights == more.population[1].genome->weights);
}

TEST_CASE("population: activation, new tag, birth -> marked in the tree") {
  Row<rules::Paper> row;
  CHECK(row.population.tree() == nullptr);
  row.population.stand_at(row.poses);
  const auto found = [&](Species species, int tag) {
    View view = row.view(1);
    view.tree = row.population.tree();
    const auto is_species = [&](Species other) { return other == species; };
    const auto accepts = [&](const Individual& other) { return other.species == species && other.tag == tag && other.active; };
    return view.closest(3, accepts, {.among = view.marks(is_species, tag, true)});
  };
  CHECK_FALSE(found(prey, 1));
  row.population.activate(1, 0.0, false);
  CHECK(found(prey, 1) == 1);
  CHECK_FALSE(found(prey, -1));
  row.population.show_tag(1, -1);
  CHECK(found(prey, -1) == 1);
  CHECK(found(predator, 1) == 2);
  row.population.show_tag(2, -1);
  row.catch_first(1);  // a predator is born in body 0
  row.population.show_tag(0, 1);
  CHECK(found(predator, 1) == 0);
}
