// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <memory>
#include <trophic/reproduction/heredity/all_but.hpp>
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
