// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/body/descriptors.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <unit/habitat/hand_bodies.hpp>

using namespace trophic;
using namespace trophic::body;

namespace {

/// All results of an operator in 400 tries.
std::set<std::string> results(const char* plan, TreeOperator how, double forward_deg = 0.0) {
  std::set<std::string> found;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Rng rng{seed, Stream::user};
    found.insert(text_of(changed(read_plan(plan), how, forward_deg, rng)));
  }
  return found;
}

/// Draws that an operator takes, counted by the place at which an equal stream continues with the same bits.
std::size_t draws(const char* plan, TreeOperator how) {
  Rng used{7, Stream::user};
  (void)changed(read_plan(plan), how, 0.0, used);
  const std::uint64_t next = used.bits();
  Rng fresh{7, Stream::user};
  std::size_t count = 0;
  while (fresh.bits() != next) ++count;
  return count;
}

}  // namespace

TEST_CASE("tree operators: hand-drawn plan -> every result that is possible, and no other") {
  using Texts = std::set<std::string>;
  CHECK(results("core", TreeOperator::add).size() == 4 * 2 * 4);
  CHECK(results("core[front:hinge0]", TreeOperator::add).contains("core[front:hinge0[front:brick3]]"));
  CHECK(results(hand::hook, TreeOperator::remove) == Texts{"core[front:brick0]"});
  CHECK(results(hand::hook, TreeOperator::cut) == Texts{"core[front:brick0]", "core"});
  CHECK(results("core[left:hinge2]", TreeOperator::copy) ==
        Texts{"core[front:hinge2 left:hinge2]", "core[back:hinge2 left:hinge2]", "core[left:hinge2 right:hinge2]",
              "core[left:hinge2[front:hinge2]]"});
  CHECK(results(hand::one_leg, TreeOperator::mirror) == Texts{"core[left:hinge0[front:brick0] right:hinge0[front:brick0]]"});
  CHECK(results("core[front:brick0[left:hinge1]]", TreeOperator::mirror) ==
        Texts{"core[front:brick0[left:hinge1 right:hinge3]]"});
  CHECK(results("core[front:hinge0 left:brick1]", TreeOperator::swap) == Texts{"core[front:brick1 left:hinge0]"});
  CHECK(results("core[front:hinge0]", TreeOperator::turn) ==
        Texts{"core[front:hinge1]", "core[front:hinge2]", "core[front:hinge3]"});
  CHECK(results(hand::hook, TreeOperator::change) == Texts{"core[front:brick0[left:brick0]]"});
  CHECK(results("core[front:brick0[front:hinge0]]", TreeOperator::change) ==
        Texts{"core[front:hinge0[front:hinge0]]", "core[front:brick0[front:brick0]]"});
}

TEST_CASE("tree operators: forward axis at 45 degrees -> mirror exchanges front with left, back with right") {
  CHECK(results("core[front:hinge1]", TreeOperator::mirror, 45.0) == std::set<std::string>{"core[front:hinge1 left:hinge3]"});
  CHECK(results("core[front:hinge1]", TreeOperator::mirror, -135.0) == std::set<std::string>{"core[front:hinge1 left:hinge3]"});
  CHECK(results("core[front:hinge1]", TreeOperator::mirror, 90.0) == std::set<std::string>{"core[front:hinge1 back:hinge3]"});
  CHECK(results("core[front:hinge1]", TreeOperator::mirror, -40.0) == std::set<std::string>{"core[front:hinge1 right:hinge3]"});
}

TEST_CASE("tree operators: nothing to change -> same plan without a draw") {
  for (const TreeOperator how : {TreeOperator::remove, TreeOperator::cut, TreeOperator::copy, TreeOperator::mirror,
                                 TreeOperator::swap, TreeOperator::turn, TreeOperator::change}) {
    CAPTURE(enum_name(how));
    CHECK(results("core", how) == std::set<std::string>{"core"});
    CHECK(draws("core", how) == 0);
  }
  CHECK(results(hand::snake, TreeOperator::mirror) == std::set<std::string>{hand::snake});
}

TEST_CASE("tree operators: a change -> as many draws as documented") {
  CHECK(draws(hand::spider, TreeOperator::add) == 3);
  CHECK(draws(hand::spider, TreeOperator::remove) == 1);
  CHECK(draws(hand::spider, TreeOperator::cut) == 1);
  CHECK(draws(hand::spider, TreeOperator::copy) == 2);
  CHECK(draws(hand::one_leg, TreeOperator::mirror) == 1);
  CHECK(draws(hand::spider, TreeOperator::swap) == 2);
  CHECK(draws(hand::spider, TreeOperator::turn) == 1);
  CHECK(draws(hand::spider, TreeOperator::change) == 1);
}

