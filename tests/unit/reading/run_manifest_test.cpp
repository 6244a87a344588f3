// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/run_manifest.hpp>
#include <unit/reading/run_files.hpp>

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

TEST_CASE("a manifest's manifest: rules, seed, time and food web") {
  const TemporaryFolder folder;
  static_cast<void>(folder.file("manifest.json", test::manifest("00ff", 12)));
  const auto manifest = analysis::read_manifest(folder.path());
  CHECK(manifest.fingerprint == "00ff");
  CHECK(manifest.rules == "paper");
  CHECK(manifest.seed == 12);
  CHECK(manifest.until_s == 6000.0);
  CHECK_FALSE(manifest.reached_s);
  CHECK(manifest.web.name(1) == "predator");
  CHECK(manifest.web.eats(1, 0));
}

TEST_CASE("a manifest that is broken is refused by file and field") {
  const TemporaryFolder folder;
  const std::string path = folder.file("manifest.json", "{");
  const auto refusal = [&] {
    return message_of<std::runtime_error>([&] { static_cast<void>(analysis::read_manifest(folder.path())); });
  };
  CHECK(refusal().starts_with(path + ": "));
  std::string wolf = test::manifest("00ff", 12);
  wolf.replace(wolf.find(R"("hunter": "predator")"), 20, R"("hunter": "wolf")");
  static_cast<void>(folder.file("manifest.json", wolf));
  CHECK(refusal().find("food web: link 2 eats 0: must be < 2") != std::string::npos);
  const auto with = [&](const std::string& text, const std::string& other) {
    std::string changed = test::manifest("00ff", 12);
    static_cast<void>(folder.file("manifest.json", changed.replace(changed.find(text), text.size(), other)));
    return refusal();
  };
  for (const char* until_s : {"-1", "1e9", "1e300"}) {
    CHECK(with(R"("until_s": 6000)", R"("until_s": )" + std::string{until_s}).find("clock.until_s = ") != std::string::npos);
  }
  CHECK(with(R"("hunter": "predator")", R"("hunter": "predator", "\u009b2J": 1)")
            .ends_with("must be text without control characters"));
}
