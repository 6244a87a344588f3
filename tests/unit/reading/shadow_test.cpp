// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/shadow.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

using namespace trophic;
using test::message_of;
using test::run_of;
using test::TemporaryFolder;

TEST_CASE("shadow: run with a shadow in its folder -> found") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  CHECK(analysis::null_folders(std::vector{run}, Null::shadow).empty());
  const auto shadow = run_of(run / "shadow", "nothing_inherited");
  CHECK(analysis::null_folders(std::vector{run}, Null::shadow) == std::vector{shadow});
  CHECK_NOTHROW(analysis::check_shadow(analysis::read_manifest(run), analysis::read_manifest(shadow)));
}

TEST_CASE("shadow: run that is not the neutral shadow -> refused, naming the difference") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  const auto refusal = [&](const std::filesystem::path& shadow) {
    return message_of<std::invalid_argument>(
        [&] { analysis::check_shadow(analysis::read_manifest(run), analysis::read_manifest(shadow)); });
  };
  const std::string from = ": is not a neutral shadow of " + run.string() + ": ";
  const auto same = run_of(folder.path() / "same", "copy", 7, 2);
  CHECK(refusal(same) == same.string() + from + "its rule in slot heredity is copy: must be nothing_inherited");
  const auto floor = run_of(folder.path() / "floor", "nothing_inherited", 6);
  CHECK(refusal(floor) == floor.string() + from + "params/rules/floor/floor = 6: must be 7");
  const auto parent = [](const char* rule) {
    analysis::RunManifest manifest;
    manifest.policies = {{"heredity", "nothing_inherited"}, {"parent", rule}};
    manifest.params = Json::object();
    manifest.status = "complete";
    manifest.reached_s = manifest.until_s = 60.0;
    return manifest;
  };
  CHECK_THROWS_AS(analysis::check_shadow(parent("killer"), parent("none")), std::invalid_argument);
  CHECK_NOTHROW(analysis::check_shadow(parent("killer"), parent("none"), true));
  const auto stopped = run_of(folder.path() / "stopped", "nothing_inherited", 7, 1, "stopped");
  CHECK(refusal(stopped) == stopped.string() + from +
                                "it has status \"stopped\" at an unknown time of 6000 s: must be as status "
                                "\"complete\" at 6000 of 6000 s");
  const auto bare = test::write_run(folder.path() / "bare", test::manifest("cc", 3));
  CHECK(refusal(bare).find("slot heredity is unknown") != std::string::npos);
}