TEST_CASE("tree operators: any tree and any operator -> a robot, in canonical order") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    ModuleTree tree = random_tree(1 + rng.index(15), rng);
    for (int i = 0; i < 8; ++i) {
      const auto how = static_cast<TreeOperator>(rng.index(8));
      const std::size_t before = tree.modules().size();
      tree = changed(tree, how, 45.0 * static_cast<double>(rng.index(8)), rng);
      const std::size_t after = tree.modules().size();
      const bool grows = how == TreeOperator::add || how == TreeOperator::copy || how == TreeOperator::mirror;
      const bool shrinks = how == TreeOperator::remove || how == TreeOperator::cut || how == TreeOperator::mirror;
      RC_ASSERT((grows || after <= before));
      RC_ASSERT((shrinks || after >= before));
      RC_ASSERT(genes_of(tree) == genes_of(in_canonical_order(tree)));
      Design design;
      design.name = "changed";
      design.modules = tree;
      (void)build(design);  // validates
    }
  }));
}

TEST_CASE("tree operators: mirror of a branch of a rolled module -> the branch's image in space") {
  // The first brick's left side is up: in the mirror plane, where a branch is its own image.
  CHECK(results("core[front:brick1[left:brick0[left:hinge0]]]", TreeOperator::mirror) ==
        std::set<std::string>{"core[front:brick1[left:brick0[left:hinge0]]]"});
  // The hinge on that branch's front turned to the side: its image is on the other side.
  CHECK(results("core[front:brick1[left:brick1[left:hinge0]]]", TreeOperator::mirror) ==
        std::set<std::string>{"core[front:brick1[left:brick1[left:hinge0 right:hinge0]]]"});
}

TEST_CASE("tree operators: mirrored again and again -> nearly symmetric bodies") {
  const auto symmetry = [](const ModuleTree& plan) {
    double matched = 0.0;
    for (const Module& one : plan.modules()) {
      for (const Module& other : plan.modules())
        matched += other.type == one.type && other.cell == Eigen::Vector3i{one.cell.x(), -one.cell.y(), one.cell.z()};
    }
    return matched / static_cast<double>(plan.modules().size());
  };
  double before = 0.0;
  double after = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng{seed, Stream::user};
    ModuleTree tree = random_tree(8, rng);
    before += symmetry(tree) / 40.0;
    for (int i = 0; i < 20; ++i) tree = changed(tree, TreeOperator::mirror, 0.0, rng);
    after += symmetry(tree) / 40.0;
  }
  CHECK(before < 0.7);
  CHECK(after > 0.95);
}

TEST_CASE("tree mutation: probability 0 -> same plan, 1 -> all operators, 0.15 -> as often") {
  const ModuleTree spider = read_plan(hand::spider);
  const TreeMutation none{.add = 0, .remove = 0, .cut = 0, .copy = 0, .mirror = 0, .swap = 0, .turn = 0, .change = 0};
  Rng rng{1, Stream::user};
  CHECK(text_of(mutated(spider, none, 45.0, rng)) == hand::spider);
  CHECK(rng.bits() == [] {
    Rng fresh{1, Stream::user};
    for (int i = 0; i < 8; ++i) (void)fresh.bits();
    return fresh.bits();
  }());
  TreeMutation adds = none;
  adds.add = 0.15;
  int larger = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Rng stream{seed, Stream::user};
    larger += mutated(spider, adds, 45.0, stream).modules().size() == 10;
  }
  CHECK(larger > 300 - 4 * 16);  // 4 standard deviations of a binomial of 2000 and 0.15
  CHECK(larger < 300 + 4 * 16);
}

TEST_CASE("random tree: n modules -> n modules, each place as likely") {
  std::map<std::string, int> found;
  for (std::uint64_t seed = 0; seed < 3200; ++seed) {
    Rng rng{seed, Stream::user};
    ++found[text_of(random_tree(2, rng))];
    Rng other{seed, Stream::user};
    CHECK(random_tree(12, other).modules().size() == 12);
  }
  CHECK(found.size() == 32);
  for (const auto& plan_and_times : found) {
    CAPTURE(plan_and_times.first);
    CHECK(plan_and_times.second > 60);  // 100 expected, 4 standard deviations of 9.8
    CHECK(plan_and_times.second < 140);
  }
}
