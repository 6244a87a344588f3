// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <optional>
#include <string>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/params/numbers_text.hpp>
#include <utility>
#include <vector>

using namespace trophic;

namespace {

template <class... Models>
constexpr bool all_listed = ((trophic::detail::members_of<Models> == trophic::detail::fields_of<Models>)&&...);
static_assert(all_listed<Box, Link, Servo, Hinge, MeasuredWalk, RobotModel, HeightField, Obstacle, Zone, Gait>,
              "a model's struct has a member that its fields() lack");
static_assert(trophic::detail::members_of<Habitat> == trophic::detail::fields_of<Habitat> + 3 &&
                  trophic::detail::members_of<Arena> == trophic::detail::fields_of<Arena> + 2,
              "numbers_text of a habitat adds design, robots, gaits, and the arena's obstacles and zones to its fields");

/// A copy in which the number at a place is another one; none behind the last. Counts of elements are constant: no places.
std::optional<Habitat> with_other_number(const Habitat& habitat, std::size_t place) {
  Habitat other = habitat;
  std::size_t at = 0;
  for_each_number(other, [&](auto& number) {
    using Number = std::remove_reference_t<decltype(number)>;
    if constexpr (!std::is_const_v<Number>) {
      if (at++ == place) number = static_cast<Number>(number + 1);
    }
  });
  return place < at ? std::optional{other} : std::nullopt;
}

}  // namespace

TEST_CASE("fingerprints: number changed -> other text, name changed -> same text") {
  EcologyParams ecology;
  ecology.arena = "height_field";
  const Habitat habitat = load_habitat(ecology);
  REQUIRE(habitat.arena.height_field);
  const std::string text = numbers_text(habitat);
  std::size_t place = 0;
  for (auto other = with_other_number(habitat, 0); other; other = with_other_number(habitat, ++place)) {
    CAPTURE(place);
    CHECK(numbers_text(*other) != text);
  }
  CHECK(place > 400);
  Habitat renamed = habitat;
  renamed.robot.name = renamed.robot.links[0].boxes[0].part = renamed.arena.name = renamed.gait.provenance = "other";
  CHECK(numbers_text(renamed) == text);
}

TEST_CASE("fingerprints: other number of a model that rules name -> other text") {
  Habitat habitat = load_habitat(EcologyParams{});
  std::string text = numbers_text(habitat);
  const auto changes = [&] { return std::exchange(text, numbers_text(habitat)) != text; };
  CHECK_FALSE(changes());
  habitat.design = load_design("spider");
  CHECK(changes());
  habitat.design->friction += 1.0;
  CHECK(changes());
  habitat.design->servo.position_gain += 1.0;
  CHECK(changes());
  habitat.robots.push_back({.name = "other", .design = *habitat.design, .robot = habitat.robot, .gait = habitat.gait});
  CHECK(changes());
  habitat.robots[0].robot.friction += 1.0;
  CHECK(changes());
  habitat.gaits.push_back({.name = "other", .gait = habitat.gait});
  CHECK(changes());
}

TEST_CASE("fingerprints: same numbers, other element boundaries -> other text") {
  using Rows = std::vector<std::vector<double>>;
  CHECK(numbers_text(Rows{{1, 2}, {}}) != numbers_text(Rows{{1}, {2}}));
  CHECK(numbers_text(std::optional<double>{}) != numbers_text(std::optional<double>{0.0}));
  CHECK(numbers_text(Eigen::MatrixXd::Zero(1, 2).eval()) != numbers_text(Eigen::MatrixXd::Zero(2, 1).eval()));
}
