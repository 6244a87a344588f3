// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <ode/scene.hpp>

#include <cmath>
#include <cstddef>
#include <trophic/backend/ode/compliance.hpp>
#include <trophic/backend/ode/robot.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <vector>

namespace ode = trophic::backend::ode;

TEST_CASE("ODE robot: bodies -> the model's masses and inertias to 1e-9") {
  const ode::EngineGuard guard;
  for (const char* name : {"spider", "gecko"}) {
    CAPTURE(name);
    const trophic::RobotModel model = trophic::load_robot(name);
    const ode::WorldPtr world{dWorldCreate()};
    const ode::Robot robot{world.get(), model, {}, 0.0012};
    REQUIRE(robot.bodies().size() == model.links.size());
    for (std::size_t i = 0; i < model.links.size(); ++i) {
      CAPTURE(i);
      dMass mass;
      dBodyGetMass(robot.bodies()[i], &mass);
      CHECK(std::abs(mass.mass - model.links[i].mass_kg) <= 1e-9 * model.links[i].mass_kg);
      CHECK(std::abs(mass.c[0]) + std::abs(mass.c[1]) + std::abs(mass.c[2]) == 0.0);
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          const double expected = model.links[i].inertia_kgm2(row, column);
          CHECK(std::abs(mass.I[4 * row + column] - expected) <= 1e-9 * model.links[i].inertia_kgm2.norm());
        }
      }
    }
  }
}

TEST_CASE("ODE robot: boxes -> the model's poses") {
  const ode::EngineGuard guard;
  const trophic::RobotModel model = trophic::load_robot("gecko");
  const ode::WorldPtr world{dWorldCreate()};
  ode::Robot robot{world.get(), model, {}, 0.0012};
  const trophic::Pose root{.position_m = {1.0, -2.0, 0.5},
                           .orientation = Eigen::Quaterniond{Eigen::AngleAxisd{0.8, Eigen::Vector3d{1, 2, 3}.normalized()}}};
  std::vector<ode::LinkState> links;
  ode::append_at_rest(model, root, links);
  robot.load(links);

  std::vector<trophic::Pose> frames;
  std::size_t geom = 0;
  for (const trophic::Link& link : model.links) {
    trophic::Pose frame = root;
    if (link.parent >= 0) {
      const trophic::Pose& parent = frames[static_cast<std::size_t>(link.parent)];
      frame = {.position_m = parent.position_m + parent.orientation * link.offset_m,
               .orientation = parent.orientation * link.rotation};
    }
    frames.push_back(frame);
    for (const trophic::Box& box : link.boxes) {
      const dGeomID id = robot.geoms()[geom++].geom.get();
      const Eigen::Vector3d expected_m = frame.position_m + frame.orientation * box.centre_m;
      CHECK((Eigen::Map<const Eigen::Vector3d>{dGeomGetPosition(id)} - expected_m).norm() < 1e-12);
      dQuaternion q;
      dGeomGetQuaternion(id, q);
      CHECK(Eigen::Quaterniond(q[0], q[1], q[2], q[3]).angularDistance(frame.orientation * box.orientation) < 1e-7);
      dVector3 extents_m;
      dGeomBoxGetLengths(id, extents_m);
      CHECK((Eigen::Map<const Eigen::Vector3d>{extents_m} - 2.0 * box.half_extents_m).norm() < 1e-15);
    }
  }
  CHECK(geom == robot.geoms().size());
}

TEST_CASE("ODE robot: links joined by a hinge -> no contacts, others -> contacts") {
  const ode::EngineGuard guard;
  const trophic::RobotModel model = trophic::load_robot("spider");
  const ode::WorldPtr world{dWorldCreate()};
  const ode::Robot robot{world.get(), model, {}, 0.0012};
  CHECK(robot.geoms().size() == 17);
  CHECK(robot.self_pairs().size() == 54);  // six pairs of legs, nine pairs of boxes each
  for (const auto& [a, b] : robot.self_pairs()) {
    const std::size_t links[] = {robot.geoms()[a].link, robot.geoms()[b].link};
    CHECK(links[0] != links[1]);
    CHECK(links[0] != 0);
    CHECK(links[1] != 0);
  }
}

TEST_CASE("compliance: spring as a row -> force at the end of an implicit step") {
  // One row on a mass m: m (v' - v) / h = f, v' + CFM f = ERP (-x) / h.
  const double mass_kg = 0.3, timestep_s = 0.01, x_m = 0.02, v_m_s = -0.4;
  const ode::Spring spring{.stiffness = 70.0, .damping = 1.5};
  const ode::Row row = ode::row_of(spring, timestep_s);
  const double force_N = (-row.erp * x_m / timestep_s - v_m_s) / (timestep_s / mass_kg + row.cfm);
  const double v_end = v_m_s + timestep_s * force_N / mass_kg;
  const double x_end = x_m + timestep_s * v_end;
  CHECK(force_N == doctest::Approx(-spring.stiffness * x_end - spring.damping * v_end).epsilon(1e-12));
}
