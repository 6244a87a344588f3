// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <mujoco/worlds.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/mjcf.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>

using namespace trophic;
using backend::Mujoco;
namespace engine = backend::mujoco;

namespace {

/// The body's inertia in its own frame, as the compiled model has it.
Eigen::Matrix3d inertia_of(const mjModel& model, int body) {
  const double* q = model.body_iquat + 4 * body;
  const double* i = model.body_inertia + 3 * body;
  const Eigen::Matrix3d turn = Eigen::Quaterniond{q[0], q[1], q[2], q[3]}.toRotationMatrix();
  return turn * Eigen::Vector3d{i[0], i[1], i[2]}.asDiagonal() * turn.transpose();
}

engine::ModelPtr load(const std::filesystem::path& path) {
  std::array<char, 1000> error{};
  engine::ModelPtr model{mj_loadXML(path.c_str(), nullptr, error.data(), static_cast<int>(error.size()))};
  REQUIRE_MESSAGE(model, error.data());
  return model;
}

}  // namespace

TEST_CASE("MuJoCo model: masses, centres of mass and inertias -> those of the robot") {
  for (const char* name : {"spider", "spider_released", "gecko"}) {
    CAPTURE(name);
    const RobotModel robot = load_robot(name);
    const engine::CompiledModel compiled{robot, load_arena("walled_square"), {}, {}, 2, 1};
    const mjModel& model = compiled.model();
    double whole_kg = 0.0;
    for (int body = 1; body < model.nbody; ++body) whole_kg += model.body_mass[body];
    CHECK(std::abs(whole_kg - 2.0 * robot.mass_kg()) < 1e-12);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t link = 0; link < robot.links.size(); ++link) {
        const Link& part = robot.links[link];
        const int body = mj_name2id(&model, mjOBJ_BODY, engine::body_name(i, link).c_str());
        REQUIRE(body > 0);
        CHECK(std::abs(model.body_mass[body] - part.mass_kg) < 1e-12);
        const Eigen::Map<const Eigen::Vector3d> centre{model.body_ipos + 3 * body};
        CHECK((centre - part.centre_of_mass_m).norm() < 1e-12);
        CHECK((inertia_of(model, body) - part.inertia_kgm2).norm() < 1e-12);
        CHECK(static_cast<std::size_t>(model.body_geomnum[body]) == part.boxes.size());
      }
    }
  }
}

TEST_CASE("MuJoCo model: physics and contacts -> as stated") {
  const RobotModel robot = load_robot("spider");
  const Physics physics{.timestep_s = 0.012, .integrator = Integrator::rk4, .gravity_m_s2 = 1.62};
  Arena arena = load_arena("walled_square");
  arena.friction = 0.7;
  const engine::CompiledModel open{
      robot, arena, physics, {.walls = false, .collisions = engine::Collisions::pairs, .servos = engine::Servos::combined}, 1, 1};
  const mjModel& model = open.model();
  CHECK(model.opt.timestep == 0.012);
  CHECK(model.opt.integrator == mjINT_RK4);
  CHECK(model.opt.gravity[2] == -1.62);
  CHECK(model.opt.solver == mjSOL_NEWTON);
  CHECK(model.opt.cone == mjCONE_PYRAMIDAL);
  CHECK(model.opt.tolerance == 1e-15);
  CHECK(model.nu == 4);
  CHECK(model.npair == 17 + 54);  // floor under each box; six pairs of legs with three boxes each
  for (int i = 0; i < model.npair; ++i) {
    CHECK(model.pair_friction[5 * i] == 1.0);  // the larger of the two
    CHECK(model.pair_dim[i] == 3);
  }
  const engine::CompiledModel walled{robot, arena, physics, {.walls = true, .collisions = engine::Collisions::pairs}, 1, 1};
  CHECK(walled.model().npair == 5 * 17 + 54);
  CHECK(walled.model().nu == 8);
}

