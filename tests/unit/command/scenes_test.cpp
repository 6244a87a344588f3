// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <tools/trophic/replay/director.hpp>
#include <trophic/habitat/load/arena.hpp>

using namespace trophic;
using namespace trophic::command::replay;

namespace {

constexpr double radius_m = 0.18;

/// A hunter that comes nearer to a victim that stands at a place.
std::vector<Track> hunt(const Eigen::Vector3d& victim_m, const Eigen::Vector3d& towards) {
  Track hunter{.places_m = {}, .radius_m = radius_m};
  for (const double apart_m : {1.5, 1.2, 1.0}) hunter.places_m.emplace_back(victim_m - apart_m * towards);
  return {hunter, {.places_m = {victim_m}, .radius_m = radius_m}};
}

Partner partner(IndividualId id, double born_s, const char* origin = "inherited") {
  return {.id = id, .body = id, .species = id == 1 ? "predator" : "prey", .origin = origin, .born_s = born_s};
}

}  // namespace

TEST_CASE("shot: catches in the open, at walls, in corners -> seen from inside the arena, large, little of the outside") {
  for (const char* name : {"walled_square", "height_field"}) {
    const Arena arena = load_arena(name);
    const double edge_m = arena.half_side_m - 0.1;
    for (const Eigen::Vector2d& place :
         {Eigen::Vector2d{0, 0}, {edge_m, 0}, {0, -edge_m}, {-edge_m, edge_m}, {edge_m, -edge_m}, {7, -8}}) {
      for (const Eigen::Vector2d& side : {Eigen::Vector2d{1, 0}, {0, 1}, {-0.6, 0.8}}) {
        const Eigen::Vector2d towards = side.dot(place) < 0.0 ? -side : side;
        const auto tracks = hunt({place.x(), place.y(), 0.05}, {towards.x(), towards.y(), 0.0});
        const Shot shot = shot_of(tracks, arena);
        CAPTURE(name);
        CAPTURE(place.x());
        CAPTURE(place.y());
        CHECK(shot.is_inside);
        CHECK(shot.outside_share <= (place.cwiseAbs().minCoeff() > 9.0 ? 0.35 : 0.15));  // more in corners
        for (const double aspect : {0.6, 4.0 / 3.0, 16.0 / 9.0}) {
          const film::Camera camera = shot.camera(aspect);
          double most = 0.0;
          for (const Track& track : tracks) {
            for (const Eigen::Vector3d& at : track.places_m) {
              for (const Eigen::Vector3d& off :
                   {Eigen::Vector3d{radius_m, 0, 0}, {-radius_m, 0, 0}, {0, radius_m, 0}, {0, -radius_m, 0}}) {
                const auto seen = film::seen_at(camera, at + off);
                REQUIRE(seen);
                CHECK(seen->y < 0.7);
                most = std::max({most, std::abs(seen->x) / aspect, std::abs(seen->y)});
              }
            }
          }
          CHECK(most < 0.9);
          CHECK(most > 0.45);  // not far away
        }
        const film::Sight sight{shot.camera(aspect_of_shots)};
        CHECK(sight.eye_m.head<2>().cwiseAbs().maxCoeff() < arena.half_side_m);
      }
    }
  }
}

TEST_CASE("shot: an arena too small for a camera -> says that a wall is in front") {
  Arena arena;
  arena.half_side_m = 0.8;
  CHECK_FALSE(shot_of(hunt({0.6, 0, 0}, {1, 0, 0}), arena).is_inside);
}

TEST_CASE("scene: hunter or victim younger than 8 s -> begins at its birth, and says so") {
  const Scene whole = scene_of(100.0, partner(1, 20.0), partner(2, 60.0));
  CHECK(whole.begins_s == 92.0);
  CHECK(whole.sentence == "predator 1 catches prey 2: inherited, lived 40 s");
  CHECK(whole.flaws == 0);
  CHECK(whole.remark.empty());
  CHECK(scene_of(100.0, partner(1, 20.0, "random"), partner(2, 60.0)).flaws == Scene::random_hunter);
  const Scene young = scene_of(100.0, partner(1, 98.0), partner(2, 60.0));
  CHECK(young.begins_s == 98.0);
  CHECK(young.flaws == Scene::newborn);
  CHECK(young.remark == "predator 1 was born 2 s before");
}

TEST_CASE("best scene: fewest flaws, genomes given up first, newborns last, the first of equals") {
  const auto best = [](std::vector<unsigned> flaws) {
    std::vector<Scene> scenes(flaws.size());
    for (std::size_t i = 0; i < flaws.size(); ++i) scenes[i].flaws = flaws[i];
    const Scene* found = best_of(scenes);
    return found ? found - scenes.data() : -1;
  };
  CHECK(best({}) == -1);
  CHECK(best({1, 0, 0}) == 1);
  CHECK(best({Scene::newborn, 31}) == 1);
  CHECK(best({Scene::other_catches, Scene::wall_in_front | Scene::much_outside | Scene::random_hunter}) == 1);
  CHECK(best({Scene::much_outside, Scene::random_hunter}) == 1);
}
