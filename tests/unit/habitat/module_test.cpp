// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/habitat/body/module.hpp>

using namespace trophic;
using namespace trophic::body;
using trophic::test::message_of;

TEST_CASE("module tree: module -> grid cell in the direction of its face") {
  ModuleTree tree;
  const auto left = tree.attach(0, Face::left, ModuleType::hinge, 1);
  const auto brick = tree.attach(left, Face::front, ModuleType::brick);
  const auto beyond = tree.attach(brick, Face::left, ModuleType::brick);
  const auto& modules = tree.modules();
  CHECK(modules[left].cell == Eigen::Vector3i{0, 1, 0});
  CHECK(modules[brick].cell == Eigen::Vector3i{0, 2, 0});
  // The hinge's quarter turn about the leg's axis turns the brick's left face up.
  CHECK(modules[beyond].cell == Eigen::Vector3i{0, 2, 1});
  CHECK(tree.path(0) == "core");
  CHECK(tree.path(beyond) == "left.front.left");
}

TEST_CASE("module tree: distance -> number of attachments between two modules") {
  ModuleTree tree;
  const auto left = tree.attach(0, Face::left, ModuleType::hinge);
  const auto right = tree.attach(0, Face::right, ModuleType::hinge);
  const auto brick = tree.attach(left, Face::front, ModuleType::brick);
  CHECK(tree.distance(left, left) == 0);
  CHECK(tree.distance(0, brick) == 2);
  CHECK(tree.distance(left, right) == 2);
  CHECK(tree.distance(brick, right) == 3);
}

TEST_CASE("module tree: module that cannot be attached -> error, tree unchanged") {
  ModuleTree tree;
  const auto hinge = tree.attach(0, Face::front, ModuleType::hinge);
  const auto brick = tree.attach(hinge, Face::front, ModuleType::brick);
  const auto attach = [&](std::size_t parent, Face face, ModuleType type) {
    return message_of<std::invalid_argument>([&] { (void)tree.attach(parent, face, type); });
  };
  CHECK(attach(0, Face::front, ModuleType::brick) == "front: two modules on one face");
  CHECK(attach(0, Face::back, ModuleType::core) == "back: a robot has only one core");
  CHECK(attach(hinge, Face::left, ModuleType::brick) == "front.left: a hinge has no left face");
  CHECK(attach(brick, Face::back, ModuleType::brick) == "front.front.back: a brick has no back face");
  CHECK(attach(7, Face::back, ModuleType::brick) == "parent = 7: must be < 3");
  CHECK(tree.modules().size() == 3);
}

TEST_CASE("module tree: overlapping modules -> error") {
  ModuleTree tree;
  std::size_t corner = tree.attach(0, Face::front, ModuleType::brick);
  corner = tree.attach(corner, Face::left, ModuleType::brick);
  corner = tree.attach(corner, Face::left, ModuleType::brick);
  CHECK(message_of<std::invalid_argument>([&] { (void)tree.attach(corner, Face::left, ModuleType::hinge); }) ==
        "front.left.left.left: overlaps module core");
}
