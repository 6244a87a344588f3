// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/support/rng.hpp>

using namespace trophic;

namespace {

std::string complaint(std::string_view content) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("arena.toml", content);
  const std::string message = test::message_of<std::invalid_argument>([&] { (void)load_arena(file); });
  return message.starts_with(file) ? message.substr(file.size()) : message;
}

}  // namespace

TEST_CASE("arena: paper's file -> 20 m between walls") {
  const Arena arena = load_arena("walled_square");
  CHECK(arena.name == "walled_square");
  CHECK(arena.half_side_m == 10.0);
  CHECK(arena.extent_m == 20.0);
  CHECK(arena.friction == 1.0);
  CHECK_FALSE(arena.height_field);
}

TEST_CASE("arena: released code's file -> flat to 28/3 m, an outer ring of nodes at 10 m") {
  const Arena arena = load_arena("height_field");
  CHECK(arena.half_side_m == doctest::Approx(28.0 / 3.0).epsilon(1e-14));
  CHECK(arena.extent_m == 24.0);
  REQUIRE(arena.height_field);
  REQUIRE(arena.height_field->nodes == 10);
  CHECK(arena.height_field->half_extent_m == 12.0);
  REQUIRE(arena.height_field->height_m.size() == 100);
  int raised = 0;
  for (std::size_t iy = 0; iy < 10; ++iy) {
    for (std::size_t ix = 0; ix < 10; ++ix) {
      const bool outer = ix == 0 || iy == 0 || ix == 9 || iy == 9;
      CHECK(arena.height_field->height_m[iy * 10 + ix] == (outer ? 10.0 : 0.0));
      raised += outer;
    }
  }
  CHECK(raised == 36);
}

TEST_CASE("arena: height field -> floor is the largest centred square of zeros") {
  HeightField field{.nodes = 5, .half_extent_m = 4.0, .height_m = std::vector<double>(25, 0.0)};
  CHECK(flat_half_side_m(field) == 4.0);
  field.height_m[2] = 1.0;
  CHECK(flat_half_side_m(field) == 2.0);
  field.height_m[6] = 1.0;
  CHECK(flat_half_side_m(field) == 0.0);
}

TEST_CASE("arena: robots_per_m2 -> 30 robots on 20 m x 20 m, four times as many on twice the side") {
  struct Case {
    std::size_t robots;
    double side_m;
  };
  for (const Case& expected : {Case{30, 20.0}, Case{120, 40.0}, Case{3000, 200.0}}) {
    CAPTURE(expected.robots);
    const Arena arena = load_arena("walled_by_density", TROPHIC_MODEL_DIR, expected.robots);
    CHECK(arena.name == "walled_by_density");
    CHECK(arena.extent_m == doctest::Approx(expected.side_m).epsilon(1e-15));
    CHECK(arena.half_side_m == arena.extent_m / 2.0);
    CHECK_FALSE(arena.height_field);
  }
}

TEST_CASE("habitat: ecology.robots -> changes the floor only with robots_per_m2") {
  EcologyParams ecology;
  ecology.robots = 120;
  CHECK(load_habitat(ecology).arena.extent_m == 20.0);
  ecology.arena = "walled_by_density";
  CHECK(load_habitat(ecology).arena.extent_m == doctest::Approx(40.0).epsilon(1e-15));
}

TEST_CASE("arena: bad file -> error with key and value") {
  CHECK(complaint("name = \"a\"\nrobots_per_m2 = 0\n") == ": robots_per_m2 = 0: must be > 0 and <= 1e+06");
  CHECK(complaint("name = \"a\"\nrobots_per_m2 = \"few\"\n") == ": robots_per_m2 = 'few': must be a number");
  CHECK(complaint("name = \"a\"\nrobots_per_m2 = 1\nside_m = 5\n") ==
        ": side_m: unknown key; known here: friction, height_m, name, obstacle, robots_per_m2, zone");
  CHECK(complaint("name = \"a\"\n") == ": side_m: missing");
  CHECK(complaint("name = \"a\"\nside_m = 0\n") == ": side_m = 0: must be > 0 and <= 1e+06");
  CHECK(complaint("name = \"a\"\nside_m = inf\n") == ": side_m = inf: must be > 0 and <= 1e+06");
  CHECK(complaint("name = \"a\"\nside_m = 5\nwalls = 4\n") ==
        ": walls: unknown key; known here: friction, height_m, name, obstacle, robots_per_m2, side_m, zone");
  CHECK(complaint("name = \"a\"\nhalf_extent_m = 1\nheight_m = [[0]]\n") == ": height_m: 1 rows: must be >= 2");
  CHECK(complaint("name = \"a\"\nhalf_extent_m = 1\nheight_m = [[0, 0], [0]]\n") ==
        ": height_m: row 1 has 1 numbers: must have 2, one a row");
  CHECK(complaint("name = \"a\"\nhalf_extent_m = 1\nheight_m = [[0, 0], [0, -1]]\n") == ": height_m = -1: must be >= 0");
  CHECK(complaint("name = \"a\"\nhalf_extent_m = 1\nheight_m = [[1, 1], [1, 1]]\n") ==
        ": height_m: must be higher at its edge than anywhere inside, or floor_side_m must give the extent of the floor");
  CHECK(complaint("name = \"a\"\nhalf_extent_m = 1\nheight_m = 3\n") == ": height_m = 3: must be a list");
}