TEST_CASE("MuJoCo model: pairs or sweep, combined or separate servos -> same motion") {
  const RobotModel robot = load_robot("spider");
  const Arena arena = load_arena("walled_square");
  engine::CompiledModel one{robot, arena, {}, {.collisions = engine::Collisions::pairs, .servos = engine::Servos::combined},
                            2,     1};
  engine::CompiledModel other{robot, arena, {}, {}, 2, 1};
  engine::RobotStates start{one.layout(), 2};
  start.set_root(0, test::standing(robot, 9.8, 0.0, 0.3));
  start.set_root(1, test::standing(robot, 9.5, 0.1, 1.0));  // legs interlock
  engine::Rows targets_rad{2, robot.hinges.size()};
  targets_rad.set_values({0.5, -0.9, 0.9, 0.2, -0.4, 0.8, -0.8, 0.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  const std::vector<std::size_t> both{0, 1};
  engine::RobotStates a = start;
  engine::RobotStates b = start;
  REQUIRE(engine::step_group(one, both, targets_rad, {}, 500, start, a).end == engine::GroupResult::End::done);
  REQUIRE(engine::step_group(other, both, targets_rad, {}, 500, start, b).end == engine::GroupResult::End::done);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 11; ++k) CHECK(std::abs(a.positions(i)[k] - b.positions(i)[k]) < 1e-10);
  }
}

TEST_CASE("MuJoCo model: saved world opened in MuJoCo -> continues as the backend") {
  const test::TemporaryFolder folder;
  const RobotModel robot = load_robot("gecko");
  for (const char* arena_name : {"walled_square", "height_field"}) {
    CAPTURE(arena_name);
    const Arena arena = load_arena(arena_name);
    const std::vector<Pose> starts{test::standing(robot, 0.0, 0.0, 0.5), test::standing(robot, 1.0, 2.0, -1.0)};
    Mujoco ours{robot, arena, starts, {}, {}};
    test::walk(ours, 1.0);
    const std::filesystem::path file = folder.path() / (std::string{arena_name} + ".xml");
    ours.save_mjcf(file);

    const engine::ModelPtr model = load(file);
    CHECK(std::abs(mj_getTotalmass(model.get()) - 2.0 * robot.mass_kg()) < 1e-12);
    CHECK(model->nu == 4 * static_cast<int>(robot.hinges.size()));
    CHECK(model->nlight == 1);
    CHECK(model->ncam == 1);
    CHECK(model->nmat == 1);
    std::ifstream text{file};
    const std::string saved{std::istreambuf_iterator<char>{text}, {}};
    CHECK(saved.find("collision") == std::string::npos);  // MuJoCo 3 refuses the attribute
    const engine::DataPtr data{mj_makeData(model.get())};
    REQUIRE(model->nkey == 1);
    mj_resetDataKeyframe(model.get(), data.get(), 0);
    for (int i = 0; i < 50; ++i) mj_step(model.get(), data.get());
    ours.advance_to(ours.time_s() + 50 * 0.0012);
    // The file does not hold the solver's warm start, so this is equal to the solver's tolerance only.
    for (std::size_t i = 0; i < 2; ++i) {
      const double* q = data->qpos + i * static_cast<std::size_t>(model->nq) / 2;
      CHECK((ours.pose(i).position_m - Eigen::Vector3d{q[0], q[1], q[2]}).norm() < 1e-9);
    }
    // Before the key frame is loaded the roots already stand where they were saved.
    CHECK(std::abs(model->qpos0[0] - starts[0].position_m.x()) < 1.0);
  }
  CHECK_THROWS_AS(Mujoco(robot, load_arena("walled_square"), std::vector<Pose>(1), {}, {}).save_mjcf("/nowhere/there.xml"),
                  std::runtime_error);
}

TEST_CASE("MuJoCo model: height field -> that of the arena") {
  Arena arena = load_arena("height_field");
  HeightField& field = *arena.height_field;
  field.height_m[3 * field.nodes + 5] = 2.5;  // row y 3, column x 5
  for (double& height_m : field.height_m) height_m += 0.5;
  const RobotModel robot = load_robot("spider");
  const engine::CompiledModel compiled{robot, arena, {}, {}, 1, 1};
  const mjModel& model = compiled.model();
  REQUIRE(model.nhfield == 1);
  CHECK(model.hfield_nrow[0] == 10);
  CHECK(model.hfield_size[0] == 12.0);
  CHECK(model.geom_pos[2] == 0.5);
  for (std::size_t i = 0; i < field.height_m.size(); ++i) {
    const double height_m = model.geom_pos[2] + model.hfield_size[2] * static_cast<double>(model.hfield_data[i]);
    CHECK(std::abs(height_m - field.height_m[i]) < 1e-6);
  }
}
