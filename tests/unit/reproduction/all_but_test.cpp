// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <trophic/reproduction/heredity/all_but.hpp>
#include <unit/reproduction/births.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::reproduction::heredity;

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