TEST_CASE("arena: slopes -> the rings that are higher than all inside, so stones and noise are part of the floor") {
  const test::TemporaryFolder folder;
  const auto arena_with = [&](bool has_stones, std::string_view more = "") {
    Rng rng{1, Stream::user};
    std::string rows;
    for (std::size_t iy = 0; iy < 21; ++iy) {
      rows += "[";
      for (std::size_t ix = 0; ix < 21; ++ix) {
        const std::size_t ring = std::min({ix, iy, 20 - ix, 20 - iy});
        const bool is_stone = has_stones && ix == iy && (ix == 7 || ix == 13);
        rows += number_text(ring == 0 ? 10.0 : ring == 1 ? 5.0 : is_stone ? 0.3 : rng.uniform(0.0, 0.01)) + ",";
      }
      rows += "],";
    }
    return load_arena(
        folder.file("arena.toml", "name = \"a\"\nhalf_extent_m = 12\n" + std::string{more} + "height_m = [" + rows + "]\n"));
  };
  CHECK(arena_with(false).half_side_m == doctest::Approx(9.6).epsilon(1e-15));
  CHECK(arena_with(true, "floor_side_m = 10\n").half_side_m == 5.0);
  const Arena arena = arena_with(true);
  CHECK(arena.half_side_m == doctest::Approx(9.6).epsilon(1e-15));
  CHECK(flat_half_side_m(*arena.height_field) == 0.0);
  CHECK(highest_below_m(arena, {.x_m = -12.0 + 7 * 1.2 + 0.5, .y_m = -12.0 + 7 * 1.2}, 0.2) == 0.3);
  CHECK(highest_below_m(arena, {.x_m = -12.0 + 7 * 1.2 + 1.5, .y_m = -12.0 + 7 * 1.2}, 0.2) < 0.01);
  CHECK(highest_below_m(arena, {.x_m = 11.9, .y_m = 0.0}, 5.0) == 10.0);
}

TEST_CASE("arena: obstacles and zones -> from their tables, a pillar without a second point") {
  const test::TemporaryFolder folder;
  const Arena arena = load_arena(folder.file("arena.toml", R"(
name = "court"
side_m = 12.0
[[obstacle]]
x_m = 1.0
y_m = 2.0
radius_m = 0.3
height_m = 0.5
[[obstacle]]
x_m = -3.0
y_m = 0.0
to_x_m = 3.0
to_y_m = 1.0
radius_m = 0.1
height_m = 0.4
[[zone]]
name = "refuge"
x_m = 4.0
y_m = 4.0
radius_m = 1.5
)"));
  REQUIRE(arena.obstacles.size() == 2);
  CHECK(arena.obstacles[0].is_pillar());
  CHECK(arena.obstacles[1] == Obstacle{.x_m = -3.0, .to_x_m = 3.0, .to_y_m = 1.0, .radius_m = 0.1, .height_m = 0.4});
  REQUIRE(arena.zones.size() == 1);
  CHECK(arena.zones[0].holds({.x_m = 5.0, .y_m = 5.0}));
  CHECK_FALSE(arena.zones[0].holds({.x_m = 5.1, .y_m = 5.1}));
  const std::string square = "name = \"a\"\nside_m = 4\n[[obstacle]]\nx_m = 1\ny_m = 0\nheight_m = 1\n";
  CHECK(complaint(square + "radius_m = 0\n") == ": obstacle[0].radius_m = 0: must be > 0 and <= 2");
  CHECK(complaint(square + "radius_m = 1\nto_x_m = 3\n") == ": obstacle[0].to_x_m = 3: must be >= -2 and <= 2");
  CHECK(complaint(square + "radius_m = 1\nwidth_m = 3\n").starts_with(": obstacle[0].width_m: unknown key"));
}

TEST_CASE("arena: what stands in it -> is in the fingerprint, and nothing changes without") {
  Habitat habitat{.robot = load_robot("spider"), .arena = load_arena("walled_square"), .gait = load_gait("spider_published")};
  const std::string plain = numbers_text(habitat);
  habitat.arena.obstacles = {{.x_m = 1.0}};
  const std::string with_pillar = numbers_text(habitat);
  CHECK(with_pillar != plain);
  habitat.arena.obstacles[0].height_m = 0.7;
  CHECK(numbers_text(habitat) != with_pillar);
  habitat.arena.obstacles.clear();
  CHECK(numbers_text(habitat) == plain);
  habitat.arena.zones = {{.name = "refuge"}};
  CHECK(numbers_text(habitat) != plain);
}
