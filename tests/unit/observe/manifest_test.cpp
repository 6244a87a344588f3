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
  CHECK(at_start["status"] == "running");
  CHECK(at_start["rule_table"] == "hand_written");
  CHECK(at_start["seed"] == 5);
  CHECK(at_start["fingerprint"] == "0123456789abcdef");
  CHECK(at_start["tags"] == Json::array({-1, 1}));
  CHECK(at_start["host"] == "desk");

  SUBCASE("end time reached -> complete") {
    manifest.on_tick(robots.at_tick(5).view());
    manifest.on_end(robots.view());
    CHECK(read(path)["status"] == "complete");
  }
  SUBCASE("stopped earlier -> stopped") {
    manifest.on_tick(robots.at_tick(4).view());
    manifest.on_end(robots.view());
    CHECK(read(path)["status"] == "stopped");
  }
  SUBCASE("exception -> failed, with its message") {
    manifest.on_failure("simulation diverged");
    CHECK(read(path)["status"] == "failed");
    CHECK(test::content(path).find("simulation diverged") != std::string::npos);
  }
  SUBCASE("facts added later -> contained") {
    manifest.add({{"wall_s", "1.5"}});
    CHECK(read(path)["wall_s"] == "1.5");
    CHECK(read(path)["status"] == "running");
  }
}
