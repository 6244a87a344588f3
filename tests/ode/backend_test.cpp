// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <ode/scene.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <support/temporary_folder.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/backend/ode/ground.hpp>
#include <trophic/backend/ode/robot.hpp>
#include <vector>

using trophic::backend::Ode;
using trophic::backend::ode::Solver;
using trophic::test::crowd;
using trophic::test::message_of;
using trophic::test::OdeWorld;
using trophic::test::walk;

namespace {

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("ODE backend: any number of threads, touching robots -> same bits") {
  for (const Solver solver : {Solver::quick_step, Solver::world_step}) {
    OdeWorld world;
    world.starts = crowd(solver == Solver::quick_step ? 3 : 2, 0.27, world.robot.rest_height_m);
    world.params.solver = solver;
    Ode one = world.make();
    world.params.threads = 3;
    Ode three = world.make();
    walk(one, 0.5);
    walk(three, 0.5);
    CHECK(one.save() == three.save());
    CHECK((one.pose(3).position_m - world.starts[3].position_m).norm() > 1e-3);
  }
}

TEST_CASE("ODE backend: more than eight sweeps -> reproducible") {
  OdeWorld world;
  world.starts = crowd(2, 0.27, world.robot.rest_height_m);
  world.params.sweeps = 30;
  Ode one = world.make();
  world.params.threads = 2;
  Ode two = world.make();
  walk(one, 0.5);
  dRandSetSeed(12345);
  walk(two, 0.5);
  CHECK(one.save() == two.save());
}

TEST_CASE("ODE backend: up to eight sweeps -> ODE draws no random number") {
  OdeWorld world;
  Ode backend = world.make();
  dRandSetSeed(77);
  walk(backend, 0.2);
  CHECK(dRandGetSeed() == 77);
}

TEST_CASE("ODE backend: robots that do not touch -> motion of each alone") {
  OdeWorld world;
  // Bounding spheres overlap, but legs point past each other.
  const Eigen::Quaterniond diagonal{Eigen::AngleAxisd{0.25 * std::numbers::pi, Eigen::Vector3d::UnitZ()}};
  for (const double x_m : {0.36, 0.72}) world.starts.push_back({.position_m = {x_m, 0.0, world.robot.rest_height_m}});
  for (trophic::Pose& start : world.starts) start.orientation = diagonal;
  REQUIRE(2.0 * world.robot.bounding_radius_m > 0.37);
  for (const Solver solver : {Solver::quick_step, Solver::world_step}) {
    world.params.solver = solver;
    Ode together = world.make();
    together.advance_to(1.0);
    OdeWorld single = world;
    single.starts = {world.starts[2]};
    Ode alone = single.make();
    alone.advance_to(1.0);
    CHECK((together.pose(2).position_m - alone.pose(0).position_m).norm() == 0.0);
  }
}

TEST_CASE("ODE backend: robots meet -> push each other, do not pass through") {
  OdeWorld world;
  world.starts = {{.position_m = {0.0, 0.0, world.robot.rest_height_m}}, {.position_m = {0.0, 0.0, 0.16}}};
  Ode backend = world.make();
  backend.advance_to(2.0);
  // The upper one landed on the other: the middles of two cores are at least a core's thickness apart.
  CHECK((backend.pose(1).position_m - backend.pose(0).position_m).norm() > 0.055);
  CHECK(backend.pose(1).position_m.z() > 0.08);
}

TEST_CASE("ODE backend: height field -> plane in the middle, slopes keep robots in") {
  OdeWorld plane;
  OdeWorld field;
  field.arena = trophic::load_arena("height_field");
  Ode on_plane = plane.make();
  Ode on_field = field.make();
  walk(on_plane, 1.0);
  walk(on_field, 1.0);
  CHECK(on_plane.save() == on_field.save());

  // From the middle of the first slope east, 1.3 m up: it slides down and comes to rest on the floor at its foot.
  field.starts[0].position_m = {9.2, 0.0, 1.0};
  field.physics.gravity_m_s2 = 9.81;
  Ode falling = field.make();
  falling.advance_to(4.0);
  const Eigen::Vector3d at = falling.pose(0).position_m;
  CHECK(at.x() < 9.35);
  CHECK(at.z() > 0.02);
  CHECK(at.z() < 0.2);
}

TEST_CASE("ODE backend: height field -> heights at the right positions") {
  // A ridge along y = +5: only there the floor is high.
  OdeWorld world;
  world.arena.height_field = trophic::HeightField{.nodes = 5, .half_extent_m = 10.0, .height_m = std::vector<double>(25, 0.0)};
  for (std::size_t ix = 0; ix < 5; ++ix) world.arena.height_field->height_m[3 * 5 + ix] = 2.0;
  world.arena.half_side_m = 0.1;
  world.arena.extent_m = 20.0;
  const trophic::backend::ode::EngineGuard guard;
  const trophic::backend::ode::Ground ground{world.arena};
  const auto depth_at = [&](double x_m, double y_m, double z_m) {
    const trophic::backend::ode::GeomPtr box{dCreateBox(nullptr, 0.1, 0.1, 0.1)};
    dGeomSetPosition(box.get(), x_m, y_m, z_m);
    double deepest_m = -1.0;
    ground.for_each_near(dGeomGetPosition(box.get()), 0.1, [&](dGeomID part) {
      std::array<dContactGeom, 8> points{};
      const int found = dCollide(part, box.get(), 8, points.data(), sizeof(dContactGeom));
      for (int i = 0; i < found; ++i) deepest_m = std::max(deepest_m, points[static_cast<std::size_t>(i)].depth);
    });
    return deepest_m;
  };
  CHECK(depth_at(1.3, 5.0, 2.02) > 0.0);
  CHECK(depth_at(1.3, 5.0, 2.10) == -1.0);
  CHECK(depth_at(1.3, -5.0, 0.10) == -1.0);
  CHECK(depth_at(1.3, -5.0, 0.04) == doctest::Approx(0.01).epsilon(1e-6));
  CHECK(depth_at(5.0, 1.3, 0.60) == -1.0);  // on the way up: 2 * 1.3 / 5 = 0.52
  CHECK(depth_at(5.0, 1.3, 0.55) > 0.0);
}

TEST_CASE("ODE backend: feature that ODE lacks -> named error") {
  OdeWorld world;
  const auto complaint = [](const OdeWorld& bad) { return message_of<std::invalid_argument>([&] { (void)bad.make(); }); };
  CHECK(complaint(world).empty());
  OdeWorld bad = world;
  bad.robot.hinges[1].range_rad = 3.1;
  CHECK(contains(complaint(bad), "range_rad = 3.1: must be <= 3"));
  bad = world;
  bad.params.threads = 0;
  CHECK(contains(complaint(bad), "ode.threads = 0"));
  bad = world;
  bad.params.sweeps = 0;
  CHECK(contains(complaint(bad), "ode.sweeps = 0"));
  bad = world;
  bad.starts[0].position_m.x() = 10.5;
  CHECK(contains(complaint(bad), "start pose 0 at (10.5"));
  bad = world;
  bad.starts[0].position_m.y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(complaint(bad), "): must be finite and within +-10"));
  bad = world;
  bad.starts[0].position_m.z() = 1e6;
  CHECK(contains(complaint(bad), "its height must be finite and within +-"));
  bad = world;
  bad.starts[0].orientation.w() = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(complaint(bad), "start pose 0 has an orientation of norm nan: must be > 0.5 and < 2"));
}

