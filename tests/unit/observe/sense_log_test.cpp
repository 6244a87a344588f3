// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <support/temporary_folder.hpp>
#include <trophic/io/sense_log.hpp>
#include <unit/observe/scene.hpp>
#include <vector>

using namespace trophic;

namespace {

const std::string header =
    "time_s,tick,body,id,species,height_m,tilt_rad,touches_wall,robots_touched,exempt,chosen_tag,tag_outcome,angle_output,tag_"
    "output,"
    "input0,input1\n";

observe::RunDescription run_of_two_inputs() {
  observe::RunDescription run = test::short_run();
  run.inputs = {"nose", "ear"};
  return run;
}

/// Cubes of 20 cm with a box of 10 cm on a hinge above.
RobotModel cube() {
  RobotModel robot;
  robot.links.resize(2);
  robot.links[0].boxes.resize(1);
  robot.links[0].boxes[0].half_extents_m = {0.1, 0.1, 0.1};
  robot.links[1].parent = 0;
  robot.links[1].offset_m = {0.0, 0.0, 0.1};
  robot.links[1].boxes.resize(1);
  robot.links[1].boxes[0].half_extents_m = {0.05, 0.05, 0.05};
  robot.hinges.resize(1);
  robot.bounding_radius_m = 0.3;
  return robot;
}

}  // namespace

TEST_CASE("senses: decisions -> inputs and outputs, empty without a decision") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / io::SenseLog::file_name;
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  io::SenseLog log{path};
  log.on_start(run_of_two_inputs(), view);
  const std::array<double, 2> told{0.25, -1.0};
  const std::array<double, 2> answered{0.5, -0.125};
  log.on_exemption(0, view);
  log.on_decision({.body = 0,
                   .inputs = told,
                   .outputs = answered,
                   .target_angle_rad = 0.7,
                   .tag = 1,
                   .tag_before = -1,
                   .might_switch = false},
                  view);
  log.on_decision({.body = 1, .inputs = told, .outputs = {}, .tag = -1, .tag_before = 1, .might_switch = true}, view);
  log.on_tick(view);
  log.on_decision({.body = 2, .inputs = told, .outputs = {}, .tag = 1, .tag_before = 1, .might_switch = true}, view);
  log.on_tick(view);
  CHECK(test::content(path) == header +
                                   "6,3,0,7,predator,,,,,1,1,denied,0.5,-0.125,0.25,-1\n"
                                   "6,3,1,8,prey,,,,,,-1,switched,,,0.25,-1\n"
                                   "6,3,2,9,prey,,,,,,,,,,,\n"
                                   "6,3,0,7,predator,,,,,0,,,,,,\n"
                                   "6,3,1,8,prey,,,,,,,,,,,\n"
                                   "6,3,2,9,prey,,,,,,1,kept,,,0.25,-1\n");
  CHECK(log.sum().rows == 6);
}

TEST_CASE("senses: other acts -> a column for each output, by name") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / io::SenseLog::file_name;
  const test::HandPopulation robots{{{.species = test::prey, .id = 4}, {.species = test::prey, .id = 5}}};
  observe::RunDescription run = test::short_run();
  run.inputs = {"nose"};
  run.outputs = {"effort", "tag", "gaze0"};
  io::SenseLog log{path};
  log.on_start(run, robots.view());
  log.on_decision({.body = 0, .inputs = std::array{0.5}, .outputs = std::array{0.1, 0.2, 0.3}, .tag = 1, .tag_before = 1},
                  robots.view());
  log.on_tick(robots.view());
  const std::string text = test::content(path);
  CHECK(text.substr(text.find("chosen_tag")) ==
        "chosen_tag,tag_outcome,angle_output,tag_output,effort_output,gaze0_output,input0\n"
        "0,0,0,4,prey,,,,,,1,kept,,0.2,0.1,0.3,0.5\n"
        "0,0,1,5,prey,,,,,,,,,,,,\n");
}

TEST_CASE("senses: exempt individual that dies anyway -> not exempt, nor is its successor") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / io::SenseLog::file_name;
  test::HandPopulation robots{{{.species = test::predator, .id = 4}}};
  io::SenseLog log{path};
  log.on_start(run_of_two_inputs(), robots.view());
  log.on_exemption(0, robots.view());
  robots.individuals[0].id = 5;
  log.on_tick(robots.view());
  CHECK(test::content(path) == header + "0,0,0,5,predator,,,,,0,,,,,,\n");
}

TEST_CASE("senses: requested ticks -> height, tilt and contacts of the last frame") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / io::SenseLog::file_name;
  test::HandPopulation robots = test::three_robots();
  const RobotModel robot = cube();
  const std::vector<double> angles_rad{0.0, 0.0, 0.0};
  std::vector<Pose> roots{
      {{9.95, 0.0, 0.125}, Eigen::Quaterniond::Identity()},
      {{0.0, 0.0, 0.5}, Eigen::Quaterniond{Eigen::AngleAxisd{std::numbers::pi / 2.0, Eigen::Vector3d::UnitX()}}},
      {{0.0, 0.21, 0.5}, Eigen::Quaterniond{Eigen::AngleAxisd{std::numbers::pi, Eigen::Vector3d::UnitX()}}}};
  io::SenseLog log{path, Opening::created, 3};
  log.on_start(run_of_two_inputs(), robots.view());
  const auto show = [&] {
    log.on_frame(
        {.time_s = 0.0, .times = {}, .roots = roots, .joint_angles_rad = angles_rad, .robot = robot, .arena = robots.arena});
  };
  CHECK(log.frame_hz() > 0.0);
  show();
  log.on_tick(robots.at_tick(3).view());
  roots[2].position_m.y() = 1.0;
  show();
  log.on_tick(robots.at_tick(4).view());
  CHECK(test::content(path) == header +
                                   "6,3,0,7,predator,0.125000,0.000000,1,0,0,,,,,,\n"
                                   "6,3,1,8,prey,0.500000,1.570796,0,0,,,,,,,\n"
                                   "6,3,2,9,prey,0.500000,3.141593,0,0,,,,,,,\n");
  roots[2].position_m.y() = -0.21;  // on the side to which the hat of the robot that lies points
  show();
  log.on_tick(robots.at_tick(6).view());
  CHECK(test::content(path).find("12,6,1,8,prey,0.500000,1.570796,0,1,") != std::string::npos);
  CHECK(test::content(path).find("12,6,2,9,prey,0.500000,3.141593,0,1,") != std::string::npos);
}
