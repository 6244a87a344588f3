// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <trophic/habitat/body/descriptors.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <unit/habitat/hand_bodies.hpp>

using namespace trophic;
using namespace trophic::body;

TEST_CASE("descriptors: bodies drawn by hand -> values computed by hand") {
  struct Drawn {
    const char* plan;
    Descriptors expected;
  };
  const Drawn all[]{
      {"core", {.size = 0.05, .proportion = 1, .coverage = 1}},
      // 9 modules in 5 x 5 cells; the core has four faces of floor(7 / 3) = 2; four leaves of 2 * 1 + 0 + 4 = 6; four hinges
      // between core and brick, of floor(8 / 2)
      {hand::spider,
       {.size = 0.45,
        .proportion = 1,
        .coverage = 9.0 / 25,
        .branching = 0.5,
        .limbs = 4.0 / 6,
        .length_of_limbs = 4.0 / 7,
        .symmetry = 1,
        .joints = 1}},
      {hand::plus, {.size = 0.25, .proportion = 1, .coverage = 5.0 / 9, .branching = 1, .limbs = 1, .symmetry = 1}},
      // a chain: one leaf of four, three modules with two faces of m - 2; nothing across either plane
      {hand::snake, {.size = 0.25, .proportion = 0.2, .coverage = 1, .limbs = 0.25, .length_of_limbs = 1, .joints = 1}},
      {hand::one_leg, {.size = 0.15, .proportion = 1.0 / 3, .coverage = 1, .limbs = 0.5, .length_of_limbs = 1, .joints = 1}},
      // a hinge that ends in nothing joins nothing
      {hand::hook, {.size = 0.15, .proportion = 1, .coverage = 0.75, .limbs = 0.5, .length_of_limbs = 1}},
      // two legs and one brick that only the left side has: 4 of 5 modules off y = 0
      {"core[left:hinge0[front:brick0[front:brick0]] right:hinge0[front:brick0]]",
       {.size = 0.3, .proportion = 1.0 / 6, .coverage = 1, .limbs = 0.5, .length_of_limbs = 0.75, .symmetry = 0.8, .joints = 1}},
      // the brick's left side, turned once about x, points up
      {"core[front:brick1[left:brick0]]",
       {.size = 0.15, .proportion = 0.5, .coverage = 0.75, .limbs = 0.5, .length_of_limbs = 1}},
  };
  for (const auto& one : all) {
    CAPTURE(one.plan);
    const Descriptors& expected = one.expected;
    const Descriptors found = descriptors_of(read_plan(one.plan), 20);
    for_each_field(found, [&](const auto& field, double value) {
      CAPTURE(field.name);
      CHECK(value == doctest::Approx(expected.*(field.member)).epsilon(1e-12));
    });
  }
}

TEST_CASE("descriptors: the gecko -> 13 modules, symmetric left and right") {
  const ModuleTree gecko = load_design("gecko").modules;
  const Descriptors found = descriptors_of(gecko, 13);
  CHECK(count(gecko, ModuleType::hinge) == 6);
  CHECK(count(gecko, ModuleType::brick) == 6);
  CHECK(found.size == 1.0);
  CHECK(found.symmetry == 1.0);
  CHECK(found.joints == 1.0);
  CHECK(found.limbs == 4.0 / 9.0);       // l_max = 2 * 2 + 1 + 4
  CHECK(found.coverage == 13.0 / 25.0);  // 5 cells along x, 5 along y
  CHECK(found.branching == 0.0);         // core and last brick have three faces attached
}

TEST_CASE("descriptors: any tree -> within 0 and 1, mirrored tree -> the same") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const ModuleTree tree = random_tree(1 + rng.index(30), rng);
    const Descriptors found = descriptors_of(tree, 30);
    for_each_field(found, [](const auto&, double value) { RC_ASSERT((value >= 0.0 && value <= 1.0)); });
    ModuleTree image;
    for (const Module& module : tree.modules()) {
      if (!module.parent) continue;
      const Face face = module.face == Face::left ? Face::right : module.face == Face::right ? Face::left : module.face;
      (void)image.attach(*module.parent, face, module.type, -module.quarter_turns);
    }
    RC_ASSERT((descriptors_of(image, 30) == found));
  }));
}
