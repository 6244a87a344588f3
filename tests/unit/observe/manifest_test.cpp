// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/manifest.hpp>
#include <trophic/support/json.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

namespace {

Json read(const std::filesystem::path& path) {
  return parse_json(test::content(path));
}

}  // namespace

TEST_CASE("manifest: run -> rules, parameters and status") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "manifest.json";
  test::HandPopulation robots = test::three_robots();
  io::Manifest manifest{path, {{"host", "desk"}}};
  manifest.on_start(test::short_run(), robots.at_tick(0).view());
  const auto at_start = read(path);
  CHECK(at_start["status"] == Json("running"));
  CHECK(at_start["rule_table"] == Json("hand_written"));
  CHECK(at_start["seed"] == Json(5));
  CHECK(at_start["fingerprint"] == Json("0123456789abcdef"));
  CHECK(at_start["tags"] == Json::array({-1, 1}));
  CHECK(at_start["host"] == Json("desk"));

  SUBCASE("no change and no branch -> the fingerprint is its identity") {
    CHECK(at_start["identity"] == Json("0123456789abcdef"));
    CHECK(at_start["description"]["name"] == Json("hand_written"));
    CHECK(at_start["description"]["changes"] == Json::array());
  }
  SUBCASE("change -> identity and description of their own at once") {
    observe::RunDescription run = test::short_run();
    run.other_params = {{"rules.mutation.sd", "0.125", "0.05"}};
    run.changes = {{4.0, 2, "rules.capture.reach_m", "0.5", "0.3"}};
    manifest.on_change(run, robots.view());
    const auto now = read(path);
    CHECK(now["fingerprint"] == Json("0123456789abcdef"));
    CHECK(now["identity"] == Json(observe::identity(run)));
    CHECK(now["description"]["name"] == Json(observe::short_name(run)));
    CHECK(now["description"]["sentence"] == Json(observe::sentence(run)));
    CHECK(now["description"]["parameters"] ==
          parse_json(R"([{"path": "rules.mutation.sd", "value": "0.125", "table": "0.05"}])"));
    CHECK(now["description"]["changes"] ==
          parse_json(R"([{"time_s": 4.0, "number": "rules.capture.reach_m", "value": "0.5", "before": "0.3"}])"));
  }
  SUBCASE("run that began from another one -> named after that moment") {
    manifest.begin_from({{"run", "runs/a"}, {"at_s", "700"}, {"seed", "7"}, {"fingerprint", "fedcba9876543210"}});
    manifest.on_start(test::short_run(), robots.view());
    CHECK(read(path)["description"]["name"] == Json("hand_written (from 700 s)"));
    CHECK(read(path)["identity"].get<std::string>().starts_with("0123456789abcdef+"));
  }
  SUBCASE("arena of one's own -> all that its file has") {
    robots.arena.friction = 0.6;
    robots.arena.zones = {{.name = "refuge", .x_m = 1.0, .y_m = 2.0, .radius_m = 3.0}};
    robots.arena.height_field = HeightField{.nodes = 2, .half_extent_m = 12.0, .height_m = {0.0, 1.0, 2.0, 3.0}};
    manifest.on_start(test::short_run(), robots.view());
    const auto arena = read(path)["arena"];
    CHECK(arena["friction"] == Json(0.6));
    CHECK(arena["zones"] == parse_json(R"([{"name": "refuge", "x_m": 1.0, "y_m": 2.0, "radius_m": 3.0}])"));
    CHECK(arena["height_field"] == parse_json(R"({"nodes": 2, "half_extent_m": 12.0, "height_m": [0.0, 1.0, 2.0, 3.0]})"));
  }
  SUBCASE("end time reached -> complete") {
    manifest.on_tick(robots.at_tick(5).view());
    manifest.on_end(robots.view());
    CHECK(read(path)["status"] == Json("complete"));
  }
  SUBCASE("stopped earlier -> stopped") {
    manifest.on_tick(robots.at_tick(4).view());
    manifest.on_end(robots.view());
    CHECK(read(path)["status"] == Json("stopped"));
  }
  SUBCASE("exception -> failed, with its message") {
    manifest.on_failure("simulation diverged");
    CHECK(read(path)["status"] == Json("failed"));
    CHECK(test::content(path).find("simulation diverged") != std::string::npos);
  }
  SUBCASE("facts added later -> contained") {
    manifest.add({{"wall_s", "1.5"}});
    CHECK(read(path)["wall_s"] == Json("1.5"));
    CHECK(read(path)["status"] == Json("running"));
  }
}
