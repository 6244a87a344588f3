// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <trophic/habitat/body/distance.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <unit/habitat/hand_bodies.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::body;

namespace {

using Forest = std::vector<std::size_t>;  ///< roots of subtrees

Forest with_children(const ModuleTree& tree, const Forest& rest, std::size_t root) {
  Forest all = rest;
  for (const auto& child : tree.modules()[root].children)
    if (child) all.push_back(*child);
  return all;
}

std::size_t modules(const ModuleTree& tree, std::size_t root) {
  std::size_t sum = 1;
  for (const auto& child : tree.modules()[root].children)
    if (child) sum += modules(tree, *child);
  return sum;
}

/// The definition, by trying everything.
std::size_t slowly(const ModuleTree& a, Forest left, const ModuleTree& b, Forest right) {
  std::size_t all = 0;
  if (left.empty() || right.empty()) {
    for (const std::size_t root : left) all += modules(a, root);
    for (const std::size_t root : right) all += modules(b, root);
    return all;
  }
  const std::size_t one = left.back();
  const std::size_t other = right.back();
  left.pop_back();
  right.pop_back();
  const Module& x = a.modules()[one];
  const Module& y = b.modules()[other];
  Forest right_whole = right;
  right_whole.push_back(other);
  Forest left_whole = left;
  left_whole.push_back(one);
  const bool differ = x.type != y.type || x.face != y.face || x.quarter_turns != y.quarter_turns;
  return std::min(
      {1 + slowly(a, with_children(a, left, one), b, right_whole), 1 + slowly(a, left_whole, b, with_children(b, right, other)),
       (differ ? 1 : 0) + slowly(a, left, b, right) + slowly(a, with_children(a, {}, one), b, with_children(b, {}, other))});
}

}  // namespace

TEST_CASE("edit distance: plans drawn by hand -> number of changes") {
  const auto distance = [](const char* a, const char* b) { return edit_distance(read_plan(a), read_plan(b)); };
  CHECK(distance("core", "core") == 0);
  CHECK(distance(hand::spider, hand::spider) == 0);
  CHECK(distance("core", hand::spider) == 8);
  CHECK(distance("core[front:hinge0]", "core[front:hinge1]") == 1);
  CHECK(distance("core[front:hinge0]", "core[left:brick1]") == 1);
  CHECK(distance(hand::one_leg, "core[left:brick0]") == 2);  // the brick was attached to the front
  CHECK(distance(hand::snake, "core[front:hinge0[front:brick0]]") == 2);
  CHECK(distance(hand::spider, hand::plus) == 7);  // a hinge less and a brick changed on each leg; the front brick stays
}

TEST_CASE("edit distance: any small trees -> that of trying everything") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const ModuleTree a = random_tree(1 + rng.index(5), rng);
    const ModuleTree b = random_tree(1 + rng.index(5), rng);
    RC_ASSERT(edit_distance(a, b) == slowly(a, {0}, b, {0}));
  }));
}

TEST_CASE("edit distance: any three plans -> a metric") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::user};
    const ModuleTree a = random_tree(1 + rng.index(20), rng);
    const ModuleTree b = mutated(a, {}, 0.0, rng);
    const ModuleTree c = random_tree(1 + rng.index(20), rng);
    RC_ASSERT((edit_distance(a, b) == 0) == (text_of(a) == text_of(b)));
    RC_ASSERT(edit_distance(a, c) == edit_distance(c, a));
    RC_ASSERT(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
  }));
}

TEST_CASE("shannon number: counts -> hill's number of order 1") {
  CHECK(shannon_number({}) == 0.0);
  CHECK(shannon_number(std::array<std::size_t, 3>{0, 7, 0}) == 1.0);
  CHECK(shannon_number(std::array<std::size_t, 4>{5, 5, 5, 5}) == doctest::Approx(4.0));
  CHECK(shannon_number(std::array<std::size_t, 2>{3, 1}) == doctest::Approx(std::pow(4.0, 1.0) / std::pow(27.0, 0.25)));
}
