// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <support/temporary_folder.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/robot.hpp>

using namespace trophic;
using trophic::Gait;
using trophic::load_gait;
using trophic::test::message_of;
using trophic::test::TemporaryFolder;

namespace {

/// The published CPPN (formula: models/README.md).
double cppn(const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
  const double s = 0.5193029403554234 + 0.0575994456677941 * a.x() + 1.037920298210572 * a.y() + 0.98193370804869985 * b.x() +
                   0.9648602838256312 * b.y() + 0.0636313795506953 * b.z();
  return std::sin(3.025 * s);
}

std::string complaint(std::string_view content) {
  const TemporaryFolder folder;
  const std::string file = folder.file("gait.toml", content);
  const std::string message = message_of<std::invalid_argument>([&] { (void)load_gait(file); });
  return message.starts_with(file) ? message.substr(file.size()) : message;
}

std::string misfit(const std::function<void(Gait&)>& change) {
  Gait gait = load_gait("spider_published");
  change(gait);
  return message_of<std::invalid_argument>([&] { check_fit(gait, load_robot("spider")); });
}

const std::string two = "name = \"g\"\nrobot = \"r\"\nhinges = [\"a\", \"b\"]\ninternal = [1, 2.5]\n";

}  // namespace

TEST_CASE("gait: published gait -> weights of the released code") {
  const Gait gait = load_gait("spider_published");
  const std::vector<double> internal{-1.0000, -1.0000, 0.9749, 0.9748};
  const std::vector<std::vector<double>> coupling{
      {0, -0.9409, -0.9988, -0.9221}, {0, 0, -0.9222, -0.9988}, {0, 0, 0, 0.9757}, {}};
  for (int i = 0; i < 4; ++i) {
    CHECK(std::abs(gait.internal[i] - internal.at(static_cast<std::size_t>(i))) < 5e-5);
    for (int j = i + 1; j < 4; ++j) {
      CHECK(std::abs(gait.coupling(i, j) - coupling.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j))) < 5e-5);
      CHECK(gait.coupling(j, i) == -gait.coupling(i, j));
    }
  }
}

TEST_CASE("gait: published gait -> its CPPN at the spider's grid positions") {
  const Gait gait = load_gait("spider_published");
  const RobotModel robot = load_robot("spider");
  REQUIRE_NOTHROW(check_fit(gait, robot));
  CHECK(gait.name == "spider_published");
  CHECK(gait.robot == "spider");
  for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::Vector3i& cell = robot.hinges[i].grid_position;
    CHECK(gait.internal[row] == doctest::Approx(cppn(cell, cell)).epsilon(1e-13));
    for (const std::size_t j : robot.hinge_neighbours[i]) {
      if (j < i) continue;
      CHECK(gait.coupling(row, static_cast<Eigen::Index>(j)) ==
            doctest::Approx(cppn(cell, robot.hinges[j].grid_position)).epsilon(1e-13));
    }
  }
  CHECK_NOTHROW(check_fit(gait, load_robot("spider_released")));
}

TEST_CASE("gait: bad file -> error with key and value") {
  CHECK(complaint(two + "speed = 1\n") ==
        ": speed: unknown key; known here: coupling, cppn, evolution, hinges, internal, name, provenance, robot");
  CHECK(complaint("name = \"g\"\n") == ": robot: missing");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\", \"a\"]\ninternal = [1, 2]\n") ==
        ": hinges: \"a\" appears twice");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\", 1]\ninternal = [1, 2]\n") == ": hinges = 1: must be a text");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\"]\ninternal = [\"x\"]\n") == ": internal = 'x': must be a number");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\"]\ninternal = [9007199254740993]\n") ==
        ": internal = 9007199254740993: must be from -2^53 to 2^53, or have a decimal point");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\"]\ninternal = [1, 2]\n") ==
        "gait g: internal has 2 weights: must have one per hinge, 1");
  CHECK(complaint("name = \"g\"\nrobot = \"r\"\nhinges = [\"a\"]\ninternal = [nan]\n") == "gait g: weights must be finite");
  CHECK(complaint(two + "[[coupling]]\nfrom = \"a\"\nto = \"c\"\nweight = 1\n") ==
        ": coupling[0].to = \"c\": must be one of the gait's hinges");
  CHECK(complaint(two + "[[coupling]]\nfrom = \"b\"\nto = \"a\"\nweight = 1\n") ==
        ": coupling[0].to = \"a\": must come after \"from\" in hinges");
  CHECK(complaint(two + "[[coupling]]\nfrom = \"a\"\nto = \"b\"\n") == ": coupling[0].weight: missing");
  CHECK(complaint(two + "[[coupling]]\nfrom = \"a\"\nto = \"b\"\nweight = inf\n") ==
        ": coupling[0].weight = inf: must be finite");
}

TEST_CASE("gait: does not fit the robot -> error with the hinge") {
  CHECK(misfit([](Gait&) {}).empty());
  CHECK(misfit([](Gait& g) { g.hinges[1] = "tail"; }) ==
        "gait spider_published does not fit robot spider: hinge 1 is \"tail\", the robot's is \"back\"");
  CHECK(misfit([](Gait& g) { g.coupling(0, 1) = 3.0; }) == "gait spider_published: coupling: must be antisymmetric");
  CHECK(misfit([](Gait& g) { g = load_gait("gecko_paper"); }) ==
        "gait gecko_paper does not fit robot spider: 6 hinges, the robot has 4");
  Gait far = load_gait("gecko_paper");
  far.coupling(0, 2) = 1.0;
  far.coupling(2, 0) = -1.0;
  CHECK(message_of<std::invalid_argument>([&] { check_fit(far, load_robot("gecko")); }) ==
        "gait gecko_paper does not fit robot gecko: \"back\" and \"back.front.front.front.left\" are coupled but not neighbours");
}
