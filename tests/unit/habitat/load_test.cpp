// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/habitat/load/robot.hpp>

using namespace trophic;
using trophic::test::message_of;
using trophic::test::TemporaryFolder;

namespace {

const TemporaryFolder& folder() {
  static const TemporaryFolder shared;
  return shared;
}

/// What loading a robot file of this content says, after "FILE: " or "FILE:".
std::string robot_complaint(std::string_view content) {
  const std::string file = folder().file("robot.toml", content);
  const std::string message = message_of<std::invalid_argument>([&] { (void)load_robot(file); });
  CAPTURE(message);
  REQUIRE(message.starts_with(file + ":"));
  return message.substr(file.size() + 1);
}

const std::string leg = "name = \"one_leg\"\n[core.left]\nmodule = \"hinge\"\n[core.left.front]\nmodule = \"brick\"\n";

}  // namespace

TEST_CASE("robot file: all keys -> read") {
  const std::string file = folder().file("full.toml", R"(
name = "full"
forward_deg = -90
friction = 0.5
hinge_range_rad = 0.8
root_density_kg_m3 = 500.0
servo = { position_gain = 2.0, velocity_gain = 0.0, target_limit_rad = 0.6 }
walk = { speed_m_s = 0.03, turn_rate_per_rad = 0.04 }
part_mass_kg = { servo_body = 0.1, servo_plate = 0.2, brick = 0.3 }
core.left = { module = "hinge", rotation_deg = -90, front = { module = "brick", rotation_deg = 180 } }
)");
  const RobotModel robot = load_robot(file);
  CHECK(robot.name == "full");
  CHECK(robot.forward_rad == doctest::Approx(-std::numbers::pi / 2));
  CHECK(robot.friction == 0.5);
  CHECK(robot.walk.speed_m_s == 0.03);
  CHECK(robot.walk.turn_rate_per_rad == 0.04);
  CHECK(robot.hinges.at(0).range_rad == 0.8);
  CHECK(robot.hinges[0].servo.position_gain == 2.0);
  CHECK(robot.hinges[0].servo.velocity_gain == 0.0);
  CHECK(robot.hinges[0].servo.target_limit_rad == 0.6);
  CHECK(robot.links[1].mass_kg == doctest::Approx(0.6));
  CHECK(robot.links[0].mass_kg == doctest::Approx(500.0 * (0.089 * 0.089 * 0.0603 + 0.018 * 0.053 * 0.0165891)));
}

TEST_CASE("robot file: core alone -> robot without hinges") {
  const RobotModel robot = load_robot(folder().file("core.toml", "name = \"stone\"\ncore = {}\n"));
  CHECK(robot.links.size() == 1);
  CHECK(robot.hinges.empty());
  CHECK(robot.walk.speed_m_s == 0.0);
  CHECK(robot.rest_height_m == doctest::Approx(0.03015));
}

TEST_CASE("robot file: missing or not TOML -> error") {
  CHECK(message_of<std::invalid_argument>([] { (void)load_robot("./no/such.toml"); }) ==
        "no robot \"./no/such.toml\"; searched: ./no/such.toml");
  CHECK(robot_complaint("name = \n").starts_with("1:"));
  CHECK(robot_complaint(leg + "[core.left]\nmodule = \"brick\"\n").starts_with("6:"));
}

TEST_CASE("robot file: control character in a text -> error that prints none") {
  CHECK(robot_complaint("name = \"\\u001b[2J\"\n[core]\n") ==
        " name = \"\\u001B[2J\": must be a text without control characters");
  CHECK(robot_complaint("name = \"a\"\ngait = \"\\u009b2J\"\n[core]\n").ends_with(": must be a text without control characters"));
}

TEST_CASE("robot file: two modules on one face -> error") {
  const std::string message = robot_complaint(leg + "[core.left]\nmodule = \"brick\"\n");
  CHECK(message.find("cannot redefine existing table 'core.left'") != std::string::npos);
}

