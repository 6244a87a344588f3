// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/read_history.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/run.hpp>

using namespace trophic;

TEST_CASE("read history: a run's folder -> its events without switches of tags, damaged or missing -> refused") {
  const test::TemporaryFolder folder;
  {
    Ecology<rules::Paper> ecology{{.seed = 4}, backend::Kinematic::Params{}};
    io::RunFolder run{folder.path() / "run"};
    ecology.run_until(400.0, run);
  }
  const SharedHistory history = replicates::read_history(folder.path() / "run");
  REQUIRE(history->size() > 40);
  CHECK(history->front().kind == observe::EventKind::birth);
  std::size_t deaths = 0;
  for (const Happening& event : *history) {
    CHECK(event.kind != observe::EventKind::tag_switch);
    deaths += event.kind == observe::EventKind::death && event.cause ? 1U : 0U;
  }
  CHECK(deaths > 3);
  std::filesystem::resize_file(folder.path() / "run/events.csv", 500);
  CHECK_THROWS_AS(static_cast<void>(replicates::read_history(folder.path() / "run")), std::runtime_error);
  CHECK_THROWS(static_cast<void>(replicates::read_history(folder.path() / "none")));
}
