// SPDX-License-Identifier: MIT
// Penetration depth of two boxes in MuJoCo, and the backend's number that corrects it.
#include <doctest/doctest.h>

#include <algorithm>
#include <compare/scenes.hpp>
#include <limits>
#include <support/temporary_folder.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/box_test.hpp>
#include <trophic/backend/mujoco/compile.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/mjcf.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using backend::Mujoco;
using backend::mujoco::BoxDepth;
namespace engine = backend::mujoco;

namespace {

constexpr double pressed_m = 0.5e-3;
constexpr double half_side_m = 0.05;
/// What MuJoCo reports of a face pressed that far into a box.
constexpr double face_depth_m = engine::halves_box_depth ? pressed_m / 2.0 : pressed_m;

/// Loads MJCF with MuJoCo alone.
engine::ModelPtr model_of(const std::string& mjcf) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "model.xml";
  std::ofstream{path} << mjcf;
  std::array<char, 500> error{};
  engine::ModelPtr model{mj_loadXML(path.c_str(), nullptr, error.data(), static_cast<int>(error.size()))};
  REQUIRE_MESSAGE(model, error.data());
  return model;
}

/// A box above `ground`, whose surface is z = 0, turned as given and with its lowest point `pressed_m` below that. `custom` goes
/// into the model as it stands.
std::vector<double> depths_m(const std::string& ground, const Eigen::Quaterniond& turn, const std::string& custom = "") {
  const engine::ModelPtr model =
      model_of("<mujoco>" + custom + "<asset><hfield name='flat' nrow='10' ncol='10' size='1 1 1 1'/></asset><worldbody>" +
               ground + "<body><freejoint/><geom type='box' size='.05 .05 .05'/></body></worldbody></mujoco>");
  const engine::DataPtr data{mj_makeData(model.get())};
  const double reach_m = half_side_m * turn.toRotationMatrix().row(2).cwiseAbs().sum();
  const std::array<double, 7> pose{0.013, 0.021, reach_m - pressed_m, turn.w(), turn.x(), turn.y(), turn.z()};
  std::ranges::copy(pose, data->qpos);
  mj_fwdPosition(model.get(), data.get());
  std::vector<double> depths;
  for (int c = 0; c < data->ncon; ++c) depths.push_back(-data->contact[c].dist);
  return depths;
}

void check_depths(const std::vector<double>& depths, std::size_t contacts, double expected_m) {
  CHECK(depths.size() == contacts);
  for (const double depth_m : depths) CHECK(std::abs(depth_m - expected_m) < 1e-6);
}

const Eigen::Quaterniond flat = Eigen::Quaterniond::Identity();
const Eigen::Quaterniond on_a_corner =
    Eigen::AngleAxisd{0.37, Eigen::Vector3d::UnitZ()} *
    Eigen::AngleAxisd{std::acos(std::numbers::inv_sqrt3), Eigen::Vector3d{1.0, -1.0, 0.0}.normalized()};  // its diagonal upwards
const Eigen::Quaterniond on_an_edge =
    Eigen::AngleAxisd{0.3, Eigen::Vector3d::UnitZ()} * Eigen::AngleAxisd{std::numbers::pi / 4.0, Eigen::Vector3d::UnitX()} * flat;

constexpr const char* plate = "<geom type='box' size='.5 .5 .1' pos='0 0 -.1'/>";
/// A bar whose upper edge, along y, is z = 0.
constexpr const char* ridge = "<geom type='box' size='.05 .5 .05' pos='0 0 -.0707106781186547' euler='0 45 0'/>";

constexpr const char* asking = "<custom><numeric name='trophic.whole_box_depth' data='1'/></custom>";
constexpr const char* declining = "<custom><numeric name='trophic.whole_box_depth' data='0'/></custom>";

}  // namespace

TEST_CASE("box depth: MuJoCo alone -> half the depth of box-face contacts up to 3.3.7, whole depth of others") {
  for (const auto& [turn, contacts] : {std::pair{flat, 4U}, std::pair{on_a_corner, 1U}, std::pair{on_an_edge, 2U}}) {
    CAPTURE(contacts);
    check_depths(depths_m(plate, turn), contacts, face_depth_m);
    check_depths(depths_m("<geom type='plane' size='1 1 1'/>", turn), contacts, pressed_m);
  }
  check_depths(depths_m("<geom type='hfield' hfield='flat'/>", on_a_corner), 1, pressed_m);
  // Two edges that cross.
  const Eigen::Quaterniond along_x{Eigen::AngleAxisd{std::numbers::pi / 4.0, Eigen::Vector3d::UnitX()}};
  check_depths(depths_m(ridge, along_x), 1, pressed_m);
}