TEST_CASE("ODE backend: integrator rk4 -> its own steps, with a remark") {
  OdeWorld world;
  CHECK(Ode::remarks(world.physics).empty());
  Ode usual = world.make();
  world.physics.integrator = trophic::Integrator::rk4;
  Ode asked = world.make();
  walk(usual, 0.5);
  walk(asked, 0.5);
  CHECK(asked.save() == usual.save());
  CHECK(Ode::remarks(world.physics) ==
        std::vector<std::string>{"physics.integrator = rk4 has no effect: ode has its own semi-implicit Euler method"});
}

TEST_CASE("ODE backend: bad commands and states -> rejected") {
  const OdeWorld world;
  Ode backend = world.make();
  const std::array<double, 3> too_few{};
  const std::array<double, 4> not_finite{0.0, std::nan(""), 0.0, 0.0};
  CHECK_THROWS_AS(backend.set_joint_targets(0, too_few), std::invalid_argument);
  CHECK_THROWS_AS(backend.set_joint_targets(0, not_finite), std::invalid_argument);
  CHECK_THROWS_AS(backend.set_joint_targets(1, std::array<double, 4>{}), std::out_of_range);
  Ode::State state = backend.save();
  state.links.pop_back();
  CHECK(contains(message_of<std::invalid_argument>([&] { backend.restore(state); }), "state.links.size() = 4: must be 5"));
}

TEST_CASE("ODE backend: robot diverges -> Diverged with time and robot, last sound state kept") {
  OdeWorld world;
  world.starts.push_back({.position_m = {3.0, 0.0, -15.0}});  // a hard floor shoots it up
  world.params.contact_stiffness_N_m = 1e9;
  Ode backend = world.make();
  const Ode::State start = backend.save();
  try {
    backend.advance_to(1.0);
    FAIL("no exception");
  } catch (const trophic::Diverged& error) {
    CHECK(error.robot() == 1);
    CHECK(error.time_s() == doctest::Approx(0.0012));
    CHECK(contains(error.what(), "simulation diverged at t = 0.0012 s, robot 1: link \"core\" is faster than"));
  }
  CHECK(backend.save() == start);
}

TEST_CASE("ODE backend: ODE reports an error -> Diverged, backend stays usable") {
  OdeWorld world;
  Ode backend = world.make();
  backend.advance_to(0.12);
  const Ode::State sound = backend.save();
  Ode::State broken = sound;
  broken.links[2].velocity_m_s = {std::nan(""), 0.0, 0.0};
  backend.restore(broken);
  CHECK_THROWS_AS(backend.advance_to(1.0), trophic::Diverged);
  backend.restore(sound);
  backend.advance_to(0.24);
  Ode unharmed = world.make();
  unharmed.advance_to(0.24);
  CHECK(backend.save() == unharmed.save());
}
