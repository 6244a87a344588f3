// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/habitat/body/variation.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <unit/habitat/hand_bodies.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::body;

TEST_CASE("plan: shipped robots -> text and genes of the hand-drawn plan") {
  CHECK(text_of(load_design("spider").modules) == hand::spider);
  CHECK(genes_of(read_plan(hand::hook)) == std::vector<double>{0, 0, 2, 0, 1, 2, 1, 0});
  CHECK(genes_of(ModuleTree{}).empty());
  CHECK(text_of(ModuleTree{}) == "core");
}

TEST_CASE("plan: any tree -> same plan from its genes and from its text") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    Rng rng{seed, Stream::user};
    const ModuleTree tree = random_tree(1 + seed % 25, rng);
    CHECK(text_of(tree_of(genes_of(tree))) == text_of(tree));
    CHECK(text_of(read_plan(text_of(tree))) == text_of(tree));
    CHECK(genes_of(read_plan(text_of(tree))) == genes_of(tree));
  }
}

TEST_CASE("plan: modules attached in another order -> same genes and text") {
  ModuleTree late;
  const std::size_t left = late.attach(0, Face::left, ModuleType::brick, 6);
  (void)late.attach(0, Face::front, ModuleType::hinge);
  (void)late.attach(left, Face::right, ModuleType::hinge, -1);
  CHECK(text_of(late) == "core[front:hinge0 left:brick2[right:hinge3]]");
  CHECK(genes_of(late) == std::vector<double>{0, 0, 1, 0, 0, 2, 2, 2, 2, 3, 1, 3});
  CHECK(in_canonical_order(late).modules()[1].type == ModuleType::hinge);
}

TEST_CASE("plan: genes of no plan -> error that names the gene") {
  const auto message = [](const std::vector<double>& genes) {
    return test::message_of<std::invalid_argument>([&] { (void)tree_of(genes); });
  };
  CHECK(message({0, 0, 1}) == "3 body genes: must be a multiple of 4 and < 4000");
  CHECK(message(std::vector<double>(4000, 0.0)) == "4000 body genes: must be a multiple of 4 and < 4000");
  CHECK(message({1, 0, 1, 0}) == "body gene 0 = 1: must be a whole number >= 0 and < 1");
  CHECK(message({0, 0.5, 1, 0}) == "body gene 1 = 0.5: must be a whole number >= 0 and < 4");
  CHECK(message({0, 0, 0, 0}) == "body gene 2 = 0: must be a whole number >= 1 and < 3");
  CHECK(message({0, 0, 1, std::nan("")}).starts_with("body gene 3 = nan: must be"));
  CHECK(message({0, 0, 1, 0, 0, 0, 2, 0}) == "body genes 4 to 7: front: two modules on one face");
  CHECK(message({0, 0, 1, 0, 1, 2, 2, 0}) == "body genes 4 to 7: front.left: a hinge has no left face");
}

TEST_CASE("plan: text of no plan -> error that names the character") {
  const auto message = [](const std::string& text) {
    return test::message_of<std::invalid_argument>([&] { (void)read_plan(text); });
  };
  CHECK(message("") == "body plan \"\", character 1: must be core");
  CHECK(message("core[]") == "body plan \"core[]\", character 6: must be a face");
  CHECK(message("core[front:wheel0]") == "body plan \"core[front:wheel0]\", character 12: must be hinge or brick");
  CHECK(message("core[front:hinge4]") == "body plan \"core[front:hinge4]\", character 17: must be quarter turns of 0 to 3");
  CHECK(message("core[front:hinge0") == "body plan \"core[front:hinge0\", character 18: must be ] or a space");
  CHECK(message("core[front:hinge0]x") == "body plan \"core[front:hinge0]x\", character 19: must be [ or the end");
  CHECK(message("core[left:brick0 left:brick0]") ==
        "body plan \"core[left:brick0 left:brick0]\", character 18: must be a module that fits (left: two modules on one face)");
  std::string endless{"core"};
  for (int i = 0; i < 1001; ++i) endless += "[front:brick0";
  CHECK(message(endless).ends_with("must be no more than 1000 modules"));
}
