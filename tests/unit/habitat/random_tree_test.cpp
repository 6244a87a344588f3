// SPDX-License-Identifier: MIT
// Properties of robots built from random module trees.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <stdexcept>
#include <trophic/control/steering/targeted_steering.hpp>
#include <trophic/habitat/body/build.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::body;

namespace {

struct Attachment {
  std::size_t parent;
  Face face;
  ModuleType type;
  int quarter_turns;
};

/// Attachments that a tree accepts, out of random tries.
std::vector<Attachment> random_attachments() {
  ModuleTree tree;
  std::vector<Attachment> accepted;
  const int tries = *rc::gen::inRange(0, 30);
  for (int i = 0; i < tries; ++i) {
    const Attachment next{.parent = *rc::gen::inRange<std::size_t>(0, tree.modules().size()),
                          .face = *rc::gen::elementOf(all_faces),
                          .type = *rc::gen::element(ModuleType::hinge, ModuleType::brick),
                          .quarter_turns = *rc::gen::inRange(0, 4)};
    try {
      (void)tree.attach(next.parent, next.face, next.type, next.quarter_turns);
      accepted.push_back(next);
    } catch (const std::invalid_argument&) {
    }
  }
  return accepted;
}

Design design_of(const std::vector<Attachment>& attachments) {
  Design design;
  design.name = "random";
  for (const Attachment& a : attachments) (void)design.modules.attach(a.parent, a.face, a.type, a.quarter_turns);
  return design;
}

/// Centre of mass and inertia about the root frame's origin, all angles 0.
struct Whole {
  double mass_kg = 0.0;
  Eigen::Vector3d moment_kgm = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kgm2 = Eigen::Matrix3d::Zero();
};

Whole sum(const RobotModel& robot) {
  Whole whole;
  std::vector<Eigen::Isometry3d> frames(robot.links.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    if (i > 0) {
      frames[i] = frames[static_cast<std::size_t>(link.parent)] * Eigen::Translation3d{link.offset_m} * link.rotation;
    }
    const Eigen::Vector3d centre = frames[i] * link.centre_of_mass_m;
    const Eigen::Matrix3d turn = frames[i].linear();
    whole.mass_kg += link.mass_kg;
    whole.moment_kgm += link.mass_kg * centre;
    whole.inertia_kgm2 += turn * link.inertia_kgm2 * turn.transpose() +
                          link.mass_kg * (centre.squaredNorm() * Eigen::Matrix3d::Identity() - centre * centre.transpose());
  }
  return whole;
}

Face mirrored(Face face) {
  if (face == Face::left) return Face::right;
  return face == Face::right ? Face::left : face;
}

}  // namespace

TEST_CASE("random trees: any tree -> valid robot with the mass of its parts") {
  CHECK(rc::check([] {
    const Design design = design_of(random_attachments());
    const RobotModel robot = build(design);  // validates
    double mass_kg = 0.250;
    std::size_t hinges = 0;
    for (const Module& module : design.modules.modules()) {
      if (module.type == ModuleType::hinge) mass_kg += 0.011 + 0.058 + 0.020;
      if (module.type == ModuleType::brick) mass_kg += 0.030;
      hinges += module.type == ModuleType::hinge;
    }
    RC_ASSERT(robot.hinges.size() == hinges);
    RC_ASSERT(std::abs(robot.mass_kg() - mass_kg) < 1e-12);
    RC_ASSERT(robot.rest_height_m >= 0.03015 - 1e-15);
    RC_ASSERT(robot.rest_height_m <= robot.bounding_radius_m);
  }));
}

TEST_CASE("random trees: hinge neighbours -> at most two attachments apart, all others farther") {
  CHECK(rc::check([] {
    const Design design = design_of(random_attachments());
    const RobotModel robot = build(design);
    const auto index_of = [&](const std::string& path) {
      for (std::size_t m = 0; m < design.modules.modules().size(); ++m) {
        if (design.modules.path(m) == path) return m;
      }
      throw std::logic_error{path};
    };
    for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
      const std::size_t module = index_of(robot.hinges[i].name);
      RC_ASSERT(robot.hinges[i].grid_position == design.modules.modules()[module].cell);
      for (std::size_t j = 0; j < robot.hinges.size(); ++j) {
        if (i == j) continue;
        const bool near = design.modules.distance(module, index_of(robot.hinges[j].name)) <= 2;
        RC_ASSERT(std::ranges::binary_search(robot.hinge_neighbours[i], j) == near);
      }
    }
  }));
}

TEST_CASE("random trees: mirrored tree -> mirrored robot") {
  CHECK(rc::check([] {
    std::vector<Attachment> attachments = random_attachments();
    const RobotModel robot = build(design_of(attachments));
    for (Attachment& a : attachments) {
      a.face = mirrored(a.face);
      a.quarter_turns = -a.quarter_turns;
    }
    const RobotModel image = build(design_of(attachments));
    const Eigen::DiagonalMatrix<double, 3> mirror{1.0, -1.0, 1.0};
    const Whole one = sum(robot);
    const Whole other = sum(image);
    RC_ASSERT(std::abs(one.mass_kg - other.mass_kg) < 1e-12);
    RC_ASSERT((mirror * one.moment_kgm - other.moment_kgm).norm() < 1e-12);
    RC_ASSERT((mirror * one.inertia_kgm2 * mirror - other.inertia_kgm2).norm() < 1e-12);
    RC_ASSERT(std::abs(robot.rest_height_m - image.rest_height_m) < 1e-12);
    RC_ASSERT(std::abs(robot.bounding_radius_m - image.bounding_radius_m) < 1e-12);
    // What slows down for a right turn of one slows down for a left turn of the other.
    std::size_t left = 0;
    std::size_t right = 0;
    for (const HingePlace& hinge : hinge_places(robot)) left += hinge.side == Side::left;
    for (const HingePlace& hinge : hinge_places(image)) right += hinge.side == Side::right;
    RC_ASSERT(left == right);
  }));
}
