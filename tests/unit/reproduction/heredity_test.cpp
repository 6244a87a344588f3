// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <memory>
#include <numeric>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <trophic/reproduction/heredity/crossover.hpp>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>
#include <trophic/reproduction/heredity/own_copy.hpp>
#include <trophic/reproduction/heredity/shared_copy.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/rules/by_species.hpp>
#include <unit/reproduction/births.hpp>
#include <vector>

using namespace trophic;
using namespace reproduction::heredity;

TEST_CASE("all but: one part of the genome -> drawn anew, the others inherited") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {1}, .gait_genes = {2}, .body_genes = {3}});
  CHECK(AllButBrain{}.inherit(parent)->weights.empty());
  CHECK(AllButBrain{}.inherit(parent)->gait_genes == std::vector<double>{2});
  CHECK(AllButGait{}.inherit(parent)->gait_genes.empty());
  CHECK(AllButGait{}.inherit(parent)->body_genes == std::vector<double>{3});
  CHECK(AllButBody{}.inherit(parent)->body_genes.empty());
  CHECK(AllButBody{}.inherit(parent)->weights == std::vector<double>{1});
  CHECK(parent->body_genes == std::vector<double>{3});
  test::Births<with_heredity<test::Evolving, AllButBody>> births;
  const std::vector<double> first = body::genes_of(births.habitat.design->modules);
  for (int birth = 0; birth < 40; ++birth)
    CHECK(births.birth(birth % 2 == 0 ? 0 : 2, birth % 2 == 0 ? 2 : 0).genome->body_genes == first);
}

TEST_CASE("nothing inherited: any parent -> no genome passed on") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.5}});
  CHECK(reproduction::heredity::NothingInherited{}.inherit(parent) == nullptr);
}

TEST_CASE("switched: off for one species -> its offspring inherit nothing, the other's as ever") {
  using Rules = with_heredity<rules::Paper, rules::by_species<Switched<OwnCopy>>>;
  for (const bool inherited : {true, false}) {
    test::Births<Rules> births{[&](auto& params) { params.heredity.template get<test::predator>().inherited = inherited; }};
    const auto before = (*births.population)[2].genome->weights;
    const auto after = births.birth(0, 2).genome->weights;
    CHECK((std::abs(after[0] - before[0]) < 0.3) == inherited);
  }
  CHECK(Switched<OwnCopy>::name == "switched_own_copy");
}

TEST_CASE("own copy: parent -> equal weights in another object, parent unchanged by mutation") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const auto offspring = reproduction::heredity::OwnCopy{}.inherit(parent);
  REQUIRE(offspring != parent);
  CHECK(offspring->weights == parent->weights);
  offspring->weights[0] = 9.0;
  CHECK(parent->weights == std::vector<double>{0.25, -0.5});
}

TEST_CASE("shared copy: parent, offspring and grandchild -> one object, each mutation reaches all") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const reproduction::heredity::SharedCopy rule;
  const auto offspring = rule.inherit(parent);
  const auto grandchild = rule.inherit(offspring);
  grandchild->weights[1] = 1.0;
  CHECK(parent->weights[1] == 1.0);
  CHECK(offspring->weights[1] == 1.0);
  CHECK(grandchild->id == 3);
}

TEST_CASE("crossover: two parents -> each gene is one parent's, about half of them, and the body the first one's") {
  const auto genome = [](double value) {
    return std::make_shared<Genome>(
        Genome{.weights = std::vector<double>(300, value), .gait_genes = std::vector<double>(30, value), .body_genes = {value}});
  };
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = genome(1.0)},
                                      {.id = 2, .species = 0, .genome = genome(2.0)}};
  const auto sum = [](const std::vector<double>& genes) { return std::accumulate(genes.begin(), genes.end(), 0.0); };
  Rng rng{1, Stream::user};
  const auto child = Crossover{}.inherit(parents, rng);
  for (const double weight : child->weights) CHECK((weight == 1.0 || weight == 2.0));
  CHECK(sum(child->weights) == doctest::Approx(450.0).epsilon(0.08));
  CHECK(sum(child->gait_genes) > 30.0);
  CHECK(sum(child->gait_genes) < 60.0);
  CHECK(child->body_genes == std::vector<double>{1.0});
  CHECK(sum(parents[0].genome->weights) == 300.0);

  const Crossover runs{{.unit = CrossoverUnit::run, .length = 3}};
  const auto by_runs = runs.inherit(parents, rng);
  for (std::size_t gene = 0; gene < 300; ++gene) CHECK(by_runs->weights[gene] == by_runs->weights[gene - gene % 3]);
}

TEST_CASE("crossover: one parent, or parts of other lengths -> the first one's genes") {
  const auto first = std::make_shared<Genome>(Genome{.weights = {1.0, 2.0}});
  const auto second = std::make_shared<Genome>(Genome{.weights = {3.0}});
  const std::vector<Ancestor> parents{{.id = 1, .species = 0, .genome = first}, {.id = 2, .species = 0, .genome = second}};
  Rng rng{1, Stream::user};
  CHECK(Crossover{}.inherit(parents, rng)->weights == first->weights);
  CHECK(Crossover{}.inherit(std::span{parents}.first(1), rng)->weights == first->weights);
  CHECK(Crossover{}.inherit(parents, rng) != first);
}