TEST_CASE("box depth: model with the request -> whole depth, others unchanged") {
  engine::install_box_test();
  for (const auto& [turn, contacts] : {std::pair{flat, 4U}, std::pair{on_a_corner, 1U}, std::pair{on_an_edge, 2U}}) {
    CAPTURE(contacts);
    check_depths(depths_m(plate, turn, asking), contacts, pressed_m);
    check_depths(depths_m(plate, turn), contacts, face_depth_m);
    check_depths(depths_m(plate, turn, declining), contacts, face_depth_m);
    check_depths(depths_m("<geom type='plane' size='1 1 1'/>", turn, asking), contacts, pressed_m);
  }
}

namespace {

/// How far two boxes must be moved apart at least, and whether along the normal of a face.
struct Overlap {
  double depth_m = std::numeric_limits<double>::infinity();
  bool face = false;
};

/// By separating axes: the faces of both boxes and all pairs of edges.
Overlap overlap(const mjModel& model, const mjData& data) {
  std::array<Eigen::Matrix3d, 2> axes;
  std::array<Eigen::Vector3d, 2> half_m;
  for (std::size_t b = 0; b < 2; ++b) {
    axes[b] = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{data.geom_xmat + 9 * b};
    half_m[b] = Eigen::Map<const Eigen::Vector3d>{model.geom_size + 3 * b};
  }
  const Eigen::Vector3d apart_m =
      Eigen::Map<const Eigen::Vector3d>{data.geom_xpos + 3} - Eigen::Map<const Eigen::Vector3d>{data.geom_xpos};
  Overlap least;
  const auto look = [&](const Eigen::Vector3d& axis, bool face) {
    double depth_m = -std::abs(axis.dot(apart_m));
    for (std::size_t b = 0; b < 2; ++b) depth_m += (axes[b].transpose() * axis).cwiseAbs().dot(half_m[b]);
    if (depth_m < least.depth_m) least = {depth_m, face};
  };
  for (const Eigen::Matrix3d& box : axes) {
    for (const auto& axis : box.colwise()) look(axis, true);
  }
  for (const auto& one : axes[0].colwise()) {
    for (const auto& other : axes[1].colwise()) look(one.cross(other).normalized(), false);
  }
  return least;
}

}  // namespace

TEST_CASE("box depth: random boxes -> face contacts as deep as by separating axes, edge contacts unchanged") {
  engine::install_box_test();
  const std::string boxes = "<worldbody><geom type='box' size='1 1 1'/><geom type='box' size='1 1 1'/></worldbody></mujoco>";
  const std::array models{model_of("<mujoco>" + boxes), model_of(std::string{"<mujoco>"} + asking + boxes)};
  std::array<engine::DataPtr, 2> data;
  std::ranges::transform(models, data.begin(), [](const auto& model) { return engine::DataPtr{mj_makeData(model.get())}; });
  std::array<std::array<engine::FoundContact, mjMAXCONPAIR>, 2> found{};
  Rng rng{41, Stream::user};
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t wrong = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    for (std::size_t geom = 0; geom < 2; ++geom) {
      const Eigen::Vector4d turn{rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1), rng.normal(0, 1)};
      const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation{Eigen::Quaterniond{turn.normalized()}.toRotationMatrix()};
      for (std::size_t i = 0; i < 3; ++i) {
        const double centre_m = rng.uniform(-0.03, 0.03);
        const double size_m = rng.uniform(0.005, 0.05);
        for (std::size_t m = 0; m < 2; ++m) {
          data[m]->geom_xpos[3 * geom + i] = centre_m;
          models[m]->geom_size[3 * geom + i] = size_m;
        }
      }
      for (std::size_t m = 0; m < 2; ++m) std::copy_n(rotation.data(), 9, data[m]->geom_xmat + 9 * geom);
    }
    std::array<int, 2> count{};
    for (std::size_t m = 0; m < 2; ++m) {
      count[m] = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX](models[m].get(), data[m].get(), found[m].data(), 0, 1, 0.0);
    }
    if (!engine::replaces_box_test) REQUIRE(count[0] == count[1]);
    if (count[1] == 0) continue;
    const Overlap expected = overlap(*models[0], *data[0]);
    (expected.face ? faces : edges) += 1;
    double deepest_m = 0.0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(count[1]); ++c) {
      const bool same_test = !engine::replaces_box_test;
      if (same_test && found[1][c].dist != (expected.face && engine::halves_box_depth ? 2.0 : 1.0) * found[0][c].dist) ++wrong;
      deepest_m = std::max(deepest_m, -found[1][c].dist);
    }
    if (expected.face ? std::abs(deepest_m - expected.depth_m) > 1e-12 : deepest_m < expected.depth_m - 1e-12) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(faces > 1000);
  CHECK(edges > 1000);
}