TEST_CASE("robot file: bad content -> error with key and value") {
  CHECK(robot_complaint("core = {}\n") == " name: missing");
  CHECK(robot_complaint("name = 3\ncore = {}\n") == " name = 3: must be a text");
  CHECK(robot_complaint("name = \"a\"\n") == " core: missing");
  CHECK(robot_complaint("name = \"a\"\ncore = 1\n") == " core = 1: must be a table");
  CHECK(robot_complaint("colour = \"red\"\n" + leg) ==
        " colour: unknown key; known here: core, forward_deg, friction, gait, hinge_range_rad, name, part_mass_kg, "
        "root_density_kg_m3, servo, walk");
  CHECK(robot_complaint(leg + "top = 1\n") ==
        " core.left.front.top: unknown key; known here: back, front, left, module, right, "
        "rotation_deg");
  CHECK(robot_complaint("name = \"a\"\ncore.left.module = \"wheel\"\n") ==
        " core.left.module = \"wheel\": must be \"hinge\" or \"brick\"");
  CHECK(robot_complaint("name = \"a\"\ncore.left = {}\n") == " core.left.module: missing");
  CHECK(robot_complaint(leg + "rotation_deg = 45\n") == " core.left.front.rotation_deg = 45: must be a multiple of 90");
  CHECK(robot_complaint(leg + "back = { module = \"brick\" }\n") ==
        " core.left.front.back.module = \"brick\": left.front.back: a brick has no back face");
  CHECK(robot_complaint("name = \"a\"\npart_mass_kg.brick = 0\ncore = {}\n") == " part_mass_kg.brick = 0: must be > 0");
  CHECK(robot_complaint("name = \"a\"\npart_mass_kg.wheel = 1\ncore = {}\n") ==
        " part_mass_kg.wheel: unknown key; known here: brick, core, hinge_frame, servo_body, servo_plate");
  CHECK(robot_complaint("name = \"a\"\nroot_density_kg_m3 = 0\ncore = {}\n") == " root_density_kg_m3 = 0: must be > 0");
  CHECK(robot_complaint("name = \"a\"\nfriction = nan\ncore = {}\n") == " friction = nan: must be >= 0 and <= 10");
  CHECK(robot_complaint("name = \"a\"\nfriction = \"high\"\ncore = {}\n") == " friction = 'high': must be a number");
  CHECK(robot_complaint("name = \"a\"\nservo.position_gain = -5\ncore = {}\n") == " servo.position_gain = -5: must be > 0");
  CHECK(robot_complaint("name = \"a\"\nwalk.speed_m_s = -1\ncore = {}\n") == " walk.speed_m_s = -1: must be >= 0 and <= 100");
  CHECK(robot_complaint("name = \"a\"\nforward_deg = 200\ncore = {}\n") == " forward_deg = 200: must be >= -180 and <= 180");
}

TEST_CASE("models: search order -> TROPHIC_MODELS, then the library's folder") {
  const TemporaryFolder own;
  std::filesystem::create_directory(own.path() / "robots");
  const std::string file = own.file("robots/spider.toml", "name = \"own\"\ncore = {}\n");
  REQUIRE(setenv("TROPHIC_MODELS", own.path().c_str(), 1) == 0);
  CHECK(find_model(ModelKind::robot, "spider") == file);
  CHECK(find_model(ModelKind::robot, "gecko") == std::filesystem::path{TROPHIC_MODEL_DIR} / "robots/gecko.toml");
  CHECK(message_of<std::invalid_argument>([] { (void)find_model(ModelKind::arena, "moon"); }) ==
        "no arena \"moon\"; searched: " + own.path().string() +
            "/arenas/moon.toml, " TROPHIC_MODEL_DIR
            "/arenas/moon.toml; there are height_field, refuges, square_25, square_51, stirred_square, walled_by_density, "
            "walled_pond, "
            "walled_square");
  REQUIRE(unsetenv("TROPHIC_MODELS") == 0);
  CHECK(find_model(ModelKind::robot, "spider") == std::filesystem::path{TROPHIC_MODEL_DIR} / "robots/spider.toml");
}