namespace {

/// How fast a brick leaves another into whose upper face one of its corners is pressed, a step later, without weight.
double leaving_m_s(Mujoco::Stepping stepping, BoxDepth depth) {
  const RobotModel robot = compare::brick({0.3, 0.3, 0.1}, 0.5, 1.0);
  const Eigen::Quaterniond tilt{Eigen::AngleAxisd{0.4, Eigen::Vector3d{1.0, 0.7, 0.2}.normalized()}};
  const double reach_m = tilt.toRotationMatrix().row(2).cwiseAbs().dot(robot.links[0].boxes[0].half_extents_m);
  const Eigen::Quaterniond turned{Eigen::AngleAxisd{0.1, Eigen::Vector3d::UnitZ()}};
  const std::vector<Pose> starts{{.position_m = {0.0, 0.0, 1.0}, .orientation = turned},
                                 {.position_m = {0.02, 0.01, 1.05 + reach_m - pressed_m}, .orientation = tilt}};
  const Physics physics{.gravity_m_s2 = 0.0};
  Mujoco backend{robot, load_arena("walled_square"), starts, physics, {.stepping = stepping, .box_depth = depth}};
  backend.advance_to(physics.timestep_s);
  return (backend.pose(1).position_m - starts[1].position_m).z() / physics.timestep_s;
}

}  // namespace

TEST_CASE("box depth: every stepping mode -> whole depth on request") {
  using Stepping = Mujoco::Stepping;
  const double engine_m_s = leaving_m_s(Stepping::one_model, BoxDepth::engine);
  const double whole_m_s = leaving_m_s(Stepping::one_model, BoxDepth::whole);
  CHECK(engine_m_s > 1e-5);
  CHECK(whole_m_s > (engine::halves_box_depth ? 1.9 : 0.999) * engine_m_s);
  for (const Stepping stepping : {Stepping::fast, Stepping::islands}) {
    CHECK(leaving_m_s(stepping, BoxDepth::engine) == doctest::Approx(engine_m_s).epsilon(1e-9));
    CHECK(leaving_m_s(stepping, BoxDepth::whole) == doctest::Approx(whole_m_s).epsilon(1e-9));
  }
}

TEST_CASE("box depth: saved world -> contains the request, none by default up to MuJoCo 3.11") {
  const test::TemporaryFolder folder;
  const RobotModel robot = compare::brick({0.3, 0.3, 0.1}, 0.5, 1.0);
  const std::vector<Pose> starts{{.position_m = {0.0, 0.0, 1.0}}};
  for (const BoxDepth depth : {BoxDepth::engine, BoxDepth::whole}) {
    const std::filesystem::path file = folder.path() / (depth == BoxDepth::whole ? "whole.xml" : "engine.xml");
    Mujoco{robot, load_arena("walled_square"), starts, {}, {.box_depth = depth}}.save_mjcf(file);
    const engine::ModelPtr model{mj_loadXML(file.c_str(), nullptr, nullptr, 0)};
    REQUIRE(model);
    const bool asks = depth == BoxDepth::whole || engine::replaces_box_test;
    CHECK(engine::asks_whole_box_depth(*model) == asks);
    CHECK(model->nnumeric == (asks ? 1 : 0));
  }
}
